import { FORM_NAMES, formName, INTEGRATOR_NAMES, integratorName } from "../app/format";
import type { Session } from "../app/session";
import { texts } from "../texts";
import { byId } from "./dom";
import { choice, number } from "./items";
import type { Item } from "./items";
import { languageChoice } from "./language";

const { labels } = texts.settings;

/** The advanced settings, which are fields of the scenario: integrator, form of the equations and step size. */
export class Settings {
  private readonly items: Item[];

  constructor(private readonly session: Session) {
    this.items = [
      this.named("simulation.integrator", INTEGRATOR_NAMES, integratorName),
      this.named("simulation.form", FORM_NAMES, formName),
      number({ name: "simulation.step_s", label: labels["simulation.step_s"], unit: "s", range: null }, (value) =>
        session.set("simulation.step_s", value),
      ),
    ];
    const form = byId("settings", HTMLFormElement);
    form.addEventListener("submit", (event) => event.preventDefault());
    form.append(...this.items.map((item) => item.element), languageChoice("language-setting"));
    session.listen({ valuesChanged: () => this.show() });
  }

  private named(path: string, choices: string[], nameOf: (choice: string) => string): Item {
    const item = choice({ name: path, label: labels[path], choices }, (value) => this.session.set(path, value));
    for (const option of item.element.querySelectorAll("option")) option.textContent = nameOf(option.value);
    return item;
  }

  private show(): void {
    const pending = new Set(this.session.status === "idle" ? [] : this.session.pending());
    for (const item of this.items) {
      const value = this.session.value(item.name);
      if (value !== undefined) item.show(value, pending.has(item.name));
    }
  }
}
