/** Most records that the plots show. */
const MOST_RECORDS = 20000;

/** How long the plots look back, s: the scenario's duration, at least 10 s, as can be drawn. */
export function windowLength(duration_s: number, interval_s: number): { window_s: number; capacity: number } {
  const wanted_s = Math.max(duration_s, 10);
  const capacity = Math.min(MOST_RECORDS, Math.ceil(wanted_s / interval_s) + 2);
  return { window_s: Math.min(wanted_s, (capacity - 2) * interval_s), capacity };
}

/** What the plots show of a run at its start, s; it doubles until all of it is in sight. */
const FIRST_STRETCH_S = 15;

/** The stretch of time in sight: from the start, in doubling stretches to the duration, then the last window. */
export function timeRange(now_s: number, duration_s: number, window_s: number): [number, number] {
  const whole = Math.min(duration_s, window_s);
  let stretch = FIRST_STRETCH_S;
  while (stretch < now_s) stretch *= 2;
  // No last stretch that is hardly longer than the one before.
  const end = Math.max(now_s, 1.3 * stretch > whole ? whole : stretch);
  return [Math.max(0, end - window_s), end];
}

/** The same, moved so far that a moment is in it which lies before. */
export function rangeInSight(now_s: number, shown_s: number, duration_s: number, window_s: number): [number, number] {
  const [from, to] = timeRange(now_s, duration_s, window_s);
  if (shown_s >= from) return [from, to];
  const start = Math.max(0, shown_s - window_s / 2);
  return [start, start + window_s];
}

/** Pairs of neighbouring places between which an angle jumps around the circle. */
export function wrapPlaces(values: ArrayLike<number>, first: number, last: number, half: number): [number, number][] {
  const places: [number, number][] = [];
  for (let i = first + 1; i <= last; i++) {
    if (Math.abs(values[i] - values[i - 1]) > half) places.push([i - 1, i]);
  }
  return places;
}

/** What of the time the plots show: follow the run, all of it, the last so many seconds, or from one time to another. */
export type WindowChoice = { kind: "follow" } | { kind: "all" } | { kind: "last"; length_s: number } | { kind: "between"; from_s: number; to_s: number };

export const FOLLOWING: WindowChoice = { kind: "follow" };
/** Last so many seconds, to choose. */
export const LAST_S = [10, 30, 60, 300];

export function isWindow(value: unknown): value is WindowChoice {
  const one = value as WindowChoice | null | undefined;
  if (one?.kind === "last") return one.length_s > 0;
  if (one?.kind === "between") return one.from_s < one.to_s;
  return one?.kind === "follow" || one?.kind === "all";
}

/** The run as far as the plots need to know it: its newest time, the one that is shown, its length and how far plots look back. */
export interface Extent {
  now_s: number;
  shown_s: number;
  duration_s: number;
  window_s: number;
}

/** The stretch of time in sight. */
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
