import type { Columns } from "../engine/columns";

export interface Errors {
  /** Energy error over the largest energy in play so far; NaN before anything moves. */
  energy: number;
  /** Momentum error over the largest angular momentum in play so far; NaN before anything turns. */
  momentum: number;
  /** J */
  energy_J: number;
  /** N m s */
  momentum_N_m_s: number;
}

/** Puts the engine's energy and momentum errors in proportion to its scales of them, the largest so far. */
export class Accuracy {
  private energy_J = 0;
  private momentum_N_m_s = 0;

  constructor(private readonly columns: Columns) {}

  /** Takes one row into account. */
  see(row: ArrayLike<number>): void {
    const [energy_J, momentum_N_m_s] = ["energy_scale", "momentum_scale"].map((name) => this.columns.read(row, name));
    if (energy_J > this.energy_J) this.energy_J = energy_J;
    if (momentum_N_m_s > this.momentum_N_m_s) this.momentum_N_m_s = momentum_N_m_s;
  }

  errors(row: ArrayLike<number>): Errors {
    const energy_J = Math.abs(this.columns.read(row, "energy_error"));
    const momentum_N_m_s = Math.abs(this.columns.read(row, "momentum_error"));
    return {
      energy: this.energy_J > 0 ? energy_J / this.energy_J : NaN,
      momentum: this.momentum_N_m_s > 0 ? momentum_N_m_s / this.momentum_N_m_s : NaN,
      energy_J,
      momentum_N_m_s,
    };
  }
}
