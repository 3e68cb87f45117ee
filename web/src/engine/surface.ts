import type { Engine, ModelInfo } from "./engine";

/** Number of evenly spaced lines on each side of the middle. */
const EVEN = 22;
/** Number of further lines on each side, and the factor by which their spacing grows from line to line. */
const BEYOND = 10;
const GROWTH = 1.55;
/** Number of evenly spaced intervals in one length of the longest hull. */
const IN_A_LENGTH = 20;

/**
 * Distance of each line from the middle, in lengths of the longest hull: dense around the hull, sparse to the horizon.
 */
export const OFFSETS: readonly number[] = offsets();
/**
 * Number of grid lines along each axis: for each wave the engine computes one sine per line instead of one per
 * crossing.
 */
export const LINES = OFFSETS.length;

/** Surface of the sea around the ship, on a square grid along the world's axes. */
export interface Surface {
  /** Positions of the grid lines, m. */
  x_m: Float64Array;
  y_m: Float64Array;
  /** Elevation at every crossing, row by row along the first x, m. */
  elevation_m: Float64Array | Float32Array;
}

/** Returns the ships around which water is drawn: hulls, and boxes that the waves move; none without a sea. */
export function shipsInTheSea({ sea, hulls, joints, bodies }: ModelInfo): { body: string; length_m: number }[] {
  if (!sea) return [];
  const boxes = joints.filter(({ kind }) => kind === "moved_by_waves").flatMap(({ body }) => {
    const shape = bodies.find(({ name }) => name === body)?.shape;
    return shape?.kind === "box" ? [{ body, length_m: shape.length_m }] : [];
  });
  return [...hulls.map(({ body, length_m }) => ({ body, length_m })), ...boxes];
}

/** Grid of the sea's surface: around the hull, on lines that stay fixed while the hull drifts. */
export class SurfaceGrid {
  private constructor(
    private readonly body: number,
    private readonly length_m: number,
    private readonly isLevel: boolean,
  ) {}

  /** Returns the grid of a model; null if there is no ship in a sea. */
  static around(model: ModelInfo): SurfaceGrid | null {
    const longest = shipsInTheSea(model).sort((a, b) => b.length_m - a.length_m)[0];
    if (!model.sea || !longest) return null;
    const body = model.bodies.findIndex(({ name }) => name === longest.body);
    return new SurfaceGrid(body, longest.length_m, model.sea.wave_components === 0);
  }

  /** Computes the surface at the engine's present time. */
  surface(engine: Engine, poses: ArrayLike<number>): Surface {
    const [x_m, y_m] = [poses[7 * this.body], poses[7 * this.body + 1]].map((at) => this.linesAround(at));
    return { x_m, y_m, elevation_m: this.isLevel ? new Float64Array(LINES * LINES) : engine.surface(x_m, y_m) };
  }

  /** Positions of the lines around a middle, which is rounded to a fixed grid of the world. */
  private linesAround(middle_m: number): Float64Array {
    const even_m = this.length_m / IN_A_LENGTH;
    const middle = Math.round(middle_m / even_m) * even_m;
    return Float64Array.from(OFFSETS, (offset) => middle + offset * this.length_m);
  }
}

function offsets(): number[] {
  const out = Array.from({ length: EVEN + 1 }, (_, i) => i / IN_A_LENGTH);
  for (let k = 1; k <= BEYOND; k++) out.push(out[out.length - 1] + GROWTH ** k / IN_A_LENGTH);
  return [...out.slice(1).reverse().map((offset) => -offset), ...out];
}
