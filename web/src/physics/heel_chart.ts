import type uPlot from "uplot";
import { dot, endsOf, heightsOf, stroke, word } from "../plots/chart";
import type { PaintedAxes, Style } from "../plots/chart";
import { texts } from "../texts";
import { Figure } from "./figure";

/** Smallest range of the heel axis, deg: a narrower range would show rounding errors as motion. */
const LEAST_DEG = 0.1;

/** Heel over time, s and deg, with reference levels, the largest heel and the present heel. */
export interface HeelContent {
  axis: string;
  points: [number, number][];
  time_s: [number, number];
  levels: { heel: number; colour: string; name: string }[];
  furthest: [number, number] | null;
  now: [number, number];
}

/** Chart of the recorded heel over time. */
export class HeelChart extends Figure<HeelContent> {
  protected axesOf({ axis }: HeelContent): PaintedAxes {
    return { across: texts.loss.time_axis, upwards: axis };
  }

  protected endsOf({ points, levels, time_s }: HeelContent): [[number, number], [number, number]] {
    const heels = [...points, ...levels.map(({ heel }) => [0, heel])].map(([, heel]) => heel);
    return [time_s, heightsOf(Math.min(0, ...heels), Math.max(0, ...heels), LEAST_DEG, [])];
  }

  protected paint(u: uPlot, style: Style, { points, levels, furthest, now }: HeelContent): void {
    const [left, right] = endsOf(u);
    stroke(u, [[left, 0], [right, 0]], "y", { colour: style.colour("edge"), width: 1 });
    for (const { heel, colour, name } of levels) {
      stroke(u, [[left, heel], [right, heel]], "y", { colour: style.colour(colour), width: 1, dash: [4, 3] });
      word(u, name, [u.bbox.left + 6, u.valToPos(heel, "y", true) - 2], String(style.axis.font), style.colour("muted"), "left");
    }
    stroke(u, points, "y", { colour: style.colour("roll"), width: 2 });
    if (furthest) dot(u, furthest, "y", style.colour("roll"), style.colour("surface"));
    dot(u, now, "y", style.colour("accent"), style.colour("surface"));
  }
}
