import { fixed } from "../app/format";
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

  show(title: string, lines: readonly DrawnLine[], times_s: Float64Array, columns: readonly Float64Array[], start_s: number): void {
    // The record before the visible time, where a line starts, does not count.
    const first = times_s[0] < start_s ? 1 : 0;
    const times = times_s.subarray(first);
    const [from, to] = [times[0] ?? NaN, times.at(-1) ?? NaN].map((one) => fixed(one, 2));
    const heads = ["", ...NAMES.map((name) => texts.plots.statistic[name])];
    const head = make("tr", {}, ...heads.map((name) => (name ? make("th", { scope: "col" }, name) : make("td"))));
    const rows = lines.map((line, i) => this.row(line, statisticsOf(times, columns[i].subarray(first))));
    this.table.replaceChildren(make("caption", {}, texts.plots.statistics_of(title, from, to)), head, ...rows);
    const isThinned = evenEnd(times)[0] > 0;
    this.note.textContent = isThinned ? texts.plots.thinned : "";
    this.note.hidden = !isThinned;
  }

  private row(line: DrawnLine, found: Statistics): HTMLElement {
    const { label, shown, decimals, line: { id } } = line;
    const hasPeriod = Number.isFinite(found.zero_up_crossing_period);
    const text = (name: Name): string => {
      if (name === "zero_up_crossing_period") return hasPeriod ? fixed(found[name], PERIOD_DECIMALS) : "–";
      // A line that does not oscillate has no significant amplitude.
      if (name === "significant_double_amplitude" && !hasPeriod) return "–";
      return fixed(found[name], decimals);
    };
    const cells = NAMES.map((name) => make("td", { "data-testid": `${name}-${this.place}-${id}` }, text(name)));
    return make("tr", {}, make("th", { scope: "row" }, shown.unit ? `${label}, ${shown.unit}` : label), ...cells);
  }
}
