import uPlot from "uplot";
import { texts } from "../texts";
import type { OtherLine } from "../runs/other_lines";
import { acrossAxis, dashOf, paddingOf, stroke, styleOf, tick, uprightAxis } from "./chart";
import type { Chart, Content, Style } from "./chart";
import type { DrawnLine } from "./drawn";
import { evenEnd, isResolved, linesThatHold, loadTransform, peakOf, spectraOf } from "./spectrum";
import type { Spectrum, Transform } from "./spectrum";
import { places } from "./table";

/** Share of the variance that is visible, and factor by which the axis extends beyond it. */
const SHOWN_SHARE = 0.995;
const BEYOND = 1.5;
const FEWEST_LINES = 8;
/** Smallest interval between two spectra during a run, ms. */
const EVERY_MS = 500;

/**
 * Chart of spectral densities over the angular frequency, computed from the evenly spaced records in the visible time.
 */
export class SpectrumChart implements Chart {
  private chart: uPlot | null = null;
  private transformOf: ((length: number) => Transform) | null = null;
  private found: Spectrum[] = [];
  private others: { one: OtherLine; spectrum: Spectrum }[] = [];
  private of_s: [number, number] = [0, 0];
  private reckoned_ms = -Infinity;

  constructor(
    private readonly area: HTMLElement,
    private readonly parts: () => number,
    loaded: () => void,
  ) {
    void loadTransform().then((transformOf) => {
      this.transformOf = transformOf;
      loaded();
    });
  }

  draw(content: Content): void {
    const now = performance.now();
    if (!this.transformOf || (this.chart && now - this.reckoned_ms < EVERY_MS)) return;
    this.reckoned_ms = now;
    this.reckon(content, this.transformOf);
    this.chart ??= this.make(content);
    const [first] = this.found;
    const data: uPlot.AlignedData = first
      ? [first.omega, ...this.found.map(({ density }) => density)]
      : [[0, 1], ...content.lines.map(() => [null, null])];
    this.chart.setData(data, false);
    this.chart.setScale("x", { min: 0, max: this.end() });
  }

  private reckon({ others, range_s, stretch }: Content, transformOf: (length: number) => Transform): void {
    const [times, ...columns] = stretch.data;
    const [from, to] = evenEnd(times);
    this.of_s = [times[from], times[to - 1]];
    this.found = this.spectra(times, columns, transformOf);
    this.others = (others?.all ?? []).flatMap((one) => {
      const [times_s, values] = others!.columnOf(one, range_s);
      return this.spectra(times_s, [values], transformOf).map((spectrum) => ({ one, spectrum }));
    });
  }

  /** Returns the spectra of lines over the evenly spaced records at the end; none if there are too few. */
  private spectra(times_s: Float64Array, columns: readonly Float64Array[], transformOf: (length: number) => Transform): Spectrum[] {
    const [from, to] = evenEnd(times_s);
    const step_s = (times_s[to - 1] - times_s[from]) / (to - 1 - from);
    return spectraOf(columns.map((values) => values.subarray(from, to)), step_s, this.parts(), transformOf);
  }

  /** Returns the frequency up to which nearly all of the variance is visible, rad/s. */
  private end(): number {
    const [first] = this.found;
    if (!first) return 1;
    const lines = Math.max(FEWEST_LINES, ...this.found.map((one) => Math.ceil(BEYOND * linesThatHold(one, SHOWN_SHARE))));
    return Math.min(lines, first.omega.length - 1) * first.resolution;
  }

  resize(width: number, height: number): void {
    this.chart?.setSize({ width, height });
  }

  private get index(): number | null {
    const index = this.chart?.cursor.idx ?? null;
    return index !== null && this.found[0] && index < this.found[0].omega.length ? index : null;
  }

  values({ lines }: Content): string[] {
    const { index } = this;
    return lines.map((_, i) => (this.found[i] ? digits(this.found[i].density[index ?? peakOf(this.found[i])]) : "–"));
  }

