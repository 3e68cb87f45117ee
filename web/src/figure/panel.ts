import type { Session } from "../app/session";
import type { Value } from "../engine/engine";
import { checkbox, choice, number, sliderRange } from "../ui/items";
import type { Item } from "../ui/items";
import { settableIn } from "./player";
import { words } from "./words";

/** The controls of a figure: the parameters and inputs that the author chose, in the order of the choice. */
export class Panel {
  private items: Item[] = [];

  constructor(
    private readonly form: HTMLElement,
    private readonly session: Session,
    private readonly names: readonly string[],
    private readonly set: (name: string, value: Value) => void,
    /** Reports names that the scenario does not have. */
    private readonly refuse: (message: string) => void,
  ) {
    form.addEventListener("submit", (event) => event.preventDefault());
    session.listen({
      opened: (_run, _frame, isAnother) => (isAnother ? this.build() : this.show()),
      valuesChanged: () => this.show(),
      inputsChanged: () => this.show(),
      branched: () => this.show(),
    });
  }

  private build(): void {
    const known = settableIn(this.session).map(({ name }) => name);
    const unknown = this.names.filter((name) => !known.includes(name));
    if (unknown.length > 0) this.refuse(words.unknown(unknown.join(", "), known.join(", ")));
    this.items = this.names.filter((name) => known.includes(name)).map((name) => this.item(name));
    this.form.replaceChildren(...this.items.map(({ element }) => element));
    this.form.hidden = this.items.length === 0;
    this.show();
  }

  private item(name: string): Item {
    const { inputs, model } = this.session.run!;
    const set = (value: Value) => this.set(name, value);
    const input = inputs.find((one) => one.name === name && !one.signal);
    if (input) return number({ name, label: name.replaceAll("_", " "), unit: input.unit === "1" ? "" : input.unit, range: sliderRange(input) }, set);
    const { kind, label, unit, range, choices } = model.parameters.find((one) => one.name === name)!;
    switch (kind) {
      case "boolean":
        return checkbox({ name, label }, set);
      case "choice":
        return choice({ name, label, choices }, set);
      case "number":
        return number({ name, label, unit, range }, set);
    }
  }

  private show(): void {
    const values = new Map(settableIn(this.session).map(({ name, value }) => [name, value]));
    for (const { name, show } of this.items) show(values.get(name) ?? "", false);
  }
}
