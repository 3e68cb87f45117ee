import type { Channel, Engine, Value, Values } from "../src/engine/engine";

/** A substitute for the engine in unit tests: a box that turns about z at a constant rate. */
export class FakeEngine implements Engine {
  private steps = 0;
  readonly taken: number[] = [];
  /** Number of requests for the poses. */
  posed = 0;
  /** Values that were set for the live parameter, in order. */
  readonly set: Value[] = [];

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

  events_json(_first: number): string {
    return "[]";
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
    this.posed += 1;
    const half = 0.05 * this.time_s();
    return Float64Array.of(0, 0, 0, Math.cos(half), 0, 0, Math.sin(half));
  }

  surface(x: Float64Array, y: Float64Array): Float64Array {
    return new Float64Array(x.length * y.length).fill(this.time_s());
  }

  equations_json(): string {
    return JSON.stringify({ matrices: [], formulas: [] });
  }

  hydrostatics_json(): string {
    throw { kind: "input", message: "the box cannot float" };
  }

  warnings_json(): string {
    return JSON.stringify(this.time_s() > 1 ? [{ time_s: 1, code: "taut", name: "painter", value: null, bound: null, unit: "", text: "it is taut" }] : []);
  }

  lines_json(): string {
    return JSON.stringify([{ name: "painter", style: "line", radius_m: 0, points: 2 }]);
  }

  line_points(): Float64Array {
    return Float64Array.of(0, 0, 0, 1, 0, this.time_s());
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
        { name: "ship", parent: "world", floats: true, is_submerged: false, mass_kg: 1200, inertia_kg_m2: [[200, 0, 0], [0, 500, 0], [0, 0, 500]], shape: { box: { length_m: 2, width_m: 1, height_m: 1 } }, colour: null, at_start: null },
      ],
      joints: [{ name: "ship", body: "ship", kind: "floating", free_coordinates: [], prescribed: [] }],
      elements: [],
      loops: [],
      connections: [],
      steps: [],
      task: null,
      gravity_m_s2: 9.81,
      sea: null,
      hulls: [],
      limits: [],
      view: { camera: "", plots: [] },
      live_settings: [],
      parameters: [
        { name: "load", label: "Load", unit: "", kind: "boolean", value: this.overrides.load ?? false, range: null, choices: null, live: false },
        { name: "wind", label: "Wind", unit: "m/s", kind: "number", value: this.overrides.wind ?? 8, range: [0, 20], choices: null, live: true },
      ],
      warnings: [],
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

  lever_moves_json(): string {
    return "[]";
  }

  parameters_set_json(): string {
    return JSON.stringify(this.set.map(() => ({ time_s: this.time_s(), parameter: "wind" })));
  }

  replay_json(): string {
    return JSON.stringify({ version: 1, title: "A box", simulation: { duration_s: 3 } });
  }

  set_parameter(name: string, valueJson: string): void {
    if (name !== "wind") throw { kind: "input", message: `parameter ${name}: takes effect at the start of a run` };
    this.set.push(JSON.parse(valueJson));
  }

  snapshot(): Uint8Array {
    return Uint8Array.of(this.steps);
  }

  restore([steps]: Uint8Array): void {
    this.steps = steps;
  }

  free(): void {}
}

/** Dimensions of variables of the whole model. */
const OF_THE_MODEL = ["body", "axis", "quaternion", "coordinate", "joint", "loop", "constraint", "point"];

/** Makes a channel as the engine publishes it, with column names from its labels. */
export function channelOf(variable: string, dims: string[] = [], labels: string[][] = [], units: string[] = ["1"], offset = 0): Channel {
  const leads = dims.length > 0 && dims[0] !== "axis";
  const column = [...dims.slice(0, leads ? 1 : 0).map((dim) => `{${dim}}`), variable, ...dims.slice(leads ? 1 : 0).map((dim) => `{${dim}}`)].join(".");
  const columns = labels.reduce((names, along, k) => names.flatMap((name) => along.map((label) => name.replace(`{${dims[k]}}`, label))), [column]);
  const each = columns.map((_, i) => units[i % units.length]);
  const unit = each.every((one) => one === each[0]) ? each[0] : null;
  const of_elements = dims.length > 0 && !OF_THE_MODEL.includes(dims[0]);
  return { variable, of_elements, long_name: variable.replaceAll("_", " "), description: "", unit, units: each, frame: "none", dims, labels, column, columns, along: null, offset, len: columns.length };
}

export const CHANNELS: Channel[] = [
  channelOf("time", [], [], ["s"], 0),
  channelOf("angular_velocity", ["body", "axis"], [["ship"], ["x", "y", "z"]], ["rad/s"], 1),
  channelOf("roll", ["body"], [["ship"]], ["rad"], 4),
  channelOf("pitch", ["body"], [["ship"]], ["rad"], 5),
  channelOf("yaw", ["body"], [["ship"]], ["rad"], 6),
  channelOf("kinetic_energy", [], [], ["J"], 7),
  channelOf("energy_error", [], [], ["J"], 8),
  channelOf("momentum_error", [], [], ["N m s"], 9),
  channelOf("joint_reaction", ["joint", "component"], [["slew"], ["force_x", "force_y", "force_z"]], ["N"], 10),
];
