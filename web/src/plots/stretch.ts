import type { Recorded } from "../app/recording/recording";

/**
 * Columns of a line in a row: one column, or the components of a vector whose magnitude is drawn; -1 for a missing
 * column.
 */
export type Places = readonly number[];

export function read(row: ArrayLike<number>, places: Places): number {
  const value = (place: number) => (place < 0 ? NaN : row[place]);
  return places.length === 1 ? value(places[0]) : Math.hypot(...places.map(value));
}

/** Lines over a part of the recording, each in one contiguous array. */
export class Stretch {
  private arrays: Float64Array[] = [];
  length = 0;

  /** Copies a range of records; the first array holds their times. `scale` converts a value to the displayed unit. */
  fill(rows: readonly Recorded[], [from, to]: [number, number], lines: readonly Places[], scale: (value: number, line: number) => number): void {
    this.length = to - from;
    if (this.arrays.length !== lines.length + 1 || this.arrays[0].length < this.length) {
      this.arrays = Array.from({ length: lines.length + 1 }, () => new Float64Array(Math.max(256, 2 * this.length)));
    }
    const [times, ...values] = this.arrays;
    for (let k = 0; k < this.length; k++) {
      const { time_s, row } = rows[from + k];
      times[k] = time_s;
      for (let i = 0; i < values.length; i++) values[i][k] = scale(read(row, lines[i]), i);
    }
  }

  /** Arrays of the lines; they are views and valid until the next `fill`. */
  get data(): Float64Array[] {
    return this.arrays.map((one) => one.subarray(0, this.length));
  }
}
