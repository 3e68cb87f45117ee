import { beforeEach, describe, expect, it, vi } from "vitest";
import { BackgroundEngine } from "../src/app/background_engine";
import { Session } from "../src/app/session";
import { faultOfControl } from "../src/app/faults";
import type { EngineClient } from "../src/engine/client";
import type { Fault, Value, Values } from "../src/engine/engine";
import type { LeverMove, Snapshot } from "../src/engine/messages";
import { Runner } from "../src/engine/runner";
import { FakeEngine } from "./fake";
import { turns, until } from "./until";

const engines: FakeEngine[] = [];

/** A client without a worker: the runner answers in a later turn of the event loop. */
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
    advance: (wall_s: number, speed: number, until_s?: number) => later(() => runner.advance(wall_s, speed, until_s)),
    step: () => later(() => runner.step()),
    input: (name: string, value: number) => later(() => runner.input(name, value)),
    snapshot: () => later(() => runner.snapshot()),
    resume: (keyframe: Snapshot) => later(() => runner.resume(keyframe)),
    restore: (snapshot: Uint8Array, moves: LeverMove[]) => later(() => runner.restore(snapshot, moves)),
    replay: () => later(() => ({ ...runner.replay(), files: [] })),
    parameter: (name: string, value: Value) => later(() => runner.parameter(name, value)),
  } as unknown as EngineClient;
}

const good = { text: "good", file: "good.yaml" };

