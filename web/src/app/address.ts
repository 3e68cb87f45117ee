import type { Value, Values } from "../engine/engine";

/** What an address asks for: a scenario of the gallery, and values over those of its file. */
export interface Asked {
  scenario: string | null;
  values: Values;
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

function valueOf(text: string): Value {
  if (text === "true" || text === "false") return text === "true";
  return text.trim() !== "" && Number.isFinite(Number(text)) ? Number(text) : text;
}
