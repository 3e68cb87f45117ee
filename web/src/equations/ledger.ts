import { scientific } from "../app/format";
import type { Run } from "../app/session";
import { texts } from "../texts";
import { make, setText } from "../ui/dom";

/**
 * Parts of the energy balance and their columns in the results, J; each is shown as its change since the start of the
 * run.
 */
const LINES = [
  { name: "drives", column: "work_by_drives" },
  { name: "outside", column: "work_by_outside" },
  { name: "kinetic", column: "kinetic_energy" },
  { name: "potential", column: "potential_energy" },
  { name: "dissipated", column: "energy_dissipated" },
] as const;

/** Energy balance as bars to either side of zero, all on one scale, with the energy error and the momentum error. */
export class Ledger {
  readonly element: HTMLElement;
  private readonly bars = LINES.map((line) => ({ ...line, bar: make("span", { class: "ledger-bar" }), value: make("td", {}) }));
  private readonly energy = make("strong", {});
  private readonly momentum = make("strong", {});
  private start: Float64Array | null = null;

  constructor() {
    const { ledger, ledger_lines, energy_error, momentum_error } = texts.equations;
    const rows = this.bars.map(({ name, bar, value }) =>
      make("tr", {}, make("th", { scope: "row" }, ledger_lines[name]), make("td", { class: "ledger-track" }, bar), value),
    );
    const errors = make("p", {}, `${energy_error} `, this.energy, `, ${momentum_error} `, this.momentum);
    this.element = make("section", { class: "ledger" }, make("h3", {}, ledger), make("table", {}, make("tbody", {}, ...rows)), errors);
  }

  /** Takes the first row of a run: all parts of the balance are shown relative to it. */
  begin(row: Float64Array): void {
    this.start = row;
  }

  show({ columns, accuracy }: Run, row: Float64Array): void {
    const changes = this.bars.map(({ column }) => columns.read(row, column) - (this.start ? columns.read(this.start, column) : 0));
    const largest = Math.max(...changes.map(Math.abs), Number.MIN_VALUE);
    this.bars.forEach(({ bar, value }, k) => {
      const share = (50 * changes[k]) / largest;
      bar.style.left = `${50 + Math.min(0, share)}%`;
      bar.style.width = `${Math.abs(share)}%`;
      bar.dataset.sign = changes[k] < 0 ? "out" : "in";
      setText(value, `${scientific(changes[k])} J`);
    });
    const { energy_J, momentum_N_m_s } = accuracy.errors(row);
    setText(this.energy, `${scientific(energy_J)} J`);
    setText(this.momentum, `${scientific(momentum_N_m_s)} N m s`);
  }
}
