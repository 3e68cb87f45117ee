import { read } from "../plots/stretch";
import type { Places } from "../plots/stretch";
import type { Future } from "./messages";
import { fanOf } from "./quantiles";

/** Futures of one moment, as far as they are computed. */
export class Outlook {
  readonly futures: Future[] = [];
  private readonly fans = new Map<string, { of: number; lines: Float64Array[] }>();

  constructor(
    /** Number of futures when all are computed. */
    readonly wanted: number,
    /** Number of values in a row. */
    private readonly width: number,
  ) {}

  add(future: Future): void {
    this.futures.push(future);
  }

  get start_s(): number {
    return this.futures[0]?.start_s ?? NaN;
  }

  /** Number of rows of a future. */
  get length(): number {
    return this.futures.length > 0 ? this.futures[0].rows.length / this.width : 0;
  }

  get end_s(): number {
    return this.futures.length > 0 ? this.timeAt(this.length - 1) : -Infinity;
  }

  timeAt(k: number): number {
    return this.start_s + k * this.futures[0].every_s;
  }

  /** Whether all futures are equal, because there are no waves. */
  get isOneLine(): boolean {
    return this.futures.length > 0 && this.futures[0].waves === 0;
  }

  row(future: number, k: number): Float32Array {
    return this.futures[future].rows.subarray(k * this.width, (k + 1) * this.width);
  }

  /** Returns the lines of the fan for these columns: one line for each level, with a value at each time. */
  fan(places: Places): Float64Array[] {
    const key = places.join();
    const known = this.fans.get(key);
    if (known?.of === this.futures.length) return known.lines;
    const values = Array.from({ length: this.length }, (_, k) => Float64Array.from(this.futures, (_one, i) => read(this.row(i, k), places)));
    const lines = fanOf(values);
    this.fans.set(key, { of: this.futures.length, lines });
    return lines;
  }
}
