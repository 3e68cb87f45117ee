import { Session } from "../src/app/session";
import type { EngineClient } from "../src/engine/client";
import type { Value, Values } from "../src/engine/engine";
import type { LeverMove } from "../src/engine/messages";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { Runner } from "../src/engine/runner";
import { filesOf, read } from "./gallery";

/** The engine itself behind a client, without a worker; scenarios name files of the gallery alone. */
export function directClient(now_ms: () => number = () => 0): EngineClient {
  const runner = new Runner((...of) => new Simulation(...of), now_ms);
  const client = {
    async open(text: string, file: string, values: Values) {
      return runner.open(text, file, values, JSON.parse(await filesOf(text)) as Record<string, string>);
    },
    advance: async (wall_s: number, speed: number) => runner.advance(wall_s, speed),
    step: async () => runner.step(),
    input: async (name: string, value: number) => runner.input(name, value),
    parameter: async (name: string, value: Value) => runner.parameter(name, value),
    snapshot: async () => runner.snapshot(),
    restore: async (snapshot: Uint8Array, moves: LeverMove[]) => runner.restore(snapshot, moves),
    replay: async () => ({ ...runner.replay(), files: [] }),
  };
  return client as unknown as EngineClient;
}

/** A scenario of the gallery in a session of its own. */
export async function openedDirectly(scenario: string, overrides: Values = {}): Promise<Session> {
  const session = new Session(directClient());
  await session.open({ text: read(`scenarios/${scenario}.yaml`), file: `${scenario}.yaml` }, overrides);
  return session;
}
