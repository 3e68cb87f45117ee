import type uPlot from "uplot";
import { indexAt } from "../app/recording/series";
import { stroke, word } from "../plots/chart";
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

/** Dashes for the lines of a plot, pixels: the colour tells the run, the dashes tell the line. */
const DASHES_PX = [[7, 4], [2, 3], [11, 3, 2, 3], [14, 6], [4, 2], [7, 2, 2, 2, 2, 2], [3, 7], [18, 4]];
/** Largest number of points that are drawn of a line; of more, the extremes are drawn. */
const MOST_POINTS = 4000;

/** Line of a kept run beside a line of a plot. */
export interface OtherLine {
  run: KeptRun;
  /** Index of the line in the plot. */
  place: number;
  own: DrawnLine;
}

/** Points of a line in stretches without a gap. */
type Path = [number, number][][];

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
    if (this.paths.every((path) => path.length === 0)) return [words.nothing];
    const marks = [...this.interpolated].map(({ mark }) => mark);
    return marks.length > 0 ? [words.interpolated(marks.join(", "))] : [];
  }

  /** Returns the smallest and the largest value beside these lines of the plot; Infinity and -Infinity if there is none. */
  rangeOf(places: readonly number[]): [number, number] {
    let [low, high] = [Infinity, -Infinity];
    this.all.forEach(({ place }, i) => {
      if (!places.includes(place)) return;
      for (const [, value] of (this.paths[i] ?? []).flat()) [low, high] = [Math.min(low, value), Math.max(high, value)];
    });
    return [low, high];
  }

  /** Draws the lines in the colours of their runs, each with the letter of its run at its end. */
  draw(u: uPlot, style: Style, scaleOf: (unit: string) => string): void {
    const end_s = u.scales.x.max ?? Infinity;
    this.all.forEach(({ run, place }, i) => {
      const scale = scaleOf(this.lines[place].shown.unit);
      const colour = style.colour(run.colour);
      const path = this.paths[i] ?? [];
      for (const points of path) stroke(u, points, scale, { colour, width: 1.75, dash: DASHES_PX[place % DASHES_PX.length] });
      const last = path.flat().filter(([time_s]) => time_s <= end_s).at(-1);
      if (!last) return;
      const place_px: [number, number] = [u.valToPos(last[0], "x", true) - 2 * devicePixelRatio, u.valToPos(last[1], scale, true)];
      word(u, run.mark, place_px, String(style.axis.font), colour, "right");
    });
  }
}

/** Returns a sample of the dashes of a line, for the legend. */
export function dashesOf(place: number): HTMLElement {
  const sample = make("span", { class: "plot-dashes", "aria-hidden": "true" });
  sample.innerHTML = `<svg viewBox="0 0 28 4" width="28" height="4"><path d="M0 2h28" stroke="currentColor" stroke-width="2" stroke-dasharray="${DASHES_PX[place % DASHES_PX.length].join(" ")}" /></svg>`;
  return sample;
}

/** Returns an angle less whole turns. */
function within(angle: number, half: number): number {
  return angle - 2 * half * Math.round(angle / (2 * half));
}

/** Divides a line where it has no value, and where an angle jumps by a full turn. */
function pathOf(times: ArrayLike<number>, values: ArrayLike<number>, { line, half }: DrawnLine): Path {
  const path: Path = [];
  let last = NaN;
  for (const k of extremesOf(values)) {
    const value = values[k];
    const isJump = line.wraps === true && Math.abs(value - last) > half;
    if (Number.isFinite(value) && (path.length === 0 || !Number.isFinite(last) || isJump)) path.push([]);
    if (Number.isFinite(value)) path[path.length - 1].push([times[k], value]);
    last = value;
  }
  return path;
}

/** Returns the indices of values to draw: all, or the smallest and the largest of each of many equal parts. */
function extremesOf(values: ArrayLike<number>): Iterable<number> {
  const count = values.length;
  if (count <= MOST_POINTS) return Array.from({ length: count }, (_, k) => k);
  const size = Math.ceil((2 * count) / MOST_POINTS);
  const chosen: number[] = [];
  for (let from = 0; from < count; from += size) {
    let [low, high] = [from, from];
    for (let k = from + 1; k < Math.min(count, from + size); k++) {
      if (values[k] < values[low]) low = k;
      if (values[k] > values[high]) high = k;
    }
    chosen.push(...new Set([Math.min(low, high), Math.max(low, high)]));
  }
  return chosen;
}
