import type { Recorded } from "../app/recording/recording";
import type { Run } from "../app/session";
import { evenEnd } from "../plots/spectrum";

/** The remaining part of a recording: the older part of a long one was thinned. */
export interface Kept {
  rows: readonly Recorded[];
  /** Approximate original number of records. */
  recorded: number;
  /** Time from which no record is missing, s; null if none is missing. */
  thinnedUntil_s: number | null;
  last_s: number;
}

/** Share of an interval by which a time may be off the grid of the recording. */
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

/** Interval at which a long task lets the page react, ms. */
const BREATH_MS = 40;

/** Joins the parts of a file as they are made; the page stays responsive. */
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
