import { isObject } from "../app/objects";
import { AXES } from "./axes";
import type { Place, Places } from "./axes";

const PLACES_KEY = "kingpost.levers.";
const HIDDEN_KEY = "kingpost.levers_hidden";

/** Returns the inputs that the user has chosen for the axes in this scenario; null for the default of the model. */
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

/** Choices on this page, if storage is denied. */
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

/** Reads stored choices, which another version of the page may have written. */
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
