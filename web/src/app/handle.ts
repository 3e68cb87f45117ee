import type { Surface } from "../engine/surface";
import type { Rest } from "./rest";
import type { Session } from "./session";

/** Read-only access to the run, for tests and the browser's console. */
export interface Sample {
  status: string;
  /** Whether the engine still has to answer a request: an opening, a reset or a frame. */
  isWaiting: boolean;
  time_s: number;
  /** Names of values that wait for a reset. */
  pending: string[];
  /** Last time of the recording. */
  newest_s: number;
  /** The row of the moment that is shown, by column name as in the CSV files. */
  row: Record<string, number>;
  /** Poses x y z qw qx qy qz for each body, world frame. */
  poses: number[];
  /** The sea around the hull, if there is one. */
  surface: Surface | null;
}

declare global {
  interface Window {
    kingpost?: {
      sample(): Sample | null;
      /** Resolves when the page shows everything that was requested; the run must be paused. */
      rested(): Promise<void>;
    };
  }
}

export function exposeHandle(session: Session, rest: Rest): void {
  window.kingpost = Object.freeze({
    rested: () => rest.reached(),
    sample() {
      const { run, status, shown } = session;
      const { moment } = shown;
      if (!run || !moment) return null;
      return {
        status,
        isWaiting: session.isWaiting,
        pending: session.pending(),
        time_s: run.columns.read(moment.row, "time"),
        newest_s: shown.recording!.now.time_s,
        row: run.columns.byName(moment.row),
        poses: Array.from(moment.poses),
        surface: moment.surface,
      };
    },
  });
}
