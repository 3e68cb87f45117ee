import { answer } from "../engine/answers";
import { asFault } from "../engine/engine";
import type { Fault } from "../engine/engine";
import type { Conditioned } from "./conditioned";
import type { Future, Past, Start } from "./messages";
import { Random } from "./random";
import { expectedAmplitudes, SeasAhead } from "./sea";
import type { EngineInSeas } from "./sea";

/** Largest number of steps in one call of the engine: between calls the worker can receive new messages. */
const STEPS_AT_ONCE = 64;

/** Continues a run from a state, with its levers unchanged, in seas that agree with the measurements. */
export class Futures {
  private readonly seas: SeasAhead;
  private readonly isGusty: boolean;
  private start: Start | null = null;
  private start_s = 0;
  private past_s = 0;
  private known: Conditioned | null = null;

  constructor(
    private readonly engine: EngineInSeas,
    open: (resolved: string) => EngineInSeas,
  ) {
    this.seas = new SeasAhead(engine, expectedAmplitudes(engine, open));
    const { wind } = answer(engine, "resolved_json");
    this.isGusty = wind?.gusts?.enabled ?? false;
  }

  get waves(): number {
    return this.seas.waves;
  }

  free(): void {
    this.engine.free();
  }

  /**
   * Sets the state at which the futures start. Throws if it belongs to another scenario, or if its sea cannot be
   * replaced.
   */
  begin(start: Start): void {
    this.engine.restore(start.snapshot);
    this.start_s = this.engine.time_s();
    this.start = start;
    const past = until(start.past, this.start_s);
    this.past_s = this.start_s - (past.time_s[0] ?? this.start_s);
    this.known = this.waves > 0 ? this.seas.after(past) : null;
  }

  /** One future, in parts; the same seed gives the same future. */
  *run(seed: number): Generator<void, Future> {
    const { engine, start, start_s, waves, isGusty, past_s } = this;
    if (!start) throw { kind: "internal", message: "no start is known" };
    engine.restore(start.snapshot);
    if (this.known) this.seas.enter(this.known, new Random(seed));
    const steps = Math.max(1, Math.round(start.every_s / engine.step_s()));
    const every_s = steps * engine.step_s();
    const count = Math.floor(start.horizon_s / every_s + 1e-9) + 1;
    const first = engine.row();
    const rows = new Float32Array(count * first.length).fill(NaN);
    rows.set(first);
    let fault: Fault | null = null;
    for (let k = 1; k < count && !fault; k++) {
      fault = yield* this.step(steps);
      if (!fault) rows.set(engine.row(), k * first.length);
    }
    return { seed, start_s, every_s, rows, waves, isGusty, past_s, fault };
  }

  private *step(steps: number): Generator<void, Fault | null> {
    for (let left = steps; left > 0; left -= STEPS_AT_ONCE) {
      try {
        this.engine.step(Math.min(left, STEPS_AT_ONCE));
      } catch (thrown) {
        return asFault(thrown);
      }
      yield;
    }
    return null;
  }
}

/** Returns the measurements up to a time. */
function until({ time_s, x_m, y_m }: Past, end_s: number): Past {
  const count = time_s.filter((time) => time <= end_s + 1e-9).length;
  return { time_s: time_s.subarray(0, count), x_m: x_m.subarray(0, count), y_m: y_m.subarray(0, count) };
}