describe("sessions", () => {
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

  it("a live value is set during a run without a reset; of many values at once, the last", async () => {
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

  it("a value that is not live restarts a run that goes and keeps it running; in a paused run it waits", async () => {
    session.start();
    await session.advance(0.1);
    for (const load of [false, true]) session.set("load", load);
    await until(() => expect([session.status, session.pending()]).toEqual(["running", []]));
    expect([time(), openings.at(-1), openings.length]).toEqual([0, { load: true }, 2]);
    session.set("load", true);
    await session.advance(0.1);
    session.pause();
    session.set("load", false);
    await turns();
    expect([session.status, session.pending(), time(), openings.length]).toEqual(["paused", ["load"], expect.closeTo(0.1, 9), 2]);
  });

  it("a run to a time that is asked for during a reset pauses there", async () => {
    void session.reset();
    session.runTo(0.05);
    await until(() => expect(session.status).toBe("running"));
    for (let i = 0; i < 4; i++) await session.advance(0.1);
    expect([session.status, time()]).toEqual(["paused", expect.closeTo(0.05, 9)]);
    session.start();
    await session.advance(0.1);
    await session.advance(0.1);
    expect(time()).toBeGreaterThan(0.1);
  });

  it("a session saves its run as a file, and reports live values that make a run of it differ", async () => {
    await session.step();
    expect(await session.save()).toMatchObject({ name: "good-saved.yaml", differs: null });
    session.set("wind", 9);
    await turns();
    expect((await session.save())!.differs).toContain("wind at 0.01 s");
    expect(session.fault).toBeNull();
  });

  it("a session reports why a run cannot be saved, and goes on", async () => {
    engines.at(-1)!.replay_json = () => {
      throw { kind: "input", message: "operation: found one in the scenario, allowed: operation.enabled: false" };
    };
    expect(await session.save()).toBeNull();
    expect(session.fault?.kind).toBe("two_operations");
    await session.step();
    expect(session.status).toBe("paused");
  });

  it("a value set at the start acts at once, with as few openings as possible", async () => {
    for (const load of [true, false, true]) session.set("load", load);
    await turns();
    expect(openings.at(-1)).toEqual({ load: true });
    expect(openings.length).toBeLessThanOrEqual(3);
    expect(session.pending()).toEqual([]);
  });

  it("Start right after a change starts the run with the new value", async () => {
    session.set("load", true);
    session.start();
    expect(session.isGoing).toBe(true);
    await turns();
    expect(session.status).toBe("running");
    expect(openings.at(-1)).toEqual({ load: true });
    await session.advance(0.1);
    expect(time()).toBeCloseTo(0.1, 9);
  });

  it("a pending start waits for the last of several changes, and Pause cancels it", async () => {
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

  it("Step right after a change steps with the new value", async () => {
    session.set("load", true);
    await session.step();
    await until(() => expect(time()).toBeCloseTo(0.01, 9));
    expect(session.status).toBe("paused");
    expect(openings.at(-1)).toEqual({ load: true });
  });

  it("Start after a refused value starts nothing", async () => {
    session.set("load", "no");
    session.start();
    await turns();
    expect(session.status).toBe("idle");
    expect(session.isGoing).toBe(false);
  });

  it.each(["pause", "reset"] as const)("a long Step ends at once on %s, and the next Step continues from there", async (stop) => {
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

  it("a second engine computes hydrostatics from the state of the first", async () => {
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
      ["open", "good", "good.yaml", {}, null, [], undefined],
      ["restore", Uint8Array.of(10)],
      ["restore", Uint8Array.of(20)],
    ]);
  });

  it("a value set during a run waits for the reset", async () => {
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

  it("a session reports why a scenario cannot be read, and keeps the present one", async () => {
    expect(await session.open({ text: "bad", file: "bad.yaml" }, {})).toBe(false);
    expect(faults.at(-1)).toMatchObject({ kind: "scenario", file: "bad.yaml", line: 1 });
    await session.step();
    expect(session.run!.columns.read(session.shown.moment!.row, "time")).toBeCloseTo(0.01, 12);
    await session.reset();
    expect(session.status).toBe("idle");
  });

  it("a control returns to its previous value when the engine refuses the new one", async () => {
    session.set("load", true);
    await turns();
    session.set("load", "no");
    await turns();
    expect(session.value("load")).toBe(true);
    expect(session.fault?.kind).toBe("scenario");
  });

  it("the message on a refused value has the words of its control", () => {
    const parameters = [{ name: "load_t", label: "Load on the hook", unit: "t", kind: "number", value: 20, range: [1, 50], choices: null, live: false }] as const;
    const fault = { kind: "scenario", message: "--set load_t: found 500, allowed: a number from 1 to 50", file: "--set load_t", field: "load_t", found: "500", allowed: "a number from 1 to 50" };
    expect(faultOfControl(fault, parameters as never)).toEqual({ kind: "setting", message: "Load on the hook: 500 t is not a number from 1 to 50 t." });
    const step = { ...fault, file: "--set simulation.step_s", found: "-1", allowed: "a number greater than 0" };
    expect(faultOfControl(step, []).message).toBe("Step size: -1 is not a number greater than 0.");
    const ofFile = { ...fault, file: "ship.yaml" };
    expect(faultOfControl(ofFile, [])).toBe(ofFile);
  });

  it("a session stops when the run diverges, and can start after a reset", async () => {
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

  it("a diverged run continues from an earlier moment, and stops again", async () => {
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

  it("choosing an earlier moment pauses the run, also if an answer comes later", async () => {
    session.start();
    for (let i = 0; i < 3; i++) await session.advance(0.1);
    const late = session.advance(0.1);
    session.scrub(0.123);
    await late;
    expect([session.status, time()]).toEqual(["paused", 0.12]);
    expect(session.shown.recording!.now.time_s).toBeCloseTo(0.4, 9);
  });

  it("a failed return to an earlier moment is reported, and the run does not start", async () => {
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

  it("a session goes on when one listener throws, and reports it", async () => {
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

  it("keeps a start before the first scenario is open, and while another scenario is loading", async () => {
    session = new Session(clientOf(openings));
    session.start();
    await session.open(good, {});
    expect(session.status).toBe("running");
    const loaded = turns().then(() => good);
    const opened = session.open(loaded, { load: true });
    expect(session.status).toBe("paused");
    session.start();
    expect(session.isGoing).toBe(true);
    expect(session.status).toBe("paused");
    await opened;
    await turns();
    expect(session.status).toBe("running");
    expect(openings.at(-1)).toEqual({ load: true });
  });

  it("drops a start of a scenario that does not load, and keeps the present run paused", async () => {
    const opened = session.open(Promise.reject({ kind: "network", message: "no file" }), {});
    session.start();
    expect(await opened).toBe(false);
    expect(session.fault).toMatchObject({ kind: "network" });
    expect([session.status, session.isGoing]).toEqual(["idle", false]);
  });

  it("continues a run whose engine is lost from its last keyframe, and reports it", async () => {
    const client = clientOf(openings);
    session = new Session(client);
    await session.open(good, { load: true });
    session.start();
    await session.advance(0.234);
    const { recording, moment } = session.shown;
    const rows = recording!.rows.items.length;
    const { advance } = client;
    client.advance = () => {
      client.advance = advance;
      return Promise.reject({ kind: "engine", message: "The engine was ended." });
    };
    await session.advance(0.1);
    await until(() => expect(session.fault).toMatchObject({ kind: "restarted" }));
    expect(session.fault!.message).toContain("0.23 s");
    expect(openings.at(-1)).toEqual({ load: true });
    expect(session.shown.recording).toBe(recording);
    expect(recording!.rows.items.length).toBe(rows);
    expect(session.shown.moment).toEqual(moment);
    await until(() => expect(session.status).toBe("running"));
    await session.advance(0.1);
    expect(time()).toBeCloseTo(0.334, 9);
  });

  it("starts a run again whose engine is lost twice at one moment", async () => {
    const client = clientOf(openings);
    session = new Session(client);
    await session.open(good, { load: true });
    session.start();
    await session.advance(0.1);
    const { advance } = client;
    client.advance = (...of) => (of[2] === 0.1 ? advance(...of) : Promise.reject({ kind: "engine", message: "The engine was ended." }));
    await session.advance(0.1);
    await until(() => expect(session.status).toBe("running"));
    await session.advance(0.1);
    await until(() => expect(session.status).toBe("idle"));
    expect(openings.at(-1)).toEqual({ load: true });
    expect(time()).toBe(0);
    await turns();
    expect(session.fault!.message).toContain("starts again");
    await session.step();
    expect(time()).toBeCloseTo(0.01, 9);
  });

  it("Reset opens the requested scenario if the engine did not load at first", async () => {
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

  it("a late answer to the previous run does not stop the new run", async () => {
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

  it("a run goes on after its duration until it is paused", async () => {
    session.start();
    for (let i = 0; i < 40; i++) await session.advance(0.1);
    expect(session.run!.columns.read(session.shown.moment!.row, "time")).toBeCloseTo(4, 9);
    session.pause();
    await session.advance(0.1);
    expect(session.run!.columns.read(session.shown.moment!.row, "time")).toBeCloseTo(4, 9);
  });
});
