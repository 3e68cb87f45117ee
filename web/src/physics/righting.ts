import type { RightingArmCurve } from "../generated/hydrostatics";
import { onLine } from "../plots/stability";

/** Righting arms over the heel to both sides: rad and m, both positive to starboard. */
export interface Arms {
  heel: number[];
  arm: number[];
  /** Where the ship comes to rest; null where the arms nowhere turn her upright. */
  rest: number | null;
}

/** Area 2 over area 1 that is asked for: in waters that are exposed, and in others. */
export const REQUIRED = { exposed: 1.4, sheltered: 1.0 };

/**
 * What the righting arms say of a ship that loses the load on her hook: area 1 drives her from the heel that she had with it to her
 * new rest, area 2 stops her from there to the end, where her arm vanishes, water enters, or her curve ends. Angles in rad, counted
 * to the side to which she rolls; areas in m rad. (International Code on Intact Stability, 2008, part B, 2.9.5.)
 */
export interface Loss {
  /** 1 where she rolls to starboard, -1 to port. */
  way: 1 | -1;
  start: number;
  rest: number;
  end: number;
  /** Whether water enters before the arms vanish: it is there that area 2 ends. */
  floods: boolean;
  area_1: number;
  area_2: number;
  /** How far she would roll without damping: where area 2 has become area 1; null where that is beyond the end. */
  reach: number | null;
}

/**
 * The arms on both sides, from those on one: of a hull that is alike on both, with `a` the arm at no heel,
 * GZ(-phi) = 2 a cos(phi) - GZ(phi).
 */
export function bothSides({ side, points, equilibrium_rad }: Pick<RightingArmCurve, "side" | "points" | "equilibrium_rad">): Arms {
  const way = side === "starboard" ? 1 : -1;
  const mirrored = points.slice(1).map(({ heel_rad, arm_m }) => ({ heel_rad: -heel_rad, arm_m: 2 * points[0].arm_m * Math.cos(heel_rad) - arm_m }));
  const own = [...mirrored.reverse(), ...points].map(({ heel_rad, arm_m }) => [way * heel_rad, way * arm_m]);
  const along = way > 0 ? own : own.reverse();
  return { heel: along.map(([heel]) => heel), arm: along.map(([, arm]) => arm), rest: equilibrium_rad === null ? null : way * equilibrium_rad };
}

/** The arm at a heel, m; NaN beyond the curve. */
export function armOf({ heel, arm }: Arms, at: number): number {
  return onLine(heel, arm, at);
}

/** The area under the arms from one heel to another, m rad, by trapezia; 0 where the second is not beyond the first. */
export function areaOf(arms: Arms, from: number, to: number): number {
  let area = 0;
  const at = [from, ...arms.heel.filter((one) => one > from && one < to), to];
  for (let k = 1; k < at.length && to > from; k++) area += 0.5 * (at[k] - at[k - 1]) * (armOf(arms, at[k - 1]) + armOf(arms, at[k]));
  return area;
}

/** The loss of the load, by the arms before and after; null where she rests at no heel before or after. */
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

/** The same, counted to the other side. */
export function mirror({ heel, arm, rest }: Arms): Arms {
  return { heel: heel.map((one) => -one).reverse(), arm: arm.map((one) => -one).reverse(), rest: rest === null ? null : -rest };
}

/** The heel beyond rest at which the arms fall through 0, or the last one. */
function vanishing({ heel, arm }: Arms, rest: number): number {
  const k = heel.findIndex((_, i) => i > 0 && heel[i] > rest && arm[i - 1] > 0 && arm[i] <= 0);
  if (k < 0) return heel[heel.length - 1];
  return heel[k - 1] + ((heel[k] - heel[k - 1]) * arm[k - 1]) / (arm[k - 1] - arm[k]);
}

/** Halvings of the angle between rest and end: to the last bit that is shown and far beyond. */
const HALVINGS = 50;

/** Where the area from rest on has become so large; the arms between rest and end are all upright. */
function reachOf(arms: Arms, rest: number, end: number, area: number): number {
  let [low, high] = [rest, end];
  for (let k = 0; k < HALVINGS; k++) {
    const middle = 0.5 * (low + high);
    if (areaOf(arms, rest, middle) < area) low = middle;
    else high = middle;
  }
  return 0.5 * (low + high);
}
