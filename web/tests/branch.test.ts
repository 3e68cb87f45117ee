import { describe, expect, it } from "vitest";
import type { Session } from "../src/app/session";
import type { Values } from "../src/engine/engine";
import type { EngineClient } from "../src/engine/client";
import { DirectEngine, openedDirectly } from "./direct";
import { bits, initEngine } from "./gallery";
import { until } from "./until";

await initEngine();

async function opened(scenario: string, overrides: Values = {}): Promise<Session> {
  const session = await openedDirectly(scenario, overrides);
  expect(session.fault).toBeNull();
  return session;
}

/** Runs for a number of seconds. */
async function run(session: Session, seconds: number): Promise<void> {
  session.start();
  await until(() => expect(session.status).toBe("running"));
  for (let i = 0; i < Math.round(seconds / 0.13); i++) await session.advance(0.13);
  session.pause();
}

/** Returns the bits of rows and poses by their times. */
const recorded = (session: Session) => new Map(session.shown.recording!.rows.items.map(({ time_s, row, poses }) => [time_s, bits([...row, ...poses])]));

/** Returns those common times at which the bits differ. */
function differences(one: Map<number, string[]>, other: Map<number, string[]>): number[] {
  return [...one.keys()].filter((time) => other.has(time) && String(one.get(time)) !== String(other.get(time)));
}

/** Lets the next request for a state report that the engine has ended; another engine answers from then on. */
function loseEngine(session: Session): void {
  const client = (session as unknown as { client: EngineClient }).client;
  const { client: next } = new DirectEngine();
  Object.assign(client, next, {
    snapshot: () => {
      client.snapshot = next.snapshot;
      return Promise.reject({ kind: "engine", message: "The engine was ended." });
    },
  });
}

