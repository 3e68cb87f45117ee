import type { Outlook } from "../forecast/outlook";
import type { Shown } from "../app/recording/shown";
import type { Run } from "../app/session";
import { dashesOf, OtherLines } from "../runs/other_lines";
import type { Compared } from "../runs/other_lines";
import { words } from "../runs/words";
import { texts } from "../texts";
import { make, setText } from "../ui/dom";
import { ArmsChart, armsLegend } from "./arms_chart";
import type { Arms } from "./arms_chart";
import type { Chart, Content } from "./chart";
import { coloursOf, DrawnLine } from "./drawn";
import { Fan } from "./fan";
import { titleAndLabels } from "./figures";
import type { Figures } from "./figures";
import { PhaseChart } from "./phase_chart";
import { drawnApart } from "./sheet";
import { SpectrumChart } from "./spectrum_chart";
import { StatisticsTable } from "./statistics_table";
import { read, Stretch } from "./stretch";
import { TimeChart } from "./time_chart";
import type { Angle } from "./units";
import type { PlotView } from "./view";

/** Smallest interval between two tables of the same plot, ms. */
const TABLE_EVERY_MS = 1000;
/** Smallest width and height of a plot that is drawn, pixels. */
const LEAST_PX = 40;

/** Data that all plots of a run share. */
export interface PlotContext {
  run: Run;
  shown: Shown;
  figures: Figures;
  angle: Angle;
  /** The visible time, s. */
  range_s(): [number, number];
  arms(): Arms | null;
  /** Futures; they are drawn with the recorded lines. */
  outlook(): Outlook | null;
  /** Kept runs; their lines are drawn with those of the present run. */
  compared(): Compared;
  /** Called when the user has selected a range of time. */
  chooseRange(range_s: [number, number]): void;
  /** Called when the user wants to choose other lines. */
  choose(plot: Plot): void;
  changed(): void;
}

/** A plot as content of a picture. */
export interface PlotPicture {
  title: string;
  entries: { label: string; colour: string; unit: string }[];
  notes: string;
  canvas: HTMLCanvasElement;
}

/** A plot: its lines, a chart, and a legend with the values at the crosshair or at the time that is shown. */
export class Plot {
  readonly element: HTMLElement;
  private readonly title: HTMLButtonElement;
  private readonly unit = make("span", { class: "plot-unit" });
  private readonly at = make("span", { class: "plot-at" });
  private readonly legend = make("span", { class: "plot-legend" });
  private readonly area = make("div", { class: "plot-area", role: "img" });
  private readonly notes = make("p", { class: "plot-notes" });
  private readonly told: HTMLButtonElement;
  private readonly statistics: StatisticsTable;
  /** Table of the plotted values, for screen readers. */
  private readonly table = make("table");
  private readonly stretch = new Stretch();
  private readonly fan = new Fan();
  private others!: OtherLines;
  private chart!: Chart;
  private lines: DrawnLine[] = [];
  private values: HTMLElement[] = [];
  private otherValues: HTMLElement[] = [];
  private name = "";
  private stale = true;
  private isTabled = false;
  private tabledAt_ms = -Infinity;

  constructor(
    readonly view: PlotView,
    readonly place: number,
    private readonly context: PlotContext,
  ) {
    this.title = make("button", { type: "button", class: "plot-title", "aria-haspopup": "dialog", "data-testid": `choose-${place}` });
    this.title.addEventListener("click", () => context.choose(this));
    this.told = make("button", { type: "button", class: "button button-quiet plot-tell", title: texts.plots.statistics, "aria-label": `${texts.plots.statistics}, ${texts.plots.plot(place).toLowerCase()}`, "data-testid": `statistics-${place}` }, "Σ");
    this.told.addEventListener("click", () => this.tell(!view.isTold));
    this.statistics = new StatisticsTable(place);
    const head = make("span", { class: "plot-head" }, this.title, this.unit, this.at, this.told);
    const hidden = make("div", { class: "visually-hidden" }, this.table);
    const caption = make("figcaption", {}, head, this.legend);
    this.element = make("figure", { class: "plot", "data-testid": `plot-${place}` }, caption, this.area, this.notes, this.statistics.element, hidden);
    new ResizeObserver(() => this.resize()).observe(this.area);
    this.show();
  }

