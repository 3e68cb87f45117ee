import type { Value, Values } from "../engine/engine";

/** Request in an address: a scenario of the gallery, and values that override those of its file. */
export interface Asked {
  scenario: string | null;
  values: Values;
}

/** Part after the `#` of an address that holds a whole run; other parts may stand before or after it. */
const RUN = /[#&]k\d+=/;

/** Whether the part after the `#` holds a run, written by this version of the app or by another. */
export function holdsRun(hash: string): boolean {
  return RUN.test(hash);
}

/** Key of the token with which `kingpost film` asks for a film. */
const FILM = "film";
/** Keys of other parts after the `#`. */
const OTHERS = ["quality", FILM];

/** Returns the token of `kingpost film`; null in all other addresses. */
export function filmToken(hash: string): string | null {
  const token = new URLSearchParams(hash.slice(1)).get(FILM);
  return token !== null && /^[\w-]+$/.test(token) ? token : null;
}

/** Returns the first key after the `#` that this app cannot read; null if there is none. */
export function unknownIn(hash: string): string | null {
  const keys = [...new URLSearchParams(hash.slice(1)).keys()];
  return keys.find((key) => hash.includes(`${key}=`) && !OTHERS.includes(key) && !holdsRun(`#${key}=`)) ?? null;
}

export function askedBy(search: string): Asked {
  const { scenario = null, ...texts } = Object.fromEntries(new URLSearchParams(search));
  return { scenario, values: Object.fromEntries(Object.entries(texts).map(([name, text]) => [name, valueOf(text)])) };
}

/** Returns the query of the address for a scenario with these values; empty if there is no scenario. */
export function queryOf({ scenario, values }: Asked): string {
  if (scenario === null) return "";
  const set = Object.entries(values).map(([name, value]) => [name, String(value)]);
  return `?${new URLSearchParams([["scenario", scenario], ...set])}`;
}

/** Address of the start page, for a server whose bare address opens a scenario. */
export const START = "?gallery";

/**
 * Whether an address leads to the start page: the bare address does, unless the server was started with a scenario to
 * open.
 */
export function asksForStart({ search, hash }: Pick<Location, "search" | "hash">, opening: string | undefined): boolean {
  if (search === START) return true;
  return search === "" && !holdsRun(hash) && opening === undefined;
}

/** Page of a figure, beside the page of the app: servers can allow frames for it alone. */
export const FIGURE_PAGE = "figure.html";
/** Name in the query of the app's page that leads to the figure page. */
const FIGURE = "figure";

/** Returns the address of the figure page for an address of the app's page that asks for it; null for any other. */
export function figurePageFor({ search, hash }: Pick<Location, "search" | "hash">): string | null {
  const query = new URLSearchParams(search);
  if (!query.has(FIGURE)) return null;
  query.delete(FIGURE);
  return `${FIGURE_PAGE}?${query}${hash}`;
}

/** Reads a value in an address: a boolean, a number or a text. */
export function valueOf(text: string): Value {
  if (text === "true" || text === "false") return text === "true";
  return text.trim() !== "" && Number.isFinite(Number(text)) ? Number(text) : text;
}
