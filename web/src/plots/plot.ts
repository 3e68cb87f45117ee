import uPlot from "uplot";
import type { Outlook } from "../ahead/outlook";
import { fixed } from "../app/format";
import type { Shown } from "../app/recording/shown";
import type { Columns } from "../engine/columns";
import { make, setText } from "../ui/dom";
import { Fan } from "./fan";
import { decimalsOf, PER_RADIAN, scaleOf } from "./quantities";
import type { FigureKey, PlotKind, Unit } from "./quantities";
import { read, Stretch } from "./stretch";
import type { Places } from "./stretch";
import { rowsOf } from "./table";
import { rangeInSight, wrapPlaces } from "./window";

/** Room for the half of the last time on the axis that stands out, pixels. */
const LAST_TICK_PX = 24;

/** Least time between two tables of the same plot, ms. */
const TABLE_EVERY_MS = 1000;

/** One figure: what it shows, to choose; legend with the values at the crosshair or the moment that is shown; the lines. */
export class Plot {
  private chart: uPlot | null = null;
  private unit: Unit = "deg";
  private stale = true;
  private duration_s = 1;
  private window_s = 1;
  private readonly area: HTMLElement;
  private readonly at = make("span", { class: "plot-at" });
  private readonly unitLabel = make("span", { class: "plot-unit" });
  private readonly choice: HTMLSelectElement;
  private readonly legend = make("span", { class: "plot-legend" });
  private values: HTMLElement[] = [];
  private lines: Places[] = [];
  private kinds: PlotKind[] = [];
  private columns: Columns | null = null;
  private kind: PlotKind = { title: "", quantities: [], units: { deg: "", rad: "" }, turns: true, wraps: false };
  private readonly stretch = new Stretch();
  private readonly fan = new Fan();
  private outlook: Outlook | null = null;
  /** The same in numbers, for those who do not see it. */
  private readonly table = make("table");
  private tabledAt_ms = -Infinity;
  private isTabled = false;

  constructor(
    figure: HTMLElement,
    private readonly key: FigureKey,
    label: string,
    private readonly shown: Shown,
  ) {
    this.choice = make("select", { class: "plot-choice", "aria-label": label, "data-testid": `choice-${key}` });
    this.choice.addEventListener("change", () => this.show(this.choice.selectedIndex));
    this.area = make("div", { class: "plot-area", role: "img" });
    const head = make("span", { class: "plot-head" }, this.choice, this.unitLabel, this.at);
    figure.replaceChildren(make("figcaption", {}, head, this.legend), this.area, make("div", { class: "visually-hidden" }, this.table));
    new ResizeObserver(() => this.resize()).observe(this.area);
  }

  /** What can be shown of rows with these columns. A choice that is still there stays. */
  offer(kinds: PlotKind[], columns: Columns): void {
    const kept = kinds.findIndex(({ title }) => title === this.kind.title);
    this.kinds = kinds;
    this.columns = columns;
    this.choice.replaceChildren(...kinds.map(({ title }) => make("option", {}, title)));
    this.show(Math.max(0, kept));
  }

  private show(index: number): void {
    this.choice.selectedIndex = index;
    this.kind = this.kinds[index];
    this.lines = this.kind.quantities.map(({ column, lengthOf }) => (lengthOf ?? [column]).map((name) => this.columns!.at(name)));
    this.values = this.kind.quantities.map(({ key }) => make("span", { class: "plot-value", "data-testid": `${key}-${this.key}` }));
    const entries = this.kind.quantities.map((quantity, i) =>
      make("span", { class: "plot-entry" }, make("span", { class: `swatch swatch-${quantity.key}` }), quantity.label, this.values[i]),
    );
    this.legend.replaceChildren(...entries);
    this.area.setAttribute("aria-label", `${this.kind.title} over time`);
    this.restyle();
  }

  setUnit(unit: Unit): void {
    this.unit = unit;
    this.stale = true;
  }

  setWindow(duration_s: number, window_s: number): void {
    this.duration_s = duration_s;
    this.window_s = window_s;
    this.stale = true;
  }

  /** Colours come from the page's theme; they are read when the chart is made. */
  restyle(): void {
    this.chart?.destroy();
    this.chart = null;
    this.stale = true;
  }

  /** What may come, to be drawn after what came. */
  foresee(outlook: Outlook | null): void {
    this.outlook = outlook;
    this.stale = true;
  }

  touch(): void {
    this.stale = true;
  }

  private drawTable(): void {
    const now = performance.now();
    if (this.isTabled || now - this.tabledAt_ms < TABLE_EVERY_MS) return;
    [this.isTabled, this.tabledAt_ms] = [true, now];
    this.fill();
    const [times, ...lines] = this.stretch.data;
    const write = (value: number) => fixed(value, decimalsOf(this.kind, this.unit));
    const heads = ["", ...this.kind.quantities.map(({ label }) => `${label}, ${this.kind.units[this.unit]}`)];
    const row = ([head, ...cells]: string[]) => make("tr", {}, make("th", { scope: "row" }, head), ...cells.map((cell) => make("td", {}, cell)));
    const head = make("tr", {}, ...heads.map((name) => (name ? make("th", { scope: "col" }, name) : make("td"))));
    this.table.replaceChildren(make("caption", {}, `${this.kind.title} over time`), head, ...rowsOf(times, lines, write).map(row), ...this.fan.rows(write).map(row));
  }

