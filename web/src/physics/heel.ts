import type { Recording } from "../app/recording/recording";
import type { Run } from "../app/session";
import { DEGREES } from "./loss_chart";

/** Largest number of points of a drawn line: more points than pixels are not visible. */
const MOST_POINTS = 800;

/**
 * Returns the heel of a body over a part of the recording, s and deg, positive to the side `way`: 1 for starboard, -1
 * for port.
 */
export function heelOver(recording: Recording, { columns }: Run, body: string, way: number, [from_s, to_s]: [number, number]): [number, number][] {
  const { rows } = recording;
  const kept = rows.items.slice(Math.max(0, rows.indexAt(from_s)), rows.indexAt(to_s) + 1);
  const every = Math.max(1, Math.ceil(kept.length / MOST_POINTS));
  const at = columns.at(`${body}.roll`);
  return kept.filter((_, k) => k % every === 0 || k === kept.length - 1).map(({ time_s, row }) => [time_s, way * row[at] * DEGREES]);
}

/** Returns the time of the largest heel among all recorded times; the drawn line may leave it out. */
export function furthest(recording: Recording, { columns }: Run, body: string, way: number, [from_s, to_s]: [number, number]): [number, number] | null {
  const at = columns.at(`${body}.roll`);
  const { rows } = recording;
  let best: [number, number] | null = null;
  for (let k = Math.max(0, rows.indexAt(from_s)); k <= rows.indexAt(to_s); k++) {
    const { time_s, row } = rows.items[k];
    const heel = way * row[at] * DEGREES;
    if (!best || heel > best[1]) best = [time_s, heel];
  }
  return best;
}
