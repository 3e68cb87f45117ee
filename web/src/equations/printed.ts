import forms from "../../../python/kingpost/paper/equations.json";
import type { Equations } from "../engine/engine";
import { texts } from "../texts";
import { make } from "../ui/dom";
import { showFormula } from "./formula";

/** Block row of B in eq. 46b, and its columns: the velocity of the arm's centre. */
const ROW = 4;
const COLUMNS = [0, 1, 2, 3];

/**
 * Equations of the paper that contain an error, as printed and corrected, for a crane with a slewing and a luffing
 * body.
 */
export class PrintedForms {
  readonly element: HTMLElement;
  private readonly choice = make("select", { "aria-label": texts.equations.printed, "data-testid": "printed" });
  private readonly list = make("div", { class: "printed-forms", tabindex: 0, role: "region", "aria-label": texts.equations.printed });

  constructor() {
    for (const [value, text] of Object.entries(texts.equations.forms)) this.choice.append(make("option", { value }, text));
    this.element = make("section", { class: "printed", hidden: true }, make("h3", {}, texts.equations.printed), this.choice, this.list, make("p", { class: "muted" }, texts.equations.printed_help));
    this.choice.addEventListener("change", () => this.draw());
    this.draw();
  }

  show({ formulas }: Equations): void {
    const b = formulas.find(({ name }) => name === "B");
    const isOfPaper = COLUMNS.every((column) => (b?.blocks[ROW]?.[column] ?? "0") !== "0");
    this.element.hidden = !isOfPaper;
  }

  private draw(): void {
    const which = this.choice.value as "printed" | "corrected";
    const lines = Object.values(forms).flatMap((form) => form[which]);
    this.list.replaceChildren(...lines.map((latex) => shown(latex)));
  }
}

function shown(latex: string): HTMLElement {
  const line = make("p", {});
  void showFormula(line, latex);
  return line;
}
