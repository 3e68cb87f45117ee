import type { Fault } from "../engine/engine";
import { isOfEngine } from "../engine/faults";
import type { Replay } from "../engine/messages";
import { texts } from "../texts";
import { fixed } from "./format";

const words = texts.saved;

/** A saved scenario: a file, and the reason if a run of the file differs from the present run. */
export interface SavedFile {
  name: string;
  text: string;
  /** Reason why a run of the file differs from the present run; null if it does not differ. */
  differs: string | null;
}

/** Integrators that use finite differences in the browser and exact derivatives elsewhere. */
const IMPLICIT = ["newmark", "generalized_alpha", "implicit_midpoint"];

/**
 * Makes the file of a scenario opened as `opened`, with the values that were set and the levers that were moved by
 * hand. `pending` are the parameters whose values wait for a reset.
 */
export async function savedFile(opened: string, replay: Replay, pending: string[] = []): Promise<SavedFile> {
  const differs = differenceOf(replay);
  const says = [words.by(seconds(replay.time_s))];
  if (replay.moves > 0) says.push(words.moves(replay.moves));
  if (pending.length > 0) says.push(words.waiting(pending.join(", ")));
  says.push(differs ?? words.same);
  if (differs === null && IMPLICIT.includes(replay.integrator)) says.push(words.implicit);
  if (replay.files.length > 0) says.push(words.needs(replay.files.join(", ")));
  const { yamlOf } = await import("./yaml");
  return { name: nameOf(opened), text: `${says.map((line) => `# ${line}\n`).join("")}\n${yamlOf(replay.scenario)}`, differs };
}

/**
 * Returns why a run of the file differs: a file holds only the last value of a parameter that was set during the run.
 * Null if it does not differ.
 */
function differenceOf({ parameters, lost }: Replay): string | null {
  if (lost > 0) return words.lost(lost);
  if (parameters.length === 0) return null;
  const set = parameters.map(({ parameter, time_s }) => words.set_at(parameter, seconds(time_s))).join(", ");
  return words.differs(set);
}

/** Returns the fault that explains why the scenario cannot be saved. */
export function faultOfSaving(fault: Fault): Fault {
  if (isOfEngine(fault)) return fault;
  if (!fault.message.startsWith("operation:")) return { ...fault, kind: "unsaved" };
  return { kind: "two_operations", message: words.two_operations };
}

function nameOf(opened: string): string {
  return `${stemOf(opened)}-saved.yaml`;
}

/** Returns the stem of the names of files made from a scenario. */
export function stemOf(opened: string): string {
  return opened.slice(opened.lastIndexOf("/") + 1).replace(/(-saved)?\.(ya?ml|json)$/i, "");
}

function seconds(time_s: number): string {
  return `${Number(fixed(time_s, 3))} s`;
}
