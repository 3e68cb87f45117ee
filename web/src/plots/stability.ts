import type { RightingArmCurve } from "../generated/hydrostatics";

/** Returns the heel to the side of the curve; the given heel is positive to starboard. */
export function heelToSide({ side }: Pick<RightingArmCurve, "side">, heel_rad: number): number {
  return side === "starboard" ? heel_rad : -heel_rad;
}

/** Returns the righting arm at a heel to the curve's side, m, interpolated linearly; NaN beyond the curve. */
export function armAt({ points }: Pick<RightingArmCurve, "points">, heel_rad: number): number {
  return onLine(points.map((point) => point.heel_rad), points.map(({ arm_m }) => arm_m), heel_rad);
}

/** Interpolates a polyline whose points are ordered from left to right; NaN beyond its ends. */
export function onLine(across: readonly number[], upwards: readonly number[], at: number): number {
  const after = across.findIndex((one) => one >= at);
  if (across[after] === at) return upwards[after];
  if (after < 1) return NaN;
  const share = (at - across[after - 1]) / (across[after] - across[after - 1]);
  return upwards[after - 1] + share * (upwards[after] - upwards[after - 1]);
}
