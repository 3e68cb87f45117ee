import type { Value, Values } from "../engine/engine";

/** The request in an address: a scenario of the gallery, and values that override its file. */
export interface Asked {
  scenario: string | null;
  values: Values;
}

/** The part after the `#` of an address that holds a whole run, possibly with other parts. */
const RUN = /[#&]k\d+=/;

/** Whether it holds a run, from this version of the app or another. */
export function holdsRun(hash: string): boolean {
  return RUN.test(hash);
}

export function askedBy(search: string): Asked {
  const { scenario = null, ...texts } = Object.fromEntries(new URLSearchParams(search));
  return { scenario, values: Object.fromEntries(Object.entries(texts).map(([name, text]) => [name, valueOf(text)])) };
}

/** The query that asks for a scenario with these values; empty for none. */
export function queryOf({ scenario, values }: Asked): string {
  if (scenario === null) return "";
  const set = Object.entries(values).map(([name, value]) => [name, String(value)]);
  return `?${new URLSearchParams([["scenario", scenario], ...set])}`;
}

/** The start page's address if the bare address opens a scenario. */
export const START = "?gallery";

/** Whether an address asks for the start page: the bare one does, unless the server was started with a scenario to open. */
export function asksForStart({ search, hash }: Pick<Location, "search" | "hash">, opening: string | undefined): boolean {
  if (search === START) return true;
  return search === "" && !holdsRun(hash) && opening === undefined;
}

function valueOf(text: string): Value {
  if (text === "true" || text === "false") return text === "true";
  return text.trim() !== "" && Number.isFinite(Number(text)) ? Number(text) : text;
}
