import type { Session } from "../app/session";
import type { InputInfo, ParameterInfo } from "../engine/engine";
import { checkbox, choice, number, sliderRange } from "./items";
import type { Item } from "./items";
import { byId, make } from "./dom";

/** The controls of the scenario's parameters: switches together, then choices, then numbers. */
export class Controls {
  private readonly form = byId<HTMLFormElement>("parameters");
  private readonly levers = make("div", { id: "levers" });
  private items: Item[] = [];
  private inputs: Item[] = [];

  constructor(private readonly session: Session) {
    this.form.addEventListener("submit", (event) => event.preventDefault());
    session.listen({
      opened: (run, _frame, isAnother) => (isAnother ? this.build(run.model.parameters) : this.showLevers()),
      valuesChanged: () => this.show(),
      branched: (run) => this.showInputs(run.inputs),
      followed: (run) => this.showInputs(run.inputs),
    });
  }

  private build(parameters: ParameterInfo[]): void {
    const made = parameters.map((parameter) => ({ kind: parameter.kind, item: this.item(parameter) }));
    this.items = made.map(({ item }) => item);
    const of = (kind: ParameterInfo["kind"]) => made.filter((one) => one.kind === kind).map((one) => one.item.element);
    const groups = [
      group("Switches", "group-switches", of("boolean")),
      group("Choices", "group-choices", of("choice")),
      group("Numbers", "group-numbers", of("number")),
    ];
    this.form.replaceChildren(...groups.filter((one) => one !== null), this.levers);
    this.showLevers();
    if (this.items.length + this.levers.childElementCount === 0) {
      this.form.append(make("p", { class: "muted" }, "This scenario has no parameters."));
    }
    this.show();
  }

  /** A lever for each input that a hand sets, and what sets the others. */
  private showLevers(): void {
    const inputs = this.session.run?.inputs ?? [];
    this.inputs = inputs.filter((input) => !input.signal).map(({ name }) => this.lever(name));
    const free = group("Levers", "group-numbers", this.inputs.map(({ element }) => element));
    const taken = inputs.filter((input) => input.signal);
    const words = taken.map((input) => `${input.name.replaceAll("_", " ")} by ${input.signal}`).join(", ");
    const note = taken.length > 0 ? make("p", { class: "muted" }, `Set by the scenario: ${words}.`) : null;
    const kept = free ? make("p", { class: "muted" }, "Save scenario keeps the lever moves as an operation.") : null;
    this.levers.replaceChildren(...[free, kept, note].filter((one) => one !== null));
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

  /** A lever acts at once, at any time. */
  private lever(name: string): Item {
    const input = this.session.run!.inputs.find((one) => one.name === name)!;
    const range = sliderRange(input);
    const lever = number({ name: `input-${name}`, label: name.replaceAll("_", " "), unit: input.unit, range }, (value) => {
      void this.session.setInput(name, value);
      lever.show(value, false);
    });
    lever.show(input.value, false);
    return lever;
  }

  /** Where the run branches levers are as they were; one in a hand is as the hand has it. */
  private showInputs(inputs: readonly InputInfo[]): void {
    for (const { name, element, show } of this.inputs) {
      const input = inputs.find((one) => `input-${one.name}` === name);
      if (input && !element.contains(document.activeElement)) show(input.value, false);
    }
  }

  private show(): void {
    const pending = new Set(this.session.status === "idle" ? [] : this.session.pending());
    for (const item of this.items) {
      const value = this.session.value(item.name);
      if (value !== undefined) item.show(value, pending.has(item.name));
    }
  }
}

function group(name: string, kind: string, elements: HTMLElement[]): HTMLElement | null {
  if (elements.length === 0) return null;
  return make("fieldset", { class: `group ${kind}` }, make("legend", { class: "visually-hidden" }, name), ...elements);
}
