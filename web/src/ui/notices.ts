import { texts } from "../texts";
import { byId, make } from "./dom";

/** Shows a notice until the user dismisses it, at most one of each kind; returns a function that closes it. */
export function notice(kind: string, heading: string, says: readonly string[], buttons: readonly HTMLElement[] = []): () => void {
  const region = byId("notices");
  const dismiss = make("button", { type: "button", class: "button alert-close", "aria-label": texts.warnings.dismiss }, "×");
  const head = make("p", { class: "alert-heading" }, heading);
  const text = make("div", { class: "alert-text" }, head, ...says.map((line) => make("p", {}, line)), ...buttons);
  const box = make("div", { class: "alert-box", "data-kind": kind, "data-testid": `notice-${kind}` }, text, dismiss);
  dismiss.addEventListener("click", () => box.remove());
  region.querySelector(`[data-kind="${kind}"]`)?.remove();
  region.append(box);
  return () => box.remove();
}
