import type { ScenarioOf } from "../ahead/messages";
import type { Fault } from "../engine/engine";
import type { ModesAt } from "./modes";
import type { SeaSpectrum } from "./sea_spectrum";

/** A scenario whose modes are asked for at these values of a parameter. */
export interface Sweep {
  scenario: ScenarioOf;
  parameter: string;
  values: readonly number[];
}

/** One value after the other, and the sea before them; a value that has none says why. */
export type FromSweep =
  | { kind: "sea"; sea: SeaSpectrum | null }
  | { kind: "modes"; found: ModesAt }
  | { kind: "skipped"; value: number; fault: Fault }
  | { kind: "done" }
  | { kind: "fault"; fault: Fault };
