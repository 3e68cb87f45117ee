import type uPlot from "uplot";
import { fixed } from "../app/format";
import type { PhasePath } from "../runs/other_lines";
import { texts } from "../texts";
import { dot, heightsOf, Painted, stroke } from "./chart";
import type { Chart, Content, Style } from "./chart";
import type { DrawnLine } from "./drawn";
import { places } from "./table";

/** Chart of the second line over the first one: their path during the visible time. */
export class PhaseChart implements Chart {
  private chart: Painted | null = null;
  private content: Content | null = null;
  private others: PhasePath[] = [];

  constructor(private readonly area: HTMLElement) {}

  draw(content: Content): void {
    this.content = content;
    this.chart ??= this.make(content);
    const [, xs = [], ys = []] = content.stretch.data;
    this.others = content.others?.phases(content.range_s) ?? [];
    const points = this.others.flatMap((other) => other.points);
    this.chart.fit(roundOf(xs, points.map(([x]) => x)), roundOf(ys, points.map(([, y]) => y)));
  }

  resize(width: number, height: number): void {
    this.chart?.resize(width, height);
  }

  values(content: Content): string[] {
    return content.lines.map((line) => fixed(content.now(line), line.decimals));
  }

  at(): string {
    return "";
  }

  notes({ lines }: Content): string[] {
    return lines.length < 2 ? [texts.plots.phase_needs] : lines.length > 2 ? [texts.plots.phase_first] : [];
  }

  table({ lines, stretch }: Content): string[][] {
    const [times, ...columns] = stretch.data;
    const pair = lines.slice(0, 2);
    const rows = places(times.length).map((at) => [`${Number(times[at].toPrecision(6))} s`, ...pair.map((line, i) => fixed(columns[i][at], line.decimals))]);
    return [["", ...pair.map(nameOf)], ...rows];
  }

  canvas(): HTMLCanvasElement | null {
    return this.chart?.canvas ?? null;
  }

  destroy(): void {
    this.chart?.destroy();
    this.chart = null;
  }

  private make({ lines: [across, upwards] }: Content): Painted {
    const axes = { across: across ? nameOf(across) : "", upwards: upwards ? nameOf(upwards) : "" };
    return new Painted(this.area, axes, (u, style) => this.drawPath(u, style));
  }

  /** Draws the paths of kept runs, the path, and the point at the time that is shown. */
  private drawPath(u: uPlot, style: Style): void {
    const { content } = this;
    if (!content || content.lines.length < 2) return;
    const [across, upwards] = content.lines;
    const [, xs, ys] = content.stretch.data;
    const path = Array.from(xs, (x, i): [number, number] => [x, ys[i]]).filter(([x, y]) => Number.isFinite(x) && Number.isFinite(y));
    for (const { run, points } of this.others) stroke(u, points, "y", { colour: style.colour(run.colour), width: 1.25, dash: [7, 4] });
    stroke(u, path, "y", { colour: style.colour(upwards.colour), width: 1.5 });
    dot(u, [content.now(across), content.now(upwards)], "y", style.colour("accent"), style.colour("surface"));
  }
}

function nameOf({ label, shown }: DrawnLine): string {
  return shown.unit ? `${label}, ${shown.unit}` : label;
}

/** Returns the range of the values with a margin. */
function roundOf(...lists: readonly ArrayLike<number>[]): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const values of lists) for (let i = 0; i < values.length; i++) [low, high] = [Math.min(low, values[i]), Math.max(high, values[i])];
  return heightsOf(low <= high ? low : null, low <= high ? high : null, 1e-9, []);
}
