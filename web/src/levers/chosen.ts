import { isObject } from "../app/objects";
import { AXES } from "./axes";
import type { Place, Places } from "./axes";

const PLACES_KEY = "kingpost.levers.";
const HIDDEN_KEY = "kingpost.levers_hidden";

/** The user's choice of an input for each axis in this scenario; null if the model decides. */
export function chosenPlaces(file: string): Places | null {
  try {
    const text = kept(PLACES_KEY + file);
    return text === null ? null : placesIn(JSON.parse(text));
  } catch {
    return null;
  }
}

export function choosePlaces(file: string, places: Places | null): void {
  keep(PLACES_KEY + file, places && JSON.stringify(places));
}

/** Whether the user has hidden the sticks. */
export function areHidden(): boolean {
  return kept(HIDDEN_KEY) !== null;
}

export function hideSticks(hidden: boolean): void {
  keep(HIDDEN_KEY, hidden ? "yes" : null);
}

/** The setting of this page if storage is denied. */
const here = new Map<string, string>();

function keep(key: string, text: string | null): void {
  try {
    if (text === null) localStorage.removeItem(key);
    else localStorage.setItem(key, text);
  } catch {
    if (text === null) here.delete(key);
    else here.set(key, text);
  }
}

function kept(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return here.get(key) ?? null;
  }
}

/** Reads stored places, which may be of another version of the page. */
function placesIn(stored: unknown): Places {
  const places: Places = {};
  for (const axis of AXES) {
    const place = isObject(stored) ? stored[axis] : null;
    if (isPlace(place)) places[axis] = place;
  }
  return places;
}

function isPlace(stored: unknown): stored is Place {
  return isObject(stored) && typeof stored.input === "string" && typeof stored.reversed === "boolean";
}
