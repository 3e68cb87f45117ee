import type { BackgroundEngine } from "../app/background_engine";
import type { Run, Session } from "../app/session";
import type { Equations as Found } from "../engine/engine";
import { texts } from "../texts";
import { byId, make, setText } from "../ui/dom";
import { isPanelOpen, offerPanel, onPanelOpened } from "../ui/switcher";
import type { Block, NamedMatrix } from "./blocks";
import { inCell } from "./blocks";
import { showFormula } from "./formula";
import { Ledger } from "./ledger";
import { MatrixTable } from "./matrix_table";
import { bodyFinder } from "./moved";
import { highlightOf } from "./highlight";
import type { Highlight } from "./highlight";
import { Polhode } from "./polhode";
import { PrintedForms } from "./printed";

/** Interval between two updates of the numbers during a run, ms: a person reads no faster. */
const EVERY_MS = 250;
/** Matrix that is shown first: the rates of all bodies follow from it. */
const FIRST = "B";

/** The equations of the method with their numbers at the moment that is shown. */
export class EquationsPanel {
  private readonly panel = byId("equations");
  private readonly choice = make("select", { "aria-label": texts.equations.matrix, "data-testid": "matrix" });
  private readonly notation = make("select", { "aria-label": texts.equations.notation, "data-testid": "notation" });
  private readonly formula = make("p", { class: "matrix-formula", tabindex: 0, role: "region", "aria-label": texts.equations.formula });
  private readonly sheet = make("div", { class: "matrix-sheet", tabindex: 0, role: "region", "aria-label": texts.equations.matrix });
  private readonly detail = make("p", { class: "matrix-detail", role: "status" });
  private readonly ledger = new Ledger();
  private readonly polhode: Polhode;
  private readonly printed = new PrintedForms();
  private table: MatrixTable | null = null;
  private shown = "";
  private block: Block | null = null;
  private found: Found | null = null;
  private isAsking = false;
  private asked_ms = 0;

  constructor(
    private readonly session: Session,
    private readonly background: BackgroundEngine,
    private readonly highlight: (what: Highlight | null) => void,
  ) {
    this.polhode = new Polhode(session);
    for (const [value, text] of Object.entries(texts.equations.notations)) this.notation.append(make("option", { value }, text));
    const tools = make("div", { class: "matrix-tools" }, this.choice, this.notation, this.enlarge());
    const intro = make("p", { class: "muted" }, texts.equations.intro);
    this.panel.append(make("h2", { class: "visually-hidden" }, texts.equations.title), intro, tools, this.formula, this.sheet, this.detail, this.printed.element, this.ledger.element, this.polhode.element);
    this.choice.addEventListener("change", () => this.showFound());
    this.notation.addEventListener("change", () => this.showFound());
    session.listen({
      opened: (run) => this.open(run),
      moved: (run, { row }) => this.isOpen && this.move(run, row),
      branched: () => this.forget(),
    });
    onPanelOpened("equations", () => this.refresh());
  }

  private get isOpen(): boolean {
    return isPanelOpen("equations");
  }

  private open(run: Run): void {
    this.forget();
    this.ledger.begin(this.session.shown.recording!.rows.items[0].row);
    this.polhode.begin(run);
    offerPanel("equations", true);
    if (this.isOpen) this.refresh();
  }

  private refresh(): void {
    const { run, shown } = this.session;
    if (run && shown.moment) this.move(run, shown.moment.row);
  }

  private forget(): void {
    this.shown = "";
    this.touch(null);
  }

  private move(run: Run, row: Float64Array): void {
    this.ledger.show(run, row);
    this.polhode.show();
    void this.ask(run);
  }

  /**
   * Asks for the matrices: one request at a time, at most once per interval. The last request is for the moment that is
   * then shown.
   */
  private async ask(run: Run): Promise<void> {
    if (this.isAsking) return;
    this.isAsking = true;
    const wait_ms = Math.max(0, EVERY_MS - (performance.now() - this.asked_ms));
    await new Promise((resolve) => setTimeout(resolve, wait_ms));
    this.asked_ms = performance.now();
    const time_s = this.session.shown.time_s;
    const found = await this.background.equations(this.session).catch(() => null);
    this.isAsking = false;
    if (!found || this.session.run !== run) return;
    this.found = found;
    this.showFound();
    if (this.isOpen && this.session.shown.time_s !== time_s) void this.ask(run);
  }

  private showFound(): void {
    const { found, session } = this;
    if (!found || !session.run) return;
    this.offer(found.matrices);
    const matrix = found.matrices.find(({ name }) => name === this.choice.value) ?? found.matrices[0];
    const key = `${matrix.name} ${this.notation.value} ${matrix.row_labels.length}`;
    if (this.shown === key && this.table) this.table.update(matrix);
    else this.build(found, matrix, session.run);
    this.shown = key;
    this.printed.show(found);
    this.tell();
  }

  private offer(matrices: readonly NamedMatrix[]): void {
    const names = matrices.map(({ name }) => name);
    if (names.join() === [...this.choice.options].map(({ value }) => value).join()) return;
    const before = this.choice.value || FIRST;
    this.choice.replaceChildren(...names.map((name) => make("option", { value: name }, texts.equations.names[name] ?? name.replaceAll("_", " "))));
    this.choice.value = names.includes(before) ? before : FIRST;
  }

  private build(found: Found, matrix: NamedMatrix, { model }: Run): void {
    this.touch(null);
    const formula = found.formulas.find(({ name }) => name === matrix.name);
    const bodyOf = bodyFinder(model.bodies.map(({ name }) => name), model.joints);
    const notation = this.notation.value === "names" ? "names" : "paper";
    this.table = new MatrixTable(matrix, formula, notation, bodyOf, (block) => this.touch(block));
    this.sheet.replaceChildren(this.table.element);
    this.formula.hidden = !formula;
    if (!formula) return;
    // If the formula has many blocks, only the table shows them.
    const isOne = formula.blocks.length === 1 && formula.blocks[0].length === 1;
    void showFormula(this.formula, isOne ? `${formula.symbol} = ${formula.blocks[0][0]} \\quad (${formula.equation})` : `${formula.symbol} \\quad (${formula.equation})`);
  }

  /** Shows a block in symbols and in numbers, and draws its effect on the ship. */
  private touch(block: Block | null): void {
    this.block = block;
    this.tell();
  }

  private tell(): void {
    const { block, found, session } = this;
    const matrix = found?.matrices.find(({ name }) => name === this.choice.value);
    if (!block || !found || !matrix || !session.run) {
      this.highlight(null);
      return setText(this.detail, this.table ? texts.equations.touch : "");
    }
    const bodyOf = bodyFinder(session.run.model.bodies.map(({ name }) => name), session.run.model.joints);
    this.highlight(highlightOf(found, matrix, block, bodyOf));
    const [row, column] = [matrix.row_labels[block.rows.from], matrix.column_labels[block.columns.from]];
    const entries = block.values.flat().map((value) => (block.isZero ? "0" : inCell(value))).join(" ");
    setText(this.detail, texts.equations.block(row, column, entries));
  }

  /** Space for large matrices. */
  private enlarge(): HTMLElement {
    const button = make("button", { type: "button", class: "button button-quiet wide-only", "aria-pressed": "false" }, texts.equations.enlarge);
    button.addEventListener("click", () => {
      const isWide = document.querySelector(".app")!.classList.toggle("is-wide-panel");
      button.setAttribute("aria-pressed", String(isWide));
    });
    return button;
  }
}
