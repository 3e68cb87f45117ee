import type { Color } from "three";
import type { Box, Vec3 } from "../fit";
import { vec3 } from "../fit";
import { straight } from "./pieces";
import type { Pieces } from "./pieces";
import type { Work } from "./work";

type Axis = "x" | "y" | "z";

/** Adds a drum about its middle: the barrel has the dimensions of the model, and the flanges are larger. */
export function addDrum({ body, fittings, palette }: Work, radius: number, length: number, axis: Axis, colour: Color): void {
  const half = length / 2;
  body.turned(straight(radius, -half, half), axis, [0, 0, 0], palette.line, 32);
  const flange = 0.08 * length;
  for (const from of [-half, half - flange]) fittings.turned(straight(1.35 * radius, from, from + flange), axis, [0, 0, 0], colour, 32);
  // Number of turns on the drum.
  const turns = 9;
  for (let k = 1; k < turns; k++) {
    const at = -half + flange + (k / turns) * (length - 2 * flange);
    fittings.turned(straight(1.03 * radius, at - 0.02 * length, at + 0.02 * length), axis, [0, 0, 0], palette.fitting, 24);
  }
  const end = 1.36 * half;
  for (const from of [-end, half]) fittings.turned(straight(0.3 * radius, from, from + end - half), axis, [0, 0, 0], palette.pin, 14);
}

/** Adds a sheave with its cheeks, about an axis through `middle`. */
export function addSheave({ fittings, palette }: Work, middle: Vec3, axis: Axis, radius: number): void {
  const wide = 0.16 * radius;
  const rim = [[0, -wide], [radius, -wide], [0.9 * radius, 0], [radius, wide], [0, wide]] as const;
  fittings.turned(rim, axis, middle, palette.pin, 24);
  fittings.turned(straight(0.22 * radius, -3.2 * wide, 3.2 * wide), axis, middle, palette.fitting, 12);
}

/** Adds a hook block with sheaves and a hook: the eye of the hook is at `eye`, with the block above it. */
export function addHook({ fittings, palette }: Work, eye: Vec3, size: number): void {
  const [x, y, z] = eye;
  const at = (height: number): Vec3 => [x, y, z + size * height];
  const yellow = palette.load;
  fittings.rod(at(0), at(0.5), 0.09 * size, palette.pin, 8);
  fittings.turned(straight(0.2 * size, 0.42 * size, 0.56 * size), "z", [x, y, z], palette.fitting, 14);
  for (const side of [-1, 1]) {
    const cheek: [number, number][] = [[-0.3, 0.5], [0.3, 0.5], [0.48, 0.85], [0.48, 1.25], [0.28, 1.5], [-0.28, 1.5], [-0.48, 1.25], [-0.48, 0.85]];
    fittings.profile(cheek.map(([u, v]) => [x + u * size, z + v * size] as const), 0.07 * size, y + side * 0.26 * size, yellow);
  }
  for (const k of [-1, 0, 1]) fittings.turned(straight(0.4 * size, -0.05 * size, 0.05 * size), "y", [x, y + k * 0.15 * size, z + 1.05 * size], palette.pin, 20);
  fittings.turned(straight(0.09 * size, -0.34 * size, 0.34 * size), "y", [x, y, z + 1.05 * size], palette.fitting, 10);
}

/**
 * Adds a crate, a module or a container of the size of the model's box: posts and beams, with slightly recessed panels.
 */
export function addCargo({ body }: Work, { low, high }: Box, colour: Color): void {
  const size = vec3((k) => high[k] - low[k]);
  const [x, y, z] = size;
  const bar = 0.06 * Math.min(x, y, z);
  const dark = colour.clone().multiplyScalar(0.62);
  body.box([x - bar, y - bar, z - bar], [0, 0, 0], colour);
  for (const sy of [-1, 1]) for (const sz of [-1, 1]) body.box([x, bar, bar], [0, sy * (y - bar) / 2, sz * (z - bar) / 2], dark);
  for (const sx of [-1, 1]) for (const sz of [-1, 1]) body.box([bar, y - 2 * bar, bar], [sx * (x - bar) / 2, 0, sz * (z - bar) / 2], dark);
  for (const sx of [-1, 1]) for (const sy of [-1, 1]) body.box([bar, bar, z - 2 * bar], [sx * (x - bar) / 2, sy * (y - bar) / 2, 0], dark);
  addRibs(body, size, bar, colour.clone().multiplyScalar(0.86));
}

/** Adds upright corrugations on the four sides. */
function addRibs(body: Pieces, [x, y, z]: [number, number, number], bar: number, colour: Color): void {
  const high = z - 2 * bar;
  const along = Math.max(2, Math.round(x / (6 * bar)));
  for (let k = 1; k < along; k++) for (const side of [-1, 1]) body.box([1.6 * bar, 0.4 * bar, high], [-x / 2 + (k / along) * x, side * (y / 2 - 0.35 * bar), 0], colour);
  const across = Math.max(2, Math.round(y / (6 * bar)));
  for (let k = 1; k < across; k++) for (const side of [-1, 1]) body.box([0.4 * bar, 1.6 * bar, high], [side * (x / 2 - 0.35 * bar), -y / 2 + (k / across) * y, 0], colour);
}

/** Adds a quay: a block, a coping of the same colour, fenders on the long sides and bollards on the edge. */
export function addQuay({ body, fittings, palette }: Work, { low, high }: Box, colour: Color): void {
  const [x, y, z] = [0, 1, 2].map((k) => high[k] - low[k]);
  body.box([x, y, z], [0, 0, 0], colour);
  const size = Math.min(0.5, 0.03 * y);
  for (const side of [-1, 1]) {
    fittings.box([x, 0.5 * size, 0.4 * size], [0, side * (y / 2 - 0.3 * size), z / 2 + 0.2 * size], palette.load);
    const count = Math.round(x / 8);
    for (let k = 0; k < count; k++) {
      const at = -x / 2 + ((k + 0.5) / count) * x;
      fittings.rod([at, side * (y / 2 + size), z / 2 - 0.5], [at, side * (y / 2 + size), z / 2 - 3], 1.1 * size, palette.fitting, 14);
      if (k % 2 === 0) fittings.turned([[0, 0], [0.5 * size, 0], [0.5 * size, size], [0.8 * size, 1.1 * size], [0.8 * size, 1.4 * size], [0, 1.4 * size]], "z", [at, side * (y / 2 - 2 * size), z / 2], palette.fitting, 12);
    }
  }
}
