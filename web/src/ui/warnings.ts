import type { Session } from "../app/session";
import type { Warning } from "../engine/engine";
import { byId, make } from "./dom";

/** Shows what the engine warns of in a run, each until it is dismissed or another run begins. */
export function showWarnings(session: Session): void {
  const region = byId("run-warnings");
  let shown = "";
  let dismissed = 0;
  const show = (warnings: readonly Warning[]): void => {
    const left = warnings.length > dismissed ? warnings : [];
    const texts = left.map(({ name, text }) => `${name}: ${text}`);
    if (texts.join("\n") === shown) return;
    shown = texts.join("\n");
    if (texts.length === 0) return region.replaceChildren();
    const close = make("button", { type: "button", class: "button alert-close", "aria-label": "Dismiss" }, "×");
    close.addEventListener("click", () => {
      dismissed = warnings.length;
      show(warnings);
    });
    const heading = make("p", { class: "alert-heading" }, texts.length > 1 ? `${texts.length} warnings` : "Warning");
    const words = make("div", { class: "alert-text" }, heading, ...texts.map((text) => make("p", {}, text)));
    region.replaceChildren(make("div", { class: "alert-box" }, words, close));
  };
  session.listen({
    opened: (_, frame) => {
      dismissed = 0;
      show(frame.warnings);
    },
    advanced: () => show(session.shown.recording?.warnings ?? []),
    branched: () => {
      const warnings = session.shown.recording?.warnings ?? [];
      dismissed = Math.min(dismissed, warnings.length);
      show(warnings);
    },
  });
}
