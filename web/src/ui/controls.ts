import type { Session } from "../app/session";
import type { ParameterInfo } from "../engine/engine";
import { checkbox, choice, number } from "./items";
import type { Item } from "./items";
import { byId, make } from "./dom";

/** The controls of the scenario's parameters: switches together, then choices, then numbers. */
export class Controls {
  private readonly form = byId<HTMLFormElement>("parameters");
  private items: Item[] = [];

  constructor(private readonly session: Session) {
    this.form.addEventListener("submit", (event) => event.preventDefault());
    session.listen({
      opened: (run, _frame, isAnother) => isAnother && this.build(run.model.parameters),
      valuesChanged: () => this.show(),
    });
  }

  private build(parameters: ParameterInfo[]): void {
    const made = parameters.map((parameter) => ({ kind: parameter.kind, item: this.item(parameter) }));
    this.items = made.map(({ item }) => item);
    const inputs = (this.session.run?.inputs ?? []).map((input) => this.lever(input.name));
    const of = (kind: ParameterInfo["kind"]) => made.filter((one) => one.kind === kind).map((one) => one.item.element);
    const groups = [
      group("Switches", "group-switches", of("boolean")),
      group("Choices", "group-choices", of("choice")),
      group("Numbers", "group-numbers", of("number")),
      group("Levers", "group-numbers", inputs),
    ];
    this.form.replaceChildren(...groups.filter((one) => one !== null));
    if (this.items.length + inputs.length === 0) {
      this.form.append(make("p", { class: "muted" }, "This scenario has no parameters."));
    }
    this.show();
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
  private lever(name: string): HTMLElement {
    const input = this.session.run!.inputs.find((one) => one.name === name)!;
    const range: [number, number] = [input.lower, input.upper];
    const lever = number({ name: `input-${name}`, label: name.replaceAll("_", " "), unit: input.unit, range }, (value) => {
      void this.session.setInput(name, value);
      lever.show(value, false);
    });
    lever.show(input.value, false);
    return lever.element;
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
