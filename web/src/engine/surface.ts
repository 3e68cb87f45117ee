import type { Engine, ModelInfo } from "./engine";

/** Lines of the grid along each axis: of each wave the engine takes a sine a line, not a crossing. */
export const LINES = 64;
/** Width of the grid, in lengths of the longest hull. */
const LENGTHS = 3.2;

/** The sea around the ship, on a square grid along the world's axes. */
export interface Surface {
  /** x of the first line, m. */
  x_m: number;
  /** y of the first line, m. */
  y_m: number;
  spacing_m: number;
  /** At every crossing, along the first x first, m. */
  elevation_m: Float64Array;
}

/** Where the surface is asked for: around the hull, on lines that stay where they are as it drifts. */
export class SurfaceGrid {
  private constructor(
    private readonly body: number,
    private readonly spacing_m: number,
    private readonly isLevel: boolean,
  ) {}

  /** Null where there is no hull in a sea. */
  static around(model: ModelInfo): SurfaceGrid | null {
    if (!model.sea || model.hulls.length === 0) return null;
    const longest = model.hulls.reduce((a, b) => (b.length_m > a.length_m ? b : a));
    const body = model.bodies.findIndex(({ name }) => name === longest.body);
    return new SurfaceGrid(body, (LENGTHS * longest.length_m) / (LINES - 1), model.sea.wave_components === 0);
  }

  /** The surface now. */
  surface(engine: Engine, poses: ArrayLike<number>): Surface {
    const [x, y] = [poses[7 * this.body], poses[7 * this.body + 1]].map((at) => this.linesFrom(at));
    const elevation_m = this.isLevel ? new Float64Array(LINES * LINES) : engine.surface(x, y);
    return { x_m: x[0], y_m: y[0], spacing_m: this.spacing_m, elevation_m };
  }

  private linesFrom(middle_m: number): Float64Array {
    const first = Math.round(middle_m / this.spacing_m) - LINES / 2;
    return Float64Array.from({ length: LINES }, (_, i) => (first + i) * this.spacing_m);
  }
}
