import { asFault, readModel, readSettings } from "./engine";
import type { Engine, Fault, Hydrostatics, OpenEngine, Value, Values, Warning } from "./engine";
import type { Frame, Opened, Replay } from "./messages";
import { SurfaceGrid } from "./surface";

/** Longest stretch of wall time that one frame may catch up with, s: a slow machine runs slowly. */
const LONGEST_WALL_S = 0.25;
/** Longest time that one frame may compute, ms. */
const BUDGET_MS = 40;
/** Most steps between two looks at the clock, and how long they may take, ms. */
const STEPS_AT_ONCE = 64;
const MS_AT_ONCE = 8;

/** Owns the engine: opens scenarios, steps to the wall clock, records rows. */
export class Runner {
  private engine: Engine | null = null;
  private grid: SurfaceGrid | null = null;
  private steps = 0;
  private stepsPerRecord = 1;
  private stepsAtOnce = 1;
  private owed_s = 0;
  private fault: Fault | null = null;

  constructor(
    private readonly openEngine: OpenEngine,
    private readonly now_ms: () => number,
  ) {}

  /** Opens a scenario, with the files that it names, at its initial state; when that throws, the engine in hand stays. */
  open(text: string, file: string, overrides: Values, files: Record<string, string> = {}): Opened {
    const engine = this.openEngine(text, file, JSON.stringify(overrides), JSON.stringify(files));
    const model = readModel(engine.model_json());
    this.engine?.free();
    this.engine = engine;
    this.grid = SurfaceGrid.around(model);
    this.steps = 0;
    this.stepsPerRecord = Math.max(1, Math.round(model.record_every_s / engine.step_s()));
    this.owed_s = 0;
    this.fault = null;
    return {
      model,
      lines: JSON.parse(engine.lines_json()),
      settings: readSettings(engine.resolved_json()),
      channels: JSON.parse(engine.channels_json()),
      inputs: JSON.parse(engine.inputs_json()),
      frame: this.frame([engine.row()]),
    };
  }

  /** Advances by `wall_s` times `speed`, as far as the budget of one frame goes; null where no step is due. */
  advance(wall_s: number, speed: number): Frame | null {
    const engine = this.current();
    const step_s = engine.step_s();
    this.owed_s += Math.min(wall_s, LONGEST_WALL_S) * speed;
    const wanted = Math.floor(this.owed_s / step_s + 1e-9);
    const done = this.take(wanted, this.now_ms() + BUDGET_MS);
    this.owed_s = done.steps < wanted ? 0 : this.owed_s - wanted * step_s;
    return done.steps > 0 || this.fault ? this.frame(done.rows) : null;
  }

  /** Steps towards the next recording time, as far as the budget of one frame goes. */
  step(): Frame {
    this.owed_s = 0;
    const wanted = this.toNextRecord();
    const done = this.take(wanted, this.now_ms() + BUDGET_MS);
    return { ...this.frame(done.rows), isPart: done.steps < wanted && !this.fault };
  }

  snapshot(): Uint8Array {
    return this.current().snapshot();
  }

  restore(snapshot: Uint8Array): void {
    this.current().restore(snapshot);
  }

  /** How the hulls float at rest with the crane as it stands; a hull that cannot float is a warning. */
  hydrostatics(): Hydrostatics {
    try {
      return JSON.parse(this.current().hydrostatics_json()) as Hydrostatics;
    } catch (thrown) {
      return { hulls: [], warnings: [asFault(thrown).message] };
    }
  }

  input(name: string, value: number): void {
    this.current().set_input(name, value);
  }

  parameter(name: string, value: Value): void {
    this.current().set_parameter(name, JSON.stringify(value));
  }

  /** The run as a scenario, but for the files that it names. */
  replay(): Omit<Replay, "files"> {
    const engine = this.current();
    return {
      scenario: engine.replay_json(),
      time_s: engine.time_s(),
      integrator: readSettings(engine.resolved_json()).integrator,
      moves: (JSON.parse(engine.lever_moves_json()) as unknown[]).length,
      parameters: JSON.parse(engine.parameters_set_json()) as Replay["parameters"],
    };
  }

  private current(): Engine {
    if (!this.engine) throw { kind: "internal", message: "no scenario is open" };
    return this.engine;
  }

  private toNextRecord(): number {
    return this.stepsPerRecord - (this.steps % this.stepsPerRecord);
  }

  private take(wanted: number, deadline_ms: number): { steps: number; rows: Float64Array[] } {
    const engine = this.current();
    const rows: Float64Array[] = [];
    let left = this.fault ? 0 : wanted;
    for (let from_ms = this.now_ms(); left > 0 && from_ms < deadline_ms; from_ms = this.now_ms()) {
      const n = Math.min(left, this.toNextRecord(), this.stepsAtOnce);
      try {
        engine.step(n);
      } catch (thrown) {
        this.fault = asFault(thrown);
        rows.push(engine.row());
        break;
      }
      this.steps += n;
      left -= n;
      this.pace(n, this.now_ms() - from_ms);
      if (this.steps % this.stepsPerRecord === 0) rows.push(engine.row());
    }
    return { steps: wanted - left, rows };
  }

  /** As many steps at once as leave room for looks at the clock. */
  private pace(steps: number, took_ms: number): void {
    const fits = took_ms > 0 ? Math.floor((MS_AT_ONCE * steps) / took_ms) : STEPS_AT_ONCE;
    this.stepsAtOnce = Math.max(1, Math.min(fits, 2 * this.stepsAtOnce, STEPS_AT_ONCE));
  }

  private frame(rows: Float64Array[]): Frame {
    const engine = this.current();
    const row = engine.row();
    const flat = new Float64Array(rows.length * row.length);
    rows.forEach((one, index) => flat.set(one, index * row.length));
    const poses = engine.poses();
    const surface = this.grid?.surface(engine, poses) ?? null;
    const warnings = JSON.parse(engine.warnings_json()) as Warning[];
    return { rows: flat, row, poses, line_points: engine.line_points(), surface, warnings, isPart: false, fault: this.fault };
  }
}
