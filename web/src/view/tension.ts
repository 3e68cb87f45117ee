import type { Channel, DrawnLine } from "../engine/engine";

/** A drawn line with its tension at points along it. */
interface TautLine {
  /** Place among the drawn lines. */
  at: number;
  /** Number of its drawn points, evenly spaced along it. */
  points: number;
  /** Places of the tensions in a row, from the first end to the second, and their shares of the length. */
  columns: readonly number[];
  shares: readonly number[];
  /** Largest tension so far, N. */
  largest: number;
}

/** Tension at the drawn points of a line, as a share of its largest tension so far. */
export interface Tints {
  /** Place among the drawn lines. */
  at: number;
  shares: Float32Array;
}

/** Tensions along lines in a run, relative to the largest tension of each line so far. */
export class Tensions {
  private readonly taut: TautLine[];
  private readonly names: string[];

  constructor(lines: readonly DrawnLine[], channels: readonly Channel[]) {
    const along = channels.filter(({ along: places, unit }) => places !== null && unit === "N");
    this.taut = lines.flatMap((line, at) => along.flatMap((channel) => tautOf(line, at, channel)));
    this.names = this.taut.map(({ at }) => lines[at].name);
  }

  /** Returns the lines that have tensions along them, with their largest tension so far, N. */
  get largest(): { name: string; largest_N: number }[] {
    return this.taut.map(({ largest }, k) => ({ name: this.names[k], largest_N: largest }));
  }

  /** Reads a row: updates the largest tensions, and returns the tension at the drawn points of each line. */
  read(row: ArrayLike<number>): Tints[] {
    for (const line of this.taut) for (const column of line.columns) if (row[column] > line.largest) line.largest = row[column];
    return this.tints(row);
  }

  /** Returns the tension at the drawn points of each line, as a share of the largest that was read. */
  tints(row: ArrayLike<number>): Tints[] {
    return this.taut.map((line) => {
      const shares = new Float32Array(line.points);
      for (let i = 0; i < line.points; i++) shares[i] = line.largest > 0 ? Math.min(1, tensionAt(line, i / (line.points - 1), row) / line.largest) : 0;
      return { at: line.at, shares };
    });
  }
}

function tautOf(line: DrawnLine, at: number, { along, offset }: Channel): TautLine[] {
  const own = (along?.lines ?? []).flatMap((name, k) => (name === line.name ? [k] : []));
  if (!along || own.length < 2 || line.points < 2) return [];
  return [{ at, points: line.points, columns: own.map((k) => offset + k), shares: own.map((k) => along.shares[k]), largest: 0 }];
}

/** Returns the tension at a share of the length, linear between the points that have it, N. */
function tensionAt({ columns, shares }: TautLine, share: number, row: ArrayLike<number>): number {
  const found = shares.findIndex((next) => next >= share);
  const k = found < 0 ? shares.length - 1 : Math.max(1, found);
  const part = Math.min(1, (share - shares[k - 1]) / (shares[k] - shares[k - 1]));
  return row[columns[k - 1]] + part * (row[columns[k]] - row[columns[k - 1]]);
}
