import type { Recorded } from "../app/recording/recording";
import type { Run } from "../app/session";
import { evenEnd } from "../plots/spectrum";

/** Rows of a recording that are still in memory; the older part of a long recording was thinned. */
export interface Kept {
  rows: readonly Recorded[];
  /** Approximate number of records before thinning. */
  recorded: number;
  /** Time from which no record is missing, s; null if no record is missing at all. */
  thinnedUntil_s: number | null;
  last_s: number;
}

/** Largest deviation of a time from the grid of recording times, as a share of the interval. */
const OFF_GRID = 1e-6;

export function keptOf(items: readonly Recorded[], { record_every_s, step_s }: Run["model"]): Kept {
  const rows = [...items];
  const interval_s = Math.max(record_every_s, step_s);
  const [start_s, last_s] = [rows[0].time_s, rows[rows.length - 1].time_s];
  const recorded = Math.max(rows.length, Math.floor((last_s - start_s) / interval_s + OFF_GRID) + 1);
  if (recorded === rows.length) return { rows, recorded, thinnedUntil_s: null, last_s };
  const [from] = evenEnd(rows.map(({ time_s }) => time_s));
  return { rows, recorded, thinnedUntil_s: rows[from].time_s, last_s };
}

/** Interval at which a long task lets the page handle input, ms. */
const BREATH_MS = 40;

/** Collects the parts of a file as they are made; the page stays responsive. */
export async function gathered(parts: Iterable<string>): Promise<string[]> {
  const all: string[] = [];
  let since_ms = performance.now();
  for (const part of parts) {
    all.push(part);
    if (performance.now() - since_ms < BREATH_MS) continue;
    await new Promise((resolve) => setTimeout(resolve));
    since_ms = performance.now();
  }
  return all;
}
