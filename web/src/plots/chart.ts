import uPlot from "uplot";
import { fixed, scientific } from "../app/format";
import type { OtherLines } from "../runs/other_lines";
import type { DrawnLine } from "./drawn";
import type { Fan } from "./fan";
import type { Stretch } from "./stretch";

/** Data of a plot for its charts: the lines over the visible time. */
export interface Content {
  lines: DrawnLine[];
  /** Values of the lines over the visible time in displayed units; the first array holds the times. */
  stretch: Stretch;
  /** Futures over time. */
  fan: Fan;
  /** Lines of kept runs; null where there are none. */
  others: OtherLines | null;
  /** The visible time, s. */
  range_s: [number, number];
  /** Time that is shown, and whether it is before the newest time. */
  shown_s: number;
  isBack: boolean;
  /** Time of the record from which `now` reads, s. */
  row_s: number;
  /** Returns the value of a line at the time that is shown. */
  now(line: DrawnLine): number;
}

/** A way to draw the lines of a plot. */
export interface Chart {
  /** Draws into the area of the chart; reads the visible data again only if it has changed. */
  draw(content: Content): void;
  resize(width: number, height: number): void;
  /** Returns the value of each line for the legend, at the crosshair if there is one. */
  values(content: Content): string[];
  /** Returns the value of each line of a kept run for the legend; empty if the chart draws none. */
  otherValues?(content: Content): string[];
  /** Describes the position of the crosshair; empty if there is none. */
  at(content: Content): string;
  /** Returns further text for below the picture. */
  notes(content: Content): string[];
  /** Returns the content as a table of numbers; the first row holds the headings. */
  table(content: Content): string[][];
  canvas(): HTMLCanvasElement | null;
  destroy(): void;
}

/** Colours and font that the page has at present. */
export interface Style {
  colour(name: string): string;
  axis: Pick<uPlot.Axis, "stroke" | "font" | "labelFont" | "ticks" | "grid">;
}

export function styleOf(): Style {
  const style = getComputedStyle(document.documentElement);
  const colour = (name: string) => style.getPropertyValue(`--${name}`).trim();
  const font = `12px ${colour("font")}`;
  const grid = { stroke: colour("plot-grid"), width: 1 };
  return { colour, axis: { stroke: colour("muted"), font, labelFont: font, ticks: { show: false }, grid } };
}

/** Space for the part of the last number that extends beyond the axis, pixels. */
const LAST_TICK_PX = 24;
const AXIS_PX = { across: 28, upright: 48, label: 18 };

/** Numbers below this are written with a power of ten on an axis. */
const TINY = 1e-5;

export function tick(value: number): string {
  return Math.abs(value) >= TINY || value === 0 ? fixed(value, 6).replace(/\.0+$|(\.\d*?)0+$/, "$1") : scientific(value);
}

/** Returns the horizontal axis. */
export function acrossAxis(style: Style, values: (value: number) => string, label?: string): uPlot.Axis {
  const named = label === undefined ? {} : { label, labelSize: AXIS_PX.label };
  return { ...style.axis, ...named, size: AXIS_PX.across, values: (_u, splits) => splits.map(values) };
}

/** Returns a vertical axis for a unit; all axes except the first stand on the right, without a grid. */
export function uprightAxis(style: Style, scale: string, place: number, label: string): uPlot.Axis {
  const side = place === 0 ? 3 : 1;
  const grid = place === 0 ? style.axis.grid : { show: false };
  const named = label === "" ? {} : { label, labelSize: AXIS_PX.label };
  return { ...style.axis, ...named, scale, side, grid, size: AXIS_PX.upright, values: (_u, splits) => splits.map(tick) };
}

export function paddingOf(axes: number): uPlot.Padding {
  return [8, axes > 1 ? 8 : LAST_TICK_PX, 0, 0];
}

/** Smallest share of the chart's height that the lines keep: a limit that leaves them less is not drawn. */
const LINES_SHARE = 0.15;
const MARGIN = 0.06;
/**
 * Smallest range of an axis, relative to a nearly constant value: a narrower range would show rounding errors as
 * motion.
 */
const LEAST_SHARE = 1e-6;
/** An axis includes zero if the range of the lines exceeds this share of their largest magnitude. */
const FLAT = 0.25;

/** Returns the range of an axis, with a margin around lines, zero and limits. */
export function heightsOf(low: number | null, high: number | null, least: number, bounds: readonly number[]): [number, number] {
  let [bottom, top] = [low ?? 0, high ?? 0];
  const size = Math.max(Math.abs(bottom), Math.abs(top));
  if (top - bottom > FLAT * size) [bottom, top] = [Math.min(bottom, 0), Math.max(top, 0)];
  // If all values are zero, the axis has one unit to either side.
  const lack = (size === 0 ? 1 : Math.max(least, LEAST_SHARE * size)) - (top - bottom) / 2;
  if (lack > 0) [bottom, top] = [bottom - lack, top + lack];
  const drawn = top - bottom;
  for (const bound of bounds) {
    const [lower, upper] = [Math.min(bottom, bound), Math.max(top, bound)];
    if (drawn >= LINES_SHARE * (upper - lower)) [bottom, top] = [lower, upper];
  }
  const margin = MARGIN * (top - bottom);
  return [bottom - margin, top + margin];
}

