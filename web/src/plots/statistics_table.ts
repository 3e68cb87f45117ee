import { fixed } from "../app/format";
import type { OtherLine, OtherLines } from "../runs/other_lines";
import { words } from "../runs/words";
import { texts } from "../texts";
import { make } from "../ui/dom";
import type { DrawnLine } from "./drawn";
import { evenEnd } from "./spectrum";
import { statisticsOf } from "./statistics";
import type { Statistics } from "./statistics";

type Name = keyof Statistics;
const NAMES: Name[] = ["mean", "standard_deviation", "minimum", "maximum", "significant_double_amplitude", "zero_up_crossing_period"];
const PERIOD_DECIMALS = 2;

/** Table of the statistics of a plot's lines over the visible time. */
export class StatisticsTable {
  readonly element: HTMLElement;
  private readonly table = make("table", { class: "plot-statistics" });
  private readonly note = make("p", { class: "plot-notes" });

  constructor(private readonly place: number) {
    const region = { class: "plot-told", tabindex: 0, role: "region", "aria-label": `${texts.plots.statistics}, ${texts.plots.plot(place).toLowerCase()}` };
    this.element = make("div", region, this.table, this.note);
  }

  /** Shows the statistics of lines; with kept runs in the plot, each run has a column. */
  show(title: string, lines: readonly DrawnLine[], times_s: Float64Array, columns: readonly Float64Array[], range_s: [number, number], others: OtherLines): void {
    // The record before the visible time, where a line starts, does not count.
    const first = times_s[0] < range_s[0] ? 1 : 0;
    const times = times_s.subarray(first);
    const [from, to] = [times[0] ?? NaN, times.at(-1) ?? NaN].map((one) => fixed(one, 2));
    const found = lines.map((_, i) => statisticsOf(times, columns[i].subarray(first)));
    const beside = others.all.map((one) => ({ one, column: others.columnOf(one, range_s) }));
    const rows = beside.length === 0 ? this.rows(lines, found) : this.rowsBeside(lines, found, beside);
    this.table.replaceChildren(make("caption", {}, texts.plots.statistics_of(title, from, to)), ...rows);
    const isThinned = [times, ...beside.map(({ column }) => column[0])].some((of) => evenEnd(of)[0] > 0);
    const notes = [...(isThinned ? [texts.plots.thinned] : []), ...coversOf(beside, times)];
    this.note.textContent = notes.join(" ");
    this.note.hidden = notes.length === 0;
  }

  private rows(lines: readonly DrawnLine[], found: readonly Statistics[]): HTMLElement[] {
    const heads = NAMES.map((name) => make("th", { scope: "col" }, texts.plots.statistic[name]));
    const rows = lines.map((line, i) => {
      const cells = NAMES.map((name) => make("td", { "data-testid": `${name}-${this.place}-${line.line.id}` }, textOf(line, found[i], name)));
      return make("tr", {}, make("th", { scope: "row" }, headOf(line)), ...cells);
    });
    return [make("tr", {}, make("td"), ...heads), ...rows];
  }

  /** Returns a row for each statistic of each line, and a column for each run. */
  private rowsBeside(lines: readonly DrawnLine[], found: readonly Statistics[], beside: readonly Beside[]): HTMLElement[] {
    const runs = [...new Set(beside.map(({ one }) => one.run))];
    const marks = runs.map((run) => make("th", { scope: "col", style: `color: var(--${run.colour})`, title: run.name }, run.mark));
    const head = make("tr", {}, make("td"), make("th", { scope: "col" }, words.present), ...marks);
    const rows = lines.flatMap((line, i) => {
      const known = runs.map((run) => beside.find(({ one }) => one.run === run && one.place === i)).map((kept) => kept && statisticsOf(...kept.column));
      const title = make("tr", {}, make("th", { scope: "rowgroup", colspan: runs.length + 2, class: "plot-group" }, headOf(line)));
      return [title, ...NAMES.map((name) => this.rowBeside(line, name, [found[i], ...known], runs.map(({ mark }) => mark)))];
    });
    return [head, ...rows];
  }

  private rowBeside(line: DrawnLine, name: Name, found: readonly (Statistics | undefined)[], marks: readonly string[]): HTMLElement {
    const id = `${name}-${this.place}-${line.line.id}`;
    const cells = found.map((one, k) => make("td", { "data-testid": k === 0 ? id : `${id}-${marks[k - 1]}` }, one ? textOf(line, one, name) : "–"));
    return make("tr", {}, make("th", { scope: "row" }, texts.plots.statistic[name]), ...cells);
  }
}

/** Line of a kept run with its times and values. */
interface Beside {
  one: OtherLine;
  column: [Float64Array, Float64Array];
}

/** Says of each kept run that has another part of the visible time than the present run which part that is. */
function coversOf(beside: readonly Beside[], times: Float64Array): string[] {
  const ends = (of: Float64Array) => [of[0] ?? NaN, of.at(-1) ?? NaN].map((one) => fixed(one, 2));
  const own = ends(times).join();
  const covers = new Map(beside.map(({ one, column }) => [one.run.mark, ends(column[0])]));
  return [...covers].filter(([, of]) => of.join() !== own).map(([mark, [from, to]]) => words.covers(mark, from, to));
}

function headOf({ label, shown }: DrawnLine): string {
  return shown.unit ? `${label}, ${shown.unit}` : label;
}

function textOf({ decimals }: DrawnLine, found: Statistics, name: Name): string {
  const hasPeriod = Number.isFinite(found.zero_up_crossing_period);
  if (name === "zero_up_crossing_period") return hasPeriod ? fixed(found[name], PERIOD_DECIMALS) : "–";
  // A line that does not oscillate has no significant amplitude.
  if (name === "significant_double_amplitude" && !hasPeriod) return "–";
  return fixed(found[name], decimals);
}
