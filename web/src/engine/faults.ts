import { texts } from "../texts";
import type { Fault } from "./engine";

/** Kinds of faults whose message the page writes, in its language; messages of the engine are in English. */
export const OF_PAGE = ["database", "engine", "file", "link", "network", "restarted", "runs", "saved", "setting", "two_operations"];

/** Whether a fault is of the kind `engine`: the engine is dead. */
export function isOfEngine(fault: unknown): fault is Fault & { kind: "engine" } {
  return typeof fault === "object" && fault !== null && "kind" in fault && fault.kind === "engine";
}

/** Whether the engine wrote the message of a fault: such messages are in English. */
export function isInEnglish({ kind }: Fault): boolean {
  return !OF_PAGE.includes(kind);
}

export const UNLOADED: Fault = { kind: "engine", message: texts.engine.unloaded };

export const ENDED: Fault = { kind: "engine", message: texts.engine.ended };

export function faultOfLoading(why: string): Fault {
  return { kind: "engine", message: texts.engine.not_loaded(why) };
}

export function faultOfSilence(silent_s: number): Fault {
  return { kind: "engine", message: texts.engine.silent(silent_s) };
}

export function faultOfBreakdown(why: string): Fault {
  return { kind: "engine", message: texts.engine.broke_down(why) };
}

/** Returns the fault of a file that may exist, but could not be loaded. */
export function faultOfNetwork(url: string, why: string): Fault {
  return { kind: "network", message: texts.engine.not_fetched(url.slice(url.lastIndexOf("/") + 1), why) };
}
