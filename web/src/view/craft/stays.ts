import type { Vec3 } from "../fit";
import type { Work } from "./work";

/**
 * Height of a gantry above its column, as a share of the length of the boom, and position of the stays' attachment
 * along the boom.
 */
const GANTRY = 0.13;
const REACH = 0.93;

/** A bar of a stay between two bodies; each end is given in the axes of its body. */
export interface Stay {
  from: { body: number; point: Vec3 };
  to: { body: number; point: Vec3 };
  radius: number;
}

/**
 * Column on which a boom luffs: its radius, the height of its head and the direction of the boom in plan, column axes.
 */
interface Column {
  body: number;
  radius: number;
  head: number;
  boom_rad: number;
}

/**
 * A boom: `toBody` transforms from the boom's axes (along, across, up) to the axes of its body; the foot is at the
 * smaller end.
 */
interface Boom {
  body: number;
  length: number;
  width: number;
  height: number;
  toBody(along: number, across: number, up: number): Vec3;
}

/**
 * Adds the supports of a slender boom that only its hinge holds in the model: a gantry on the column and two stays to
 * the boom's head.
 */
export function addStays({ fittings, palette }: Work, column: Column, boom: Boom): Stay[] {
  const { radius, head, boom_rad } = column;
  const [c, s] = [Math.cos(boom_rad), Math.sin(boom_rad)];
  const at = (ahead: number, left: number, up: number): Vec3 => [ahead * c - left * s, ahead * s + left * c, head + up];
  const [apart, up, bar] = [0.55 * radius, GANTRY * boom.length, 0.09 * radius];
  const apex = (side: number) => at(-1.15 * radius, side * apart, up);
  for (const side of [-1, 1]) {
    fittings.rod(at(0.35 * radius, side * apart, -0.1 * radius), apex(side), bar, palette.fitting, 8);
    fittings.rod(at(-0.75 * radius, side * apart, -0.1 * radius), apex(side), bar, palette.fitting, 8);
    fittings.ball(apex(side), 1.7 * bar, palette.pin);
  }
  fittings.rod(apex(-1), apex(1), bar, palette.fitting, 8);
  return [-1, 1].map((side) => ({
    from: { body: column.body, point: apex(side) },
    to: { body: boom.body, point: boom.toBody((REACH - 0.5) * boom.length, side * 0.4 * boom.width, 0.3 * boom.height) },
    radius: 0.035 * radius,
  }));
}
