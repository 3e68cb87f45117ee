import { describe, expect, it } from "vitest";
import { Conditioned } from "../src/ahead/conditioned";
import { Futures } from "../src/ahead/futures";
import type { FromForeseer, Future, Past, Start } from "../src/ahead/messages";
import { Outlook } from "../src/ahead/outlook";
import { Foreseers } from "../src/ahead/pool";
import { fanOf, LEVELS, quantile } from "../src/ahead/quantiles";
import { Random } from "../src/ahead/random";
import { scoreOf, TrackRecord } from "../src/ahead/score";
import { expectedAmplitudes, SeasAhead } from "../src/ahead/sea";
import type { EngineInSeas } from "../src/ahead/sea";
import { Columns } from "../src/engine/columns";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { bits, filesOf, initEngine, read } from "./gallery";

await initEngine();
const VESSEL = read("scenarios/offshore_vessel.yaml");
const VESSEL_FILES = await filesOf(VESSEL);

function vessel(overrides: Record<string, unknown> = {}): EngineInSeas {
  return new Simulation(VESSEL, "offshore_vessel.yaml", JSON.stringify({ waves: true, ...overrides }), VESSEL_FILES);
}

/** A run up to a time, and where its ship was. */
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

/** x with A x = b, by Gauss's elimination. */
function solved(a: number[][], b: number[]): number[] {
  const rows = a.map((row, i) => [...row, b[i]]);
  rows.forEach((pivot, i) => {
    for (const row of rows) {
      if (row === pivot) continue;
      const share = row[i] / pivot[i];
      row.forEach((_, k) => (row[k] -= share * pivot[k]));
    }
  });
  return rows.map((row, i) => row[b.length] / row[i]);
}

describe("unknowns of which something was measured", () => {
  const H = [[1, 0.5, -0.3], [0.2, -1, 0.7]];
  const measured = { rows: Float64Array.from(H.flat()), values: Float64Array.of(0.8, -1.1), noise: 0.4 };
  // The information form, which the draws do not use: precision 1 + H^T H / R, mean precision^-1 H^T y / R.
  const square = measured.noise ** 2;
  const precision = [0, 1, 2].map((i) => [0, 1, 2].map((j) => (i === j ? 1 : 0) + H.reduce((sum, row) => sum + (row[i] * row[j]) / square, 0)));
  const mean = solved(precision, [0, 1, 2].map((i) => H.reduce((sum, row, k) => sum + (row[i] * measured.values[k]) / square, 0)));
  const covariance = [0, 1, 2].map((j) => solved(precision, [0, 1, 2].map((i) => (i === j ? 1 : 0))));

  it("have the mean of the normal distribution given what was measured", () => {
    new Conditioned(3, measured).mean().forEach((value, i) => expect(value).toBeCloseTo(mean[i], 12));
  });

  it("are drawn with its mean and covariance", () => {
    const known = new Conditioned(3, measured);
    const random = new Random(5);
    const draws = Array.from({ length: 40_000 }, () => known.draw(random));
    const average = (of: (draw: Float64Array) => number) => draws.reduce((sum, draw) => sum + of(draw), 0) / draws.length;
    for (let i = 0; i < 3; i++) {
      // Four standard errors of a mean and of a covariance.
      expect(Math.abs(average((x) => x[i]) - mean[i])).toBeLessThan(4 * Math.sqrt(covariance[i][i] / draws.length));
      for (let j = 0; j <= i; j++) {
        const found = average((x) => (x[i] - mean[i]) * (x[j] - mean[j]));
        const error = Math.sqrt((covariance[i][i] * covariance[j][j] + covariance[i][j] ** 2) / draws.length);
        expect(Math.abs(found - covariance[i][j])).toBeLessThan(4 * error);
      }
    }
  });

  it("are as they were where nothing was measured", () => {
    const known = new Conditioned(2, { rows: new Float64Array(), values: new Float64Array(), noise: 0.1 });
    expect(Array.from(known.draw(new Random(3)))).toEqual(Array.from(new Random(3).normals(2)));
  });
});