  at(): string {
    const { index } = this;
    if (index === null) return this.found.length > 0 ? texts.plots.at_peak : "";
    return texts.plots.at_frequency(...wordsOf(this.found[0].omega[index]));
  }

  notes({ lines }: Content): string[] {
    const [first] = this.found;
    if (!first) return [texts.plots.spectrum_short];
    const peaks = lines.flatMap(({ label }, i) => {
      const peak = peakOf(this.found[i]);
      if (!(this.found[i].density[peak] > 0)) return [];
      if (!isResolved(this.found[i])) return [texts.plots.peak_unresolved(label, digits((2 * Math.PI) / first.resolution))];
      return [texts.plots.peak(label, ...wordsOf(first.omega[peak]))];
    });
    const [from, to] = this.of_s.map((one) => String(Number(one.toPrecision(6))));
    return [...peaks, texts.plots.resolution(digits(first.resolution), first.segments, from, to)];
  }

  table({ lines }: Content): string[][] {
    const [first] = this.found;
    if (!first) return [[texts.plots.spectrum_short]];
    const inSight = Math.round(this.end() / first.resolution);
    const rows = places(inSight + 1).map((k) => [`${digits(first.omega[k])} rad/s`, ...this.found.map(({ density }) => digits(density[k]))]);
    return [["", ...lines.map(headOf)], ...rows];
  }

  canvas(): HTMLCanvasElement | null {
    return this.chart?.ctx.canvas ?? null;
  }

  destroy(): void {
    this.chart?.destroy();
    this.chart = null;
    this.reckoned_ms = -Infinity;
  }

  /** Returns the largest density of the kept runs with a unit; 0 if there is none. */
  private highest(unit: string): number {
    const own = this.others.filter(({ one }) => unitOf(one.own) === unit);
    return own.reduce((most, { spectrum }) => Math.max(most, spectrum.density[peakOf(spectrum)]), 0);
  }

  /** Draws the spectra of kept runs, each with the resolution of its records. */
  private drawOthers(u: uPlot, style: Style): void {
    for (const { one: { run, own, place }, spectrum: { density, omega } } of this.others) {
      const points = Array.from(omega, (x, k): [number, number] => [x, density[k]]);
      stroke(u, points, unitOf(own), { colour: style.colour(run.colour), width: 1.75, dash: dashOf(place) });
    }
  }

  private make({ lines }: Content): uPlot {
    const style = styleOf();
    const units = [...new Set(lines.map(unitOf))];
    const options: uPlot.Options = {
      width: this.area.clientWidth,
      height: this.area.clientHeight,
      legend: { show: false },
      padding: paddingOf(units.length),
      cursor: { drag: { x: false, y: false }, points: { size: 7 } },
      scales: { x: { time: false }, ...Object.fromEntries(units.map((unit) => [unit, { range: (_u: uPlot, _low: number, high: number): [number, number] => [0, 1.06 * (Math.max(high, this.highest(unit)) || 1)] }])) },
      hooks: { drawAxes: [(u) => this.drawOthers(u, style)] },
      axes: [acrossAxis(style, tick, "rad/s"), ...units.map((unit, place) => uprightAxis(style, unit, place, unit))],
      series: [{}, ...lines.map((line): uPlot.Series => ({ label: line.label, stroke: style.colour(line.colour), scale: unitOf(line), width: 2, points: { show: false } }))],
    };
    return new uPlot(options, [[0, 1], ...lines.map(() => [null, null])] as uPlot.AlignedData, this.area);
  }
}

/** Returns the unit of a density: the squared unit of the line over the unit of the angular frequency. */
function unitOf({ shown }: DrawnLine): string {
  return shown.unit === "" ? "s/rad" : `(${shown.unit})² s/rad`;
}

function headOf(line: DrawnLine): string {
  return `${line.label}, ${unitOf(line)}`;
}

function digits(value: number): string {
  return String(Number(value.toPrecision(3))).replace("-", "−");
}

/** Formats a frequency, and its period in seconds. */
function wordsOf(omega: number): [string, string] {
  return [digits(omega), omega > 0 ? digits((2 * Math.PI) / omega) : "∞"];
}
