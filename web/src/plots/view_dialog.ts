import { texts } from "../texts";
import { make } from "../ui/dom";
import type { Angle } from "./units";
import type { PlotsView } from "./view";
import { FOLLOWING, LAST_S } from "./window";
import type { WindowChoice } from "./window";

/** Dialog for the settings of all plots: the visible time and the unit of angles. */
export class ViewDialog {
  private readonly dialog = make("dialog", { class: "picker picker-small", "aria-label": texts.plots.view_title, "data-testid": "view-dialog" });
  private readonly window = make("select", { "data-testid": "plot-window" });
  private readonly from = make("input", { type: "number", min: 0, step: "any", "data-testid": "window-from" });
  private readonly to = make("input", { type: "number", min: 0, step: "any", "data-testid": "window-to" });
  private readonly ends = make("div", { class: "picker-fields" });
  private readonly angles: HTMLButtonElement[];
  private view: PlotsView | null = null;
  private inSight: () => [number, number] = () => [0, 1];

  constructor(
    private readonly changed: () => void,
    private readonly reset: () => void,
  ) {
    const words = texts.plots.windows;
    const options: [string, string][] = [["follow", words.follow], ["all", words.all], ...LAST_S.map((length_s): [string, string] => [`last ${length_s}`, words.last(length_s)]), ["between", words.between]];
    for (const [value, text] of options) this.window.append(make("option", { value }, text));
    this.window.addEventListener("change", () => this.choose());
    for (const input of [this.from, this.to]) input.addEventListener("change", () => this.setBetween());
    this.angles = (["deg", "rad"] as const).map((angle) => this.angle(angle));
    this.ends.append(make("label", { class: "picker-field" }, texts.plots.from, this.from), make("label", { class: "picker-field" }, texts.plots.to, this.to));
    const angles = make("div", { class: "picker-field" }, make("span", {}, texts.plots.angles), make("div", { class: "segmented", role: "group", "aria-label": texts.plots.angles }, ...this.angles));
    const field = make("label", { class: "picker-field" }, texts.plots.window, this.window);
    const help = make("p", { class: "muted" }, texts.plots.drag);
    this.dialog.append(make("form", { method: "dialog" }, make("h2", {}, texts.plots.view_title), field, this.ends, help, angles, this.buttons()));
    this.dialog.addEventListener("click", (event) => event.target === this.dialog && this.dialog.close());
    document.body.append(this.dialog);
  }

  private buttons(): HTMLElement {
    const reset = make("button", { type: "button", class: "button", "data-testid": "default-plots" }, texts.plots.default_view);
    reset.addEventListener("click", () => {
      this.dialog.close();
      this.reset();
    });
    return make("div", { class: "picker-buttons" }, reset, make("button", { class: "button button-primary", "data-testid": "view-done" }, texts.plots.done));
  }

  private angle(angle: Angle): HTMLButtonElement {
    const button = make("button", { type: "button", "data-testid": `unit-${angle}` }, texts.plots.angle[angle]);
    button.addEventListener("click", () => {
      this.view!.angle = angle;
      this.tell();
    });
    return button;
  }

  open(view: PlotsView, inSight: () => [number, number]): void {
    this.view = view;
    this.inSight = inSight;
    this.show();
    this.dialog.showModal();
  }

  private show(): void {
    const { window, angle } = this.view!;
    this.window.value = window.kind === "last" ? `last ${window.length_s}` : window.kind;
    this.ends.hidden = window.kind !== "between";
    if (window.kind === "between") [this.from.value, this.to.value] = [window.from_s, window.to_s].map((one) => String(Number(one.toFixed(3))));
    this.angles.forEach((button, i) => button.setAttribute("aria-pressed", String((i === 0 ? "deg" : "rad") === angle)));
  }

  private choose(): void {
    const [kind, length] = this.window.value.split(" ");
    const choices: Record<string, () => WindowChoice> = {
      follow: () => FOLLOWING,
      all: () => ({ kind: "all" }),
      last: () => ({ kind: "last", length_s: Number(length) }),
      between: () => between(...this.inSight()),
    };
    this.view!.window = choices[kind]();
    this.tell();
  }

  /** Sets a fixed range of time; if its ends are in the wrong order, they are swapped. */
  private setBetween(): void {
    const [from_s, to_s] = [this.from.valueAsNumber, this.to.valueAsNumber];
    if (Number.isFinite(from_s) && Number.isFinite(to_s) && from_s !== to_s) this.view!.window = between(Math.min(from_s, to_s), Math.max(from_s, to_s));
    this.tell();
  }

  private tell(): void {
    this.changed();
    this.show();
  }
}

export function between(from_s: number, to_s: number): WindowChoice {
  return { kind: "between", from_s, to_s };
}