describe("random numbers", () => {
  it("are normal, and of a seed always the same", () => {
    const numbers = new Random(1).normals(100_000);
    const moment = (power: number) => numbers.reduce((sum, x) => sum + x ** power, 0) / numbers.length;
    // Four standard errors of each: the variances of x, x^2 and x^4 are 1, 2 and 96.
    expect(Math.abs(moment(1))).toBeLessThan(4 / Math.sqrt(numbers.length));
    expect(Math.abs(moment(2) - 1)).toBeLessThan(4 * Math.sqrt(2 / numbers.length));
    expect(Math.abs(moment(4) - 3)).toBeLessThan(4 * Math.sqrt(96 / numbers.length));
    expect(bits(new Random(1).normals(9))).toEqual(bits(numbers.subarray(0, 9)));
    expect(new Random(2).normal()).not.toBe(numbers[0]);
  });
});

describe("the lines of a fan", () => {
  it("have as much between them as they say of what comes next, whatever the number of futures", () => {
    // Of n numbers in order those of 1 to n: what comes next is below the place p (n + 1) with the probability p.
    for (const n of [32, 64, 199]) {
      const ascending = Array.from({ length: n }, (_, i) => i + 1);
      for (const level of LEVELS) expect(quantile(ascending, level)).toBeCloseTo(level * (n + 1), 12);
    }
  });

  it("end at the outermost future where there are few, and leave out what is no number", () => {
    expect(quantile([2, 3], 0.05)).toBe(2);
    expect(quantile([2, 3], 0.95)).toBe(3);
    expect(quantile([], 0.5)).toBeNaN();
    const [low, , middle, , high] = fanOf([Float64Array.of(3, NaN, 1, 2)]);
    expect([low[0], middle[0], high[0]]).toEqual([1, 2, 3]);
  });
});

