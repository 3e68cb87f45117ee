/**
 * The last stretch of some columns over time. Memory is bounded: twice `capacity` numbers a column,
 * moved to the front when the end is reached, so that every view is one contiguous array.
 */
export class History {
  private readonly data: Float64Array[];
  private from = 0;
  private to = 0;

  constructor(
    columns: number,
    readonly capacity: number,
  ) {
    this.data = Array.from({ length: columns }, () => new Float64Array(2 * capacity));
  }

  get length(): number {
    return this.to - this.from;
  }

  clear(): void {
    this.from = this.to = 0;
  }

  push(values: readonly number[]): void {
    if (this.to === 2 * this.capacity) {
      for (const column of this.data) column.copyWithin(0, this.from, this.to);
      this.to -= this.from;
      this.from = 0;
    }
    this.data.forEach((column, i) => (column[this.to] = values[i]));
    this.to += 1;
    if (this.length > this.capacity) this.from += 1;
  }

  /** A view, not a copy; it stands until the next push. */
  column(i: number): Float64Array {
    return this.data[i].subarray(this.from, this.to);
  }

  last(i: number): number {
    return this.length > 0 ? this.data[i][this.to - 1] : NaN;
  }
}
