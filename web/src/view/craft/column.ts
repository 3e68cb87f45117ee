import type { Color } from "three";
import type { Vec3 } from "../fit";
import { straight } from "./pieces";
import type { Work } from "./work";

/** Column of a crane, along z about its middle. */
export interface ColumnShape {
  radius: number;
  length: number;
  /** Direction of the boom in plan, rad. */
  boom_rad: number;
  /** Whether the column has an operator's cab. */
  hasCab: boolean;
}

/** Smallest height of a column with a ladder, m. */
const CLIMBED_M = 1.5;

/**
 * Adds a slewing column with the dimensions of the model: a ring on the foundation, a tapering shaft, and a head for
 * the hinge of the boom.
 */
export function addColumn(work: Work, { radius, length, boom_rad, hasCab }: ColumnShape, colour: Color): void {
  const { body, fittings, palette } = work;
  const half = length / 2;
  const ring = Math.min(0.24 * radius, 0.08 * length);
  body.turned(straight(radius, -half, -half + ring), "z", [0, 0, 0], palette.fitting, 40);
  const head = Math.min(0.5 * radius, 0.12 * length);
  const shaft = [[0, -half + ring], [0.97 * radius, -half + ring], [0.84 * radius, -half + 3 * ring], [0.84 * radius, half - 2 * head], [radius, half - head], [radius, half], [0, half]] as const;
  body.turned(shaft, "z", [0, 0, 0], colour, 40);
  const bolts = 24;
  for (let k = 0; k < bolts; k++) {
    const angle = (2 * Math.PI * k) / bolts;
    const at = (z: number): Vec3 => [0.92 * radius * Math.cos(angle), 0.92 * radius * Math.sin(angle), z];
    fittings.rod(at(-half + ring), at(-half + 1.25 * ring), 0.035 * radius, palette.fitting, 5);
  }
  if (length > CLIMBED_M) addLadder(work, radius, half, boom_rad + Math.PI);
  if (hasCab) addCab(work, cabOf({ radius, length, boom_rad, hasCab }));
}

/** Adds a ladder on the side away from the boom. */
function addLadder({ fittings, palette }: Work, radius: number, half: number, angle: number): void {
  const [u, v] = [Math.cos(angle), Math.sin(angle)];
  const [away, wide, bar] = [0.99 * radius, Math.min(0.3, 0.3 * radius), 0.025];
  const at = (side: number, z: number): Vec3 => [away * u - side * wide * v, away * v + side * wide * u, z];
  for (const side of [-1, 1]) fittings.rod(at(side, -half), at(side, half), bar, palette.fitting, 4);
  const count = Math.round(half / 0.3);
  for (let k = 0; k <= count; k++) fittings.rod(at(-1, -half + (k / count) * 2 * half), at(1, -half + (k / count) * 2 * half), 0.7 * bar, palette.fitting, 4);
}

/** Operator's cab: its middle in the axes of the column, its size, and the direction in which it faces. */
export interface Cab {
  middle: Vec3;
  size: number;
  looks_rad: number;
}

/**
 * Returns the cab of a column: next to the boom, with its roof below the head, of a person's size if the column is
 * large enough.
 */
export function cabOf({ radius, length, boom_rad }: ColumnShape): Cab {
  const size = Math.min(1.9, 1.6 * radius, 0.3 * length);
  const away = radius + 0.42 * size;
  const side = boom_rad - Math.PI / 2;
  const z = length / 2 - Math.max(0.5 * size, 0.12 * length + 0.62 * size);
  const forward = 0.25 * size;
  return { middle: [away * Math.cos(side) + forward * Math.cos(boom_rad), away * Math.sin(side) + forward * Math.sin(boom_rad), z], size, looks_rad: boom_rad };
}

/** Places of the cab's pillars in sizes of the cab; none stands before the eye of the operator, in the middle. */
export const PILLARS = [[-0.48, -0.39], [0.5, -0.39], [0.5, 0.39], [-0.48, 0.39]] as const;

function addCab({ fittings, lit, palette }: Work, { middle, size, looks_rad }: Cab): void {
  const [u, v] = [Math.cos(looks_rad), Math.sin(looks_rad)];
  // Axes of the cab: x forward, y to the side, z up.
  const at = (x: number, y: number, z: number): Vec3 => [middle[0] + size * (x * u - y * v), middle[1] + size * (x * v + y * u), middle[2] + size * z];
  const plan = (grow: number, front: number) => [[-0.5, -0.4], [front, -0.4], [front, 0.4], [-0.5, 0.4]].map(([x, y]) => at(x * grow, y * grow, 0)).map(([x, y]) => [x, y] as const);
  const level = (z: number) => middle[2] + size * z;
  fittings.prism(plan(1, 0.5), level(-0.62), level(-0.25), palette.house);
  fittings.prism(plan(1.08, 0.56), level(0.5), level(0.6), palette.house);
  lit.prism(plan(0.96, 0.5), level(-0.25), level(0.5), palette.window);
  for (const [x, y] of PILLARS) fittings.rod(at(x, y, -0.25), at(x, y, 0.5), 0.03 * size, palette.house, 4);
  fittings.prism(plan(1.35, 0.45), level(-0.7), level(-0.64), palette.fitting);
  fittings.rod(at(-0.2, 0.3, -0.66), at(-0.3, 0.75, -1.15), 0.06 * size, palette.fitting, 6);
}
