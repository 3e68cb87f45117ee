import type { Session } from "../app/session";
import type { InputInfo, ParameterInfo } from "../engine/engine";
import { onSticks } from "../levers/axes";
import { namesOf } from "../levers/names";
import { texts } from "../texts";
import { checkbox, choice, number, sliderRange } from "./items";
import type { Item } from "./items";
import { byId, make } from "./dom";

/** Controls of the scenario's parameters: first switches, then choices, then numbers. */
export class Controls {
  private readonly form = byId("parameters", HTMLFormElement);
  private readonly levers = make("div", { id: "levers" });
  private readonly restart = this.restartButton();
  private items: Item[] = [];
  private inputs: Item[] = [];

  constructor(
    private readonly session: Session,
    private readonly chooseAxes: () => void,
  ) {
    this.form.addEventListener("submit", (event) => event.preventDefault());
    session.listen({
      opened: (run, _frame, isAnother) => (isAnother ? this.build(run.model.parameters) : this.showLevers()),
      valuesChanged: () => this.show(),
      branched: (run) => this.showInputs(run.inputs),
      inputsChanged: (run) => this.showInputs(run.inputs),
    });
  }

  private build(parameters: ParameterInfo[]): void {
    const made = parameters.map((parameter) => ({ kind: parameter.kind, item: this.item(parameter) }));
    this.items = made.map(({ item }) => item);
    const of = (kind: ParameterInfo["kind"]) => made.filter((one) => one.kind === kind).map((one) => one.item.element);
    const groups = [
      group(texts.controls.switches, "group-switches", of("boolean")),
      group(texts.controls.choices, "group-choices", of("choice")),
      group(texts.controls.numbers, "group-numbers", of("number")),
    ];
    this.form.replaceChildren(...groups.filter((one) => one !== null), this.levers);
    this.showLevers();
    if (this.items.length + this.levers.childElementCount === 0) {
      this.form.append(make("p", { class: "muted" }, texts.controls.none));
    }
    this.show();
  }

  /** Returns the button that restarts the run; it stands below the last changed control that waits for a restart. */
  private restartButton(): HTMLElement {
    const button = make("button", { type: "button", class: "button is-due", "data-testid": "restart" }, texts.controls.restart_now);
    button.addEventListener("click", () => this.session.restart());
    return button;
  }

  /** Shows a lever for each input that is set by hand, and names the inputs that the scenario sets. */
  private showLevers(): void {
    const inputs = this.session.run?.inputs ?? [];
    this.inputs = inputs.filter((input) => !input.signal).map(({ name }) => this.lever(name));
    const free = group(texts.levers.title, "group-numbers", this.inputs.map(({ element }) => element));
    const taken = inputs.filter((input) => input.signal);
    const words = taken.map((input) => texts.controls.by(input.name.replaceAll("_", " "), String(input.signal))).join(", ");
    const note = taken.length > 0 ? make("p", { class: "muted" }, texts.controls.set_by_scenario(words)) : null;
    const kept = free ? make("p", { class: "muted" }, texts.controls.moves_are_kept) : null;
    this.levers.replaceChildren(...[free, this.axesButton(inputs), kept, note].filter((one) => one !== null));
  }

  private axesButton(inputs: readonly InputInfo[]): HTMLElement | null {
    if (onSticks(inputs).length === 0) return null;
    const button = make("button", { type: "button", class: "button", "data-testid": "choose-axes" }, texts.levers.choose_axes);
    button.addEventListener("click", this.chooseAxes);
    return button;
  }

  private item(parameter: ParameterInfo): Item {
    const set = (value: boolean | number | string) => this.session.set(parameter.name, value);
    switch (parameter.kind) {
      case "boolean":
        return checkbox(parameter, set);
      case "choice":
        return choice(parameter, set);
      case "number":
        return number(parameter, set);
    }
  }

  /** Returns the lever of an input; it acts at once, at any time. */
  private lever(name: string): Item {
    const input = this.session.run!.inputs.find((one) => one.name === name)!;
    const range = sliderRange(input);
    const label = namesOf(this.session.run!.inputs).get(name)!;
    const lever = number({ name: `input-${name}`, label, unit: input.unit === "1" ? "" : input.unit, range }, (value) => {
      void this.session.setInput(name, value);
      lever.show(value, false);
    });
    lever.show(inShort(input.value), false);
    return lever;
  }

  /**
   * Shows the present values of the inputs, also after a branch; a control that the user is editing keeps its value.
   */
  private showInputs(inputs: readonly InputInfo[]): void {
    for (const { name, element, show } of this.inputs) {
      const input = inputs.find((one) => `input-${one.name}` === name);
      if (input && !element.contains(document.activeElement)) show(inShort(input.value), false);
    }
  }

  private show(): void {
    const pending = this.session.status === "idle" ? [] : this.session.pending();
    for (const item of this.items) {
      const value = this.session.value(item.name);
      if (value !== undefined) item.show(value, pending.includes(item.name));
    }
    this.offerRestart(pending);
  }

  private offerRestart(pending: string[]): void {
    if (pending.length === 0) return this.restart.remove();
    const last = pending.map((name) => this.items.find((item) => item.name === name)?.element).filter((element) => element !== undefined).at(-1);
    // If no parameter waits, a numerical setting does.
    if (!last) byId("settings").append(this.restart);
    else if (last.nextElementSibling !== this.restart) last.after(this.restart);
  }
}

/** Rounds a value to four digits: a stick sets many digits, and its control has little space. */
function inShort(value: number): number {
  return Number(value.toPrecision(4));
}

function group(name: string, kind: string, elements: HTMLElement[]): HTMLElement | null {
  if (elements.length === 0) return null;
  return make("fieldset", { class: `group ${kind}` }, make("legend", { class: "visually-hidden" }, name), ...elements);
}
