import type { Fault } from "./engine";

/** What went wrong between the page and the engine, in words. The kind `engine`: there is no engine any more. */
export function isOfEngine(fault: unknown): boolean {
  return typeof fault === "object" && fault !== null && "kind" in fault && fault.kind === "engine";
}

export const UNLOADED: Fault = { kind: "engine", message: "The engine did not load. The connection may be down." };

export function faultOfLoading(why: string): Fault {
  return { kind: "engine", message: `The engine did not load: ${why}.` };
}

export function faultOfSilence(silent_s: number): Fault {
  return { kind: "engine", message: `The engine gave no answer for ${silent_s} s.` };
}

export function faultOfBreakdown(why: string): Fault {
  return { kind: "engine", message: `The engine broke down: ${why}.` };
}

/** A file that may well be there, but did not come. */
export function faultOfNetwork(url: string, why: string): Fault {
  return { kind: "network", message: `${url.slice(url.lastIndexOf("/") + 1)} could not be fetched: ${why}.` };
}
