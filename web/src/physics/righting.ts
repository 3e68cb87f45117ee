import type { RightingArmCurve } from "../generated/hydrostatics";
import { onLine } from "../plots/stability";

/** Righting arms over the heel to both sides, m and rad, both positive to starboard. */
export interface Arms {
  heel: number[];
  arm: number[];
  /** Heel at which the ship is in stable equilibrium, rad; null if there is none. */
  rest: number | null;
}

/** Required ratio of area 2 to area 1, in exposed and in other waters. */
export const REQUIRED = { exposed: 1.4, sheltered: 1.0 };

/**
 * Loss of the hook load, evaluated with the righting arms: area 1 drives the ship from her heel with the load to her
 * new equilibrium; area 2 stops her between the new equilibrium and the end, where the righting arm vanishes, water
 * enters, or the curve ends. Angles in rad, positive to the side to which she rolls; areas in m rad. (International
 * Code on Intact Stability, 2008, part B, 2.9.5.)
 */
export interface Loss {
  /** 1 if she rolls to starboard, -1 if to port. */
  way: 1 | -1;
  start: number;
  rest: number;
  end: number;
  /** Whether water enters before the righting arm vanishes; area 2 then ends there. */
  floods: boolean;
  area_1: number;
  area_2: number;
  /** Largest roll without damping, at which area 2 equals area 1; null if that is beyond the end. */
  reach: number | null;
}

/**
 * Returns the righting arms to both sides from those to one side, for a symmetric hull with the arm `a` at zero heel:
 * GZ(-phi) = 2 a cos(phi) - GZ(phi).
 */
export function bothSides({ side, points, equilibrium_rad }: Pick<RightingArmCurve, "side" | "points" | "equilibrium_rad">): Arms {
  const way = side === "starboard" ? 1 : -1;
  const mirrored = points.slice(1).map(({ heel_rad, arm_m }) => ({ heel_rad: -heel_rad, arm_m: 2 * points[0].arm_m * Math.cos(heel_rad) - arm_m }));
  const own = [...mirrored.reverse(), ...points].map(({ heel_rad, arm_m }) => [way * heel_rad, way * arm_m]);
  const along = way > 0 ? own : own.reverse();
  return { heel: along.map(([heel]) => heel), arm: along.map(([, arm]) => arm), rest: equilibrium_rad === null ? null : way * equilibrium_rad };
}

/** Returns the righting arm at a heel, m; NaN beyond the curve. */
export function armOf({ heel, arm }: Arms, at: number): number {
  return onLine(heel, arm, at);
}

/**
 * Returns the area under the righting arms from one heel to another by the trapezoidal rule, m rad; 0 if the second
 * heel is not beyond the first.
 */
export function areaOf(arms: Arms, from: number, to: number): number {
  let area = 0;
  const at = [from, ...arms.heel.filter((one) => one > from && one < to), to];
  for (let k = 1; k < at.length && to > from; k++) area += 0.5 * (at[k] - at[k - 1]) * (armOf(arms, at[k - 1]) + armOf(arms, at[k]));
  return area;
}

/**
 * Evaluates the loss of the hook load from the righting arms before and after it; null if there is no equilibrium
 * before or after.
 */
export function lossOf(before: Arms, after: Arms, flooding_rad: number): Loss | null {
  if (before.rest === null || after.rest === null) return null;
  const way = after.rest >= before.rest ? 1 : -1;
  const [start, rest] = [way * before.rest, way * after.rest];
  const arms = way > 0 ? after : mirror(after);
  const upright = vanishing(arms, rest);
  const end = Math.max(rest, Math.min(upright, flooding_rad));
  const [area_1, area_2] = [Math.max(0, -areaOf(arms, start, rest)), Math.max(0, areaOf(arms, rest, end))];
  return { way, start, rest, end, floods: flooding_rad < upright, area_1, area_2, reach: area_2 < area_1 ? null : reachOf(arms, rest, end, area_1) };
}

/** Mirrors righting arms: heel and arm are then positive to the other side. */
export function mirror({ heel, arm, rest }: Arms): Arms {
  return { heel: heel.map((one) => -one).reverse(), arm: arm.map((one) => -one).reverse(), rest: rest === null ? null : -rest };
}

/** Returns the heel beyond equilibrium at which the righting arm falls to 0, or the last heel of the curve. */
function vanishing({ heel, arm }: Arms, rest: number): number {
  const k = heel.findIndex((_, i) => i > 0 && heel[i] > rest && arm[i - 1] > 0 && arm[i] <= 0);
  if (k < 0) return heel[heel.length - 1];
  return heel[k - 1] + ((heel[k] - heel[k - 1]) * arm[k - 1]) / (arm[k - 1] - arm[k]);
}

/** Number of bisection steps between equilibrium and end: more than enough for the displayed digits. */
const HALVINGS = 50;

/**
 * Returns the heel up to which the area from equilibrium has a given value; all righting arms in between are positive.
 */
function reachOf(arms: Arms, rest: number, end: number, area: number): number {
  let [low, high] = [rest, end];
  for (let k = 0; k < HALVINGS; k++) {
    const middle = 0.5 * (low + high);
    if (areaOf(arms, rest, middle) < area) low = middle;
    else high = middle;
  }
  return 0.5 * (low + high);
}
