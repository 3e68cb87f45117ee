import type { Recording } from "../app/recording/recording";
import type { Run } from "../app/session";
import { DEGREES } from "./loss_chart";

/** Most points of a drawn line: more than pixels would be invisible. */
const MOST_POINTS = 800;

/** The heel of a body over a stretch of the recording, s and deg, counted to a side: 1 for starboard, -1 for port. */
export function heelOver(recording: Recording, { columns }: Run, body: string, way: number, [from_s, to_s]: [number, number]): [number, number][] {
  const { rows } = recording;
  const kept = rows.items.slice(Math.max(0, rows.indexAt(from_s)), rows.indexAt(to_s) + 1);
  const every = Math.max(1, Math.ceil(kept.length / MOST_POINTS));
  const at = columns.at(`${body}.roll`);
  return kept.filter((_, k) => k % every === 0 || k === kept.length - 1).map(({ time_s, row }) => [time_s, way * row[at] * DEGREES]);
}

/** Time of the largest heel, among all recorded times, not only the drawn ones. */
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
