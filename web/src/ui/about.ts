import type { Session } from "../app/session";
import type { ModelInfo } from "../engine/engine";
import { texts } from "../texts";
import { byId, make, setText } from "./dom";

const DOI = /doi:\s*(10\.\d{4,}\/[^\s,;]*[^\s,;.)])/g;

/** Shows the description of the scenario, with links to its papers. */
export function showAbout(session: Session): void {
  session.listen({
    opened: ({ model }) => {
      // Descriptions in the gallery are in English; the language of others is unknown.
      for (const id of ["about-title", "about-text"]) byId(id).lang = session.source?.gallery === undefined ? "" : "en";
      setText(byId("about-title"), model.title);
      const parts = linked(model.description).map(({ text, href }) => (href ? make("a", { href }, text) : text));
      byId("about-text").replaceChildren(...parts);
      byId("about-elements").replaceChildren(...model.elements.flatMap(acting));
    },
  });
}

/** Returns the entry of a force or a drive, with its facts. */
function acting({ name, kind, enabled, facts }: ModelInfo["elements"][number]): HTMLElement[] {
  const words = facts.map(({ label, value, unit }) => `${label} ${value} ${unit}`.trimEnd()).join(", ");
  const heading = `${name}: ${kind}`;
  return [make("dt", {}, enabled ? heading : texts.about.off(heading)), make("dd", {}, words)];
}

/** Splits a text into parts; each DOI becomes a link. */
export function linked(text: string): { text: string; href?: string }[] {
  const parts: { text: string; href?: string }[] = [];
  let from = 0;
  for (const found of text.matchAll(DOI)) {
    parts.push({ text: text.slice(from, found.index) }, { text: found[0], href: `https://doi.org/${found[1]}` });
    from = found.index + found[0].length;
  }
  return [...parts, { text: text.slice(from) }];
}
