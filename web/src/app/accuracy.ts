import type { Columns } from "../engine/columns";

export interface Errors {
  /** Energy error over the largest energy exchanged so far; NaN while that is below the rounding of the stored energy. */
  energy: number;
  /** Momentum error over the largest angular momentum in play so far; NaN before anything turns. */
  momentum: number;
  /** J */
  energy_J: number;
  /** N m s */
  momentum_N_m_s: number;
}

/** The exchanged energy counts from this many roundings of the stored energy on: a rounding is then a thousandth of it. */
const ROUNDINGS = 1000;

/** Divides the engine's energy and momentum errors by their scales, the largest so far. */
export class Accuracy {
  private energy_J = 0;
  private stored_J = 0;
  private momentum_N_m_s = 0;

  constructor(private readonly columns: Columns) {}

  /** Nothing was exchanged yet. */
  begin(): void {
    this.energy_J = this.stored_J = this.momentum_N_m_s = 0;
  }

  /** Takes one row into account. */
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

/** The first if the second is NaN. */
function larger(known: number, found: number): number {
  return found > known ? found : known;
}
