import type { ParameterInfo, Value } from "../engine/engine";
import { texts } from "../texts";
import { make } from "./dom";

/** A control: its element, and a function that shows its value and whether the value waits for a reset. */
export interface Item {
  name: string;
  element: HTMLElement;
  show(value: Value, pending: boolean): void;
}

type Named = Pick<ParameterInfo, "name" | "label"> & Partial<Pick<ParameterInfo, "live">>;
type Numeric = Named & Pick<ParameterInfo, "unit" | "range">;

export function checkbox({ name, label, live }: Named, set: (value: boolean) => void): Item {
  const input = make("input", { type: "checkbox", id: id(name), "data-testid": `parameter-${name}` });
  const element = make("label", { class: "item item-checkbox", for: id(name) }, input, make("span", {}, label, whenOf(live)));
  input.addEventListener("change", () => set(input.checked));
  return {
    name,
    element,
    show(value, pending) {
      input.checked = value === true;
      mark(element, pending);
    },
  };
}

export function choice({ name, label, live, choices }: Named & Pick<ParameterInfo, "choices">, set: (value: string) => void): Item {
  const options = (choices ?? []).map((one) => make("option", { value: one }, one.replaceAll("_", " ")));
  const select = make("select", { id: id(name), "data-testid": `parameter-${name}` }, ...options);
  const element = make("div", { class: "item item-choice" }, make("label", { for: id(name) }, label, whenOf(live)), select);
  select.addEventListener("change", () => set(select.value));
  return {
    name,
    element,
    show(value, pending) {
      select.value = String(value);
      mark(element, pending);
    },
  };
}

/** Returns a note when a change takes effect; empty for a control that is not a parameter. */
function whenOf(live: boolean | undefined): Node | string {
  if (live === undefined) return "";
  const { live: at_once, restart } = texts.controls;
  return make("span", { class: live ? "item-when item-live" : "item-when item-restart" }, live ? at_once : restart);
}

/** Returns a slider with a field for the number; without a range, only the field. */
export function number({ name, label, live, unit, range }: Numeric, set: (value: number) => void): Item {
  const text = unit ? `${label}, ${unit}` : label;
  const box = make("input", {
    type: "number",
    id: id(name),
    step: "any",
    inputmode: "decimal",
    "data-testid": `parameter-${name}`,
  });
  const head = make("div", { class: "item-head" }, make("label", { for: id(name) }, text, whenOf(live)), box);
  const element = make("div", { class: "item item-number" }, head);
  const slider = range && sliderFor(name, text, range);
  if (slider && range) {
    const [low, high] = range.map((end) => make("span", { class: "slider-end", "aria-hidden": "true" }, inShort(end).replace("-", "−")));
    element.append(make("div", { class: "slider" }, low, slider, high));
    slider.addEventListener("input", () => set(slider.valueAsNumber));
  }
  let shown = "";
  box.addEventListener("change", () => {
    if (Number.isFinite(box.valueAsNumber)) set(box.valueAsNumber);
    // If the field has no valid number, it shows the present value again.
    else box.value = shown;
  });
  return {
    name,
    element,
    show(value, pending) {
      box.value = shown = typeof value === "number" ? withoutRounding(value) : String(value);
      if (slider) slider.value = String(value);
      mark(element, pending);
    },
  };
}

function inShort(value: number): string {
  return String(Number(value.toPrecision(4)));
}

/** Returns the number of degrees before it was converted to radians and back, without rounding errors. */
export function withoutRounding(value: number): string {
  return String(Number(value.toPrecision(12)));
}

/** Half range of the slider of a position input, rad or m; the field beside the slider takes any number. */
const SLIDER_REACH = 100;

/**
 * Returns the range of an input's slider. The set-point of a position has no real bounds: they are plus and minus a
 * million.
 */
export function sliderRange({ unit, lower, upper }: { unit: string; lower: number; upper: number }): [number, number] {
  const isPosition = unit === "rad" || unit === "m";
  return isPosition ? [Math.max(lower, -SLIDER_REACH), Math.min(upper, SLIDER_REACH)] : [lower, upper];
}

function sliderFor(name: string, text: string, [lower, upper]: [number, number]): HTMLInputElement {
  return make("input", {
    type: "range",
    min: lower,
    max: upper,
    step: sliderStep(lower, upper),
    "aria-label": texts.controls.slider(text),
    "data-testid": `slider-${name}`,
  });
}

/** Returns a round step (1, 2 or 5 times a power of ten) that divides a slider into 100 to 250 steps. */
export function sliderStep(lower: number, upper: number): number {
  const finest = (upper - lower) / 250;
  if (!(finest > 0) || !Number.isFinite(finest)) return 1;
  const power = Math.floor(Math.log10(finest) + 1e-9);
  const round = [1, 2, 5, 10].find((factor) => factor * 10 ** power >= finest * (1 - 1e-9)) ?? 10;
  return Number((round * 10 ** power).toPrecision(3));
}

function mark(element: HTMLElement, pending: boolean): void {
  element.classList.toggle("is-pending", pending);
}

function id(name: string): string {
  return `parameter-${name.replaceAll(".", "-")}`;
}
