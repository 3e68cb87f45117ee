import type { Channel } from "./engine";

/** Dimensions that name a thing of the model; its name leads, as in `ship.angular_velocity.x`. */
const THINGS = new Set([
  "body",
  "coordinate",
  "joint",
  "loop",
  "constraint",
  "cylinder",
  "hull",
  "line",
  "flow",
  "station",
  "thruster",
  "point",
  "drive",
]);

/** Flat column names, in the order of a row: the names of the CSV files. */
export function columnNames(channels: Channel[]): string[] {
  const names: string[] = [];
  for (const channel of channels) {
    const combined = combinations(channel.labels);
    combined.forEach((labels, index) => {
      names[channel.offset + index] = flatName(channel, labels);
    });
  }
  return names;
}

function flatName(channel: Channel, labels: string[]): string {
  const leads = channel.dims.length > 0 && THINGS.has(channel.dims[0]);
  const parts = leads
    ? [labels[0], channel.variable, ...labels.slice(1)]
    : [channel.variable, ...labels];
  return parts.join(".");
}

/** Every combination of one label per dimension, the last dimension running fastest. */
function combinations(labels: string[][]): string[][] {
  return labels.reduce<string[][]>(
    (heads, tail) =>
      heads.flatMap((head) => tail.map((label) => [...head, label])),
    [[]],
  );
}

/** Where named columns stand in a row. */
export class Columns {
  readonly names: string[];
  private readonly index: Map<string, number>;

  constructor(channels: Channel[]) {
    this.names = columnNames(channels);
    this.index = new Map(this.names.map((name, at) => [name, at]));
  }

  get width(): number {
    return this.names.length;
  }

  /** -1 where there is no such column. */
  at(name: string): number {
    return this.index.get(name) ?? -1;
  }

  /** NaN where there is no such column. */
  read(row: ArrayLike<number>, name: string): number {
    const at = this.at(name);
    return at < 0 ? NaN : row[at];
  }

  byName(row: ArrayLike<number>): Record<string, number> {
    return Object.fromEntries(this.names.map((name, at) => [name, row[at]]));
  }
}