describe("seas that may be", () => {
  it("go through the measured past where there is no noise", () => {
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
    // Five minutes on they know nothing of one another.
    const later: Past = { time_s: Float64Array.from(past.time_s, (time) => time + 300), x_m: past.x_m, y_m: past.y_m };
    const [one, other] = [1, 2].map((seed) => {
      exact.enter(known, new Random(seed));
      return elevations(engine, later);
    });
    const dot = (a: number[], b: number[]) => a.reduce((sum, value, i) => sum + value * b[i], 0);
    expect(Math.abs(dot(one, other)) / Math.sqrt(dot(one, one) * dot(other, other))).toBeLessThan(0.5);
    engine.free();
  });

  it("have the height of the spectrum, and that of what the spectrum gives where the run drew its own at random", () => {
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

  it("begin at the state of the run and go their own ways, the same for the same seed", () => {
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

  it("read the sea of the run at no time after their start, and never move in it", () => {
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

  it("are one line where the water is still", () => {
    const calm = vessel({ waves: false });
    calm.step(20);
    const futures = new Futures(calm, () => vessel());
    futures.begin({ ...start, snapshot: calm.snapshot() });
    const [one, other] = [1, 2].map((seed) => wholeRun(futures, seed));
    expect(one.waves).toBe(0);
    expect(one.rows).toEqual(other.rows);
  });

  it("hold the truth near the start, where the state of the ship and the measured waves decide", () => {
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
});

describe("how minutes of the recording were held", () => {
  it("is counted once a minute, of the newest six", () => {
    const record = new TrackRecord();
    expect(record.due(59)).toEqual([]);
    expect(record.due(125)).toEqual([60, 0]);
    record.add(60, { held: 9, of: 10 });
    record.add(0, null);
    expect(record.due(125)).toEqual([]);
    expect(record.newest).toEqual({ held: 9, of: 10, minutes: 1 });
    for (const start_s of record.due(600)) record.add(start_s, { held: 8, of: 10 });
    expect(record.newest).toEqual({ held: 48, of: 60, minutes: 6 });
    record.dropAfter(110);
    expect(record.due(125)).toEqual([60]);
  });
});

/** Workers that do what they are told when they are let. */
class FakeWorker {
  onmessage: ((event: MessageEvent<FromForeseer>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  readonly told: { kind: string; job?: number; seeds?: number[] }[] = [];
  isOver = false;

  postMessage(message: { kind: string }): void {
    this.told.push(message);
  }

  terminate(): void {
    this.isOver = true;
  }

  say(message: FromForeseer): void {
    this.onmessage?.({ data: message } as MessageEvent<FromForeseer>);
  }
}

describe("engines that look ahead", () => {
  const scenario = { text: "", file: "", overrides: {}, opened: null, folder: "" };
  const start = { snapshot: new Uint8Array(), past: { time_s: new Float64Array(), x_m: new Float64Array(), y_m: new Float64Array() }, horizon_s: 60, every_s: 0.5 };
  const future = { seed: 1 } as Future;

  async function employed() {
    const workers: FakeWorker[] = [];
    const make = () => (workers.push(new FakeWorker()), workers.at(-1)!) as unknown as Worker;
    const module = {} as WebAssembly.Module;
    let compiled = 0;
    const foreseers = new Foreseers(make, async () => (compiled++, module), 2);
    const heard: Future[] = [];
    const ended = foreseers.look(scenario, start, [1, 2, 3, 4, 5], (one) => heard.push(one));
    await new Promise((resolve) => setTimeout(resolve));
    return { workers, foreseers, heard, ended, compiledOften: () => compiled };
  }

  it("share one compiled module and the seeds", async () => {
    const { workers, compiledOften } = await employed();
    expect(compiledOften()).toBe(1);
    expect(workers.map(({ told }) => told.map(({ kind }) => kind))).toEqual([["module", "look"], ["module", "look"]]);
    expect(workers.map(({ told }) => told[1].seeds)).toEqual([[1, 3, 5], [2, 4]]);
  });

  it("end when all have come, and are heard before", async () => {
    const { workers, heard, ended } = await employed();
    const { job } = workers[0].told[1];
    workers[0].say({ kind: "future", job: job!, future });
    workers[0].say({ kind: "done", job: job! });
    expect(heard).toEqual([future]);
    workers[1].say({ kind: "done", job: job! });
    expect(await ended).toBe(true);
  });

  it("are stopped by something newer, whose futures alone are heard", async () => {
    const { workers, foreseers, heard, ended } = await employed();
    const { job } = workers[0].told[1];
    const newer: Future[] = [];
    void foreseers.look(scenario, start, [9], (one) => newer.push(one));
    expect(await ended).toBe(false);
    await new Promise((resolve) => setTimeout(resolve));
    workers[0].say({ kind: "future", job: job!, future });
    workers[1].say({ kind: "future", job: job! + 1, future });
    expect([heard, newer]).toEqual([[], [future]]);
  });

  it("are told to stop where no one looks ahead any more", async () => {
    const { workers, foreseers, ended } = await employed();
    foreseers.cancel();
    expect(await ended).toBe(false);
    expect(workers.map(({ told }) => told.at(-1)!.kind)).toEqual(["cancel", "cancel"]);
  });

  it("say what went wrong, and are others afterwards where one broke down", async () => {
    const { workers, foreseers, ended } = await employed();
    const broken = expect(ended).rejects.toMatchObject({ kind: "engine" });
    workers[1].onerror?.({ message: "out of memory" } as ErrorEvent);
    await broken;
    expect(workers.every(({ isOver }) => isOver)).toBe(true);
    void foreseers.look(scenario, start, [1], () => undefined);
    await new Promise((resolve) => setTimeout(resolve));
    expect(workers.length).toBe(4);
  });
});
