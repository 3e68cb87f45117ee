import type { Columns } from "../engine/columns";
import type { ModelInfo } from "../engine/engine";

/** How a hull floats. */
export interface Afloat {
  /** Roll: positive to starboard, rad. */
  heel_rad: number;
  /** Pitch: positive by the bow, rad. */
  trim_rad: number;
  /**
   * Depth of the keel below still water, below the origin of the hull's data, along the vertical, m, as in the engine's
   * hydrostatics.
   */
  draught_m: number;
  /** Elevation of the incident waves at the hull's mean position, m. */
  wave_m: number;
}

/** Returns how the first hull floats; null if there is no hull. Poses are x y z qw qx qy qz for each body. */
export function afloat(model: ModelInfo, columns: Columns, row: ArrayLike<number>, poses: ArrayLike<number>): Afloat | null {
  if (model.hulls.length === 0) return null;
  const { name, body, origin_m, draught_m } = model.hulls[0];
  const at = 7 * model.bodies.findIndex((one) => one.name === body);
  const [z, w, x, y, v] = [2, 3, 4, 5, 6].map((k) => poses[at + k]);
  // The third row of the rotation matrix: vertical components of the body's axes.
  const heights = [2 * (x * v - w * y), 2 * (y * v + w * x), 1 - 2 * (x * x + y * y)];
  const rise_m = heights.reduce((sum, height, k) => sum + height * origin_m[k], z);
  return {
    heel_rad: columns.read(row, `${body}.roll`),
    trim_rad: columns.read(row, `${body}.pitch`),
    draught_m: heights[2] * draught_m - rise_m,
    wave_m: columns.read(row, `${name}.wave_elevation`),
  };
}
