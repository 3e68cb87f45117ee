import type { Recording } from "../app/recording/recording";
import { fixed } from "../app/format";
import { heightsOf, styleOf, tick } from "../plots/chart";
import type { DrawnLine } from "../plots/drawn";
import { read, Stretch } from "../plots/stretch";
import { decimalsFor } from "../plots/units";
import { wrapPlaces } from "../plots/window";
import type { Part } from "./layout";

/** A plot over time whose lines are shown beside the ship. */
export interface FilmedLines {
  title: string;
  lines: readonly DrawnLine[];
}

/** Sizes in pixels of 1280x720. */
const PX = { text: 12, title: 14, row: 17, margin: 10, axis: 46, last: 24, foot: 20, line: 2, dot: 4 };
/** Smallest range of an axis, in its unit. */
const LEAST = 1e-6;
/** Approximate distances of the marks of the axes, pixels of 1280x720. */
const TICKS_PX = { across: 80, upwards: 34 };
/** Opacity of the part of the lines that lies ahead. */
const AHEAD = 0.25;
/** Largest number of axes that are labelled. */
const LABELLED = 2;

/** Vertical axis of a unit: its range, and the side on which its numbers stand. */
interface Axis {
  unit: string;
  range: [number, number];
  side: "left" | "right" | "none";
}

/** Marks of an axis: multiples of 1, 2 or 5 times a power of ten. */
export function ticksOf([from, to]: readonly [number, number], most: number): number[] {
  const rough = (to - from) / Math.max(1, most);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((part) => part * power).find((one) => one >= rough * (1 - 1e-9))!;
  const first = Math.ceil(from / step - 1e-9);
  return Array.from({ length: Math.floor(to / step + 1e-9) - first + 1 }, (_, k) => Number(((first + k) * step).toPrecision(12)));
}

/**
 * Draws lines over the times of a film once, and in each frame the moment and the values. The library of the page's plots
 * draws in the pixels of the screen alone; the pixels of a film do not depend on a screen.
 */
export class FilmedPlot {
  private readonly stretch = new Stretch();
  private readonly style = styleOf();
  private readonly axes: Axis[];
  private readonly decimals: number[];
  private readonly area: Part;
  private readonly still: HTMLCanvasElement;

  constructor(
    private readonly plot: FilmedLines,
    private readonly part: Part,
    private readonly scale: number,
    private readonly range_s: readonly [number, number],
    recording: Recording,
  ) {
    const { lines } = plot;
    const { items } = recording.rows;
    const [first, last] = range_s.map((time_s) => recording.rows.indexAt(time_s));
    this.stretch.fill(items, [Math.max(0, first), Math.min(items.length, last + 2)], lines.map(({ places }) => places), (value, i) => lines[i].scaled(value));
    this.axes = [...new Set(lines.map(({ shown }) => shown.unit))].map((unit, k) => this.axisOf(unit, k));
    this.decimals = lines.map(({ shown }) => decimalsFor(shown, Math.max(0, ...this.rangeIn(shown.unit).map(Math.abs))));
    const [margin, axis] = [scale * PX.margin, scale * PX.axis];
    const head = margin + scale * (PX.title + 6 + PX.row * this.rows());
    const right = this.axes.some(({ side }) => side === "right") ? axis : scale * PX.last;
    this.area = { left: axis, top: head, width: part.width - axis - right, height: Math.max(1, part.height - head - scale * PX.foot) };
    this.still = this.drawn();
  }

  /** Draws the plot into a picture at the time of a row. */
  draw(pen: CanvasRenderingContext2D, time_s: number, row: ArrayLike<number>): void {
    const { area, part, scale, style } = this;
    pen.save();
    pen.translate(part.left, part.top);
    pen.drawImage(this.still, 0, 0);
    const x = this.across(time_s);
    pen.globalAlpha = 1 - AHEAD;
    pen.fillStyle = style.colour("surface");
    pen.fillRect(x, area.top, area.left + area.width - x, area.height);
    pen.globalAlpha = 1;
    pen.fillStyle = style.colour("accent");
    pen.fillRect(x - scale / 2, area.top, scale, area.height);
    this.plot.lines.forEach((line) => this.dot(pen, x, line, read(row, line.places)));
    this.legend(pen, (line, i) => fixed(line.scaled(read(row, line.places)), this.decimals[i]));
    pen.restore();
  }

  private dot(pen: CanvasRenderingContext2D, x: number, line: DrawnLine, value: number): void {
    if (!Number.isFinite(value)) return;
    const y = this.up(line.scaled(value), this.axisFor(line));
    if (y < this.area.top || y > this.area.top + this.area.height) return;
    pen.beginPath();
    pen.arc(x, y, this.scale * PX.dot, 0, 2 * Math.PI);
    pen.fillStyle = this.style.colour(line.colour);
    pen.fill();
  }

  /** Writes the lines with their values; two in a row, so that nothing moves when a number becomes longer. */
  private legend(pen: CanvasRenderingContext2D, valueOf: (line: DrawnLine, i: number) => string): void {
    const { part, scale, style } = this;
    const { lines } = this.plot;
    const columns = lines.length > 1 ? 2 : 1;
    const width = (part.width - 2 * scale * PX.margin) / columns;
    lines.forEach((line, i) => {
      const x = scale * PX.margin + (i % columns) * width;
      const y = scale * (PX.margin + PX.title + 6 + PX.row * Math.floor(i / columns));
      pen.fillStyle = style.colour(line.colour);
      pen.fillRect(x, y + scale * 4, scale * 14, scale * 4);
      const value = `${valueOf(line, i)} ${line.shown.unit}`.trim();
      this.pen(pen, "ink", PX.text, "right");
      const room = pen.measureText(value).width;
      pen.fillText(value, x + width - scale * 12, y, width);
      this.pen(pen, "muted", PX.text, "left");
      pen.fillText(line.label, x + scale * 18, y, Math.max(1, width - room - scale * 34));
    });
  }

