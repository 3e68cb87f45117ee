import { isObject } from "../app/objects";
import { language, texts } from "./index";

/**
 * Attributes that hold the key of a text: `data-text="transport.start"` for the content, these for other attributes.
 */
const ATTRIBUTES = { "data-label": "aria-label", "data-title": "title" } as const;

/** Writes the texts into all elements that hold a key, and sets the language of the page. */
export function fillPage(): void {
  document.documentElement.lang = language;
  for (const element of document.querySelectorAll("[data-text]")) element.append(...strong(textOf(element.getAttribute("data-text")!)));
  for (const [key, attribute] of Object.entries(ATTRIBUTES)) {
    for (const element of document.querySelectorAll(`[${key}]`)) element.setAttribute(attribute, textOf(element.getAttribute(key)!));
  }
}

/** Returns the text of a key such as `transport.start`. */
function textOf(key: string): string {
  const found = key.split(".").reduce<unknown>((area, part) => (isObject(area) ? area[part] : undefined), texts);
  if (typeof found !== "string") throw new Error(`the page names no text: ${key}`);
  return found;
}

/** Splits a text into parts; text between double asterisks is bold. */
function strong(text: string): (Node | string)[] {
  return text.split("**").map((part, k) => {
    if (k % 2 === 0) return part;
    const element = document.createElement("strong");
    element.append(part);
    return element;
  });
}
