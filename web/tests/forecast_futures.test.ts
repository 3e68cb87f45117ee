import { describe, expect, it } from "vitest";
import { Futures } from "../src/forecast/futures";
import type { Future, Past, Start } from "../src/forecast/messages";
import { Outlook } from "../src/forecast/outlook";
import { Random } from "../src/forecast/random";
import { scoreOf } from "../src/forecast/score";
import { expectedAmplitudes, SeasAhead } from "../src/forecast/sea";
import type { EngineInSeas } from "../src/forecast/sea";
import { swarmOf } from "../src/forecast/swarm";
import { Columns } from "../src/engine/columns";
import { readModel } from "../src/engine/engine";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { bits, filesOf, initEngine, read } from "./gallery";

await initEngine();
const VESSEL = read("scenarios/offshore_vessel.yaml");
const VESSEL_FILES = await filesOf(VESSEL);

function vessel(overrides: Record<string, unknown> = {}): EngineInSeas {
  return new Simulation(VESSEL, "offshore_vessel.yaml", JSON.stringify({ waves: true, ...overrides }), VESSEL_FILES);
}

/** Steps a run to a time, and returns the positions of its ship. */
function runTo(engine: EngineInSeas, end_s: number, every_s = 0.6): Past {
  const columns = new Columns(JSON.parse(engine.channels_json()));
  const steps = Math.round(every_s / engine.step_s());
  const rows = [engine.row()];
  while (engine.time_s() < end_s - 1e-9) {
    engine.step(steps);
    rows.push(engine.row());
  }
  const column = (name: string) => Float64Array.from(rows, (row) => columns.read(row, name));
  return { time_s: column("time"), x_m: column("hull.position.x"), y_m: column("hull.position.y") };
}

function elevations(engine: EngineInSeas, { time_s, x_m, y_m }: Past): number[] {
  const waves = engine.wave_amplitudes_m().length;
  return Array.from(time_s, (time, i) => engine.wave_phasors(x_m[i], y_m[i], time).subarray(0, waves).reduce((a, b) => a + b, 0));
}

function wholeRun(futures: Futures, seed: number): Future {
  const running = futures.run(seed);
  for (let next = running.next(); ; next = running.next()) if (next.done) return next.value;
}

describe("possible seas", () => {
  it("possible seas agree with measurements without noise", () => {
    const engine = vessel();
    const past = runTo(engine, 60);
    const measured = elevations(engine, past);
    const largest = Math.max(...measured.map(Math.abs));
    const exact = new SeasAhead(engine, engine.wave_amplitudes_m(), 1e-4);
    const known = exact.after(past);
    for (const seed of [1, 2]) {
      exact.enter(known, new Random(seed));
      const off = elevations(engine, past).map((value, i) => Math.abs(value - measured[i]));
      expect(Math.max(...off)).toBeLessThan(0.005 * largest);
    }
    // Five minutes later two seas are uncorrelated.
    const later: Past = { time_s: Float64Array.from(past.time_s, (time) => time + 300), x_m: past.x_m, y_m: past.y_m };
    const [one, other] = [1, 2].map((seed) => {
      exact.enter(known, new Random(seed));
      return elevations(engine, later);
    });
    const dot = (a: number[], b: number[]) => a.reduce((sum, value, i) => sum + value * b[i], 0);
    expect(Math.abs(dot(one, other)) / Math.sqrt(dot(one, one) * dot(other, other))).toBeLessThan(0.5);
    engine.free();
  });

  it("possible seas have the wave height of the spectrum, also if the run's amplitudes are random", () => {
    const random = "sea.waves.wind_sea.jonswap.realisation.amplitudes";
    const [engine, plain] = [vessel({ [random]: "random" }), vessel()];
    const open = (resolved: string) => new Simulation(resolved, "again", "{}", VESSEL_FILES) as EngineInSeas;
    const expected = expectedAmplitudes(engine, open);
    expect(bits(expected)).toEqual(bits(plain.wave_amplitudes_m()));
    expect(bits(expected)).not.toEqual(bits(engine.wave_amplitudes_m()));
    expect(new SeasAhead(engine, expected).height_m).toBeCloseTo(2.5, 6);
    [engine, plain].forEach((one) => one.free());
  });
});

