import type uPlot from "uplot";
import type { Outlook } from "../forecast/outlook";
import { texts } from "../texts";
import type { Places } from "./stretch";

/** Opacity of the wide and the narrow band. */
const DENSITIES = [0.16, 0.26];
const DASHES_PX = [5, 4];
/** Number of times for which a table gives values. */
const TOLD = 4;

/** Futures over time: for each line of a plot two bands, with 90 and 50 % of the futures, and a dashed median. */
export class Fan {
  private times: Float64Array = new Float64Array();
  /** Lines of the fan, for each line of the plot. */
  private fans: Float64Array[][] = [];

  fill(outlook: Outlook | null, lines: readonly Places[], scale: (value: number, line: number) => number): void {
    const length = outlook?.length ?? 0;
    this.times = Float64Array.from({ length }, (_, k) => outlook!.timeAt(k));
    this.fans = outlook ? lines.map((places, i) => outlook.fan(places).map((line) => line.map((value) => scale(value, i)))) : [];
  }

  /** Smallest and largest value of all fans; Infinity and -Infinity without futures. */
  get range(): [number, number] {
    return this.rangeOf(this.fans.map((_, i) => i));
  }

  rangeOf(lines: readonly number[]): [number, number] {
    const values = this.fans.filter((_, i) => lines.includes(i)).flatMap((fan) => [fan[0], fan[fan.length - 1]]);
    const all = (choose: (...of: number[]) => number, start: number) =>
      values.reduce((so, line) => line.reduce((best, value) => (Number.isFinite(value) ? choose(best, value) : best), so), start);
    return [all(Math.min, Infinity), all(Math.max, -Infinity)];
  }

  /** Returns rows of a table: a time, and the wide band of each line. */
  rows(write: (value: number, line: number) => string): string[][] {
    const last = this.times.length - 1;
    const told = Array.from({ length: TOLD }, (_, i) => Math.round((last * (i + 1)) / TOLD));
    const band = (fan: Float64Array[], i: number, k: number) => texts.forecast.band(write(fan[0][k], i), write(fan[fan.length - 1][k], i));
    return last < TOLD ? [] : told.map((k) => [texts.forecast.foreseen(write(this.times[k], -1)), ...this.fans.map((fan, i) => band(fan, i, k))]);
  }

  /** Draws the fan of each line in the line's colour, on the line's axis. */
  draw(u: uPlot, colours: readonly string[], scales: readonly string[]): void {
    if (this.times.length < 2) return;
    const { ctx, bbox } = u;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    this.fans.forEach((fan, i) => this.paint(u, fan, colours[i], scales[i]));
    ctx.restore();
  }

  private paint(u: uPlot, fan: Float64Array[], colour: string, scale: string): void {
    const { ctx } = u;
    [ctx.fillStyle, ctx.strokeStyle] = [colour, colour];
    DENSITIES.forEach((density, i) => {
      ctx.globalAlpha = density;
      ctx.beginPath();
      this.trace(u, fan[i], scale);
      this.trace(u, fan[fan.length - 1 - i], scale, true);
      ctx.fill();
    });
    ctx.globalAlpha = 1;
    ctx.lineWidth = 1.5 * devicePixelRatio;
    ctx.setLineDash(DASHES_PX.map((px) => px * devicePixelRatio));
    ctx.beginPath();
    this.trace(u, fan[(fan.length - 1) / 2], scale);
    ctx.stroke();
  }

  /** Adds a line to the path, forwards or backwards. */
  private trace({ ctx, valToPos }: uPlot, line: Float64Array, scale: string, isBack = false): void {
    for (let n = 0; n < line.length; n++) {
      const k = isBack ? line.length - 1 - n : n;
      if (Number.isFinite(line[k])) ctx.lineTo(valToPos(this.times[k], "x", true), valToPos(line[k], scale, true));
    }
  }
}
