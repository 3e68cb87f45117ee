import type { Session } from "../app/session";
import type { Warning } from "../engine/engine";
import { texts } from "../texts";
import { byId, make, setText } from "./dom";

/** Shows the engine's warnings of a run, each until the user dismisses it or another run begins. */
export function showWarnings(session: Session): void {
  const region = byId("run-warnings");
  let shown = "";
  let dismissed = 0;
  const show = (warnings: readonly Warning[]): void => {
    const left = warnings.length > dismissed ? warnings : [];
    const said = left.map(({ name, text }) => `${name}: ${text}`);
    if (said.join("\n") === shown) return;
    shown = said.join("\n");
    if (said.length === 0) return region.replaceChildren();
    const close = make("button", { type: "button", class: "button alert-close", "aria-label": texts.warnings.dismiss }, "×");
    close.addEventListener("click", () => {
      dismissed = warnings.length;
      show(warnings);
    });
    const heading = make("p", { class: "alert-heading" }, texts.warnings.title(said.length));
    const words = make("div", { class: "alert-text" }, heading, ...said.map((text) => make("p", { lang: "en" }, text)));
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

/** Shows the engine's warnings about the model, from before the run. */
export function showModelWarnings(session: Session): void {
  const region = byId("model-warnings");
  session.listen({
    opened: ({ model }) => {
      region.hidden = model.warnings.length === 0;
      setText(region.querySelector("summary")!, texts.warnings.of_model(model.warnings.length));
      region.querySelector("ul")!.replaceChildren(...model.warnings.map((warning) => make("li", {}, warning)));
    },
  });
}
