import { OVERHEAD } from "../app/recording/recording";
import type { Recorded } from "../app/recording/recording";
import { withoutClosest } from "../app/recording/series";
import type { KeptRun } from "./kept";

/** Memory limit of all kept runs together, bytes: the limit of a recording once more. */
export const KEPT_BYTES = 96e6;
/** Memory of a reference, bytes. */
const REFERENCE = 8;
/** Smallest number of rows of a run that is thinned. */
const FEWEST_ROWS = 16;

/** Counts the memory of kept runs, bytes; what several runs share counts once. */
export function bytesOf(runs: readonly KeptRun[]): number {
  const rows = new Set(runs.flatMap((run) => run.rows));
  const facts = new Set(runs.map((run) => run.facts));
  const events = new Set(runs.flatMap((run) => run.events));
  let sum = OVERHEAD * events.size;
  for (const run of runs) sum += REFERENCE * (run.rows.length + run.events.length);
  for (const { bytes } of facts) sum += bytes;
  for (const row of rows) sum += bytesOfRow(row);
  return sum;
}

function bytesOfRow({ row, poses, line_points }: Recorded): number {
  return 8 * (row.length + poses.length + line_points.length) + OVERHEAD;
}

/**
 * Thins the kept run with the most bytes, again and again, until all are within a limit: every second one of its
 * closest rows goes, also from the runs that share it. Returns false if the limit cannot be reached.
 */
export function thin(runs: readonly KeptRun[], limit = KEPT_BYTES): boolean {
  while (bytesOf(runs) > limit) {
    const long = runs.filter(({ rows }) => rows.length > FEWEST_ROWS);
    if (long.length === 0) return false;
    const size = ({ rows }: KeptRun) => rows.length * bytesOfRow(rows[0]);
    const largest = long.reduce((so, run) => (size(run) > size(so) ? run : so));
    // The first and the last row of every run stay.
    const ends = runs.flatMap(({ rows }) => [rows[0], rows[rows.length - 1]]);
    const stay = new Set([...ends, ...withoutClosest(largest.rows, largest.rows.length - 1, 1 / 2)]);
    const gone = new Set(largest.rows.filter((row) => !stay.has(row)));
    for (const run of runs) run.rows = run.rows.filter((row) => !gone.has(row));
  }
  return true;
}
