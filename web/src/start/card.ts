import { openingOf } from "../app/opening";
import { queryOf } from "../app/address";
import { firstSentence } from "../app/gallery";
import type { GalleryEntry } from "../app/gallery";
import { make } from "../ui/dom";

/** Size of a card's picture, px, reserved before it is loaded. */
export const PICTURE = { width: 480, height: 300 };

/** A link that opens a scenario: its picture, its title and a sentence about it. */
export function cardOf(entry: GalleryEntry): HTMLAnchorElement {
  const words = [make("h3", { lang: "en" }, entry.title), make("p", { lang: "en" }, firstSentence(entry.description))];
  return make("a", { class: "card", href: addressOf(entry.name), "data-testid": `card-${entry.name}` }, pictureOf(entry), ...words);
}

export function addressOf(name: string): string {
  return queryOf(openingOf(name));
}

/** A user's own file has none. */
function pictureOf({ name, group }: GalleryEntry): HTMLElement {
  if (!group) return make("span", { class: "card-picture" });
  return make("img", { class: "card-picture", loading: "lazy", src: `./cards/${name}.webp`, alt: "", ...PICTURE });
}
