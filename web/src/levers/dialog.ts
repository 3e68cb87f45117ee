import type { InputInfo } from "../engine/engine";
import { texts } from "../texts";
import { make } from "../ui/dom";
import { AXES } from "./axes";
import type { Axis, Places } from "./axes";

/**
 * Asks the user for the input of each axis of the sticks; `choose` gets every choice, or null for the default of the
 * model.
 */
export function askForPlaces(inputs: readonly InputInfo[], places: Places, choose: (places: Places | null) => Places): void {
  const dialog = make("dialog", { class: "axes-dialog", "aria-labelledby": "axes-title" });
  const rows = make("div", { class: "axes-rows" });
  const show = (now: Places): void => {
    const pick = (next: Places) => show(choose(next));
    const focus = document.activeElement?.id;
    rows.replaceChildren(...AXES.map((axis) => rowOf(axis, inputs, now, pick)));
    if (focus && rows.querySelector(`#${focus}`)) rows.querySelector<HTMLElement>(`#${focus}`)!.focus();
  };
  const standard = make("button", { type: "button", class: "button", "data-testid": "axes-standard" }, texts.levers.standard);
  standard.addEventListener("click", () => show(choose(null)));
  const close = make("button", { type: "button", class: "button button-primary", "data-testid": "axes-close" }, texts.levers.close);
  close.addEventListener("click", () => dialog.close());
  dialog.append(make("h2", { id: "axes-title" }, texts.levers.axes_title), rows, make("div", { class: "axes-buttons" }, standard, close));
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  show(places);
  dialog.showModal();
}

function rowOf(axis: Axis, inputs: readonly InputInfo[], places: Places, pick: (places: Places) => void): HTMLElement {
  const place = places[axis];
  const options = inputs.map(({ name }) => make("option", { value: name, selected: name === place?.input }, name.replaceAll("_", " ")));
  const select = make("select", { id: `axis-${axis}`, "data-testid": `axis-${axis}` }, make("option", { value: "" }, texts.levers.none), ...options);
  select.addEventListener("change", () => pick(placed(places, axis, select.value)));
  const box = make("input", { type: "checkbox", id: `reverse-${axis}`, checked: place?.reversed ?? false, disabled: !place, "data-testid": `reverse-${axis}` });
  box.addEventListener("change", () => place && pick({ ...places, [axis]: { ...place, reversed: box.checked } }));
  const reverse = make("label", { class: "item item-checkbox", for: `reverse-${axis}` }, box, make("span", {}, texts.levers.reverse));
  return make("div", { class: "axes-row" }, make("label", { for: `axis-${axis}` }, texts.levers.axes[axis]), select, reverse);
}

/** Assigns an input to an axis. An input has only one axis: it leaves its previous axis and keeps its direction. */
export function placed(places: Places, axis: Axis, input: string): Places {
  const held = Object.values(places).find((place) => place?.input === input);
  const others = Object.entries(places).filter(([name, place]) => name !== axis && place && place.input !== input);
  return { ...Object.fromEntries(others), ...(input && { [axis]: { input, reversed: held?.reversed ?? false } }) };
}