  /** Applies the chosen view: kind, lines and units. */
  show(): void {
    const { view, context } = this;
    const { run, figures, angle } = context;
    const chosen = view.kind === "arms" ? [] : view.lines.map((id) => figures.line(id)!);
    const { title, labels } = titleAndLabels(chosen, figures.ofLines(view.lines));
    const colours = coloursOf(chosen);
    this.lines = chosen.map((line, i) => new DrawnLine(line, labels[i], colours[i], run.columns, angle, run.model.limits));
    const compared = context.compared();
    this.others = new OtherLines({ ...compared, isDifference: compared.isDifference && view.kind === "time" && compared.runs.length > 0 }, this.lines, angle);
    this.name = this.titleOf(title, labels);
    setText(this.title, this.name);
    this.title.setAttribute("aria-label", texts.plots.choose(this.name, this.place));
    this.area.setAttribute("aria-label", view.kind === "time" ? texts.plots.over_time(this.name) : this.name);
    const units = [...new Set(this.lines.map(({ shown }) => shown.unit))];
    setText(this.unit, units.length === 1 && view.kind === "time" ? units[0] : "");
    this.drawEntries(units.length > 1);
    this.chart?.destroy();
    this.chart = this.chartIn(this.area);
    this.tell(view.isTold);
    this.touch();
  }

  get heading(): string {
    return this.name;
  }

  get drawn(): readonly DrawnLine[] {
    return this.lines;
  }

  private titleOf(title: string, labels: readonly string[]): string {
    const { kind } = this.view;
    if (kind === "time") return this.others.isDifference ? words.difference_of(title) : title;
    if (kind === "arms") return texts.plots.kinds.arms;
    if (kind === "phase" && labels.length > 1) return texts.plots.against(labels[1], labels[0]);
    return texts.plots.with_kind(title, texts.plots.kinds[kind].toLowerCase());
  }

  private drawEntries(hasUnits: boolean): void {
    this.otherValues = this.others.all.map(({ run, own }) => make("span", { class: "plot-value", "data-testid": `value-${this.place}-${own.line.id}-${run.mark}` }));
    this.values = this.lines.map(({ line }) => make("span", { class: "plot-value", "data-testid": `value-${this.place}-${line.id}` }));
    const entries = this.lines.map(({ colour, label, shown }, i) => {
      const unit = hasUnits && shown.unit && this.view.kind === "time" ? [make("span", { class: "plot-unit" }, ` ${shown.unit}`)] : [];
      return make("span", { class: "plot-entry" }, swatch(colour), label, this.values[i], ...unit, ...this.otherEntries(i));
    });
    const hulls = this.hulls().map(({ colour, label }) => make("span", { class: "plot-entry" }, swatch(colour), label));
    this.legend.replaceChildren(...entries, ...hulls);
  }

  /** Returns the part of the legend with the values of kept runs beside a line, after a sample of its dashes. */
  private otherEntries(place: number): HTMLElement[] {
    const { others, otherValues, view } = this;
    const beside = others.all.map((one, i) => ({ ...one, value: otherValues[i] })).filter((one) => one.place === place);
    if (view.kind === "arms" || beside.length === 0) return [];
    const entries = beside.map(({ run, value }) => {
      const mark = make("span", { class: "run-mark", style: `color: var(--${run.colour})`, title: run.name }, others.isDifference ? `− ${run.mark}` : run.mark);
      return make("span", { class: "plot-other" }, mark, ...(view.kind === "time" ? [value] : []));
    });
    return [dashesOf(place), ...entries];
  }

  /** Returns the legend of the hulls whose righting arms are drawn. */
  private hulls(): PlotPicture["entries"] {
    return this.view.kind === "arms" ? armsLegend(this.context.run.model.hulls) : [];
  }

  private chartIn(area: HTMLElement): Chart {
    const { context, view } = this;
    switch (view.kind) {
      case "time":
        return new TimeChart(area, (range_s) => context.chooseRange(range_s));
      case "spectrum":
        return new SpectrumChart(area, () => view.parts, () => this.touch());
      case "phase":
        return new PhaseChart(area);
      case "arms":
        return new ArmsChart(area, () => context.arms(), context.run.columns, context.shown);
    }
  }

  private tell(isTold: boolean): void {
    const { view } = this;
    this.tabledAt_ms = -Infinity;
    const isOffered = view.kind === "time" || view.kind === "phase";
    this.told.hidden = !isOffered;
    this.told.setAttribute("aria-pressed", String(isTold));
    this.statistics.element.hidden = !isTold || !isOffered;
    this.stale = true;
    if (view.isTold === isTold) return;
    view.isTold = isTold;
    this.context.changed();
  }

  touch(): void {
    this.stale = true;
  }

  /** Makes the charts again with the colours of the page's theme, which are read only when a chart is made. */
  restyle(): void {
    this.chart.destroy();
    this.stale = true;
  }

