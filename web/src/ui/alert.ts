import type { Fault } from "../engine/engine";
import type { Session } from "../app/session";
import { byId, make } from "./dom";

/** Shows what went wrong until it is dismissed or something opens; the app runs on. */
export function showFaults(session: Session): void {
  const region = byId("alert");
  session.listen({
    faulted(fault) {
      if (!fault) return region.replaceChildren();
      const close = make("button", { type: "button", class: "button alert-close", "aria-label": "Dismiss" }, "×");
      close.addEventListener("click", () => session.dismissFault());
      region.replaceChildren(make("div", { class: "alert-box" }, make("div", { class: "alert-text" }, ...lines(fault)), close));
    },
  });
}

const HEADINGS: Record<string, string> = {
  scenario: "This scenario does not read",
  database: "That is no scenario",
  file: "That file is too large",
  diverged: "The run diverged",
  singular_loop: "A closed loop is at a dead centre",
  open_loop: "A closed loop does not close",
  rope_constraint: "A constraint cannot hold",
  step: "The integrator cannot go on",
  input: "That value is not allowed",
  engine: "There is no engine",
  restarted: "The engine was started again",
  network: "A file did not come",
  page: "A part of the page failed",
  address: "The address has a value that is not allowed",
  operation: "The operation cannot go on",
  saved: "Saved, but a run of the file differs",
  link: "This link does not open",
  followed: "A change of the link cannot be made again",
  unsaved: "The scenario cannot be saved",
};

function lines(fault: Fault): HTMLElement[] {
  const heading = make("p", { class: "alert-heading" }, HEADINGS[fault.kind] ?? "Something went wrong");
  const message = make("p", { class: "alert-message", "data-testid": "alert-message" }, fault.message);
  const words = [heading, message, ...advice(fault).map((text) => make("p", {}, text))];
  const details = facts(fault).map(([name, value]) => make("div", {}, make("dt", {}, name), make("dd", {}, value)));
  return details.length > 0 ? [...words, make("dl", {}, ...details)] : words;
}

/** What to do here about what the engine cannot know of. */
function advice({ field, found }: Fault): string[] {
  if (!found?.startsWith("no file ")) return [];
  const what = field?.endsWith(".database") ? "its database" : "the file that it names";
  return [`Open the scenario and ${what} together: choose both files, or drop both here.`];
}

/** The parts of a fault that are there, one by one: a long message is hard to take apart on a phone. */
function facts(fault: Fault): [string, string][] {
  const place = [fault.file, fault.line, fault.column].filter((part) => part !== undefined && part !== "").join(":");
  const pairs: [string, string | undefined][] = [
    ["Place", place],
    ["Field", fault.field],
    ["Found", fault.found],
    ["Allowed", fault.allowed],
    ["Time", fault.time_s === undefined ? undefined : `${Number(fault.time_s.toPrecision(6))} s`],
    ["Body", fault.body],
  ];
  return pairs.filter((pair): pair is [string, string] => pair[1] !== undefined && pair[1] !== "");
}
