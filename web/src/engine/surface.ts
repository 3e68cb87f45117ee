import type { Engine, ModelInfo } from "./engine";

/** Evenly spaced lines on each side of the middle. */
const EVEN = 22;
/** Further lines on each side: the spacing grows by this factor. */
const BEYOND = 10;
const GROWTH = 1.55;
/** Even distances in a length of the longest hull. */
const IN_A_LENGTH = 20;

/** Distance of each line from the middle, in lengths of the longest hull: dense around it, sparse to the horizon. */
export const OFFSETS: readonly number[] = offsets();
/** Lines of the grid along each axis: for each wave the engine computes one sine per line, not per crossing. */
export const LINES = OFFSETS.length;

/** The sea around the ship, on a square grid along the world's axes. */
export interface Surface {
  /** Positions of the lines, m. */
  x_m: Float64Array;
  y_m: Float64Array;
  /** Elevation at every crossing, row by row along the first x, m. */
  elevation_m: Float64Array | Float32Array;
}

/** The ships that the water is drawn for: hulls, and boxes that the waves move; none without a sea. */
export function shipsInTheSea({ sea, hulls, joints, bodies }: ModelInfo): { body: string; length_m: number }[] {
  if (!sea) return [];
  const boxes = joints.filter(({ kind }) => kind === "moved_by_waves").flatMap(({ body }) => {
    const shape = bodies.find(({ name }) => name === body)?.shape;
    return shape?.kind === "box" ? [{ body, length_m: shape.length_m }] : [];
  });
  return [...hulls.map(({ body, length_m }) => ({ body, length_m })), ...boxes];
}

/** The grid of the surface: around the hull, on lines that stay fixed while it drifts. */
export class SurfaceGrid {
  private constructor(
    private readonly body: number,
    private readonly length_m: number,
    private readonly isLevel: boolean,
  ) {}

  /** Null if there is no ship in a sea. */
  static around(model: ModelInfo): SurfaceGrid | null {
    const longest = shipsInTheSea(model).sort((a, b) => b.length_m - a.length_m)[0];
    if (!model.sea || !longest) return null;
    const body = model.bodies.findIndex(({ name }) => name === longest.body);
    return new SurfaceGrid(body, longest.length_m, model.sea.wave_components === 0);
  }

  /** The surface now. */
  surface(engine: Engine, poses: ArrayLike<number>): Surface {
    const [x_m, y_m] = [poses[7 * this.body], poses[7 * this.body + 1]].map((at) => this.linesAround(at));
    return { x_m, y_m, elevation_m: this.isLevel ? new Float64Array(LINES * LINES) : engine.surface(x_m, y_m) };
  }

  /** The middle line is on a fixed grid of the world. */
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