/** Labels of the axes of a chart that the app paints. */
export interface PaintedAxes {
  across: string;
  upwards: string;
  /** Formats a number of the horizontal axis. */
  written?: (value: number) => string;
}

/** Chart with axes from the library and a content that the app paints. */
export class Painted {
  private readonly chart: uPlot;

  constructor(area: HTMLElement, { across, upwards, written = tick }: PaintedAxes, paint: (u: uPlot, style: Style) => void) {
    const style = styleOf();
    const options: uPlot.Options = {
      width: area.clientWidth,
      height: area.clientHeight,
      legend: { show: false },
      padding: paddingOf(1),
      cursor: { show: false },
      scales: { x: { time: false }, y: {} },
      axes: [acrossAxis(style, written, across), uprightAxis(style, "y", 0, upwards)],
      hooks: { draw: [(u) => paint(u, style)] },
      series: [{}, { scale: "y" }],
    };
    this.chart = new uPlot(options, [[0, 1], [null, null]], area);
  }

  /** Repaints the chart between these ends of its axes. */
  fit([left, right]: [number, number], [bottom, top]: [number, number]): void {
    this.chart.setData([[left, right], [null, null]], false);
    this.chart.batch(() => {
      this.chart.setScale("x", { min: left, max: right });
      this.chart.setScale("y", { min: bottom, max: top });
    });
  }

  resize(width: number, height: number): void {
    this.chart.setSize({ width, height });
  }

  get canvas(): HTMLCanvasElement {
    return this.chart.ctx.canvas;
  }

  destroy(): void {
    this.chart.destroy();
  }
}

/** Returns the ends of the axes of a chart: left, right, bottom, top. */
export function endsOf(u: uPlot): [number, number, number, number] {
  const { x, y } = u.scales;
  return [x.min ?? 0, x.max ?? 1, y.min ?? 0, y.max ?? 1];
}

/** Dashes for the lines of a plot, pixels, in plots that tell runs by their colours. */
const DASHES_PX = [[7, 4], [2, 3], [11, 3, 2, 3], [14, 6], [4, 2], [7, 2, 2, 2, 2, 2], [3, 7], [18, 4]];

/** Returns the dashes of a line of a kept run, pixels: they tell which line of the plot it is. */
export function dashOf(place: number): number[] {
  return DASHES_PX[place % DASHES_PX.length];
}

/** Draws a line through points on a chart, in the units of its axes. */
export function stroke(u: uPlot, points: Iterable<[number, number]>, scale: string, style: { colour: string; width: number; dash?: number[] }): void {
  const { ctx, bbox } = u;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.beginPath();
  for (const [x, y] of points) ctx.lineTo(u.valToPos(x, "x", true), u.valToPos(y, scale, true));
  ctx.strokeStyle = style.colour;
  ctx.lineWidth = style.width * devicePixelRatio;
  ctx.setLineDash((style.dash ?? []).map((one) => one * devicePixelRatio));
  ctx.stroke();
  ctx.restore();
}

/** Fills a polygon on a chart. */
export function fill(u: uPlot, points: Iterable<[number, number]>, scale: string, colour: string): void {
  const { ctx } = u;
  ctx.save();
  ctx.beginPath();
  for (const [x, y] of points) ctx.lineTo(u.valToPos(x, "x", true), u.valToPos(y, scale, true));
  ctx.closePath();
  ctx.globalAlpha = 0.3;
  ctx.fillStyle = colour;
  ctx.fill();
  ctx.restore();
}

/** Draws a dot with a ring on a chart. */
export function dot(u: uPlot, [x, y]: [number, number], scale: string, colour: string, ring: string): void {
  const { ctx } = u;
  ctx.save();
  ctx.beginPath();
  ctx.arc(u.valToPos(x, "x", true), u.valToPos(y, scale, true), 5 * devicePixelRatio, 0, 2 * Math.PI);
  ctx.fillStyle = colour;
  ctx.strokeStyle = ring;
  ctx.lineWidth = 2 * devicePixelRatio;
  ctx.fill();
  ctx.stroke();
  ctx.restore();
}

/** Writes a label next to a point on a chart. */
export function word(u: uPlot, text: string, [x, y]: [number, number], font: string, colour: string, align: CanvasTextAlign): void {
  const { ctx } = u;
  ctx.save();
  ctx.font = font.replace(/^\d+px/, (size) => `${Number.parseFloat(size) * 0.92 * devicePixelRatio}px`);
  ctx.fillStyle = colour;
  ctx.textAlign = align;
  ctx.textBaseline = "bottom";
  ctx.fillText(text, x, y);
  ctx.restore();
}
