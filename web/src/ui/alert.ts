import type { Fault } from "../engine/engine";
import type { Session } from "../app/session";
import { isInEnglish } from "../engine/faults";
import { language, texts } from "../texts";
import { byId, make } from "./dom";

/** Shows a fault until the user dismisses it or a scenario opens; the app continues to run. */
export function showFaults(session: Session): void {
  const region = byId("alert");
  session.listen({
    faulted(fault) {
      if (!fault) return region.replaceChildren();
      const close = make("button", { type: "button", class: "button alert-close", "aria-label": texts.warnings.dismiss }, "×");
      close.addEventListener("click", () => session.dismissFault());
      region.replaceChildren(make("div", { class: "alert-box" }, make("div", { class: "alert-text" }, ...lines(fault)), close));
    },
  });
}

function lines(fault: Fault): HTMLElement[] {
  const { headings, other } = texts.alert;
  const heading = make("p", { class: "alert-heading" }, headings[fault.kind] ?? other);
  const says = isInEnglish(fault) ? make("span", { lang: "en" }, fault.message) : fault.message;
  const message = make("p", { class: "alert-message", "data-testid": "alert-message" }, says, fault.note ? ` ${fault.note}` : "");
  const words = [heading, message, ...advice(fault).map((text) => make("p", {}, text))];
  const details = facts(fault).map(([name, value]) => make("div", {}, make("dt", { lang: language }, name), make("dd", {}, value)));
  return details.length > 0 ? [...words, make("dl", { lang: "en" }, ...details)] : words;
}

/** Returns the page's advice for faults whose message has none. */
function advice({ field, found }: Fault): string[] {
  if (!found?.startsWith("no file ")) return [];
  return [field?.endsWith(".database") ? texts.alert.its_database : texts.alert.its_file];
}

/** Returns the parts of a fault for a list: a long message is hard to read on a phone. */
function facts(fault: Fault): [string, string][] {
  const place = [fault.file, fault.line, fault.column].filter((part) => part !== undefined && part !== "").join(":");
  const words = texts.alert.facts;
  const pairs: [string, string | undefined][] = [
    [words.place, place],
    [words.field, fault.field],
    [words.found, fault.found],
    [words.allowed, fault.allowed],
    [words.time, fault.time_s === undefined ? undefined : `${Number(fault.time_s.toPrecision(6))} s`],
    [words.body, fault.body],
  ];
  return pairs.filter((pair): pair is [string, string] => pair[1] !== undefined && pair[1] !== "");
}
