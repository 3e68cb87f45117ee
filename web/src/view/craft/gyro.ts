import type { Color } from "three";
import type { Box, Vec3 } from "../fit";
import { vec3 } from "../fit";
import { straight } from "./pieces";
import type { Work } from "./work";

/** Share of the space between wheel and edge that a bar of the frame takes. */
const BAR = 0.7;
/** Length of a trunnion outside the frame, as a share of the frame's length. */
const TRUNNION = 0.12;
const SPOKES = 6;

/** Adds a flywheel with the dimensions of the model: a rim, a hub, and spokes by which its spin is seen. */
export function addWheel({ body, palette }: Work, radius: number, length: number, axis: "x" | "y" | "z", colour: Color): void {
  const [half, web] = [length / 2, 0.14 * length];
  const [hub, rim] = [0.22 * radius, 0.74 * radius];
  const profile = [[0, -half], [hub, -half], [hub, -web], [rim, -web], [rim, -half], [radius, -half], [radius, half], [rim, half], [rim, web], [hub, web], [hub, half], [0, half]] as const;
  body.turned(profile, axis, [0, 0, 0], colour, 48);
  const along = "xyz".indexOf(axis);
  const [u, v] = [0, 1, 2].filter((k) => k !== along);
  for (let k = 0; k < SPOKES; k++) {
    const angle = (2 * Math.PI * k) / SPOKES;
    const at = (away: number, side: number): Vec3 => vec3((i) => (i === along ? side * 1.6 * web : i === u ? away * Math.cos(angle) : i === v ? away * Math.sin(angle) : 0));
    // One spoke of another colour shows the turns.
    for (const side of [-1, 1]) body.rod(at(hub, side), at(rim, side), 0.05 * radius, k === 0 ? palette.marking : palette.fitting, 6);
  }
}

/** Adds the frame around a wheel with the dimensions of the model, and its trunnions along the axis on which it turns. */
export function addGimbal({ body, fittings, palette }: Work, { low, high }: Box, wheel_m: number, turns: Vec3, colour: Color): void {
  const [x, y, z] = [0, 1, 2].map((k) => high[k] - low[k]);
  const bar = Math.max(0.02 * x, BAR * (Math.min(x, y) / 2 - wheel_m));
  for (const side of [-1, 1]) {
    body.box([x, bar, z], [0, (side * (y - bar)) / 2, 0], colour);
    body.box([bar, y - 2 * bar, z], [(side * (x - bar)) / 2, 0, 0], colour);
  }
  for (const [from, to] of trunnionsOf({ low, high }, turns)) fittings.rod(from, to, 0.4 * z, palette.pin, 14);
}

/** Adds the bearings of a gimbal on its carrier, with a post under each down to a height; all in axes of the carrier. */
export function addBearings({ fittings, palette }: Work, ends: readonly Vec3[], radius: number, foot: number): void {
  for (const [x, y, z] of ends) {
    fittings.box([2.6 * radius, 2.6 * radius, z - foot], [x, y, (z + foot) / 2], palette.fitting);
    fittings.turned(straight(1.5 * radius, -1.3 * radius, 1.3 * radius), "z", [x, y, z], palette.fitting, 20);
  }
}

/** Returns the two trunnions of a frame, each from the frame outwards. */
export function trunnionsOf({ low, high }: Box, turns: Vec3): [Vec3, Vec3][] {
  const along = [0, 1, 2].reduce((most, k) => (Math.abs(turns[k]) > Math.abs(turns[most]) ? k : most), 0);
  const length = high[along] - low[along];
  return [-1, 1].map((side) => [side * (length / 2 - 0.02 * length), side * (0.5 + TRUNNION) * length].map((at): Vec3 => vec3((k) => (k === along ? at : 0))) as [Vec3, Vec3]);
}
