import type { Columns } from "../engine/columns";

export interface Errors {
  /** Energy error over the largest energy exchanged so far; NaN while that energy is small (see ROUNDINGS). */
  energy: number;
  /** Momentum error over the largest angular momentum so far; NaN before any body rotates. */
  momentum: number;
  /** Energy error, J. */
  energy_J: number;
  /** Momentum error, N m s. */
  momentum_N_m_s: number;
}

/**
 * Smallest ratio of the exchanged energy to the rounding error of the stored energy at which a relative energy error is
 * shown.
 */
const ROUNDINGS = 1000;

/** Divides the engine's energy and momentum errors by the largest energy and momentum so far. */
export class Accuracy {
  private energy_J = 0;
  private stored_J = 0;
  private momentum_N_m_s = 0;

  constructor(private readonly columns: Columns) {}

  /** Forgets the largest energy and momentum, for a new run. */
  begin(): void {
    this.energy_J = this.stored_J = this.momentum_N_m_s = 0;
  }

  /** Updates the largest energy and momentum with one row. */
  see(row: ArrayLike<number>): void {
    const read = (name: string): number => this.columns.read(row, name);
    this.energy_J = larger(this.energy_J, read("energy_scale"));
    this.stored_J = larger(this.stored_J, Math.abs(read("potential_energy")));
    this.momentum_N_m_s = larger(this.momentum_N_m_s, read("momentum_scale"));
  }

  errors(row: ArrayLike<number>): Errors {
    const energy_J = Math.abs(this.columns.read(row, "energy_error"));
    const momentum_N_m_s = Math.abs(this.columns.read(row, "momentum_error"));
    // A ship at rest stores 1e8 J, which a double resolves to 1e-8 J; her motion is smaller than that.
    const isInPlay = this.energy_J > ROUNDINGS * Number.EPSILON * this.stored_J;
    return {
      energy: isInPlay ? energy_J / this.energy_J : NaN,
      momentum: this.momentum_N_m_s > 0 ? momentum_N_m_s / this.momentum_N_m_s : NaN,
      energy_J,
      momentum_N_m_s,
    };
  }
}

/** Returns the larger of two numbers; the first one if the second is NaN. */
function larger(known: number, found: number): number {
  return found > known ? found : known;
}
