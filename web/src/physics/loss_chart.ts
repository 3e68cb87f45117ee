import type uPlot from "uplot";
import { dot, endsOf, fill, heightsOf, stroke, tick } from "../plots/chart";
import type { PaintedAxes, Style } from "../plots/chart";
import { texts } from "../texts";
import { Figure } from "./figure";
import { armOf } from "./righting";
import type { Arms, Loss } from "./righting";

export const DEGREES = 180 / Math.PI;
/** Names of the theme's colours. */
export const COLOURS = { before: "muted", after: "yaw", area_1: "roll", area_2: "pitch" } as const;
/** Smallest range on the other side, from which she rolls, and margin beyond the largest marked heel, deg. */
const OTHER_SIDE = { least: 10, beyond: 5 };

/**
 * Righting arms with and without the load, counted to the side to which she rolls, the results, and her present heel,
 * rad.
 */
export interface LossContent {
  before: Arms;
  after: Arms;
  loss: Loss | null;
  side: string;
  heel: number;
  isLost: boolean;
}

/** Chart of the righting arms with and without the load, the areas that drive and stop her, and her present heel. */
export class LossChart extends Figure<LossContent> {
  protected axesOf({ side }: LossContent): PaintedAxes {
    return { across: texts.loss.heel_axis(side), upwards: texts.plots.arm_axis, written: (value) => `${tick(value)}°` };
  }

  protected endsOf({ before, after, loss, heel }: LossContent): [[number, number], [number, number]] {
    const left = Math.min(-OTHER_SIDE.least, (loss?.start ?? 0) * DEGREES - OTHER_SIDE.beyond, heel * DEGREES);
    const last = after.heel[after.heel.length - 1] * DEGREES;
    const right = loss ? Math.min(last, Math.max(loss.end, heel) * DEGREES + OTHER_SIDE.beyond) : last;
    const seen = [before, after].flatMap((arms) => arms.arm.filter((_, k) => arms.heel[k] * DEGREES >= left && arms.heel[k] * DEGREES <= right));
    return [[left, right], heightsOf(Math.min(...seen), Math.max(...seen), 1e-3, [])];
  }

  protected paint(u: uPlot, style: Style, { before, after, loss, heel, isLost }: LossContent): void {
    const [left, right, bottom, top] = endsOf(u);
    const upright = (at: number, colour: string, dash: number[]) =>
      stroke(u, [[at * DEGREES, bottom], [at * DEGREES, top]], "y", { colour: style.colour(colour), width: 1, dash });
    if (loss) {
      fill(u, under(after, loss.start, loss.rest), "y", style.colour(COLOURS.area_1));
      fill(u, under(after, loss.rest, loss.end), "y", style.colour(COLOURS.area_2));
    }
    stroke(u, [[left, 0], [right, 0]], "y", { colour: style.colour("edge"), width: 1 });
    drawArms(u, style.colour(COLOURS.before), before, !isLost);
    drawArms(u, style.colour(COLOURS.after), after, isLost);
    if (loss?.reach != null) upright(loss.reach, COLOURS.area_1, [2, 3]);
    upright(heel, "accent", [4, 3]);
    const arm = armOf(isLost ? after : before, heel);
    if (!Number.isNaN(arm)) dot(u, [heel * DEGREES, arm], "y", style.colour("accent"), style.colour("surface"));
  }
}

/** Draws a curve of righting arms: solid if it is her present curve. */
function drawArms(u: uPlot, colour: string, { heel, arm }: Arms, isNow: boolean): void {
  const points = heel.map((at, k): [number, number] => [at * DEGREES, arm[k]]);
  stroke(u, points, "y", isNow ? { colour, width: 2.5 } : { colour, width: 1.5, dash: [6, 4] });
}

/** Returns the outline of the area between the righting arms and zero. */
function under(arms: Arms, from: number, to: number): [number, number][] {
  const at = [from, ...arms.heel.filter((one) => one > from && one < to), to];
  return [[from * DEGREES, 0], ...at.map((one): [number, number] => [one * DEGREES, armOf(arms, one)]), [to * DEGREES, 0]];
}
