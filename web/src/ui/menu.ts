import { make } from "./dom";

/** Returns a button that opens a small panel beneath it; Escape, or a press outside, closes the panel. */
export function menuOf(element: HTMLDetailsElement, title: string, icon: string, ...parts: HTMLElement[]): void {
  const summary = make("summary", { class: "button button-quiet" });
  summary.innerHTML = `<svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><path d="${icon}" /></svg>`;
  summary.append(title);
  const panel = make("div", { class: "menu-panel" }, ...parts);
  element.replaceChildren(summary, panel);
  listenOnce(element, panel);
}

/** Distance of the panel from the bottom of its container, pixels. */
const FOOT_PX = 8;

/** Fits the panel to the available height; the listeners are added only once, even if the menu is filled again. */
function listenOnce(element: HTMLDetailsElement, panel: HTMLElement): void {
  element.ontoggle = () => {
    const room = element.closest("section")?.getBoundingClientRect();
    if (element.open && room) panel.style.maxHeight = `${room.bottom - panel.getBoundingClientRect().top - FOOT_PX}px`;
  };
  if (element.dataset.hears) return;
  element.dataset.hears = "true";
  element.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !element.open) return;
    element.open = false;
    element.querySelector("summary")!.focus();
  });
  document.addEventListener("pointerdown", ({ target }) => {
    if (!(target instanceof Node && element.contains(target))) element.open = false;
  });
}

export interface Choice<Name extends string> {
  name: Name;
  label: string;
}

/** Returns a choice as radio buttons. */
export function oneOf<Name extends string>(
  group: string,
  legend: string,
  choices: readonly Choice<Name>[],
  chosen: Name,
  choose: (name: Name) => void,
): HTMLElement {
  const items = choices.map(({ name, label }) => {
    const input = make("input", { type: "radio", name: group, value: name, checked: name === chosen, "data-testid": `${group}-${name}` });
    input.addEventListener("change", () => choose(name));
    const item = make("label", { class: "menu-item" }, input, make("span", {}, label));
    // A press closes the menu; arrow keys, which go through the choices, do not.
    item.addEventListener("click", ({ detail }) => detail > 0 && item.closest("details")?.removeAttribute("open"));
    return item;
  });
  return make("fieldset", {}, make("legend", { class: "visually-hidden" }, legend), ...items);
}

/** Returns a switch. */
export function tick(testId: string, label: string, isOn: boolean, set: (isOn: boolean) => void): HTMLElement {
  const input = make("input", { type: "checkbox", checked: isOn, "data-testid": testId });
  input.addEventListener("change", () => set(input.checked));
  return make("label", { class: "menu-item" }, input, make("span", {}, label));
}
