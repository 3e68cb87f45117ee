import uPlot from "uplot";
import { fixed } from "../app/format";
import { texts } from "../texts";
import { joined } from "./bound_labels";
import type { BoundLabel } from "./bound_labels";
import { acrossAxis, heightsOf, paddingOf, stroke, styleOf, uprightAxis, word } from "./chart";
import type { Chart, Content, Style } from "./chart";
import type { DrawnLine } from "./drawn";
import { rowsOf } from "./table";
import { wrapPlaces } from "./window";

/** Smallest range of an angle axis, rad: a narrower range would show rounding errors. */
const LEAST_ANGLE = 1e-4;
/** Smallest range of other axes, in their unit. */
const LEAST = 1e-9;
/** Smallest width of a selection, pixels; a narrower one counts as a click. */
const LEAST_DRAG_PX = 6;
const TIME_DECIMALS = 2;
/** Smallest distance between the labels of two limits, pixels. */
const LABEL_PX = 13;

/** Chart of lines over time, with an axis for each unit and the limits of the columns. */
export class TimeChart implements Chart {
  private chart: uPlot | null = null;
  private content: Content | null = null;

  constructor(
    private readonly area: HTMLElement,
    /** Called when the user has selected a range of time with the mouse. */
    private readonly choose: (range_s: [number, number]) => void,
  ) {}

  draw(content: Content): void {
    this.content = content;
    this.chart ??= this.make(content);
    this.chart.setData(dataOf(content), false);
    const [min, max] = content.range_s;
    this.chart.setScale("x", { min, max });
  }

  resize(width: number, height: number): void {
    this.chart?.setSize({ width, height });
  }

  private get index(): number | null {
    return this.chart?.cursor.idx ?? null;
  }

  values(content: Content): string[] {
    const { index } = this;
    const [, ...columns] = content.stretch.data;
    return content.lines.map((line, i) => fixed(this.isInside(content) ? columns[i][index!] : content.now(line), line.decimals));
  }

  otherValues(content: Content): string[] {
    const { lines, others, stretch } = content;
    const isInside = this.isInside(content);
    const [times, ...columns] = stretch.data;
    return (others?.all ?? []).map((one) => {
      const present = isInside ? columns[one.place][this.index!] : content.now(lines[one.place]);
      return fixed(others!.shownAt(one, isInside ? times[this.index!] : content.row_s, present), lines[one.place].decimals);
    });
  }

  private isInside({ stretch }: Content): boolean {
    return this.index !== null && this.index < stretch.length;
  }

  at(content: Content): string {
    return this.isInside(content) ? texts.plots.at_time(fixed(content.stretch.data[0][this.index!], 2)) : "";
  }

  notes({ others }: Content): string[] {
    return others?.notes ?? [];
  }

  table({ fan, lines, stretch }: Content): string[][] {
    const [times, ...columns] = stretch.data;
    const heads = ["", ...lines.map(({ label, shown }) => (shown.unit ? `${label}, ${shown.unit}` : label))];
    const limits = lines.flatMap(({ bounds, decimals }, at) =>
      bounds.map(({ name, value }) => [texts.plots.limit(name), ...lines.map((_, i) => (i === at ? fixed(value, decimals) : ""))]),
    );
    const write = (value: number, i: number) => fixed(value, lines[i]?.decimals ?? TIME_DECIMALS);
    return [heads, ...limits, ...rowsOf(times, columns, write), ...fan.rows(write)];
  }

  canvas(): HTMLCanvasElement | null {
    return this.chart?.ctx.canvas ?? null;
  }

  destroy(): void {
    this.chart?.destroy();
    this.chart = null;
  }

  private make(content: Content): uPlot {
    const style = styleOf();
    const { lines } = content;
    const units = [...new Set(lines.map(({ shown }) => shown.unit))];
    const options: uPlot.Options = {
      width: this.area.clientWidth,
      height: this.area.clientHeight,
      legend: { show: false },
      padding: paddingOf(units.length),
      cursor: { sync: { key: "time" }, drag: { x: true, y: false, setScale: false }, points: { size: 7 } },
      scales: { x: { time: false }, ...Object.fromEntries(units.map((unit) => [scaleOf(unit), { range: this.rangeFor(lines, unit) }])) },
      axes: [acrossAxis(style, (value) => `${Number(value.toPrecision(6))} s`), ...units.map((unit, place) => uprightAxis(style, scaleOf(unit), place, units.length > 1 ? unit : ""))],
      hooks: { drawAxes: [(u) => this.drawFan(u, style), (u) => this.drawOthers(u, style)], draw: [(u) => this.drawBounds(u, style), (u) => this.drawMoment(u, style)], setSelect: [(u) => this.select(u)] },
      series: [{}, ...lines.map((line) => seriesOf(line, style.colour(line.colour)))],
    };
    return new uPlot(options, dataOf(content), this.area);
  }

