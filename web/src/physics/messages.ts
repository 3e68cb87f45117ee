import type { ScenarioOf } from "../forecast/messages";
import type { Fault } from "../engine/engine";
import type { ModesAt } from "./modes";
import type { SeaSpectrum } from "./sea_spectrum";

/** A request for the modes of a scenario at these values of a parameter. */
export interface Sweep {
  scenario: ScenarioOf;
  parameter: string;
  values: readonly number[];
}

/** Answers: first the sea, then one value after the other; a value without modes gives a reason. */
export type FromSweep =
  | { kind: "sea"; sea: SeaSpectrum | null }
  | { kind: "modes"; found: ModesAt }
  | { kind: "skipped"; value: number; fault: Fault }
  | { kind: "done" }
  | { kind: "fault"; fault: Fault };
