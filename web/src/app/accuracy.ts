import type { ModelInfo, Shape } from "../engine/engine";
import type { Columns } from "../engine/columns";

/** Principal moments of inertia of a solid shape about its centre, kg m2, body axes. */
export function principalInertia(shape: Shape | null, mass_kg: number): [number, number, number] {
  switch (shape?.kind) {
    case "box": {
      const [x, y, z] = [shape.length_m ** 2, shape.width_m ** 2, shape.height_m ** 2];
      return [(mass_kg * (y + z)) / 12, (mass_kg * (x + z)) / 12, (mass_kg * (x + y)) / 12];
    }
    case "cylinder": {
      const along = (mass_kg * shape.radius_m ** 2) / 2;
      const across = (mass_kg * (3 * shape.radius_m ** 2 + shape.length_m ** 2)) / 12;
      return [0, 1, 2].map((i) => ("xyz"[i] === shape.axis ? along : across)) as [number, number, number];
    }
    case "sphere": {
      const about = 0.4 * mass_kg * shape.radius_m ** 2;
      return [about, about, about];
    }
    default:
      return [0, 0, 0];
  }
}

export interface Errors {
  /** Energy error over the largest kinetic energy so far; NaN before anything moves. */
  energy: number;
  /** Momentum error over the largest angular momentum so far, of a body or of all; NaN before anything turns. */
  momentum: number;
  /** J */
  energy_J: number;
  /** N m s */
  momentum_N_m_s: number;
}

/** Puts the engine's energy and momentum errors in proportion to the motion so far. */
export class Accuracy {
  private largestKinetic_J = 0;
  private largestMomentum_N_m_s = 0;
  private readonly bodies: { name: string; inertia: [number, number, number] }[];

  constructor(
    model: ModelInfo,
    private readonly columns: Columns,
  ) {
    this.bodies = model.bodies.map(({ name, shape, mass_kg }) => ({ name, inertia: principalInertia(shape, mass_kg) }));
  }

  /** Takes one row into account. */
  see(row: ArrayLike<number>): void {
    const kinetic = this.columns.read(row, "kinetic_energy");
    if (kinetic > this.largestKinetic_J) this.largestKinetic_J = kinetic;
    for (const momentum of [this.length(row, "angular_momentum"), ...this.bodies.map((body) => this.spin(row, body))]) {
      if (momentum > this.largestMomentum_N_m_s) this.largestMomentum_N_m_s = momentum;
    }
  }

  errors(row: ArrayLike<number>): Errors {
    const energy_J = Math.abs(this.columns.read(row, "energy_error"));
    const momentum_N_m_s = Math.abs(this.columns.read(row, "momentum_error"));
    return {
      energy: this.largestKinetic_J > 0 ? energy_J / this.largestKinetic_J : NaN,
      momentum: this.largestMomentum_N_m_s > 0 ? momentum_N_m_s / this.largestMomentum_N_m_s : NaN,
      energy_J,
      momentum_N_m_s,
    };
  }

  private length(row: ArrayLike<number>, vector: string, scale = [1, 1, 1]): number {
    return Math.hypot(...["x", "y", "z"].map((axis, i) => scale[i] * this.columns.read(row, `${vector}.${axis}`)));
  }

  /** Of one body about its own centre. */
  private spin(row: ArrayLike<number>, { name, inertia }: { name: string; inertia: number[] }): number {
    return this.length(row, `${name}.angular_velocity`, inertia);
  }
}
