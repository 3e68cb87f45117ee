import type { Recorded } from "../app/recording/recording";
import type { Series } from "../app/recording/series";
import { RANGE_S } from "./readings";

/**
 * Returns the smallest and the largest value of a column in the last minute before a time; NaN if there is no such
 * column.
 */
export function rangeOf(rows: Series<Recorded>, place: number, time_s: number): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (let at = rows.indexAt(time_s); at >= 0 && rows.items[at].time_s >= time_s - RANGE_S; at--) {
    const value = rows.items[at].row[place];
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? [low, high] : [NaN, NaN];
}
