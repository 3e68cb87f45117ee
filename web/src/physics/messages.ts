import type { ScenarioOf } from "../forecast/messages";
import type { Fault } from "../engine/engine";
import type { ModesAt } from "./modes";
import type { SeaSpectrum } from "./sea_spectrum";

/** Request for the modes of a scenario at these values of a parameter. */
export interface Sweep {
  scenario: ScenarioOf;
  parameter: string;
  values: readonly number[];
}

/**
 * Answers to a sweep: first the spectrum of the sea, then the modes at each value; a value without modes comes with a
 * reason.
 */
export type FromSweep =
  | { kind: "sea"; sea: SeaSpectrum | null }
  | { kind: "modes"; found: ModesAt }
  | { kind: "skipped"; value: number; fault: Fault }
  | { kind: "done" }
  | { kind: "fault"; fault: Fault };
