import { Changes } from "./changes";
import type { Change } from "./changes";
import { digestOf } from "./digest";
import { answer } from "./answers";
import { asFault, readJointAxes, readModel, readTimelineSwitch } from "./engine";
import type { Engine, Equations, Fault, Hydrostatics, OpenEngine, Value, Values } from "./engine";
import { Events } from "./events";
import type { Frame, LeverMove, Opened, Replay, Restored, Snapshot } from "./messages";
import { SurfaceGrid } from "./surface";
import { withoutBodies } from "./without";

/** Longest wall time that one frame makes up for, s: on a slow machine the run is slower than asked for. */
const LONGEST_WALL_S = 0.25;
/** Longest computing time of one frame, ms. */
const BUDGET_MS = 40;
/** Largest number of steps between two checks of the clock, and the longest time for them, ms. */
const STEPS_AT_ONCE = 64;
const MS_AT_ONCE = 8;
/** Number of recording times between two keyframes. */
const KEYFRAME_EVERY = 10;

/** Data that a frame collects at its recording times. */
interface Taken {
  steps: number;
  rows: Float64Array[];
  poses: Float64Array[];
  line_points: Float64Array[];
  keyframes: Snapshot[];
  /** Changes of a link that were repeated before the first step. */
  changes: Change[];
}

const nothing = (): Taken => ({ steps: 0, rows: [], poses: [], line_points: [], keyframes: [], changes: [] });

/** Owns the engine: opens scenarios, steps to the wall clock, records rows. */
export class Runner {
  private engine: Engine | null = null;
  private source = { file: "", files: "{}" };
  private grid: SurfaceGrid | null = null;
  private steps = 0;
  private stepsPerRecord = 1;
  private stepsAtOnce = 1;
  private owed_s = 0;
  /** Time of the newest recorded row, s. */
  private recorded_s = 0;
  /** Time from which this engine continued the run of another engine; 0 if it computed the whole run, s. */
  private resumed_s = 0;
  private fault: Fault | null = null;
  /** Whether a parameter was set since the last step. */
  private isSet = false;
  /** Lever moves to repeat while a stretch is computed again. */
  private again: LeverMove[] = [];
  private events = new Events();
  private changes = new Changes([], 1);

  constructor(
    private readonly openEngine: OpenEngine,
    private readonly now_ms: () => number,
  ) {}

  /**
   * Opens a scenario, with its files, at its initial state; if that throws, the present engine stays. `changes` are
   * made at their times, until something is set by hand.
   */
  open(text: string, file: string, overrides: Values, files: Record<string, string> = {}, changes: readonly Change[] = []): Opened {
    const source = { file, files: JSON.stringify(files) };
    const engine = this.openEngine(text, file, JSON.stringify(overrides), source.files);
    const model = readModel(engine.model_json());
    this.engine?.free();
    this.engine = engine;
    this.source = source;
    this.grid = SurfaceGrid.around(model);
    this.steps = 0;
    this.stepsPerRecord = Math.max(1, Math.round(model.record_every_s / engine.step_s()));
    this.owed_s = 0;
    this.resumed_s = 0;
    this.fault = null;
    this.isSet = false;
    this.again = [];
    this.events = new Events();
    this.changes = new Changes(changes, engine.step_s());
    const start = nothing();
    this.record(start);
    const resolved = answer(engine, "resolved_json");
    return {
      model,
      lines: answer(engine, "lines_json"),
      settings: resolved.simulation,
      joint_axes: readJointAxes(resolved),
      timeline_switch: readTimelineSwitch(resolved),
      channels: answer(engine, "channels_json"),
      inputs: answer(engine, "inputs_json"),
      digest: digestOf(text, ...Object.entries(files).sort(([a], [b]) => (a < b ? -1 : 1)).flat()),
      frame: this.frame(start),
    };
  }

