import { factorize, solve } from "./cholesky";
import type { Random } from "./random";

/** Measurements as a linear map of independent normal unknowns of mean 0 and variance 1. */
export interface Measured {
  /** Rows of the map, one after another: one row for each measured value, with one coefficient for each unknown. */
  rows: Float64Array;
  values: Float64Array;
  /** Standard deviation of the noise in each value. */
  noise: number;
}

/**
 * Unknowns x ~ N(0, 1), given measurements y = H x + noise. A sample of N(0, 1) is corrected by Matheron's rule: x +
 * H^T (H H^T + R)^-1 (y - H x - noise) has the mean and the covariance of the unknowns given y (Chilès & Delfiner,
 * *Geostatistics*, 2nd ed., 2012, sec. 7.3).
 */
export class Conditioned {
  private readonly triangle: Float64Array;

  constructor(
    private readonly unknowns: number,
    private readonly measured: Measured,
  ) {
    const { rows, values, noise } = measured;
    const n = values.length;
    this.triangle = new Float64Array(n * n);
    for (let i = 0; i < n; i++) {
      for (let j = 0; j <= i; j++) {
        let sum = i === j ? noise * noise : 0;
        for (let k = 0; k < unknowns; k++) sum += rows[i * unknowns + k] * rows[j * unknowns + k];
        this.triangle[i * n + j] = sum;
      }
    }
    factorize(this.triangle, n);
  }

  draw(random: Random): Float64Array {
    const { values, noise } = this.measured;
    const x = random.normals(this.unknowns);
    const off = this.seen(x).map((seen, i) => values[i] - seen - noise * random.normal());
    solve(this.triangle, values.length, off);
    this.add(off, x);
    return x;
  }

  /** Mean of the unknowns, given the measurements. */
  mean(): Float64Array {
    const x = new Float64Array(this.unknowns);
    const off = this.measured.values.slice();
    solve(this.triangle, off.length, off);
    this.add(off, x);
    return x;
  }

  /** Computes H x. */
  seen(x: Float64Array): Float64Array {
    const { rows, values } = this.measured;
    return values.map((_, i) => {
      let sum = 0;
      for (let k = 0; k < this.unknowns; k++) sum += rows[i * this.unknowns + k] * x[k];
      return sum;
    });
  }

  /** Computes x + H^T w. */
  private add(weights: Float64Array, x: Float64Array): void {
    weights.forEach((weight, i) => {
      for (let k = 0; k < this.unknowns; k++) x[k] += weight * this.measured.rows[i * this.unknowns + k];
    });
  }
}
