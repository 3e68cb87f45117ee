import type { BodyInfo, Engine, ModelInfo } from "./engine";

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
  /** Wind over it and current in it. */
  flows?: Flows;
}

/** Velocities along the world's x and y, m/s; null if there is none. */
export interface Flows {
  wind_m_s: readonly [number, number] | null;
  current_m_s: readonly [number, number] | null;
}

/** Returns the wind and the current of a model. */
export function flowsOf({ wind, sea }: Pick<ModelInfo, "wind" | "sea">): Flows {
  const moving = (velocity: readonly [number, number] | undefined) => (velocity && Math.hypot(...velocity) > 0 ? velocity : null);
  return { wind_m_s: moving(wind?.velocity_m_s), current_m_s: moving(sea?.current_m_s) };
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

/** Length of the hull for which the sea around a body under water is drawn, in longest edges of the body. */
const AROUND = 6;

/**
 * Returns the bodies around which water is drawn: the ships, or without one the first body that the water carries or
 * that swims in it.
 */
export function inTheSea(model: ModelInfo): { body: string; length_m: number }[] {
  const ships = shipsInTheSea(model);
  const swims = model.sea && model.bodies.find(({ is_submerged, parent }) => is_submerged && parent === "world");
  return ships.length > 0 || !swims ? ships : [{ body: swims.name, length_m: AROUND * longestEdgeOf(swims) }];
}

function longestEdgeOf({ shape }: BodyInfo): number {
  if (shape?.kind === "box") return Math.max(shape.length_m, shape.width_m, shape.height_m);
  if (shape?.kind === "cylinder") return Math.max(shape.length_m, 2 * shape.radius_m);
  return shape?.kind === "sphere" ? 2 * shape.radius_m : 1;
}

/** Grid of the sea's surface: around the hull, on lines that stay fixed while the hull drifts. */
export class SurfaceGrid {
  private constructor(
    private readonly body: number,
    private readonly length_m: number,
    private readonly isLevel: boolean,
    private flows: Flows,
  ) {}

  /** Returns the grid of a model; null if nothing is in a sea. */
  static around(model: ModelInfo): SurfaceGrid | null {
    const longest = inTheSea(model).sort((a, b) => b.length_m - a.length_m)[0];
    if (!model.sea || !longest) return null;
    const body = model.bodies.findIndex(({ name }) => name === longest.body);
    return new SurfaceGrid(body, longest.length_m, model.sea.wave_components === 0, flowsOf(model));
  }

  /** Computes the surface at the engine's present time. */
  surface(engine: Engine, poses: ArrayLike<number>): Surface {
    const [x_m, y_m] = [poses[7 * this.body], poses[7 * this.body + 1]].map((at) => this.linesAround(at));
    return { x_m, y_m, elevation_m: this.isLevel ? new Float64Array(LINES * LINES) : engine.surface(x_m, y_m), flows: this.flows };
  }

  /** Takes over the wind and the current of a model whose numbers have changed. */
  change(model: ModelInfo): void {
    this.flows = flowsOf(model);
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
