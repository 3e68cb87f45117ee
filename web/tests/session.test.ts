import { beforeEach, describe, expect, it, vi } from "vitest";
import { BackgroundEngine } from "../src/app/background_engine";
import { Session } from "../src/app/session";
import { faultOfControl } from "../src/app/faults";
import type { EngineClient } from "../src/engine/client";
import type { Fault, Value, Values } from "../src/engine/engine";
import type { LeverMove } from "../src/engine/messages";
import { Runner } from "../src/engine/runner";
import { FakeEngine } from "./fake";
import { turns, until } from "./until";

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
    input: (name: string, value: number) => later(() => runner.input(name, value)),
    snapshot: () => later(() => runner.snapshot()),
    restore: (snapshot: Uint8Array, moves: LeverMove[]) => later(() => runner.restore(snapshot, moves)),
    replay: () => later(() => ({ ...runner.replay(), files: [] })),
    parameter: (name: string, value: Value) => later(() => (runner.parameter(name, value), null)),
  } as unknown as EngineClient;
}

const good = { text: "good", file: "good.yaml" };

describe("the session", () => {
  let openings: Values[];
  let session: Session;
  let faults: (Fault | null)[];
  const time = () => session.run!.columns.read(session.shown.moment!.row, "time");

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
    await turns();
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
    await turns();
    expect((await session.save())!.differs).toContain("wind at 0.01 s");
    expect(session.fault).toBeNull();
  });

  it("reports why a run cannot be saved, and goes on", async () => {
    engines.at(-1)!.replay_json = () => {
      throw { kind: "input", message: "operation: found one in the scenario, allowed: operation.enabled: false" };
    };
    expect(await session.save()).toBeNull();
    expect(session.fault?.kind).toBe("two_operations");
    await session.step();
    expect(session.status).toBe("paused");
  });

  it("follows a value at once at the start, in as few openings as keep up", async () => {
    for (const load of [true, false, true]) session.set("load", load);
    await turns();
    expect(openings.at(-1)).toEqual({ load: true });
    expect(openings.length).toBeLessThanOrEqual(3);
    expect(session.pending()).toEqual([]);
  });

  it("starts where Start is pressed right after a change, with the value changed", async () => {
    session.set("load", true);
    session.start();
    expect(session.isGoing).toBe(true);
    await turns();
    expect(session.status).toBe("running");
    expect(openings.at(-1)).toEqual({ load: true });
    await session.advance(0.1);
    expect(time()).toBeCloseTo(0.1, 9);
  });

  it("starts after the last of several changes, and not where it was paused again meanwhile", async () => {
    session.set("load", true);
    session.start();
    session.set("load", false);
    await turns();
    expect(session.status).toBe("running");
    expect(openings.at(-1)).toEqual({ load: false });
    await session.reset();
    session.set("load", true);
    session.start();
    session.pause();
    expect(session.isGoing).toBe(false);
    await turns();
    expect(session.status).toBe("idle");
  });

  it("steps where Step is pressed right after a change", async () => {
    session.set("load", true);
    await session.step();
    await until(() => expect(time()).toBeCloseTo(0.01, 9));
    expect(session.status).toBe("paused");
    expect(openings.at(-1)).toEqual({ load: true });
  });

  it("starts nothing where the value changed before it is refused", async () => {
    session.set("load", "no");
    session.start();
    await turns();
    expect(session.status).toBe("idle");
    expect(session.isGoing).toBe(false);
  });

  it.each(["pause", "reset"] as const)("leaves a long Step off at once on %s, and steps on from there", async (stop) => {
    const client = clientOf(openings);
    const { step } = client;
    client.step = async () => ({ ...(await step()), isPart: true });
    session = new Session(client);
    await session.open(good, {});
    const stepped = session.step();
    await until(() => expect(session.status).toBe("stepping"));
    expect(session.isGoing).toBe(true);
    await session[stop]();
    await stepped;
    expect(session.status).toBe(stop === "pause" ? "paused" : "idle");
    client.step = step;
    const before = time();
    await session.step();
    expect(time()).toBeGreaterThan(before);
    expect(session.status).toBe("paused");
  });

  it("has the hulls' floating reckoned by a second engine, from the state of the first", async () => {
    const asked: unknown[][] = [];
    const note = (name: string) => (...of: unknown[]) => Promise.resolve(void asked.push([name, ...of]));
    const hydrostatics = async () => ({ hulls: [], warnings: [] });
    const background = new BackgroundEngine(() => ({ open: note("open"), restore: note("restore"), hydrostatics }) as unknown as EngineClient);
    await session.step();
    await background.hydrostatics(session);
    await session.step();
    const [dropped, newest] = [background.hydrostatics(session), background.hydrostatics(session)];
    expect([await dropped, await newest]).toEqual([null, { hulls: [], warnings: [] }]);
    expect(asked).toEqual([
      ["open", "good", "good.yaml", {}, null],
      ["restore", Uint8Array.of(10)],
      ["restore", Uint8Array.of(20)],
    ]);
  });

  it("keeps a value for the reset while a run is under way", async () => {
    await session.step();
    session.set("load", true);
    await turns();
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
    expect(session.run!.columns.read(session.shown.moment!.row, "time")).toBeCloseTo(0.01, 12);
    await session.reset();
    expect(session.status).toBe("idle");
  });

  it("goes back to the value in hand when the engine refuses one", async () => {
    session.set("load", true);
    await turns();
    session.set("load", "no");
    await turns();
    expect(session.value("load")).toBe(true);
    expect(session.fault?.kind).toBe("scenario");
  });

  it("words a refused value by its control, not as the command line does", () => {
    const parameters = [{ name: "load_t", label: "Load on the hook", unit: "t", kind: "number", value: 20, range: [1, 50], choices: null, live: false }] as const;
    const fault = { kind: "scenario", message: "--set load_t: found 500, allowed: a number from 1 to 50", file: "--set load_t", field: "load_t", found: "500", allowed: "a number from 1 to 50" };
    expect(faultOfControl(fault, parameters as never)).toEqual({ kind: "setting", message: "Load on the hook: 500 t is not a number from 1 to 50 t." });
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

  it("goes on from before it diverged, and stops there again", async () => {
    session = new Session(clientOf(openings, 0.0155));
    await session.open(good, {});
    await session.step();
    await session.step();
    session.scrub(0);
    expect(session.status).toBe("stopped");
    session.start();
    await until(() => expect(session.status).toBe("running"));
    expect([session.fault, time(), session.shown.recording!.now.time_s]).toEqual([null, 0, 0]);
    await session.advance(0.1);
    expect(session.status).toBe("stopped");
    expect(session.fault).toMatchObject({ kind: "diverged" });
    expect(time()).toBeCloseTo(0.015, 9);
  });

  it("shows an earlier moment though an answer comes later, and pauses for it", async () => {
    session.start();
    for (let i = 0; i < 3; i++) await session.advance(0.1);
    const late = session.advance(0.1);
    session.scrub(0.123);
    await late;
    expect([session.status, time()]).toEqual(["paused", 0.12]);
    expect(session.shown.recording!.now.time_s).toBeCloseTo(0.4, 9);
  });

  it("says so where the way back fails, and neither starts nor tries for ever", async () => {
    const client = clientOf(openings);
    client.restore = () => Promise.reject({ kind: "input", message: "the snapshot is of another setup" });
    session = new Session(client);
    await session.open(good, {});
    await session.step();
    session.scrub(0);
    session.start();
    await turns();
    expect([session.status, session.isGoing, session.fault?.message]).toEqual(["paused", false, "the snapshot is of another setup"]);
    expect(session.shown.isBack).toBe(true);
  });

  it("goes on where a part of the page fails, tells the others and says so", async () => {
    const told: number[] = [];
    const log = vi.spyOn(console, "error").mockImplementation(() => undefined);
    const other = new Session(clientOf(openings));
    other.listen({ advanced: () => { throw new Error("no picture"); } });
    other.listen({ advanced: (run, frame) => told.push(run.columns.read(frame.row, "time")) });
    await other.open(good, {});
    await other.step();
    await other.step();
    expect(told).toEqual([0.01, 0.02]);
    expect(other.status).toBe("paused");
    expect(other.fault).toMatchObject({ kind: "page", message: "no picture.", note: "The run goes on." });
    log.mockRestore();
  });

  it("begins anew with the same values where the engine is lost under way, and says so", async () => {
    const client = clientOf(openings);
    session = new Session(client);
    await session.open(good, { load: true });
    session.start();
    await session.advance(0.1);
    client.advance = () => Promise.reject({ kind: "engine", message: "The engine gave no answer for 60 s." });
    await session.advance(0.1);
    await turns();
    expect(session.status).toBe("idle");
    expect(openings.at(-1)).toEqual({ load: true });
    expect(time()).toBe(0);
    expect(session.fault).toMatchObject({ kind: "restarted" });
    await session.step();
    expect(time()).toBeCloseTo(0.01, 9);
  });

  it("opens what was asked for at Reset where the engine did not load at first", async () => {
    const client = clientOf(openings);
    const { open } = client;
    session = new Session(client);
    client.open = () => Promise.reject({ kind: "engine", message: "The engine did not load." });
    expect(await session.open(good, { load: true })).toBe(false);
    expect(session.status).toBe("empty");
    await session.reset();
    expect(session.status).toBe("empty");
    client.open = open;
    await session.reset();
    expect(session.status).toBe("idle");
    expect(openings.at(-1)).toEqual({ load: true });
    expect(session.value("load")).toBe(true);
  });

  it("does not stop a new run for an answer that belonged to the one before", async () => {
    const client = clientOf(openings);
    session = new Session(client);
    await session.open(good, {});
    session.start();
    let reject = (_: Fault) => {};
    client.advance = () => new Promise((_, no) => (reject = no));
    const stale = session.advance(0.1);
    await session.open(good, { load: true });
    reject({ kind: "internal", message: "too late" });
    await stale;
    expect(session.status).toBe("idle");
    expect(session.fault).toBeNull();
  });

  it("runs on past the duration until it is paused", async () => {
    session.start();
    for (let i = 0; i < 40; i++) await session.advance(0.1);
    expect(session.run!.columns.read(session.shown.moment!.row, "time")).toBeCloseTo(4, 9);
    session.pause();
    await session.advance(0.1);
    expect(session.run!.columns.read(session.shown.moment!.row, "time")).toBeCloseTo(4, 9);
  });
});
