import uPlot from "uplot";
import { fixed, scientific } from "../app/format";
import type { DrawnLine } from "./drawn";
import type { Fan } from "./fan";
import type { Stretch } from "./stretch";

/** Data of all charts of a plot: lines over the visible stretch of the recording. */
export interface Content {
  lines: DrawnLine[];
  /** The visible numbers in displayed units; the first array has the times. */
  stretch: Stretch;
  /** Futures over time. */
  fan: Fan;
  /** The visible stretch, s. */
  range_s: [number, number];
  /** The moment that is shown; whether it lies before the newest. */
  shown_s: number;
  isBack: boolean;
  /** The value of a line at the moment that is shown. */
  now(line: DrawnLine): number;
}

/** A way to show lines. */
export interface Chart {
  /** Draws into its area; the visible data is read again only if it is stale. */
  draw(content: Content): void;
  resize(width: number, height: number): void;
  /** For the legend: the value of each line, at the crosshair if there is one. */
  values(content: Content): string[];
  /** The position of the crosshair in words; empty if there is none. */
  at(content: Content): string;
  /** Further text under the picture. */
  notes(content: Content): string[];
  /** Table of the content in numbers: its first row has the headings. */
  table(content: Content): string[][];
  canvas(): HTMLCanvasElement | null;
  destroy(): void;
}

/** Present colours and font of the page. */
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

/** Space for the half of the last number that extends beyond the axis, pixels. */
const LAST_TICK_PX = 24;
const AXIS_PX = { across: 28, upright: 48, label: 18 };

/** Numbers on an axis below this have a power of ten. */
const TINY = 1e-5;

export function tick(value: number): string {
  return Math.abs(value) >= TINY || value === 0 ? fixed(value, 6).replace(/\.0+$|(\.\d*?)0+$/, "$1") : scientific(value);
}

/** The axis across the bottom. */
export function acrossAxis(style: Style, values: (value: number) => string, label?: string): uPlot.Axis {
  const named = label === undefined ? {} : { label, labelSize: AXIS_PX.label };
  return { ...style.axis, ...named, size: AXIS_PX.across, values: (_u, splits) => splits.map(values) };
}

/** An upright axis of a unit; those after the first stand on the right, without a grid. */
export function uprightAxis(style: Style, scale: string, place: number, label: string): uPlot.Axis {
  const side = place === 0 ? 3 : 1;
  const grid = place === 0 ? style.axis.grid : { show: false };
  const named = label === "" ? {} : { label, labelSize: AXIS_PX.label };
  return { ...style.axis, ...named, scale, side, grid, size: AXIS_PX.upright, values: (_u, splits) => splits.map(tick) };
}

export function paddingOf(axes: number): uPlot.Padding {
  return [8, axes > 1 ? 8 : LAST_TICK_PX, 0, 0];
}

/** Smallest share of the height for the lines if a limit is also drawn. */
const LINES_SHARE = 0.15;
const MARGIN = 0.06;
/** Smallest range, relative to a nearly constant value: a narrower one would show rounding noise as motion. */
const LEAST_SHARE = 1e-6;
/** If the range of lines is below this share of their distance from zero, the axis leaves zero out. */
const FLAT = 0.25;

/** Range of an axis, with a margin around lines, zero and limits. */
export function heightsOf(low: number | null, high: number | null, least: number, bounds: readonly number[]): [number, number] {
  let [bottom, top] = [low ?? 0, high ?? 0];
  const size = Math.max(Math.abs(bottom), Math.abs(top));
  if (top - bottom > FLAT * size) [bottom, top] = [Math.min(bottom, 0), Math.max(top, 0)];
  // Nothing but zeros: one unit to either side.
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

/** Labels of the axes of a hand-painted chart. */
export interface PaintedAxes {
  across: string;
  upwards: string;
  /** Formats a number of the horizontal axis. */
  written?: (value: number) => string;
}

/** A chart with axes from the library and a hand-painted content. */
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

  /** Repaints it between these ends of its axes. */
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

/** The ends of the axes of a chart: left, right, bottom, top. */
export function endsOf(u: uPlot): [number, number, number, number] {
  const { x, y } = u.scales;
  return [x.min ?? 0, x.max ?? 1, y.min ?? 0, y.max ?? 1];
}

/** A line from point to point on a chart, in the unit of its axes. */
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

/** Fills the polygon of points on a chart. */
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

/** A ring with a dot on a chart. */
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

/** A label next to a point on a chart. */
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
