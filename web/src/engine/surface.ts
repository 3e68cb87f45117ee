import type { Engine, ModelInfo } from "./engine";

/** Lines to each side of the middle that stand evenly. */
const EVEN = 22;
/** Lines beyond those to each side: each is further from the one before than that is, by this factor. */
const BEYOND = 10;
const GROWTH = 1.55;
/** Even distances in a length of the longest hull. */
const IN_A_LENGTH = 20;

/** Of each line from the middle one, in lengths of the longest hull: close around it, sparse to the horizon. */
export const OFFSETS: readonly number[] = offsets();
/** Lines of the grid along each axis: of each wave the engine takes a sine a line, not a crossing. */
export const LINES = OFFSETS.length;

/** The sea around the ship, on a square grid along the world's axes. */
export interface Surface {
  /** Of the lines, m. */
  x_m: Float64Array;
  y_m: Float64Array;
  /** At every crossing, along the first x first, m. */
  elevation_m: Float64Array | Float32Array;
}

/** Where the surface is asked for: around the hull, on lines that stay where they are as it drifts. */
export class SurfaceGrid {
  private constructor(
    private readonly body: number,
    private readonly length_m: number,
    private readonly isLevel: boolean,
  ) {}

  /** Null where there is no hull in a sea. */
  static around(model: ModelInfo): SurfaceGrid | null {
    if (!model.sea || model.hulls.length === 0) return null;
    const longest = model.hulls.reduce((a, b) => (b.length_m > a.length_m ? b : a));
    const body = model.bodies.findIndex(({ name }) => name === longest.body);
    return new SurfaceGrid(body, longest.length_m, model.sea.wave_components === 0);
  }

  /** The surface now. */
  surface(engine: Engine, poses: ArrayLike<number>): Surface {
    const [x_m, y_m] = [poses[7 * this.body], poses[7 * this.body + 1]].map((at) => this.linesAround(at));
    return { x_m, y_m, elevation_m: this.isLevel ? new Float64Array(LINES * LINES) : engine.surface(x_m, y_m) };
  }

  /** The middle line is one of the even lines of the world. */
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
