import type { RightingArmCurve } from "../generated/hydrostatics";

/** Heel to the side of the curve; heel is positive to starboard. */
export function heelToSide({ side }: Pick<RightingArmCurve, "side">, heel_rad: number): number {
  return side === "starboard" ? heel_rad : -heel_rad;
}

/** The righting arm at a heel to the curve's side, m, on the line between two points; NaN beyond the curve. */
export function armAt({ points }: Pick<RightingArmCurve, "points">, heel_rad: number): number {
  const after = points.findIndex((point) => point.heel_rad >= heel_rad);
  if (after < 0 || points.length === 0) return NaN;
  const [to, from] = [points[after], points[after - 1]];
  if (to.heel_rad === heel_rad) return to.arm_m;
  if (!from) return NaN;
  return from.arm_m + ((heel_rad - from.heel_rad) / (to.heel_rad - from.heel_rad)) * (to.arm_m - from.arm_m);
}
