import type uPlot from "uplot";
import { indexAt } from "../app/recording/series";
import { dashOf, stroke, word } from "../plots/chart";
import type { Style } from "../plots/chart";
import { DrawnLine } from "../plots/drawn";
import { read, Stretch } from "../plots/stretch";
import type { Angle } from "../plots/units";
import { make } from "../ui/dom";
import type { KeptRun } from "./kept";
import { words } from "./words";

/** Kept runs in the plots, and whether plots over time show how the present run differs from them. */
export interface Compared {
  runs: readonly KeptRun[];
  isDifference: boolean;
}

/** Largest number of points that are drawn of a line; of more, the extremes are drawn. */
const MOST_POINTS = 4000;

/** Line of a kept run beside a line of a plot. */
export interface OtherLine {
  run: KeptRun;
  /** Index of the line in the plot. */
  place: number;
  own: DrawnLine;
}

type Point = [number, number];

/** Points of a line in stretches without a gap, with their smallest and largest value. */
interface Path {
  stretches: Point[][];
  range: [number, number];
}

/** Path of a kept run: its second line over its first one. */
export interface PhasePath {
  run: KeptRun;
  points: Point[];
}

/** Lines of kept runs beside the lines of a plot, or the differences of the two, over the visible time. */
export class OtherLines {
  readonly all: readonly OtherLine[];
  readonly isDifference: boolean;
  private paths: Path[] = [];
  private ofRange = "";
  /** Runs of which values between two recorded times were interpolated. */
  private readonly interpolated = new Set<KeptRun>();

  constructor(
    { runs, isDifference }: Compared,
    private readonly lines: readonly DrawnLine[],
    angle: Angle,
  ) {
    this.isDifference = isDifference;
    this.all = runs.flatMap((run) =>
      lines.flatMap((drawn, place) => {
        const line = run.line(drawn.line.id);
        if (!line || line.unit !== drawn.line.unit) return [];
        return [{ run, place, own: new DrawnLine(line, drawn.label, run.colour, run.facts.columns, angle, []) }];
      }),
    );
  }

  /** Takes the visible time, and the lines of the present run over it. */
  fill([from_s, to_s]: [number, number], present: Stretch): void {
    if (this.isDifference) {
      this.interpolated.clear();
      const [times, ...columns] = present.data;
      this.paths = this.all.map((one) => this.difference(one, times, columns[one.place], from_s));
    } else if (this.ofRange !== `${from_s} ${to_s}`) {
      this.paths = this.all.map((one) => pathOf(...this.columnOf(one, [from_s, to_s], true), one.own));
      this.ofRange = `${from_s} ${to_s}`;
    }
  }

  /**
   * Returns times and values of a line over a range of time; with `before`, also those of the record before it, where a
   * drawn line starts.
   */
  columnOf({ run, own }: OtherLine, [from_s, to_s]: [number, number], before = false): [Float64Array, Float64Array] {
    const { rows } = run;
    const first = indexAt(rows, from_s);
    const isAt = rows[first]?.time_s === from_s;
    const from = Math.max(0, before || isAt ? first : first + 1);
    const stretch = new Stretch();
    stretch.fill(rows, [from, Math.max(from, indexAt(rows, to_s) + 1)], [own.places], (value) => own.scaled(value));
    const [times, values] = stretch.data;
    return [times, values];
  }

  private difference(one: OtherLine, times: Float64Array, values: Float64Array, from_s: number): Path {
    const first = times[0] < from_s ? 1 : 0;
    const found = values.slice(first).map((value, k) => this.less(one, value, times[first + k]));
    return pathOf(times.subarray(first), found, one.own);
  }

  /** Returns the value of the present run less that of a kept run; of an angle, within half a turn. */
  private less(one: OtherLine, value: number, time_s: number): number {
    const difference = value - this.valueAt(one, time_s);
    const { own } = one;
    return own.line.wraps ? within(difference, own.half) : difference;
  }

  /** Returns the value of a kept run at a time, interpolated linearly if it is not recorded; NaN outside the run. */
  valueAt({ run, own }: OtherLine, time_s: number): number {
    const found = run.around(time_s);
    if (!found) return NaN;
    const [a, b] = [found.from, found.to].map(({ row }) => own.scaled(read(row, own.places)));
    if (found.share === 0) return a;
    this.interpolated.add(run);
    return a + found.share * (own.line.wraps ? within(b - a, own.half) : b - a);
  }

  /** Returns what the legend shows of a line at a recorded time of the present run, at which that has a value. */
  shownAt(one: OtherLine, time_s: number, present: number): number {
    return this.isDifference ? this.less(one, present, time_s) : this.valueAt(one, time_s);
  }

