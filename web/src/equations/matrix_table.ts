import { texts } from "../texts";
import { make } from "../ui/dom";
import { blocksOf, inCell, isZero, stretchesOf } from "./blocks";
import type { Block, NamedMatrix, Stretch, SymbolicMatrix } from "./blocks";
import { showFormula } from "./formula";

/** Angle between the hues of successive bodies, degrees: the golden angle keeps the hues far apart. */
const GOLDEN_ANGLE = 137.5;
const FIRST_HUE = 210;

export function hueOf(body: number): number {
  return (FIRST_HUE + GOLDEN_ANGLE * body) % 360;
}

/** Notation of the labels of rows and columns: the paper's symbols, or names of bodies and coordinates. */
export type Notation = "paper" | "names";

/** Table of one matrix with its numbers; each block has the colour of its body. */
export class MatrixTable {
  readonly element: HTMLElement;
  private readonly cells: HTMLElement[] = [];
  private blocks: Block[][];
  private readonly rows: Stretch[];
  private readonly columns: Stretch[];

  constructor(
    matrix: NamedMatrix,
    formula: SymbolicMatrix | undefined,
    notation: Notation,
    bodyOf: (label: string) => number,
    private readonly touched: (block: Block | null) => void,
  ) {
    this.rows = stretchesOf(matrix.row_labels, matrix.row_units, bodyOf);
    this.columns = stretchesOf(matrix.column_labels, matrix.column_units, bodyOf);
    this.blocks = blocksOf(matrix, this.rows, this.columns);
    const isByPaper = notation === "paper" && formula !== undefined && fits(formula, this.rows, this.columns);
    const head = make("tr", {}, make("td", {}), ...this.columns.map((stretch, k) => this.header("col", matrix.column_labels, stretch, isByPaper ? formula.columns[k] : null)));
    const lines = matrix.row_labels.map((_, row) => make("tr", {}, ...this.line(matrix, row, isByPaper ? formula : undefined)));
    this.element = make("table", { class: "matrix", "aria-label": texts.equations.names[matrix.name] ?? matrix.name }, make("thead", {}, head), make("tbody", {}, ...lines));
    this.element.addEventListener("click", ({ target }) => this.touch(target));
    this.update(matrix);
  }

  /** Updates the numbers of the matrix. */
  update(matrix: NamedMatrix): void {
    this.blocks = blocksOf(matrix, this.rows, this.columns);
    this.cells.forEach((cell, at) => {
      const zero = isZero(matrix, matrix.data[at]);
      const text = zero ? "0" : inCell(matrix.data[at]);
      if (cell.textContent !== text) cell.textContent = text;
      cell.classList.toggle("is-zero", zero);
    });
  }

  private line(matrix: NamedMatrix, row: number, formula: SymbolicMatrix | undefined): HTMLElement[] {
    const down = this.rows.findIndex(({ from, length }) => row >= from && row < from + length);
    const stretch = this.rows[down];
    const cells = this.columns.flatMap((across, k) => Array.from({ length: across.length }, (_, j) => this.cell(matrix, row, down, k, across.from + j)));
    this.cells.push(...cells);
    return row === stretch.from ? [this.header("row", matrix.row_labels, stretch, formula?.rows[down] ?? null), ...cells] : cells;
  }

  private cell(matrix: NamedMatrix, row: number, down: number, across: number, column: number): HTMLElement {
    const [rows, columns] = [this.rows[down], this.columns[across]];
    const unit = unitOf(matrix.row_units[row], matrix.column_units[column]);
    const label = `${matrix.row_labels[row]}, ${matrix.column_labels[column]}${unit ? `, ${unit}` : ""}`;
    const edge = [row === rows.from ? "is-top" : "", column === columns.from ? "is-left" : ""].filter(Boolean).join(" ");
    const cell = make("td", { class: edge, title: label, "data-block": `${down},${across}` });
    const hues = [rows.body, columns.body].filter((body) => body >= 0).map(hueOf);
    if (hues.length > 0) cell.style.setProperty("--first", String(hues[0]));
    if (hues.length > 0) cell.style.setProperty("--second", String(hues.at(-1)));
    return cell;
  }

  private header(side: "row" | "col", labels: readonly string[], { from, length, body }: Stretch, latex: string | null): HTMLElement {
    const words = length === 1 ? labels[from] : labels[from].replace(/([._])[^._]*$/, "");
    const header = make("th", { scope: length === 1 ? side : `${side}group`, [side === "row" ? "rowspan" : "colspan"]: length, title: labels.slice(from, from + length).join(", ") });
    if (body >= 0) header.style.setProperty("--first", String(hueOf(body)));
    const name = words.replaceAll("_", " ");
    if (!latex) header.append(name);
    else {
      const symbol = make("span", { "aria-hidden": "true" });
      header.append(make("span", { class: "visually-hidden" }, name), symbol);
      void showFormula(symbol, latex);
    }
    return header;
  }

  /** A second touch of a block deselects it. */
  private touch(target: EventTarget | null): void {
    const place = target instanceof HTMLElement ? target.dataset.block : undefined;
    const isOn = target instanceof HTMLElement && target.classList.contains("is-touched");
    for (const cell of this.cells) cell.classList.toggle("is-touched", !isOn && cell.dataset.block === place);
    if (!place || isOn) return this.touched(null);
    const [down, across] = place.split(",").map(Number);
    this.touched(this.blocks[down][across]);
  }
}

/** Returns the unit of an entry: the unit of its row over the unit of its column. */
export function unitOf(row: string, column: string): string {
  if (column === "1") return row === "1" ? "" : row;
  return row === column ? "" : `(${row})/(${column})`;
}

function fits({ rows, columns }: SymbolicMatrix, down: readonly Stretch[], across: readonly Stretch[]): boolean {
  return rows.length === down.length && columns.length === across.length;
}