  draw(): void {
    if (this.stale) this.isTabled = false;
    this.drawTable();
    if (!this.stale || this.area.clientWidth < 40 || this.area.clientHeight < 40) return this.drawLegend();
    this.stale = false;
    const [min, max] = this.fill();
    this.chart ??= this.makeChart();
    this.chart.setData(this.stretch.data as unknown as uPlot.AlignedData, false);
    this.chart.setScale("x", { min, max });
    this.drawLegend();
  }

  /** Takes what is in sight from the recording; returns the range of time, s. */
  private fill(): [number, number] {
    const rows = this.shown.recording?.rows;
    const last_s = rows?.last?.time_s ?? 0;
    const range = rangeInSight(Math.max(last_s, this.outlook?.end_s ?? 0), this.shown.time_s, this.duration_s, this.window_s);
    // One record beyond the left edge, so that the line comes from there.
    const places: [number, number] = rows ? [Math.max(0, rows.indexAt(range[0])), rows.indexAt(range[1]) + 1] : [0, 0];
    this.stretch.fill(rows?.items ?? [], places, this.lines, (value, i) => this.scaled(value, i));
    this.fan.fill(this.outlook, this.lines, (value, i) => this.scaled(value, i));
    return range;
  }

  private scaled(value: number, line: number): number {
    return (value + (this.kind.quantities[line].offset ?? 0)) * scaleOf(this.kind, this.unit);
  }

  private drawLegend(): void {
    const index = this.chart?.cursor.idx ?? null;
    const [times, ...lines] = index === null ? [] : this.stretch.data;
    const inside = index !== null && index < this.stretch.length;
    const row = this.shown.recording?.rows.around(this.shown.time_s)[0].row ?? [];
    setText(this.unitLabel, this.kind.units[this.unit]);
    setText(this.at, inside ? `at ${fixed(times[index], 2)} s` : "");
    this.values.forEach((value, i) => {
      const number = inside ? lines[i][index] : this.scaled(read(row, this.lines[i]), i);
      setText(value, fixed(number, decimalsOf(this.kind, this.unit)));
    });
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.area;
    if (this.chart && width > 0 && height > 0) this.chart.setSize({ width, height });
    this.stale = true;
  }

  private makeChart(): uPlot {
    const style = getComputedStyle(document.documentElement);
    const colour = (name: string) => style.getPropertyValue(name).trim();
    const axis = { stroke: colour("--muted"), font: "12px " + colour("--font"), ticks: { show: false } };
    const grid = { stroke: colour("--plot-grid"), width: 1 };
    const options: uPlot.Options = {
      width: this.area.clientWidth,
      height: this.area.clientHeight,
      legend: { show: false },
      padding: [8, LAST_TICK_PX, 0, 0],
      cursor: { sync: { key: "time" }, drag: { x: false, y: false }, points: { size: 7 } },
      scales: { x: { time: false }, y: { range: (_u, low, high) => this.rangeOf(low, high) } },
      axes: [
        { ...axis, grid, size: 28, values: (_u, splits) => splits.map((split) => `${Number(split.toPrecision(6))} s`) },
        { ...axis, grid, size: 52, values: (_u, splits) => splits.map((split) => fixed(split, 6).replace(/\.?0+$/, "")) },
      ],
      hooks: {
        drawAxes: [(u) => this.fan.draw(u, this.kind.quantities.map(({ key }) => colour(`--${key}`)))],
        draw: [(u) => this.drawMoment(u, colour("--accent"))],
      },
      series: [{}, ...this.kind.quantities.map(({ key, label }) => this.line(label, colour(`--${key}`)))],
    };
    return new uPlot(options, this.stretch.data as unknown as uPlot.AlignedData, this.area);
  }

  private rangeOf(low: number | null, high: number | null): [number, number] {
    const [bottom, top] = this.fan.range;
    return paddedRange(Math.min(low ?? 0, bottom), Math.max(high ?? 0, top), 0.005 * scaleOf(this.kind, this.unit));
  }

  /** A line across at an earlier moment that is shown. */
  private drawMoment({ ctx, bbox, valToPos }: uPlot, stroke: string): void {
    if (!this.shown.isBack) return;
    const x = Math.round(valToPos(this.shown.time_s, "x", true)) + 0.5;
    ctx.save();
    ctx.strokeStyle = stroke;
    ctx.lineWidth = devicePixelRatio;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  }

  private line(label: string, stroke: string): uPlot.Series {
    const series: uPlot.Series = { label, stroke, width: 2, pxAlign: 0, points: { show: false } };
    if (!this.kind.wraps) return series;
    series.gaps = (u, seriesIndex, first, last) => {
      const values = u.data[seriesIndex] as unknown as Float64Array;
      const pixel = (i: number) => u.valToPos(u.data[0][i], "x", true);
      const places = wrapPlaces(values, first, last, Math.PI * PER_RADIAN[this.unit]);
      return places.map(([from, to]): [number, number] => [pixel(from), pixel(to)]);
    };
    return series;
  }
}

/** Room around the lines; never so narrow that rounding noise looks like motion. */
function paddedRange(low: number, high: number, least: number): [number, number] {
  const bottom = Math.min(low, -least);
  const top = Math.max(high, least);
  const margin = 0.06 * (top - bottom);
  return [bottom - margin, top + margin];
}
