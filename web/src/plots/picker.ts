import { texts } from "../texts";
import { make, setText } from "../ui/dom";
import { MOST_LINES } from "./figures";
import type { Figure, Figures } from "./figures";
import { foldPoints, hasWords, inWords, labelOf } from "./lines";
import type { Fold, Line } from "./lines";
import { CHART_KINDS, PARTS } from "./view";
import type { PlotView } from "./view";

/** Functions by which a picker changes its plot. */
export interface Picked {
  place: number;
  view: PlotView;
  figures: Figures;
  hasHulls: boolean;
  changed(): void;
  remove(): void;
}

/** Largest number of groups in the list; a search finds the others. */
const MOST_FIGURES = 12;

/** A dialog to choose the kind of a plot and, with a search, its lines. */
export class Picker {
  private readonly dialog = make("dialog", { class: "picker", "data-testid": "picker" });
  private readonly heading = make("h2");
  private readonly kind = make("select", { "data-testid": "plot-kind" });
  private readonly parts = make("select", { "data-testid": "plot-parts" });
  private readonly smoothing: HTMLElement;
  private readonly lines = make("div", { class: "picker-lines" });
  private readonly chosen = make("ul", { class: "picker-chosen", "aria-label": texts.plots.chosen });
  private readonly search = make("input", { type: "search", placeholder: texts.plots.search_hint, "aria-label": texts.plots.search, "data-testid": "search-lines" });
  private readonly count = make("p", { class: "muted", role: "status" });
  private readonly list = make("div", { class: "picker-list", tabindex: 0, role: "group" });
  private picked: Picked | null = null;

  constructor() {
    for (const value of CHART_KINDS) this.kind.append(make("option", { value }, texts.plots.kinds[value]));
    for (const parts of PARTS) this.parts.append(make("option", { value: parts }, texts.plots.smoothings[parts]));
    const kind = () => CHART_KINDS.find((one) => one === this.kind.value);
    this.kind.addEventListener("change", () => this.change((view) => (view.kind = kind() ?? view.kind)));
    this.parts.addEventListener("change", () => this.change((view) => (view.parts = Number(this.parts.value))));
    this.search.addEventListener("input", () => this.offer());
    this.smoothing = make("label", { class: "picker-field" }, texts.plots.smoothing, this.parts);
    const fields = make("div", { class: "picker-fields" }, make("label", { class: "picker-field" }, texts.plots.kind, this.kind), this.smoothing);
    this.lines.append(this.chosen, this.search, this.count, this.list);
    this.dialog.append(make("form", { method: "dialog" }, this.heading, fields, this.lines, this.buttons()));
    this.dialog.addEventListener("click", (event) => event.target === this.dialog && this.dialog.close());
    // Enter in the search field must not close the dialog.
    this.search.addEventListener("keydown", (event) => event.key === "Enter" && event.preventDefault());
    document.body.append(this.dialog);
  }

  private buttons(): HTMLElement {
    const remove = make("button", { type: "button", class: "button", "data-testid": "remove-plot" }, texts.plots.remove);
    remove.addEventListener("click", () => {
      this.dialog.close();
      this.picked?.remove();
    });
    return make("div", { class: "picker-buttons" }, remove, make("button", { class: "button button-primary", "data-testid": "picker-done" }, texts.plots.done));
  }

  open(picked: Picked): void {
    this.picked = picked;
    const title = texts.plots.plot(picked.place);
    setText(this.heading, title);
    this.dialog.setAttribute("aria-label", title);
    const arms = this.kind.querySelector<HTMLOptionElement>('[value="arms"]')!;
    arms.hidden = arms.disabled = !picked.hasHulls;
    this.search.value = "";
    this.show();
    this.offer();
    this.dialog.showModal();
    // On a phone the keyboard would cover the list.
    if (matchMedia("(pointer: fine)").matches) this.search.focus();
  }

  private change(set: (view: PlotView) => void): void {
    if (!this.picked) return;
    set(this.picked.view);
    this.picked.changed();
    this.show();
  }

