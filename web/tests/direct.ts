import { Session } from "../src/app/session";
import type { Change } from "../src/engine/changes";
import type { EngineClient } from "../src/engine/client";
import type { Engine, InputInfo, ParameterInfo, Value, Values } from "../src/engine/engine";
import { asFault, readModel } from "../src/engine/engine";
import type { LeverMove, Snapshot } from "../src/engine/messages";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { Runner } from "../src/engine/runner";
import { filesOf, read } from "./gallery";

/**
 * The engine behind a client, without a worker: it answers requests in turn, with a delay if `isLate` returns true.
 * Each reading of the clock advances it by `look_ms`; without `look_ms` a frame computes everything that is requested.
 * Scenarios may name only files of the gallery.
 */
export class DirectEngine {
  private engine: Engine | null = null;
  private clock_ms = 0;
  private turn: Promise<unknown> = Promise.resolve();
  private asked = 0;
  readonly runner = new Runner(
    (...of) => (this.engine = new Simulation(...of)),
    () => (this.clock_ms += this.look_ms),
  );
  readonly client: EngineClient;

  constructor(
    private readonly isLate: () => boolean = () => false,
    private readonly look_ms = 0,
  ) {
    const { runner } = this;
    const client = {
      open: (text: string, file: string, values: Values, _opened: unknown, changes?: readonly Change[]) =>
        this.inTurn(async () => runner.open(text, file, values, JSON.parse(await filesOf(text)) as Record<string, string>, changes)),
      advance: (wall_s: number, speed: number, until_s?: number) => this.inTurn(() => runner.advance(wall_s, speed, until_s)),
      step: () => this.inTurn(() => runner.step()),
      input: (name: string, value: number) => this.inTurn(() => runner.input(name, value)),
      parameter: (name: string, value: Value) => this.inTurn(() => runner.parameter(name, value)),
      snapshot: () => this.inTurn(() => runner.snapshot()),
      restore: (snapshot: Uint8Array, moves: LeverMove[] = []) => this.inTurn(() => runner.restore(snapshot, moves)),
      resume: (keyframe: Snapshot) => this.inTurn(() => runner.resume(keyframe)),
      changes: () => this.inTurn(() => structuredClone(runner.made())),
      replay: () => this.inTurn(() => ({ ...runner.replay(), files: [] })),
    };
    this.client = client as unknown as EngineClient;
  }

  /** Returns the inputs of the engine. */
  inputs(): InputInfo[] {
    return JSON.parse(this.engine!.inputs_json()) as InputInfo[];
  }

  parameters(): ParameterInfo[] {
    return readModel(this.engine!.model_json()).parameters;
  }

  get isBusy(): boolean {
    return this.asked > 0;
  }

  private inTurn<T>(work: () => T | Promise<T>): Promise<T> {
    this.asked += 1;
    const answer = this.turn
      .then(() => this.isLate() && new Promise((resolve) => setImmediate(resolve)))
      .then(work)
      .catch((thrown: unknown) => {
        throw asFault(thrown);
      })
      .finally(() => (this.asked -= 1));
    this.turn = answer.catch(() => undefined);
    return answer;
  }
}

/** Opens a scenario of the gallery in a new session. */
export async function openedDirectly(scenario: string, overrides: Values = {}): Promise<Session> {
  const session = new Session(new DirectEngine().client);
  await session.open({ text: read(`scenarios/${scenario}.yaml`), file: `${scenario}.yaml` }, overrides);
  return session;
}
