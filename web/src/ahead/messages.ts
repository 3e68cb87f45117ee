import type { Fault } from "../engine/engine";
import type { OpenRequest } from "../engine/messages";

/** Times and places, m, at which the wave was measured. */
export interface Past {
  time_s: Float64Array;
  x_m: Float64Array;
  y_m: Float64Array;
}

/** Where futures begin, and how far they go. */
export interface Start {
  snapshot: Uint8Array;
  past: Past;
  horizon_s: number;
  every_s: number;
}

/** What may come to pass. */
export interface Future {
  seed: number;
  /** Of its first row, s. */
  start_s: number;
  every_s: number;
  /** Rows from the start on, one after another; not a number after the run failed. */
  rows: Float32Array;
  /** How many waves the sea has; where there are none, all futures are this one. */
  waves: number;
  /** Whether the wind has gusts: they are the run's own. */
  isGusty: boolean;
  /** How long the measured past is that it agrees with, s. */
  past_s: number;
  fault: Fault | null;
}

/** A scenario with the values that the run has. */
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
