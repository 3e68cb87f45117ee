import { isObject } from "../app/objects";

/** Largest number of records that the plots show. */
const MOST_RECORDS = 20000;

/** Returns the longest visible time, s: the scenario's duration, at least 10 s, and no more than can be drawn. */
export function windowLength(duration_s: number, interval_s: number): { window_s: number; capacity: number } {
  const wanted_s = Math.max(duration_s, 10);
  const capacity = Math.min(MOST_RECORDS, Math.ceil(wanted_s / interval_s) + 2);
  return { window_s: Math.min(wanted_s, (capacity - 2) * interval_s), capacity };
}

/** Length of the visible time at the start of a run, s; it doubles until the whole run is visible. */
const FIRST_STRETCH_S = 15;

/**
 * Returns the visible time: from the start, with a length that doubles up to the duration; after that, the last
 * `window_s`.
 */
export function timeRange(now_s: number, duration_s: number, window_s: number): [number, number] {
  const whole = Math.min(duration_s, window_s);
  let stretch = FIRST_STRETCH_S;
  while (stretch < now_s) stretch *= 2;
  // Avoids a last length that is hardly greater than the one before.
  const end = Math.max(now_s, 1.3 * stretch > whole ? whole : stretch);
  return [Math.max(0, end - window_s), end];
}

/** Returns the visible time, moved so that it contains an earlier time that is shown. */
export function rangeInSight(now_s: number, shown_s: number, duration_s: number, window_s: number): [number, number] {
  const [from, to] = timeRange(now_s, duration_s, window_s);
  if (shown_s >= from) return [from, to];
  const start = Math.max(0, shown_s - window_s / 2);
  return [start, start + window_s];
}

/** Returns the pairs of neighbouring records between which an angle jumps by a full turn. */
export function wrapPlaces(values: ArrayLike<number | null | undefined>, first: number, last: number, half: number): [number, number][] {
  const places: [number, number][] = [];
  for (let i = first + 1; i <= last; i++) {
    if (Math.abs(Number(values[i]) - Number(values[i - 1])) > half) places.push([i - 1, i]);
  }
  return places;
}

/**
 * The user's choice of the visible time: following the run, the whole recording, the last seconds, or a fixed range.
 */
export type WindowChoice = { kind: "follow" } | { kind: "all" } | { kind: "last"; length_s: number } | { kind: "between"; from_s: number; to_s: number };

export const FOLLOWING: WindowChoice = { kind: "follow" };
/** Choices for the last seconds, s. */
export const LAST_S = [10, 30, 60, 300];

export function isWindow(value: unknown): value is WindowChoice {
  if (!isObject(value)) return false;
  const { kind, length_s, from_s, to_s } = value;
  if (kind === "last") return typeof length_s === "number" && length_s > 0;
  if (kind === "between") return typeof from_s === "number" && typeof to_s === "number" && from_s < to_s;
  return kind === "follow" || kind === "all";
}

/**
 * Times of the run that determine the visible time: the newest, the shown, the duration and the longest visible time.
 */
export interface Extent {
  now_s: number;
  shown_s: number;
  duration_s: number;
  window_s: number;
}

/** Returns the visible time for a choice. */
export function stretchOf(choice: WindowChoice, { now_s, shown_s, duration_s, window_s }: Extent): [number, number] {
  switch (choice.kind) {
    case "follow":
      return rangeInSight(now_s, shown_s, duration_s, window_s);
    case "all":
      return [0, Math.max(now_s, 1e-3)];
    case "last":
      return [Math.max(0, shown_s - choice.length_s), Math.max(shown_s, choice.length_s)];
    case "between":
      return [choice.from_s, choice.to_s];
  }
}