  /**
   * Advances by `wall_s` times `speed`, which may be infinite, within the time budget of one frame and not beyond
   * `until_s`; null if no step is due.
   */
  advance(wall_s: number, speed: number, until_s = Infinity): Frame | null {
    const engine = this.current();
    const step_s = engine.step_s();
    this.owed_s += speed === Infinity ? Infinity : Math.min(wall_s, LONGEST_WALL_S) * speed;
    const allowed = Math.min(Math.round(until_s / step_s) - this.steps, this.changes.toNext(this.steps));
    const wanted = Math.max(0, Math.min(Math.floor(this.owed_s / step_s + 1e-9), allowed));
    const done = this.take(wanted, this.now_ms() + BUDGET_MS);
    this.owed_s = done.steps < wanted || speed === Infinity ? 0 : this.owed_s - wanted * step_s;
    return done.steps > 0 || this.fault ? this.frame(done) : null;
  }

  /** Steps towards the next recording time, within the time budget of one frame. */
  step(): Frame {
    this.owed_s = 0;
    const wanted = this.toNextRecord();
    const done = this.take(Math.min(wanted, this.changes.toNext(this.steps)), this.now_ms() + BUDGET_MS);
    return { ...this.frame(done), isPart: done.steps < wanted && !this.fault };
  }

  snapshot(): Uint8Array {
    return this.current().snapshot();
  }

  /** Continues the run from an earlier state and repeats these lever moves; a fault after that state is cleared. */
  restore(snapshot: Uint8Array, moves: LeverMove[] = []): Restored {
    this.goTo(snapshot);
    this.changes.dropAfter(this.steps);
    this.again = [...moves];
    this.moveAgain();
    return this.restored();
  }

  /**
   * Continues a run of another engine from a keyframe. The run was opened with all its changes: those before the keyframe
   * count as made, the later ones are due.
   */
  resume({ bytes, isChange }: Snapshot): Restored {
    this.goTo(bytes);
    this.changes.skipTo(this.steps, isChange);
    this.resumed_s = this.recorded_s;
    return this.restored();
  }

  private goTo(snapshot: Uint8Array): void {
    const engine = this.current();
    engine.restore(snapshot);
    this.steps = Math.round(engine.time_s() / engine.step_s());
    this.owed_s = 0;
    this.recorded_s = engine.time_s();
    this.fault = null;
    this.isSet = false;
    this.events = new Events();
    this.again = [];
  }

  private restored(): Restored {
    return { inputs: answer(this.current(), "inputs_json"), frame: this.frame(nothing()) };
  }

  /**
   * Computes how the hulls float at rest: with the crane in its present pose, or without some bodies and with the crane
   * as at the start. A hull that cannot float gives a warning.
   */
  hydrostatics(without: readonly string[] | null = null): Hydrostatics {
    try {
      if (!without) return answer(this.current(), "hydrostatics_json");
      const lighter = this.openEngine(withoutBodies(this.current().resolved_json(), without), this.source.file, "{}", this.source.files);
      const found = answer(lighter, "hydrostatics_json");
      lighter.free();
      return found;
    } catch (thrown) {
      return { hulls: [], warnings: [asFault(thrown).message] };
    }
  }

  /** Computes the matrices of the method at the engine's present state. */
  equations(): Equations {
    return answer(this.current(), "equations_json");
  }

  /** Sets an input by hand; returns the time at which it acts, s. */
  input(name: string, value: number): number {
    const time_s = this.current().time_s();
    // JSON, which a link contains, has no negative zero.
    this.setByHand({ time_s, input: name, value: value === 0 ? 0 : value });
    return time_s;
  }

  /** Sets a parameter by hand; returns the time at which it acts, s. */
  parameter(name: string, value: Value): number {
    const time_s = this.current().time_s();
    this.setByHand({ time_s, parameter: name, value });
    return time_s;
  }

  /** Changes made so far, by hand or repeated from a link. */
  made(): readonly Change[] {
    return this.changes.made;
  }

  private setByHand(change: Change): void {
    this.set(change);
    this.changes.dropDue();
  }

  private set(change: Change): void {
    const engine = this.current();
    if ("input" in change) engine.set_input(change.input, change.value);
    else engine.set_parameter(change.parameter, JSON.stringify(change.value));
    this.changes.make(change);
    if (!("parameter" in change)) return;
    this.isSet = true;
    this.grid?.change(readModel(engine.model_json()));
  }

