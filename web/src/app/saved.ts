import type { Fault } from "../engine/engine";
import { isOfEngine } from "../engine/faults";
import type { Replay } from "../engine/messages";
import { fixed } from "./format";
import { yamlOf } from "./yaml";

/** A scenario to be kept: a file, and why a run of it is not the run in hand. */
export interface SavedFile {
  name: string;
  text: string;
  /** Null where it is. */
  differs: string | null;
}

/** Schemes that the browser solves with differences and other machines with exact derivatives. */
const IMPLICIT = ["newmark", "generalized_alpha", "implicit_midpoint"];

/**
 * The file of a scenario that was opened as `opened`, with what was set and driven by hand. `pending` are the parameters whose
 * values wait for a reset.
 */
export function savedFile(opened: string, replay: Replay, pending: string[] = []): SavedFile {
  const differs = differenceOf(replay);
  const says = [`Saved by Kingpost's app at ${seconds(replay.time_s)} of a run, with the parameters as they were set.`];
  if (replay.moves > 0) {
    says.push(`The operation has ${replay.moves === 1 ? "the lever move" : `the ${replay.moves} lever moves`} made by hand.`);
  }
  if (pending.length > 0) says.push(`Values that waited for a reset are not in it: ${pending.join(", ")}.`);
  says.push(differs ?? "A run of this file gives the same numbers.");
  if (differs === null && IMPLICIT.includes(replay.integrator)) {
    says.push("Its integrator is implicit: a run outside the browser agrees within its tolerance, not to the last bit.");
  }
  if (replay.files.length > 0) says.push(`It needs these files beside it: ${replay.files.join(", ")}.`);
  return { name: nameOf(opened), text: `${says.map((line) => `# ${line}\n`).join("")}\n${yamlOf(replay.scenario)}`, differs };
}

/** A parameter that was set under way has no place in a file, but for its last value. */
function differenceOf({ parameters }: Replay): string | null {
  if (parameters.length === 0) return null;
  const set = parameters.map(({ parameter, time_s }) => `${parameter} at ${seconds(time_s)}`).join(", ");
  return (
    `A run of this file differs from the one that was saved, in which parameters were set under way: ${set}. ` +
    "The file has their last values from the start."
  );
}

/** Why there is nothing to keep. */
export function faultOfSaving(fault: Fault): Fault {
  if (isOfEngine(fault)) return fault;
  if (!fault.message.startsWith("operation:")) return { ...fault, kind: "unsaved" };
  const message =
    "Levers were moved by hand while the scenario's own operation was on, and a file holds one operation. " +
    "Switch that off (operation.enabled: false) and drive all by hand; or reset, and save without the moves.";
  return { kind: "unsaved", message };
}

function nameOf(opened: string): string {
  return `${stemOf(opened)}-saved.yaml`;
}

/** Of files that are made of a scenario. */
export function stemOf(opened: string): string {
  return opened.slice(opened.lastIndexOf("/") + 1).replace(/(-saved)?\.(ya?ml|json)$/i, "");
}

function seconds(time_s: number): string {
  return `${Number(fixed(time_s, 3))} s`;
}
