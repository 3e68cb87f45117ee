import type uPlot from "uplot";
import { fixed } from "../app/format";
import type { Shown } from "../app/recording/shown";
import type { Columns } from "../engine/columns";
import type { Hydrostatics } from "../engine/engine";
import { texts } from "../texts";
import { dot, endsOf, heightsOf, Painted, stroke, tick } from "./chart";
import type { Chart, Style } from "./chart";
import { inWords } from "./lines";
import { armAt, heelToSide } from "./stability";
import { places } from "./table";

/** Righting arms that were computed last, and the time of the run for which they hold. */
export interface Arms {
  found: Hydrostatics;
  time_s: number;
}

/** A hull with its curve of righting arms and its present heel. */
interface Curve {
  body: string;
  side: string;
  colour: string;
  points: [number, number][];
  heel: number;
  arm_m: number;
  equilibrium: number | null;
  largest: { heel: number; arm_m: number } | null;
  vanishing: number | null;
}

const DEGREES = 180 / Math.PI;
const COLOURS = ["yaw", "roll", "pitch", "line-4"];

/** Chart of the righting arms of the hulls over the heel, in degrees, with the present heel of each ship. */
export class ArmsChart implements Chart {
  private chart: Painted | null = null;
  private curves: Curve[] = [];

  constructor(
    private readonly area: HTMLElement,
    private readonly arms: () => Arms | null,
    private readonly columns: Columns,
    private readonly shown: Shown,
  ) {}

  draw(): void {
    this.curves = this.read();
    this.chart ??= this.make();
    const all = this.curves.flatMap(({ points, heel, arm_m }): readonly (readonly [number, number])[] =>
      Number.isNaN(arm_m) ? points : [...points, [heel, arm_m]],
    );
    const [left, right] = [Math.min(0, ...this.curves.map(({ heel }) => heel)), Math.max(1, ...all.map(([x]) => x))];
    const heights = all.map(([, y]) => y);
    const [bottom, top] = heightsOf(Math.min(0, ...heights), Math.max(0, ...heights), 1e-3, []);
    this.chart.fit([left, right], [bottom, top]);
  }

  private read(): Curve[] {
    const row = this.shown.moment?.row ?? [];
    const hulls = this.arms()?.found.hulls ?? [];
    return hulls.flatMap(({ body, righting_arm: curve }, i): Curve[] => {
      if (!curve) return [];
      const heel_rad = heelToSide(curve, this.columns.read(row, `${body}.roll`));
      const degrees = (value: number | null) => (value === null ? null : value * DEGREES);
      return [{
        body: inWords(body),
        side: texts.plots.sides[curve.side],
        colour: COLOURS[i % COLOURS.length],
        points: curve.points.map((point) => [point.heel_rad * DEGREES, point.arm_m]),
        heel: heel_rad * DEGREES,
        arm_m: armAt(curve, heel_rad),
        equilibrium: degrees(curve.equilibrium_rad),
        largest: curve.largest && { heel: curve.largest.heel_rad * DEGREES, arm_m: curve.largest.arm_m },
        vanishing: degrees(curve.vanishing_rad),
      }];
    });
  }

  resize(width: number, height: number): void {
    this.chart?.resize(width, height);
  }

  values(): string[] {
    return [];
  }

  at(): string {
    const time_s = this.arms()?.time_s;
    return time_s === undefined ? "" : texts.plots.crane_as_at(fixed(time_s, 1));
  }

  notes(): string[] {
    const arms = this.arms();
    if (!arms) return [texts.plots.arms_wait];
    if (this.curves.length === 0) return [texts.plots.arms_none, ...arms.found.warnings];
    return this.curves.map(({ body, side, heel, arm_m, equilibrium, largest, vanishing }) => {
      const now = Number.isNaN(arm_m) ? texts.plots.heel_beyond(body, fixed(heel, 2), side) : texts.plots.heel_now(body, fixed(heel, 2), side, fixed(arm_m, 3));
      const ends = [
        equilibrium === null ? "" : texts.plots.at_rest(fixed(equilibrium, 2)),
        largest ? texts.plots.largest_arm(fixed(largest.arm_m, 3), fixed(largest.heel, 1)) : "",
        vanishing === null ? "" : texts.plots.vanishes(fixed(vanishing, 1)),
      ];
      return [now, ...ends].filter((text) => text !== "").join("; ");
    });
  }

  table(): string[][] {
    if (this.curves.length === 0) return [this.notes()];
    const rows = this.curves.flatMap(({ body, points }) => places(points.length).map((k) => [body, fixed(points[k][0], 1), fixed(points[k][1], 3)]));
    return [["", texts.plots.heel_axis, texts.plots.arm_axis], ...rows];
  }

  canvas(): HTMLCanvasElement | null {
    return this.chart?.canvas ?? null;
  }

  destroy(): void {
    this.chart?.destroy();
    this.chart = null;
  }

  private make(): Painted {
    const axes = { across: texts.plots.heel_axis, upwards: texts.plots.arm_axis, written: (value: number) => `${tick(value)}°` };
    return new Painted(this.area, axes, (u, style) => this.drawCurves(u, style));
  }

  private drawCurves(u: uPlot, style: Style): void {
    const [left, right, bottom, top] = endsOf(u);
    stroke(u, [[left, 0], [right, 0]], "y", { colour: style.colour("edge"), width: 1 });
    for (const { points, colour, heel, arm_m } of this.curves) {
      stroke(u, points, "y", { colour: style.colour(colour), width: 2 });
      stroke(u, [[heel, bottom], [heel, top]], "y", { colour: style.colour("accent"), width: 1, dash: [4, 3] });
      if (!Number.isNaN(arm_m)) dot(u, [heel, arm_m], "y", style.colour("accent"), style.colour("surface"));
    }
  }
}

/** Returns the legend of hulls with curves; empty if there is only one hull. */
export function armsLegend(hulls: readonly { body: string }[]): { label: string; colour: string; unit: string }[] {
  return hulls.length < 2 ? [] : hulls.map(({ body }, i) => ({ label: inWords(body), colour: COLOURS[i % COLOURS.length], unit: "" }));
}