  /** Returns the range of the axis of a unit, from its lines, those of kept runs, their limits and their futures. */
  private rangeFor(lines: readonly DrawnLine[], unit: string): uPlot.Range.Function {
    const places = lines.flatMap((line, i) => (line.shown.unit === unit ? [i] : []));
    const own = places.map((i) => lines[i]);
    const least = Math.max(...own.map(({ line, shown }) => (line.unit.startsWith("rad") ? LEAST_ANGLE * shown.scale : LEAST)));
    return (_u, low, high) => {
      const { fan, others } = this.content!;
      const bounds = others?.isDifference ? [] : own.flatMap((line) => line.bounds.map(({ value }) => value));
      const ranges = [[low ?? Infinity, high ?? -Infinity], ...(others ? [others.rangeOf(places)] : []), ...(others?.isDifference ? [] : [fan.rangeOf(places)])];
      const [bottom, top] = [Math.min(...ranges.map(([one]) => one)), Math.max(...ranges.map(([, one]) => one))];
      return heightsOf(bottom <= top ? bottom : null, bottom <= top ? top : null, least, bounds);
    };
  }

  /** Draws the futures below the lines. */
  private drawFan(u: uPlot, style: Style): void {
    if (!this.content || this.content.others?.isDifference) return;
    const { fan, lines } = this.content;
    fan.draw(u, lines.map(({ colour }) => style.colour(colour)), lines.map(({ shown }) => scaleOf(shown.unit)));
  }

  /** Draws the lines of kept runs below the lines. */
  private drawOthers(u: uPlot, style: Style): void {
    this.content?.others?.draw(u, style, scaleOf);
  }

  private select(u: uPlot): void {
    const { left, width } = u.select;
    if (width === 0) return;
    u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    if (width >= LEAST_DRAG_PX) this.choose([u.posToVal(left, "x"), u.posToVal(left + width, "x")]);
  }

  /** Draws a vertical line at the time that is shown, if it is before the newest. */
  private drawMoment(u: uPlot, style: Style): void {
    const { content } = this;
    if (!content?.isBack || content.lines.length === 0) return;
    const scale = scaleOf(content.lines[0].shown.unit);
    const { min = 0, max = 0 } = u.scales[scale];
    stroke(u, [[content.shown_s, min!], [content.shown_s, max!]], scale, { colour: style.colour("accent"), width: 1 });
  }

  /** Draws the limits of a column in the colour of its line, from the time at which they count. */
  private drawBounds(u: uPlot, style: Style): void {
    const { content } = this;
    if (!content || content.others?.isDifference) return;
    const end_s = content.range_s[1];
    const labels: BoundLabel[] = [];
    for (const { bounds, colour, shown } of content.lines) {
      const scale = scaleOf(shown.unit);
      const { min, max } = u.scales[scale];
      const isShown = ({ value, until_s }: (typeof bounds)[number]) => value >= min! && value <= max! && until_s >= content.range_s[0];
      for (const { name, value, from_s, until_s } of bounds.filter(isShown)) {
        stroke(u, [[Math.max(from_s, content.range_s[0]), value], [Math.min(end_s, until_s), value]], scale, { colour: style.colour(colour), width: 1.5, dash: [6, 4] });
        labels.push({ name, y: u.valToPos(value, scale, true) - 2 * devicePixelRatio });
      }
    }
    const right = u.bbox.left + u.bbox.width - 4 * devicePixelRatio;
    for (const { name, y } of joined(labels, LABEL_PX * devicePixelRatio)) word(u, name, [right, y], String(style.axis.font), style.colour("ink"), "right");
  }
}

const scaleOf = (unit: string) => `in ${unit}`;

/** Returns the data of the chart: where it draws differences, the lines themselves are left out. */
function dataOf({ lines, others, stretch }: Content): uPlot.AlignedData {
  if (!others?.isDifference) return stretch.data;
  return [stretch.data[0], ...lines.map(() => new Array<null>(stretch.length).fill(null))];
}

function seriesOf(line: DrawnLine, colour: string): uPlot.Series {
  const series: uPlot.Series = { label: line.label, stroke: colour, scale: scaleOf(line.shown.unit), width: 2, pxAlign: 0, points: { show: false } };
  if (!line.line.wraps) return series;
  series.gaps = (u, seriesIndex, first, last) => {
    const values = u.data[seriesIndex];
    const pixel = (i: number) => u.valToPos(u.data[0][i], "x", true);
    return wrapPlaces(values, first, last, line.half).map(([from, to]): [number, number] => [pixel(from), pixel(to)]);
  };
  return series;
}