  /** Makes the changes of a link that are due now; if the engine refuses one, the run ends. */
  private setAgain(taken: Taken): void {
    try {
      const time_s = this.current().time_s();
      for (const due of this.changes.takeDue(this.steps)) {
        const change = { ...due, time_s };
        this.set(change);
        taken.changes.push(change);
      }
    } catch (thrown) {
      this.fault = { kind: "followed", message: asFault(thrown).message };
    }
  }

  /** Returns the run as a scenario, without the list of the files that it names. */
  replay(): Omit<Replay, "files"> {
    const engine = this.current();
    return {
      scenario: engine.replay_json(),
      time_s: engine.time_s(),
      integrator: answer(engine, "resolved_json").simulation.integrator,
      moves: answer(engine, "lever_moves_json").length,
      parameters: answer(engine, "parameters_set_json"),
      lost: this.changes.made.filter(({ time_s }) => time_s < this.resumed_s).length,
    };
  }

  private current(): Engine {
    if (!this.engine) throw { kind: "internal", message: "no scenario is open" };
    return this.engine;
  }

  private toNextRecord(): number {
    return this.stepsPerRecord - (this.steps % this.stepsPerRecord);
  }

  /** Makes the lever moves that are due again. */
  private moveAgain(): void {
    while (this.again.length > 0 && this.toNextMove() <= 0) {
      this.set(this.again.shift()!);
    }
  }

  private toNextMove(): number {
    const [next] = this.again;
    return next ? Math.round(next.time_s / this.current().step_s()) - this.steps : Infinity;
  }

  private take(wanted: number, deadline_ms: number): Taken {
    const engine = this.current();
    const taken = nothing();
    if (wanted > 0 && !this.fault) this.setAgain(taken);
    let left = this.fault ? 0 : wanted;
    if (left > 0 && this.isSet) this.keep(taken);
    for (let from_ms = this.now_ms(); left > 0 && from_ms < deadline_ms; from_ms = this.now_ms()) {
      const n = Math.min(left, this.toNextRecord(), this.stepsAtOnce, this.toNextMove());
      try {
        engine.step(n);
      } catch (thrown) {
        this.fault = asFault(thrown);
        if (engine.time_s() > this.recorded_s) this.record(taken);
        break;
      }
      this.steps += n;
      taken.steps += n;
      left -= n;
      this.moveAgain();
      this.pace(n, this.now_ms() - from_ms);
      if (this.steps % this.stepsPerRecord === 0) this.record(taken);
    }
    return taken;
  }

  private record(taken: Taken): void {
    const engine = this.current();
    this.recorded_s = engine.time_s();
    taken.rows.push(engine.row());
    taken.poses.push(engine.poses());
    taken.line_points.push(engine.line_points());
    if (!this.fault && this.steps % (KEYFRAME_EVERY * this.stepsPerRecord) === 0) this.keep(taken);
  }

  private keep({ keyframes }: Taken): void {
    const engine = this.current();
    keyframes.push({ time_s: engine.time_s(), bytes: engine.snapshot(), isChange: this.isSet });
    this.isSet = false;
  }

  /** Sets the number of steps between two checks of the clock from the time that the last ones took. */
  private pace(steps: number, took_ms: number): void {
    const fits = took_ms > 0 ? Math.floor((MS_AT_ONCE * steps) / took_ms) : STEPS_AT_ONCE;
    this.stepsAtOnce = Math.max(1, Math.min(fits, 2 * this.stepsAtOnce, STEPS_AT_ONCE));
  }

  private frame({ rows, poses, line_points, keyframes, changes }: Taken): Frame {
    const engine = this.current();
    const poses_now = engine.poses();
    return {
      rows: flat(rows),
      row_poses: flat(poses),
      row_line_points: flat(line_points),
      keyframes,
      changes,
      row: engine.row(),
      poses: poses_now,
      line_points: engine.line_points(),
      surface: this.grid?.surface(engine, poses_now) ?? null,
      warnings: answer(engine, "warnings_json"),
      events: this.events.of(engine),
      isPart: false,
      fault: this.fault,
    };
  }
}

/** Joins arrays one after another. */
function flat(parts: Float64Array[]): Float64Array {
  const all = new Float64Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
