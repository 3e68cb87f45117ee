import type { Fault } from "../engine/engine";
import type { OpenRequest } from "../engine/messages";

/** Times, s, and positions, m, at which the wave was measured. */
export interface Past {
  time_s: Float64Array;
  x_m: Float64Array;
  y_m: Float64Array;
}

/** State at which the futures start, the measurements before it, and the length of the futures. */
export interface Start {
  snapshot: Uint8Array;
  past: Past;
  horizon_s: number;
  every_s: number;
}

/** One possible continuation of the run. */
export interface Future {
  seed: number;
  /** Time of the first row, s. */
  start_s: number;
  every_s: number;
  /** Rows from the start of the future on, one after another; NaN after the run has failed. */
  rows: Float32Array;
  /** Number of wave components of the sea; with 0, all futures are equal. */
  waves: number;
  /** Whether the wind has gusts; the gusts are those of the run, in all futures. */
  isGusty: boolean;
  /** Length of the measurements with which the future agrees, s. */
  past_s: number;
  fault: Fault | null;
}

/** A scenario with the parameter values of the run. */
export type ScenarioOf = Omit<OpenRequest, "kind" | "changes">;

export type ToForeseer =
  | { kind: "module"; module: WebAssembly.Module }
  | { kind: "look"; job: number; scenario: ScenarioOf; start: Start; seeds: number[] }
  | { kind: "cancel" };

/** Answers of a worker; `done`: all futures of a job are computed. */
export type FromForeseer =
  | { kind: "future"; job: number; future: Future }
  | { kind: "done"; job: number }
  | { kind: "fault"; job: number; fault: Fault };
