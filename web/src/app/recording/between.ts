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
