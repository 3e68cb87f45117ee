import type { ModelInfo } from "../engine/engine";
import type { Box, Vec3 } from "./fit";

/** The line of sight to a body under water: from the surface above it to its middle. */
export interface Sight {
  top: Vec3;
  bottom: Vec3;
  /** Distance from this line within which the water is clear, m. */
  radius_m: number;
}

/** Radius of the clear water: in diagonals of the body, and as a share of its depth. */
const RADIUS = { own: 1.5, depth: 0.16 };
/** Depth of the lowest point of lines that hang far below the ships, relative to the size of the model. */
const FAR_DOWN = 0.4;

/**
 * Returns the line of sight to the load, or without a load under water to the first body that the water acts on as on an
 * object in it; null if none is under water.
 */
export function sightOf({ sea, bodies }: Pick<ModelInfo, "sea" | "bodies">, boxes: readonly Box[], poses: ArrayLike<number>, load: number | null): Sight | null {
  if (!sea) return null;
  const swim = bodies.flatMap(({ is_submerged }, i) => (is_submerged ? [i] : []));
  const body = [...(load === null ? [] : [load]), ...swim].find((i) => isUnder(boxes[i], poses[7 * i + 2]));
  if (body === undefined) return null;
  const [x, y, z] = [0, 1, 2].map((k) => poses[7 * body + k]);
  const radius_m = Math.max(RADIUS.own * diagonalOf(boxes[body]), -RADIUS.depth * z);
  return { top: [x, y, 0], bottom: [x, y, z], radius_m };
}

/** Whether lines hang far below the surface. */
export function reachesDown(line_points: ArrayLike<number>, size_m: number): boolean {
  for (let i = 2; i < line_points.length; i += 3) if (line_points[i] < -FAR_DOWN * size_m) return true;
  return false;
}

function isUnder({ low, high }: Box, z: number): boolean {
  return z + (high[2] - low[2]) / 2 < 0;
}

function diagonalOf({ low, high }: Box): number {
  return Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}
