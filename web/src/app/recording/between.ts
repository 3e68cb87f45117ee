import type { Surface } from "../../engine/surface";

/** Cosine between two quaternions above which they are interpolated along the chord instead of the arc. */
const CLOSE = 1 - 1e-12;

/** Interpolates linearly between two arrays of numbers; a `share` of 0 gives `from`. */
export function between(from: ArrayLike<number>, to: ArrayLike<number>, share: number): Float64Array {
  return Float64Array.from(from, (a, i) => a + share * (to[i] - a));
}

/**
 * Interpolates poses x y z qw qx qy qz of each body: positions linearly, attitudes about one axis at a constant rate
 * (slerp).
 */
export function posesBetween(from: ArrayLike<number>, to: ArrayLike<number>, share: number): Float64Array {
  const poses = between(from, to, share);
  for (let at = 3; at < poses.length; at += 7) turn(poses, from, to, share, at);
  return poses;
}

function turn(poses: Float64Array, from: ArrayLike<number>, to: ArrayLike<number>, share: number, at: number): void {
  let cosine = 0;
  for (let k = at; k < at + 4; k++) cosine += from[k] * to[k];
  // A quaternion and its negative are the same attitude: the sign gives the shorter rotation.
  const sign = cosine < 0 ? -1 : 1;
  const angle = Math.acos(Math.min(1, sign * cosine));
  const isClose = sign * cosine > CLOSE;
  const a = isClose ? 1 - share : Math.sin((1 - share) * angle) / Math.sin(angle);
  const b = sign * (isClose ? share : Math.sin(share * angle) / Math.sin(angle));
  for (let k = at; k < at + 4; k++) poses[k] = a * from[k] + b * to[k];
}

/** Returns the share of the way between two times, from 0 to 1. */
export function shareOf(from: { time_s: number }, to: { time_s: number }, time_s: number): number {
  const length_s = to.time_s - from.time_s;
  return length_s > 0 ? Math.min(1, Math.max(0, (time_s - from.time_s) / length_s)) : 0;
}

/** Data of one time with the sea's surface. */
interface AtSea {
  time_s: number;
  surface: Surface | null;
}

/** Interpolates the sea's surface; if the grid has moved with the ship between the two times, returns the first. */
export function surfaceBetween(from: AtSea, to: AtSea, time_s: number): Surface | null {
  const share = shareOf(from, to, time_s);
  const [a, b] = [from.surface, to.surface];
  if (!a || !b || share === 0 || a.x_m[0] !== b.x_m[0] || a.y_m[0] !== b.y_m[0]) return a;
  const elevation_m = new Float32Array(a.elevation_m.length);
  for (let i = 0; i < elevation_m.length; i++) elevation_m[i] = a.elevation_m[i] + share * (b.elevation_m[i] - a.elevation_m[i]);
  return { ...a, elevation_m };
}
