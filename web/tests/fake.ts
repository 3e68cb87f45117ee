import type { Channel, Engine, Values } from "../src/engine/engine";

/** A stand-in for the engine in unit tests: a box that turns about z at a constant rate. */
export class FakeEngine implements Engine {
  private steps = 0;
  readonly taken: number[] = [];

  constructor(
    readonly overrides: Values = {},
    private readonly h = 0.001,
    private readonly recordEvery_s = 0.01,
    private readonly divergesAt_s = Infinity,
  ) {}

  step(n: number): void {
    this.taken.push(n);
    for (let i = 0; i < n; i++) {
      if ((this.steps + 1) * this.h > this.divergesAt_s) {
        throw { kind: "diverged", message: "ship diverged", time_s: this.time_s(), body: "ship" };
      }
      this.steps += 1;
    }
  }

  time_s(): number {
    return this.steps * this.h;
  }

  step_s(): number {
    return this.h;
  }

  channels_json(): string {
    return JSON.stringify(CHANNELS);
  }

  row(): Float64Array {
    const row = new Float64Array(13);
    row[0] = this.time_s();
    row[3] = 0.1;
    row[6] = 0.1 * this.time_s();
    row[7] = 50;
    row[8] = 1e-6;
    row[9] = 2e-6;
    return row;
  }

  poses(): Float64Array {
    const half = 0.05 * this.time_s();
    return Float64Array.of(0, 0, 0, Math.cos(half), 0, 0, Math.sin(half));
  }

  surface(x: Float64Array, y: Float64Array): Float64Array {
    return new Float64Array(x.length * y.length).fill(this.time_s());
  }

  hydrostatics_json(): string {
    throw { kind: "input", message: "the box cannot float" };
  }

  model_json(): string {
    return JSON.stringify({
      title: "A box",
      description: "",
      duration_s: 3,
      step_s: this.h,
      record_every_s: this.recordEvery_s,
      integrator: "rk4",
      bodies: [
        { name: "ship", parent: "world", mass_kg: 1200, shape: { box: { length_m: 2, width_m: 1, height_m: 1 } }, colour: null },
      ],
      joints: [{ name: "ship", body: "ship", kind: "floating", free_coordinates: [] }],
      loops: [],
      cylinders: [],
      sea: null,
      hulls: [],
      parameters: [
        { name: "load", label: "Load", unit: "", kind: "boolean", value: this.overrides.load ?? false, range: null, choices: null, live: false },
      ],
    });
  }

  resolved_json(): string {
    return JSON.stringify({ simulation: { integrator: "rk4", form: "recursive", step_s: this.h } });
  }

  inputs_json(): string {
    return "[]";
  }

  set_input(name: string): void {
    throw { kind: "input", message: `no input is named ${name}` };
  }

  free(): void {}
}

function scalar(variable: string, offset: number): Channel {
  return { variable, long_name: variable, unit: "1", frame: "none", dims: [], labels: [], offset, len: 1 };
}

function ofShip(variable: string, offset: number): Channel {
  return { ...scalar(variable, offset), dims: ["body"], labels: [["ship"]] };
}

export const CHANNELS: Channel[] = [
  scalar("time", 0),
  { ...ofShip("angular_velocity", 1), dims: ["body", "axis"], labels: [["ship"], ["x", "y", "z"]], len: 3 },
  ofShip("roll", 4),
  ofShip("pitch", 5),
  ofShip("yaw", 6),
  scalar("kinetic_energy", 7),
  scalar("energy_error", 8),
  scalar("momentum_error", 9),
  { ...scalar("joint_reaction", 10), dims: ["joint", "component"], labels: [["slew"], ["force_x", "force_y", "force_z"]], len: 3 },
];
