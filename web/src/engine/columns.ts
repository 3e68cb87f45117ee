import type { Channel } from "./engine";

/** Positions of named columns in a row. */
export class Columns {
  /** Names of the columns in the order of a row, as in the CSV files. */
  readonly names: string[];
  private readonly index: Map<string, number>;

  constructor(channels: Channel[]) {
    this.names = channels.flatMap(({ columns }) => columns);
    this.index = new Map(this.names.map((name, at) => [name, at]));
  }

  get width(): number {
    return this.names.length;
  }

  /** Index of a column; -1 if there is no such column. */
  at(name: string): number {
    return this.index.get(name) ?? -1;
  }

  /** Value of a column in a row; NaN if there is no such column. */
  read(row: ArrayLike<number>, name: string): number {
    const at = this.at(name);
    return at < 0 ? NaN : row[at];
  }

  byName(row: ArrayLike<number>): Record<string, number> {
    return Object.fromEntries(this.names.map((name, at) => [name, row[at]]));
  }
}