describe("a run that branches from an earlier moment", () => {
  it.each(["lowering_by_winch", "lift_off_from_barge", "paper"])("a branch without a change repeats the run to the same bits: %s", async (scenario) => {
    const session = await opened(scenario);
    const end_s = scenario === "paper" ? 2 : 8;
    await run(session, end_s);
    const before = recorded(session);
    session.scrub(0.6 * end_s);
    expect(session.shown.isBack).toBe(true);
    const { time_s } = session.shown;
    expect(bits(session.shown.moment!.row)).toEqual(before.get(time_s)!.slice(0, session.run!.columns.width));
    await run(session, end_s);
    const after = recorded(session);
    expect(session.shown.recording!.now.time_s).toBeGreaterThan(1.5 * end_s);
    expect([...before.keys()].filter((time) => !after.has(time))).toEqual([]);
    expect(differences(before, after)).toEqual([]);
  });

  it("a run that another engine continues has the same bits, lever moves and live values", async () => {
    const [lost, whole] = [await opened("lowering_by_winch"), await opened("lowering_by_winch")];
    const steer = async (session: Session) => {
      await run(session, 1.3);
      session.set("significant_height_m", 3);
      await until(() => expect(session.pending()).toEqual([]));
      await run(session, 1.3);
      await session.setInput("hoist", -66);
      await run(session, 0.26);
    };
    for (const session of [lost, whole]) await steer(session);
    const { digest } = lost.run!;
    loseEngine(lost);
    await lost.snapshot().catch(() => undefined);
    await until(() => expect(lost.fault).toMatchObject({ kind: "restarted" }));
    expect(lost.run!.digest).toBe(digest);
    expect(lost.run!.inputs).toEqual(whole.run!.inputs);
    for (const session of [lost, whole]) await run(session, 1.3);
    expect(differences(recorded(lost), recorded(whole))).toEqual([]);
    expect(lost.shown.recording!.now.time_s).toBeGreaterThan(4);
    expect(await lost.changes()).toEqual(await whole.changes());
    expect(lost.values.inForce).toEqual(whole.values.inForce);
  });

  it("the paper's motors, damping and gravity act at once, and a branch from before sets them back", async () => {
    const session = await opened("paper");
    await run(session, 0.5);
    const before = session.run;
    for (const [name, value] of Object.entries({ motor_1: false, motor_2: true, damping: true, gravity: true })) session.set(name, value);
    await until(() => expect(session.pending()).toEqual([]));
    await run(session, 0.5);
    expect([session.run, session.fault]).toEqual([before, null]);
    const { rows } = session.shown.recording!;
    const read = (time_s: number, column: string) => session.run!.columns.read(rows.around(time_s)[0].row, column);
    // Rounding of 70 kN m.
    expect(read(0.5, "luff.joint_force")).toBeCloseTo(0, 6);
    expect(read(1, "luff.joint_force")).toBeCloseTo(70000, 6);
    expect([0.5, 1].map((time_s) => read(time_s, "energy_dissipated") > 0)).toEqual([false, true]);
    session.scrub(0.3);
    await run(session, 0.26);
    expect(session.values.inForce).toMatchObject({ motor_1: true, motor_2: false, damping: false, gravity: false });
  });

  it("a branch keeps lever moves before its start and drops later ones, also in the saved file", async () => {
    const session = await opened("lowering_by_winch");
    await run(session, 3);
    await session.setInput("hoist", -66);
    await run(session, 3);
    await session.setInput("hoist", 50);
    await run(session, 3);
    const before = recorded(session);
    const texts = () => session.shown.recording!.marks.filter(({ name }) => name === "hoist").map(({ text }) => text);
    expect(texts()).toEqual(["set to -66 by hand", "set to 50 by hand"]);
    session.scrub(4.5);
    await run(session, 4);
    expect(texts()).toEqual(["set to -66 by hand"]);
    const after = recorded(session);
    const first = Math.min(...differences(before, after));
    expect(first).toBeGreaterThan(5.9);
    expect(first).toBeLessThan(6.3);
    expect((await session.save())!.text).not.toContain("to: 50");
  });

  it("a branch that starts at the time of a lever move includes that move", async () => {
    const session = await opened("lowering_by_winch");
    for (let i = 0; i < 20; i++) await session.step();
    await session.setInput("hoist", -66);
    for (let i = 0; i < 20; i++) await session.step();
    const before = recorded(session);
    session.scrub(2);
    expect(session.shown.time_s).toBe(2);
    for (let i = 0; i < 20; i++) {
      await session.step();
      // The first step branches before it advances.
      await until(() => expect(session.shown.recording!.now.time_s).toBeCloseTo(2.1 + 0.1 * i, 9));
    }
    expect(differences(before, recorded(session))).toEqual([]);
    expect(session.run!.inputs.find(({ name }) => name === "hoist")!.value).toBe(-66);
  });

  it("a branch after hundreds of lever moves repeats the run to the same bits", async () => {
    const session = await opened("quayside_lift");
    for (let i = 0; i < 300; i++) {
      await session.setInput("hoist", -Math.abs(Math.sin(0.1 * i)));
      await session.setInput("slewing_gear", 0.05 * Math.cos(0.07 * i));
      session.start();
      await session.advance(0.03);
      session.pause();
    }
    const before = recorded(session);
    const moves = session.shown.recording!.movesBetween(0, Infinity).length;
    session.scrub(4);
    await session.setInput("main_luffing", 0);
    expect(session.shown.recording!.now.time_s).toBe(4);
    expect(session.run!.inputs.find(({ name }) => name === "hoist")!.value).toBeCloseTo(-Math.abs(Math.sin(0.1 * 133)), 9);
    expect(differences(before, recorded(session))).toEqual([]);
    expect(session.shown.recording!.movesBetween(0, Infinity).length).toBeLessThan(0.6 * moves);
    session.scrub(2);
    await session.setInput("main_luffing", 0);
    expect(bits(session.shown.recording!.now.poses)).toEqual(before.get(2)!.slice(session.run!.columns.width));
  });

  it("a lever move at an earlier moment branches the run there and changes its future", async () => {
    const session = await opened("lowering_by_winch");
    await run(session, 5);
    const before = recorded(session);
    session.scrub(3);
    await session.setInput("hoist", -66);
    expect(session.shown.isBack).toBe(false);
    expect(session.status).toBe("paused");
    expect(session.shown.recording!.now.time_s).toBe(3);
    await run(session, 2);
    const found = differences(before, recorded(session));
    expect(Math.min(...found)).toBeGreaterThan(3);
    expect(Math.min(...found)).toBeLessThan(3.3);
  });

  it("a branch resets live parameters to their earlier values, in the engine and in the controls", async () => {
    const session = await opened("offshore_vessel_moored");
    const { name, value } = session.run!.model.parameters.find(({ live }) => live)!;
    await run(session, 3);
    session.set(name, (value as number) * 0.5);
    await until(() => expect(session.pending()).toEqual([]));
    await run(session, 3);
    const before = recorded(session);
    session.scrub(2);
    await run(session, 6);
    expect(session.value(name)).toBe(value);
    expect(session.pending()).toEqual([]);
    const found = differences(before, recorded(session));
    expect(Math.min(...found)).toBeGreaterThan(2.9);
    session.scrub(1);
    session.set(name, (value as number) * 0.5);
    await until(() => expect(session.shown.recording!.now.time_s).toBe(1));
    await until(() => expect(session.pending()).toEqual([]));
    expect(session.value(name)).toBe((value as number) * 0.5);
    await run(session, 2);
    // A value that is set at an earlier moment replaces a later value.
    session.scrub(0.5);
    session.set(name, (value as number) * 0.7);
    await until(() => expect(session.shown.recording!.now.time_s).toBe(0.5));
    await until(() => expect(session.pending()).toEqual([]));
    expect(session.value(name)).toBe((value as number) * 0.7);
    expect(session.fault).toBeNull();
  });

  it("the shown time is limited to the recording, and at its end it follows the newest moment", async () => {
    const session = await opened("paper");
    await run(session, 1);
    session.scrub(-5);
    expect(session.shown.time_s).toBe(0);
    session.scrub(99);
    expect(session.shown.isBack).toBe(false);
    session.scrub(0);
    await session.reset();
    expect([session.status, session.shown.isBack, session.shown.time_s]).toEqual(["idle", false, 0]);
  });
});