  private rows(): number {
    return Math.ceil(this.plot.lines.length / 2);
  }

  private rangeIn(unit: string): [number, number] {
    const [, ...columns] = this.stretch.data;
    let [low, high] = [Infinity, -Infinity];
    this.plot.lines.forEach(({ shown }, i) => {
      if (shown.unit === unit) for (const value of columns[i]) if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
    });
    return low <= high ? [low, high] : [0, 0];
  }

  private axisOf(unit: string, k: number): Axis {
    const bounds = this.plot.lines.flatMap((line) => (line.shown.unit === unit ? line.bounds.map(({ value }) => value) : []));
    return { unit, range: heightsOf(...this.rangeIn(unit), LEAST, bounds), side: k >= LABELLED ? "none" : k === 0 ? "left" : "right" };
  }

  private axisFor({ shown }: DrawnLine): Axis {
    return this.axes.find(({ unit }) => unit === shown.unit)!;
  }

  private across(time_s: number): number {
    const [from, to] = this.range_s;
    return this.area.left + (this.area.width * (time_s - from)) / (to - from);
  }

  private up(value: number, { range: [low, high] }: Axis): number {
    return this.area.top + this.area.height * (1 - (value - low) / (high - low));
  }

  private pen(pen: CanvasRenderingContext2D, colour: string, px: number, align: CanvasTextAlign, weight = 400): void {
    pen.font = `${weight} ${this.scale * px}px ${this.style.colour("font")}`;
    pen.fillStyle = this.style.colour(colour);
    [pen.textAlign, pen.textBaseline] = [align, "top"];
  }

  /** Returns everything that is equal in all frames. */
  private drawn(): HTMLCanvasElement {
    const { part, plot, scale, style } = this;
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [part.width, part.height];
    const pen = canvas.getContext("2d")!;
    pen.fillStyle = style.colour("surface");
    pen.fillRect(0, 0, part.width, part.height);
    this.pen(pen, "ink", PX.title, "left", 700);
    pen.fillText(plot.title, scale * PX.margin, scale * PX.margin, part.width - 2 * scale * PX.margin);
    this.drawAxes(pen);
    pen.save();
    pen.beginPath();
    pen.rect(this.area.left, this.area.top, this.area.width, this.area.height);
    pen.clip();
    plot.lines.forEach((line, i) => {
      this.drawBounds(pen, line);
      this.drawLine(pen, line, i);
    });
    pen.restore();
    return canvas;
  }

  private drawAxes(pen: CanvasRenderingContext2D): void {
    const { area, range_s, scale, style } = this;
    const { left, top, width, height } = area;
    pen.fillStyle = style.colour("plot-grid");
    const lines = Math.max(1, Math.floor(height / (scale * TICKS_PX.upwards)));
    const times = ticksOf(range_s, Math.floor(width / (scale * TICKS_PX.across)));
    for (const time_s of times) pen.fillRect(this.across(time_s), top, scale, height);
    for (const axis of this.axes.slice(0, 1)) for (const value of ticksOf(axis.range, lines)) pen.fillRect(left, this.up(value, axis), width, scale);
    this.pen(pen, "muted", PX.text, "center");
    for (const time_s of times) pen.fillText(`${tick(time_s)} s`, this.across(time_s), top + height + scale * 4);
    pen.textBaseline = "middle";
    for (const axis of this.axes.filter(({ side }) => side !== "none")) {
      const isLeft = axis.side === "left";
      pen.textAlign = isLeft ? "right" : "left";
      for (const value of ticksOf(axis.range, lines)) pen.fillText(tick(value), isLeft ? left - scale * 5 : left + width + scale * 5, this.up(value, axis), scale * (PX.axis - 8));
    }
  }

  private drawBounds(pen: CanvasRenderingContext2D, line: DrawnLine): void {
    const { scale, style } = this;
    const [start_s, end_s] = this.range_s;
    pen.strokeStyle = style.colour(line.colour);
    pen.lineWidth = scale * 1.5;
    pen.setLineDash([scale * 6, scale * 4]);
    for (const { value, from_s, until_s } of line.bounds) {
      if (until_s < start_s || from_s > end_s) continue;
      const y = this.up(value, this.axisFor(line));
      pen.beginPath();
      pen.moveTo(this.across(Math.max(from_s, start_s)), y);
      pen.lineTo(this.across(Math.min(until_s, end_s)), y);
      pen.stroke();
    }
    pen.setLineDash([]);
  }

  private drawLine(pen: CanvasRenderingContext2D, line: DrawnLine, i: number): void {
    const [times, ...columns] = this.stretch.data;
    const axis = this.axisFor(line);
    const wraps = line.line.wraps ? new Set(wrapPlaces(columns[i], 0, columns[i].length - 1, line.half).map(([, next]) => next)) : null;
    let isDown = false;
    pen.beginPath();
    for (let k = 0; k < times.length; k++) {
      const value = columns[i][k];
      const [x, y] = [this.across(times[k]), this.up(value, axis)];
      if (!Number.isFinite(value)) isDown = false;
      else if (!isDown || wraps?.has(k)) pen.moveTo(x, y);
      else pen.lineTo(x, y);
      if (Number.isFinite(value)) isDown = true;
    }
    pen.strokeStyle = this.style.colour(line.colour);
    pen.lineWidth = this.scale * PX.line;
    pen.lineJoin = "round";
    pen.stroke();
  }
}