  /** Draws the plot; returns whether it was drawn again. */
  draw(): boolean {
    if (this.stale) this.isTabled = false;
    const content = this.content();
    this.drawTable(content);
    const { clientWidth: width, clientHeight: height } = this.area;
    const isDue = this.stale && width >= LEAST_PX && height >= LEAST_PX;
    if (isDue) {
      this.stale = false;
      this.fill(content);
      this.chart.draw(content);
    }
    this.drawWords(content);
    return isDue;
  }

  private content(): Content {
    const { context, fan, lines, others, stretch } = this;
    const { shown } = context;
    const { row = [], time_s: row_s = 0 } = shown.recording?.rows.around(shown.time_s)[0] ?? {};
    const now = (line: DrawnLine) => line.scaled(read(row, line.places));
    return { lines, stretch, fan, others, range_s: context.range_s(), shown_s: shown.time_s, isBack: shown.isBack, row_s, now };
  }

  /** Reads the visible time from the recording. */
  private fill({ range_s }: Content): void {
    const rows = this.context.shown.recording?.rows;
    // A chart over time also needs the record before its left edge, where the line starts.
    const first = rows ? rows.indexAt(range_s[0]) : 0;
    const isAt = rows?.items[first]?.time_s === range_s[0];
    const from = Math.max(0, this.view.kind === "time" || isAt ? first : first + 1);
    const places: [number, number] = rows ? [from, Math.max(from, rows.indexAt(range_s[1]) + 1)] : [0, 0];
    const columns = this.lines.map((line) => line.places);
    const scale = (value: number, i: number) => this.lines[i].scaled(value);
    this.stretch.fill(rows?.items ?? [], places, columns, scale);
    this.others.fill(range_s, this.stretch);
    this.fan.fill(this.view.kind === "time" ? this.context.outlook() : null, columns, scale);
  }

  private drawWords(content: Content): void {
    setText(this.at, this.chart.at(content));
    const values = this.chart.values(content);
    this.values.forEach((value, i) => setText(value, values[i] ?? ""));
    const others = this.chart.otherValues?.(content) ?? [];
    this.otherValues.forEach((value, i) => setText(value, others[i] ?? ""));
    const notes = this.chart.notes(content).join(". ").replace(/\.\./g, ".");
    setText(this.notes, notes);
    this.notes.hidden = notes === "";
  }

  /** Updates the table, the statistics and the number of decimals, at most once per interval. */
  private drawTable(content: Content): void {
    const now = performance.now();
    if (this.isTabled || now - this.tabledAt_ms < TABLE_EVERY_MS) return;
    [this.isTabled, this.tabledAt_ms] = [true, now];
    this.fill(content);
    const [times, ...columns] = this.stretch.data;
    for (const line of this.lines) line.largest = Math.max(...this.lines.map((other, i) => (other.shown.unit === line.shown.unit ? largestOf(columns[i]) : 0)));
    const [heads, ...rows] = this.chart.table(content);
    const head = make("tr", {}, ...heads.map((name) => (name ? make("th", { scope: "col" }, name) : make("td"))));
    const row = ([name, ...cells]: string[]) => make("tr", {}, make("th", { scope: "row" }, name), ...cells.map((cell) => make("td", {}, cell)));
    this.table.replaceChildren(make("caption", {}, this.area.getAttribute("aria-label")!), head, ...rows.map(row));
    if (!this.statistics.element.hidden) this.statistics.show(this.name, this.lines, times, columns, content.range_s, this.others);
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.area;
    if (width > 0 && height > 0) this.chart.resize(width, height);
    this.stale = true;
  }

  /** Returns the content of the plot, to save as a picture. */
  async picture(): Promise<PlotPicture | null> {
    const content = this.content();
    this.fill(content);
    const canvas = await drawnApart((area) => this.chartIn(area), content);
    const entries = this.lines.map(({ label, colour, shown }) => ({ label, colour, unit: shown.unit }));
    const others = this.view.kind === "time" ? this.others.all.map(({ run, own }) => ({ label: `${run.mark}: ${own.label}`, colour: run.colour, unit: own.shown.unit })) : [];
    return canvas && { title: this.name, entries: [...(this.others.isDifference ? [] : entries), ...others, ...this.hulls()], notes: this.notes.textContent ?? "", canvas };
  }

  destroy(): void {
    this.chart.destroy();
    this.element.remove();
  }
}

export function swatch(colour: string): HTMLElement {
  return make("span", { class: "swatch", style: `background: var(--${colour})` });
}

function largestOf(values: Float64Array): number {
  return values.reduce((largest, value) => Math.max(largest, Number.isNaN(value) ? 0 : Math.abs(value)), 0);
}