describe("futures", () => {
  const engine = vessel();
  const past = runTo(engine, 90);
  const start: Start = { snapshot: engine.snapshot(), past, horizon_s: 12, every_s: 0.6 };
  const width = engine.row().length;

  it("futures start at the state of the run, differ by seed, and are equal for equal seeds", () => {
    const futures = new Futures(vessel(), () => vessel());
    futures.begin(start);
    const [one, again, other] = [1, 1, 2].map((seed) => wholeRun(futures, seed));
    expect(one.start_s).toBeCloseTo(90, 9);
    expect(one.past_s).toBeCloseTo(90, 9);
    expect(one.rows.length).toBe(21 * width);
    expect(one.rows[20 * width]).toBeCloseTo(102, 4);
    expect(one.rows).toEqual(again.rows);
    const [heave] = [new Columns(JSON.parse(engine.channels_json())).at("hull.position.z")];
    expect(one.rows[heave]).toBe(other.rows[heave]);
    expect(one.rows[20 * width + heave]).not.toBe(other.rows[20 * width + heave]);
    expect(one.fault).toBeNull();
  });

  it("futures never use the run's own sea after their start", () => {
    const inner = vessel();
    const own = bits(inner.wave_phases_rad());
    let isOwn = true;
    const read: number[] = [];
    const seen = new Proxy(inner, {
      get(target, name) {
        const member = Reflect.get(target, name) as unknown;
        if (typeof member !== "function") return member;
        return (...given: unknown[]) => {
          if (name === "set_waves") isOwn = bits(given[1] as Float64Array).join() === own.join();
          if (name === "wave_phasors" && isOwn) read.push(given[2] as number);
          if (name === "step") expect(isOwn).toBe(false);
          return (member as (...all: unknown[]) => unknown).apply(target, given);
        };
      },
    });
    const futures = new Futures(seen, () => vessel());
    const more: Past = { time_s: Float64Array.from([...past.time_s, 95]), x_m: Float64Array.from([...past.x_m, 0]), y_m: Float64Array.from([...past.y_m, 0]) };
    futures.begin({ ...start, past: more });
    expect(wholeRun(futures, 1).fault).toBeNull();
    expect(read.length).toBe(past.time_s.length);
    expect(Math.max(...read)).toBeLessThanOrEqual(90 + 1e-9);
  });

  it("futures on still water are equal", () => {
    const calm = vessel({ waves: false });
    calm.step(20);
    const futures = new Futures(calm, () => vessel());
    futures.begin({ ...start, snapshot: calm.snapshot() });
    const [one, other] = [1, 2].map((seed) => wholeRun(futures, seed));
    expect(one.waves).toBe(0);
    expect(one.rows).toEqual(other.rows);
  });

  it("the band of futures is narrow near the start and contains the true run", () => {
    const truth = vessel();
    truth.restore(start.snapshot);
    const futures = new Futures(vessel(), () => vessel());
    futures.begin(start);
    const outlook = new Outlook(32, width);
    for (let seed = 1; seed <= 32; seed++) outlook.add(wholeRun(futures, seed));
    const pitch = new Columns(JSON.parse(truth.channels_json())).at("hull.pitch");
    const fan = outlook.fan([pitch]);
    const band = (k: number) => fan[4][k] - fan[0][k];
    expect(band(0)).toBe(0);
    expect(band(2)).toBeLessThan(0.2 * band(18));
    const rows = Array.from({ length: outlook.length }, (_, k) => {
      if (k > 0) truth.step(12);
      return truth.row();
    });
    const score = scoreOf(outlook, [pitch], (time_s) => rows[Math.round((time_s - 90) / 0.6)]);
    expect(score.of).toBe(20);
    expect(score.held).toBeGreaterThanOrEqual(12);
  });

  it("futures are drawn as a cloud of load positions every two seconds", () => {
    const engine = vessel();
    const columns = new Columns(JSON.parse(engine.channels_json()));
    const futures = new Futures(engine, () => vessel());
    futures.begin({ snapshot: engine.snapshot(), past: runTo(vessel(), 0), horizon_s: 6, every_s: 0.5 });
    const outlook = new Outlook(2, columns.width);
    for (const seed of [1, 2]) outlook.add(wholeRun(futures, seed));
    const { points, lateness } = swarmOf(outlook, { model: readModel(engine.model_json()), columns });
    expect(Array.from(lateness)).toEqual([4, 4, 8, 8, 12, 12].map((k) => k / 12));
    const last = outlook.row(1, 12);
    expect(Array.from(points).slice(-3)).toEqual(["x", "y", "z"].map((axis) => columns.read(last, `load.position.${axis}`)));
    engine.free();
  });
});