  private show(): void {
    const { view, figures } = this.picked!;
    this.kind.value = view.kind;
    this.parts.value = String(view.parts);
    this.smoothing.hidden = view.kind !== "spectrum";
    this.lines.hidden = view.kind === "arms";
    const items = view.lines.map((id) => this.chosenItem(figures.line(id)!));
    const none = make("li", { class: "muted" }, texts.plots.none_chosen);
    this.chosen.replaceChildren(...(items.length > 0 ? items : [none]));
    for (const box of this.list.querySelectorAll<HTMLInputElement>("input")) {
      box.checked = view.lines.includes(box.value);
      box.disabled = !box.checked && view.lines.length >= MOST_LINES;
    }
  }

  private chosenItem(line: Line): HTMLElement {
    const drop = make("button", { type: "button", class: "picker-drop", "aria-label": texts.plots.drop(labelOf(line)) }, labelOf(line), make("span", { "aria-hidden": "true" }, " ×"));
    drop.addEventListener("click", () => {
      this.take(line.id, false);
      this.search.focus();
    });
    return make("li", {}, drop);
  }

  private take(id: string, isTaken: boolean): void {
    this.change((view) => {
      view.lines = view.lines.filter((one) => one !== id);
      if (isTaken) view.lines.push(id);
    });
  }

  /** Lists the lines that match the search. */
  private offer(): void {
    const { figures } = this.picked!;
    const words = this.search.value.trim();
    const found = figures.lines.filter((line) => hasWords(line, words));
    const sets = figures.all.filter(({ title, lines }) => lines.length > 1 && hasWords({ ...lines[0], thing: title, what: "" }, words));
    const shown = words === "" ? sets.slice(0, MOST_FIGURES) : sets;
    const groups = [...new Set(found.map(({ thing }) => thing))].map((thing) => this.group(thing, found.filter((line) => line.thing === thing)));
    this.list.replaceChildren(...(shown.length > 0 ? [this.sets(shown)] : []), ...groups);
    this.list.scrollTop = 0;
    const isFull = this.picked!.view.lines.length >= MOST_LINES;
    setText(this.count, isFull ? texts.plots.most_chosen(MOST_LINES) : texts.plots.found(found.length));
    this.show();
  }

  private sets(sets: readonly Figure[]): HTMLElement {
    const buttons = sets.map(({ title, lines }) => {
      const button = make("button", { type: "button", class: "button picker-set" }, title);
      button.addEventListener("click", () => this.change((view) => (view.lines = lines.map(({ id }) => id))));
      return button;
    });
    return make("fieldset", {}, make("legend", {}, texts.plots.sets), make("div", { class: "picker-sets" }, ...buttons));
  }

  private group(thing: string, lines: readonly Line[]): HTMLElement {
    const items = foldPoints(lines).map((one) => ("lines" in one ? this.fold(one) : this.item(one)));
    return make("fieldset", {}, make("legend", {}, inWords(thing) || texts.plots.whole_model), ...items);
  }

  private item(line: Line): HTMLElement {
    const box = make("input", { type: "checkbox", value: line.id });
    box.addEventListener("change", () => this.take(line.id, box.checked));
    return make("label", { class: "item item-checkbox", title: line.about }, box, make("span", {}, line.what), make("span", { class: "muted picker-unit" }, line.unit));
  }

  /** Lists the points along an element as one entry, which is open if a search finds some of them or one is chosen. */
  private fold({ name, lines }: Fold): HTMLElement {
    const { figures, view } = this.picked!;
    const [{ thing, along, about }] = lines;
    const all = figures.lines.filter((line) => line.thing === thing && line.along === along).length;
    const isOpen = lines.length < all || lines.some(({ id }) => view.lines.includes(id));
    const summary = make("summary", { class: "item", title: about }, texts.plots.points(name, lines.length));
    return make("details", { class: "picker-fold", ...(isOpen ? { open: "" } : {}) }, summary, make("div", { class: "picker-points" }, ...lines.map((line) => this.item(line))));
  }
}
