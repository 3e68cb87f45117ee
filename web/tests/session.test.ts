import { beforeEach, describe, expect, it } from "vitest";
import { Session } from "../src/app/session";
import { faultOfControl } from "../src/app/faults";
import type { EngineClient } from "../src/engine/client";
import type { Fault, Value, Values } from "../src/engine/engine";
import { Runner } from "../src/engine/runner";
import { FakeEngine } from "./fake";

const engines: FakeEngine[] = [];

/** The client without its worker: the runner answers a moment later. */
function clientOf(openings: Values[], divergesAt_s = Infinity): EngineClient {
  const runner = new Runner(
    (text, file, json) => {
      const overrides = JSON.parse(json) as Values;
      if (text === "bad" || overrides.load === "no") {
        throw { kind: "scenario", message: `${file}:1:1: text: found bad, allowed: good`, file, line: 1, column: 1 };
      }
      openings.push(overrides);
      engines.push(new FakeEngine(overrides, 0.001, 0.01, divergesAt_s));
      return engines.at(-1)!;
    },
    () => 0,
  );
  const later = <T>(work: () => T) => new Promise<T>((resolve, reject) => setTimeout(() => {
    try {
      resolve(work());
    } catch (fault) {
      reject(fault);
    }
  }));
  return {
    open: (text: string, file: string, overrides: Values) => later(() => runner.open(text, file, overrides)),
    advance: (wall_s: number, speed: number) => later(() => runner.advance(wall_s, speed)),
    step: () => later(() => runner.step()),
    input: (name: string, value: number) => later(() => (runner.input(name, value), null)),
    replay: () => later(() => ({ ...runner.replay(), files: [] })),
    parameter: (name: string, value: Value) => later(() => (runner.parameter(name, value), null)),
  } as unknown as EngineClient;
}

const good = { text: "good", file: "good.yaml" };
const settled = () => new Promise((resolve) => setTimeout(resolve, 20));

describe("the session", () => {
  let openings: Values[];
  let session: Session;
  let faults: (Fault | null)[];

  beforeEach(async () => {
    openings = [];
    faults = [];
    session = new Session(clientOf(openings));
    session.listen({ faulted: (fault) => faults.push(fault) });
    await session.open(good, {});
  });

  it("sets a live value under way without a reset, of many that come together the last", async () => {
    session.start();
    await session.step();
    for (const wind of [9, 10, 11, 12]) session.set("wind", wind);
    expect(session.pending()).toEqual(["wind"]);
    await settled();
    expect(session.pending()).toEqual([]);
    expect(session.value("wind")).toBe(12);
    expect(openings.length).toBe(1);
    expect(engines.at(-1)?.set).toEqual([9, 12]);
    expect(session.status).toBe("paused");
  });

  it("saves the run in hand as a file, and knows which live values a run of it would lack", async () => {
    await session.step();
    expect(await session.save()).toMatchObject({ name: "good-saved.yaml", differs: null });
    session.set("wind", 9);
    await settled();
    expect((await session.save())!.differs).toContain("wind at 0.01 s");
    expect(session.fault).toBeNull();
  });

  it("reports why a run cannot be saved, and goes on", async () => {
    engines.at(-1)!.replay_json = () => {
      throw { kind: "input", message: "operation: found one in the scenario, allowed: operation.enabled: false" };
    };
    expect(await session.save()).toBeNull();
    expect(session.fault?.kind).toBe("unsaved");
    await session.step();
    expect(session.status).toBe("paused");
  });

  it("follows a value at once at the start, in as few openings as keep up", async () => {
    for (const load of [true, false, true]) session.set("load", load);
    await settled();
    expect(openings.at(-1)).toEqual({ load: true });
    expect(openings.length).toBeLessThanOrEqual(3);
    expect(session.pending()).toEqual([]);
  });

  it("keeps a value for the reset while a run is under way", async () => {
    await session.step();
    session.set("load", true);
    await settled();
    expect(openings.length).toBe(1);
    expect(session.pending()).toEqual(["load"]);
    session.set("load", false);
    expect(session.pending()).toEqual([]);
    session.set("load", true);
    await session.reset();
    expect(openings.at(-1)).toEqual({ load: true });
    expect(session.status).toBe("idle");
    expect(session.pending()).toEqual([]);
  });

  it("shows why a scenario does not read and goes on with the one in hand", async () => {
    expect(await session.open({ text: "bad", file: "bad.yaml" }, {})).toBe(false);
    expect(faults.at(-1)).toMatchObject({ kind: "scenario", file: "bad.yaml", line: 1 });
    await session.step();
    expect(session.run!.columns.read(session.lastFrame!.row, "time")).toBeCloseTo(0.01, 12);
    await session.reset();
    expect(session.status).toBe("idle");
  });

  it("goes back to the value in hand when the engine refuses one", async () => {
    session.set("load", true);
    await settled();
    session.set("load", "no");
    await settled();
    expect(session.value("load")).toBe(true);
    expect(session.fault?.kind).toBe("scenario");
  });

  it("words a refused value by its control, not as the command line does", () => {
    const parameters = [{ name: "load_t", label: "Load on the hook", unit: "t", kind: "number", value: 20, range: [1, 50], choices: null, live: false }] as const;
    const fault = { kind: "scenario", message: "--set load_t: found 500, allowed: a number from 1 to 50", file: "--set load_t", field: "load_t", found: "500", allowed: "a number from 1 to 50" };
    expect(faultOfControl(fault, parameters as never)).toEqual({ kind: "input", message: "Load on the hook: 500 t is not a number from 1 to 50 t." });
    const step = { ...fault, file: "--set simulation.step_s", found: "-1", allowed: "a number greater than 0" };
    expect(faultOfControl(step, []).message).toBe("Step size: -1 is not a number greater than 0.");
    const ofFile = { ...fault, file: "ship.yaml" };
    expect(faultOfControl(ofFile, [])).toBe(ofFile);
  });

  it("stops where the run diverges, and starts again after a reset", async () => {
    session = new Session(clientOf(openings, 0.0155));
    await session.open(good, {});
    await session.step();
    await session.step();
    expect(session.status).toBe("stopped");
    expect(session.fault).toMatchObject({ kind: "diverged", body: "ship" });
    session.start();
    expect(session.status).toBe("stopped");
    await session.reset();
    expect(session.status).toBe("idle");
    expect(session.fault).toBeNull();
  });

  it("runs on past the duration until it is paused", async () => {
    session.start();
    for (let i = 0; i < 40; i++) await session.advance(0.1);
    expect(session.run!.columns.read(session.lastFrame!.row, "time")).toBeCloseTo(4, 9);
    session.pause();
    await session.advance(0.1);
    expect(session.run!.columns.read(session.lastFrame!.row, "time")).toBeCloseTo(4, 9);
  });
});
