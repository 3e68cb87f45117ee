import { beforeEach, describe, expect, it } from "vitest";
import { Forecast, FUTURES } from "../src/forecast/forecast";
import type { Future, ScenarioOf, Start } from "../src/forecast/messages";
import { BackgroundEngine } from "../src/app/background_engine";
import { isCalm } from "../src/app/calm";
import { Session } from "../src/app/session";
import type { EngineClient } from "../src/engine/client";
import type { Value, Values } from "../src/engine/engine";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { Runner } from "../src/engine/runner";
import { filesOf, initEngine, read } from "./gallery";
import { until } from "./until";

await initEngine();
const text = read("scenarios/offshore_vessel_on_dp.yaml");
const files = await filesOf(text);
const open = (overrides: Values) => new Simulation(text, "dp.yaml", JSON.stringify(overrides), files);

/** A client without a worker. */
function client(): EngineClient {
  const runner = new Runner((_text, _file, json) => open(JSON.parse(json)), () => 0);
  return {
    open: async (given: string, file: string, overrides: Values) => runner.open(given, file, overrides),
    step: async () => runner.step(),
    input: async (name: string, value: number) => (runner.input(name, value), null),
    snapshot: async () => runner.snapshot(),
    restore: async (snapshot: Uint8Array) => runner.restore(snapshot),
    parameter: async (name: string, value: Value) => (runner.parameter(name, value), null),
  } as unknown as EngineClient;
}

interface Asked {
  scenario: ScenarioOf;
  start: Start;
  seeds: readonly number[];
}

/** Futures with constant values. */
class Still {
  readonly asked: Asked[] = [];
  cancelled = 0;

  async look(scenario: ScenarioOf, start: Start, seeds: readonly number[], hear: (future: Future) => void): Promise<boolean> {
    this.asked.push({ scenario, start, seeds });
    // A snapshot is restored in an engine with equal parameter values.
    const engine = open(scenario.overrides);
    engine.restore(start.snapshot);
    const row = engine.row();
    const count = Math.floor(start.horizon_s / start.every_s + 1e-9) + 1;
    const rows = Float32Array.from({ length: count * row.length }, (_, i) => row[i % row.length]);
    for (const seed of seeds) hear({ seed, start_s: engine.time_s(), every_s: start.every_s, rows, waves: 200, isGusty: false, past_s: 0, fault: null });
    engine.free();
    return true;
  }

  cancel(): void {
    this.cancelled += 1;
  }
}

/** Waits until no task waits. */
const calm = () => until(() => expect(isCalm()).toBe(true));

describe("forecast of a session", { timeout: 60_000 }, () => {
  let session: Session;
  let foreseers: Still;
  let forecast: Forecast;

  async function stepTo(time_s: number): Promise<void> {
    while (session.shown.time_s < time_s - 1e-9) await session.step();
  }

  beforeEach(async () => {
    session = new Session(client());
    foreseers = new Still();
    forecast = new Forecast(session, new BackgroundEngine(client), foreseers, "");
    await session.open({ text, file: "dp.yaml" }, { waves: true });
  });

  it("a forecast starts when it is switched on, at the moment that is shown, with the measurements before it", async () => {
    await stepTo(2);
    await calm();
    expect(foreseers.asked).toEqual([]);
    forecast.switch(true);
    await until(() => expect(forecast.outlook?.start_s).toBeCloseTo(2, 9));
    expect(foreseers.asked.map(({ seeds }) => seeds.length)).toEqual([FUTURES]);
    const { past } = foreseers.asked[0].start;
    expect([past.time_s[0], past.time_s.at(-1)!.toFixed(9)]).toEqual([0, "2.000000000"]);
    expect(past.x_m.every(Number.isFinite)).toBe(true);
    session.scrub(1);
    await until(() => expect(forecast.outlook?.start_s).toBeCloseTo(1, 9));
    expect(foreseers.asked[1].start.past.time_s.at(-1)).toBeCloseTo(1, 9);
  });

  it("a forecast uses the set value of a live parameter, and starts again when one is set", async () => {
    const live = session.run!.model.parameters.find((parameter) => parameter.live && parameter.kind === "number")!;
    await stepTo(1);
    forecast.switch(true);
    await until(() => expect(forecast.outlook?.start_s).toBeCloseTo(1, 9));
    const value = Number(live.value) === live.range![0] ? live.range![1] : live.range![0];
    session.set(live.name, value);
    await until(() => expect(session.pending()).toEqual([]));
    await stepTo(1.5);
    await until(() => expect(forecast.outlook?.start_s).toBeCloseTo(session.shown.time_s, 9));
    expect(forecast.fault).toBeNull();
    expect(foreseers.asked.at(-1)!.scenario.overrides[live.name]).toBe(value);
  });

  it("the forecast is judged once for each full minute, except minutes with changes by hand", async () => {
    await stepTo(61);
    forecast.switch(true);
    await until(() => expect(forecast.record.newest.minutes).toBe(1));
    const { held, of } = forecast.record.newest;
    expect(of).toBeGreaterThan(100);
    // In waves no recorded value is constant, so that most are outside the band.
    expect(held / of).toBeLessThan(0.5);
    await stepTo(61.5);
    await until(() => expect(foreseers.asked.map(({ seeds }) => seeds.length)).toEqual([FUTURES, 32, FUTURES]));
    forecast.switch(false);
    expect(forecast.outlook).toBeNull();
    const live = session.run!.model.parameters.find((parameter) => parameter.live && parameter.kind === "number")!;
    session.set(live.name, live.range![0]);
    await until(() => expect(session.pending()).toEqual([]));
    await stepTo(120.5);
    forecast.switch(true);
    await until(() => expect(forecast.outlook?.start_s).toBeCloseTo(session.shown.time_s, 9));
    await calm();
    expect(forecast.record.newest.minutes).toBe(1);
    // A new run starts with empty scores.
    await session.reset();
    expect(forecast.record.newest.minutes).toBe(0);
  });
});
