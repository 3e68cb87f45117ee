import type { Fault } from "../engine/engine";
import type { OpenRequest } from "../engine/messages";

/** Times and places, m, at which the wave was measured. */
export interface Past {
  time_s: Float64Array;
  x_m: Float64Array;
  y_m: Float64Array;
}

/** Start of the futures, and their length. */
export interface Start {
  snapshot: Uint8Array;
  past: Past;
  horizon_s: number;
  every_s: number;
}

/** A future. */
export interface Future {
  seed: number;
  /** Time of its first row, s. */
  start_s: number;
  every_s: number;
  /** Rows from the start on, one after another; NaN after the run failed. */
  rows: Float32Array;
  /** Number of waves of the sea; with 0, all futures are equal. */
  waves: number;
  /** Whether the wind has gusts; all futures have the gusts of the run. */
  isGusty: boolean;
  /** Length of the measured past that it agrees with, s. */
  past_s: number;
  fault: Fault | null;
}

/** A scenario with the parameter values of the run. */
export type ScenarioOf = Omit<OpenRequest, "kind" | "changes">;

export type ToForeseer =
  | { kind: "module"; module: WebAssembly.Module }
  | { kind: "look"; job: number; scenario: ScenarioOf; start: Start; seeds: number[] }
  | { kind: "cancel" };

/** `done`: all futures of a job have come. */
export type FromForeseer =
  | { kind: "future"; job: number; future: Future }
  | { kind: "done"; job: number }
  | { kind: "fault"; job: number; fault: Fault };
