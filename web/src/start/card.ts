import { openingOf } from "../app/opening";
import { queryOf } from "../app/address";
import { firstSentence } from "../app/gallery";
import type { GalleryEntry } from "../app/gallery";
import { make } from "../ui/dom";

/** Size of a card's picture, pixels; it is reserved before the picture is loaded. */
export const PICTURE = { width: 480, height: 300 };

/** Returns a link that opens a scenario: its picture, its title and the first sentence of its description. */
export function cardOf(entry: GalleryEntry): HTMLAnchorElement {
  const words = [make("h3", { lang: "en" }, entry.title), make("p", { lang: "en" }, firstSentence(entry.description))];
  return make("a", { class: "card", href: addressOf(entry.name), "data-testid": `card-${entry.name}` }, pictureOf(entry), ...words);
}

export function addressOf(name: string): string {
  return queryOf(openingOf(name));
}

/** Returns the picture of a scenario; a user's own file has none. */
function pictureOf({ name, group }: GalleryEntry): HTMLElement {
  if (!group) return make("span", { class: "card-picture" });
  return make("img", { class: "card-picture", loading: "lazy", src: `./cards/${name}.webp`, alt: "", ...PICTURE });
}
