import uPlot from "uplot";
import { fixed } from "../app/format";
import { texts } from "../texts";
import { acrossAxis, dot, heightsOf, paddingOf, stroke, styleOf, tick, uprightAxis } from "./chart";
import type { Chart, Content, Style } from "./chart";
import type { DrawnLine } from "./drawn";
import { places } from "./table";

/** The first line across, the second upwards: the path of the two over the stretch in sight. */
export class PhaseChart implements Chart {
  private chart: uPlot | null = null;
  private content: Content | null = null;

  constructor(private readonly area: HTMLElement) {}

  draw(content: Content): void {
    this.content = content;
    this.chart ??= this.make(content);
    const [, xs, ys] = content.stretch.data;
    const [x, y] = [endsOf(xs ?? []), endsOf(ys ?? [])];
    this.chart.setData([x, [null, null]] as unknown as uPlot.AlignedData, false);
    this.chart.batch(() => {
      this.chart!.setScale("x", { min: x[0], max: x[1] });
      this.chart!.setScale("y", { min: y[0], max: y[1] });
    });
  }

  resize(width: number, height: number): void {
    this.chart?.setSize({ width, height });
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
    return this.chart?.ctx.canvas ?? null;
  }

  destroy(): void {
    this.chart?.destroy();
    this.chart = null;
  }

  private make({ lines }: Content): uPlot {
    const style = styleOf();
    const [across, upwards] = lines;
    const options: uPlot.Options = {
      width: this.area.clientWidth,
      height: this.area.clientHeight,
      legend: { show: false },
      padding: paddingOf(1),
      cursor: { show: false },
      scales: { x: { time: false }, y: {} },
      axes: [acrossAxis(style, tick, across ? nameOf(across) : ""), uprightAxis(style, "y", 0, upwards ? nameOf(upwards) : "")],
      hooks: { draw: [(u) => this.drawPath(u, style)] },
      series: [{}, { scale: "y" }],
    };
    return new uPlot(options, [[0, 1], [null, null]], this.area);
  }

  /** The path in time, and where the moment that is shown lies on it. */
  private drawPath(u: uPlot, style: Style): void {
    const { content } = this;
    if (!content || content.lines.length < 2) return;
    const [across, upwards] = content.lines;
    const [, xs, ys] = content.stretch.data;
    const path = Array.from(xs, (x, i): [number, number] => [x, ys[i]]).filter(([x, y]) => Number.isFinite(x) && Number.isFinite(y));
    stroke(u, path, "y", { colour: style.colour(upwards.colour), width: 1.5 });
    dot(u, [content.now(across), content.now(upwards)], "y", style.colour("accent"), style.colour("surface"));
  }
}

function nameOf({ label, shown }: DrawnLine): string {
  return shown.unit ? `${label}, ${shown.unit}` : label;
}

function endsOf(values: ArrayLike<number>): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < values.length; i++) [low, high] = [Math.min(low, values[i]), Math.max(high, values[i])];
  return heightsOf(low <= high ? low : null, low <= high ? high : null, 1e-9, []);
}