  /** Says which differences are interpolated, or that there is none to draw. */
  get notes(): string[] {
    if (!this.isDifference || this.lines.length === 0) return [];
    if (this.paths.every(({ stretches }) => stretches.length === 0)) return [words.nothing];
    const marks = [...this.interpolated].map(({ mark }) => mark);
    return marks.length > 0 ? [words.interpolated(marks.join(", "))] : [];
  }

  /** Returns the smallest and the largest value beside these lines of the plot; Infinity and -Infinity if there is none. */
  rangeOf(places: readonly number[]): [number, number] {
    const ranges = this.paths.filter((_, i) => places.includes(this.all[i].place)).map(({ range }) => range);
    return [Math.min(Infinity, ...ranges.map(([low]) => low)), Math.max(-Infinity, ...ranges.map(([, high]) => high))];
  }

  /** Draws the lines in the colours of their runs, each with the letter of its run at its end. */
  draw(u: uPlot, style: Style, scaleOf: (unit: string) => string): void {
    const end_s = u.scales.x.max ?? Infinity;
    this.paths.forEach(({ stretches }, i) => {
      const { run, place } = this.all[i];
      const scale = scaleOf(this.lines[place].shown.unit);
      const colour = style.colour(run.colour);
      for (const points of stretches) stroke(u, points, scale, { colour, width: 1.75, dash: dashOf(place) });
      const last = lastBefore(stretches, end_s);
      if (!last) return;
      const place_px: Point = [u.valToPos(last[0], "x", true) - 2 * devicePixelRatio, u.valToPos(last[1], scale, true)];
      word(u, run.mark, place_px, String(style.axis.font), colour, "right");
    });
  }

  /** Returns the paths of kept runs that have both of the first two lines, over a range of time. */
  phases(range_s: [number, number]): PhasePath[] {
    const across = this.all.filter(({ place }) => place === 0);
    return across.flatMap((one) => {
      const upwards = this.all.find(({ run, place }) => run === one.run && place === 1);
      if (!upwards) return [];
      const [, xs] = this.columnOf(one, range_s);
      const [, ys] = this.columnOf(upwards, range_s);
      const points = Array.from(xs, (x, k): Point => [x, ys[k]]);
      return [{ run: one.run, points: points.filter((point) => point.every(Number.isFinite)) }];
    });
  }
}

function lastBefore(stretches: readonly Point[][], end_s: number): Point | null {
  for (let i = stretches.length - 1; i >= 0; i--) {
    for (let k = stretches[i].length - 1; k >= 0; k--) if (stretches[i][k][0] <= end_s) return stretches[i][k];
  }
  return null;
}

/** Returns a sample of the dashes of a line, for the legend. */
export function dashesOf(place: number): HTMLElement {
  const sample = make("span", { class: "plot-dashes", "aria-hidden": "true" });
  sample.innerHTML = `<svg viewBox="0 0 28 4" width="28" height="4"><path d="M0 2h28" stroke="currentColor" stroke-width="2" stroke-dasharray="${dashOf(place).join(" ")}" /></svg>`;
  return sample;
}

/** Returns an angle less whole turns. */
function within(angle: number, half: number): number {
  return angle - 2 * half * Math.round(angle / (2 * half));
}

/** Divides a line where it has no value, and where an angle jumps by a full turn. */
function pathOf(times: ArrayLike<number>, values: ArrayLike<number>, { line, half }: DrawnLine): Path {
  const stretches: Point[][] = [];
  let [low, high, last] = [Infinity, -Infinity, NaN];
  for (const k of extremesOf(values)) {
    const value = values[k];
    const isJump = line.wraps === true && Math.abs(value - last) > half;
    last = value;
    if (!Number.isFinite(value)) continue;
    if (stretches.length === 0 || isJump || !Number.isFinite(values[k - 1])) stretches.push([]);
    stretches[stretches.length - 1].push([times[k], value]);
    [low, high] = [Math.min(low, value), Math.max(high, value)];
  }
  return { stretches, range: [low, high] };
}

/** Returns the indices of values to draw: all, or the smallest and the largest of each of many equal parts. */
function extremesOf(values: ArrayLike<number>): number[] {
  const count = values.length;
  if (count <= MOST_POINTS) return Array.from({ length: count }, (_, k) => k);
  const size = Math.ceil((2 * count) / MOST_POINTS);
  const chosen: number[] = [];
  for (let from = 0; from < count; from += size) {
    let [low, high] = [from, from];
    for (let k = from + 1; k < Math.min(count, from + size); k++) {
      if (values[k] < values[low] || Number.isNaN(values[low])) low = k;
      if (values[k] > values[high] || Number.isNaN(values[high])) high = k;
    }
    chosen.push(...new Set([Math.min(low, high), Math.max(low, high)]));
  }
  return chosen;
}
