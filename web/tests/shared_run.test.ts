import { describe, expect, it } from "vitest";
import type { Source } from "../src/app/run";
import { Session } from "../src/app/session";
import type { Value, Values } from "../src/engine/engine";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { Runner } from "../src/engine/runner";
import { hashOf, runIn } from "../src/share/link";
import { isSame, sharedRun } from "../src/share/making";
import type { SharedRun } from "../src/share/shared_run";
import { DirectEngine } from "./direct";
import { bits, filesOf, initEngine, read } from "./gallery";
import { until } from "./until";

await initEngine();

/** A session with the engine itself, without a worker. */
async function sessionOf(source: Source, values: Values = {}): Promise<Session> {
  const session = new Session(new DirectEngine().client);
  await session.open(source, values);
  expect(session.fault).toBeNull();
  return session;
}

const fromGallery = (gallery: string): Source => ({ text: read(`scenarios/${gallery}.yaml`), file: `${gallery}.yaml`, gallery });

/** Opens a link as the app does, but without the page. */
async function openedBy(hash: string): Promise<{ session: Session; link: SharedRun }> {
  const link = await runIn(hash);
  const source = "gallery" in link.scenario ? fromGallery(link.scenario.gallery) : link.scenario;
  return { session: await sessionOf({ ...source, changes: link.changes }, link.values), link };
}

/** Runs for a number of seconds, in frames of different lengths. */
async function run(session: Session, seconds: number): Promise<void> {
  session.start();
  const until_s = session.shown.recording!.now.time_s + seconds;
  await until(() => expect(session.status).toBe("running"));
  for (let i = 0; session.shown.recording!.now.time_s < until_s; i++) await session.advance([0.13, 0.017, 0.09][i % 3]);
  session.pause();
}

/** Runs as fast as possible to a time. */
async function runTo(session: Session, time_s: number): Promise<void> {
  session.runTo(time_s);
  while (session.status === "running") await session.advance(0.016);
}

const set = async (session: Session, name: string, value: Value) => {
  session.set(name, value);
  await until(() => expect(session.pending()).toEqual([]));
};

/** Returns the bits of rows and poses by their times. */
const recorded = (session: Session) => new Map(session.shown.recording!.rows.items.map(({ time_s, row, poses }) => [time_s, bits([...row, ...poses])]));

/** Returns those common times at which the bits differ. */
function differences(again: Session, first: Session): number[] {
  const [there, here] = [recorded(first), recorded(again)];
  const times = [...there.keys()].filter((time) => here.has(time));
  expect(times.length).toBeGreaterThan(20);
  return times.filter((time) => String(there.get(time)) !== String(here.get(time)));
}

const expectSame = (again: Session, first: Session) => expect(differences(again, first)).toEqual([]);

const hashOfRun = async (session: Session) => hashOf((await sharedRun(session))!);

describe("a run that is opened by its link", () => {
  it("a shared run has the same bits if the integrator was changed during the run", async () => {
    const first = await sessionOf(fromGallery("paper"), { motor_1: true, load: true });
    await run(first, 0.5);
    await set(first, "simulation.integrator", "semi_implicit_euler");
    expect(first.status).toBe("paused");
    const before_s = first.shown.recording!.now.time_s;
    await run(first, 0.5);
    const { session } = await openedBy(await hashOfRun(first));
    await runTo(session, first.shown.recording!.now.time_s);
    expectSame(session, first);
    // Without the change the second half differs.
    const without = await sessionOf(fromGallery("paper"), { motor_1: true, load: true });
    await runTo(without, first.shown.recording!.now.time_s);
    expect(differences(without, first).every((time_s) => time_s > before_s)).toBe(true);
    expect(differences(without, first).length).toBeGreaterThan(20);
  });

  it("a shared run has the same bits if levers were moved", async () => {
    const first = await sessionOf(fromGallery("lowering_by_winch"), { load_t: 13.7, waves: true });
    await first.setInput("hoist", 1);
    await run(first, 1.2);
    for (const value of [-3, -7.77, -66]) await first.setInput("hoist", value);
    await run(first, 2.3);
    await first.setInput("hoist", 50 / 3);
    await run(first, 1.7);
    const { session, link } = await openedBy(await hashOfRun(first));
    expect(link.changes.length).toBe(3);
    await run(session, 5.3);
    expectSame(session, first);
    expect(session.run!.inputs.find(({ name }) => name === "hoist")!.value).toBe(50 / 3);
    // Changes that are one step later give another run.
    const step_s = first.run!.model.step_s;
    const late = await sessionOf({ ...first.source!, changes: link.changes.map((change) => ({ ...change, time_s: change.time_s + step_s })) }, link.values);
    await run(late, 5.3);
    expect(differences(late, first).length).toBeGreaterThan(20);
  });

  it("a shared run has the same bits if live parameters were set and an operation is enabled", async () => {
    const first = await sessionOf(fromGallery("offshore_vessel_on_dp"), { wind_speed_m_s: 9 });
    await run(first, 1.3);
    await set(first, "wind_speed_m_s", 15);
    await set(first, "wind_speed_m_s", 16.5);
    await run(first, 2.1);
    await set(first, "wind_speed_m_s", 3);
    await run(first, 2.2);
    const { session, link } = await openedBy(await hashOfRun(first));
    expect(link.values).toEqual({ wind_speed_m_s: 9 });
    expect(link.changes.map(({ value }) => value)).toEqual([15, 16.5, 3]);
    await runTo(session, link.moment!.time_s);
    expectSame(session, first);
    expect([session.value("wind_speed_m_s"), session.pending()]).toEqual([3, []]);
    expect(await isSame(session, link)).toBe(true);
    // After a reset the run starts with the values of the link and gives the same results.
    await session.reset();
    expect([session.status, session.value("wind_speed_m_s"), session.values.begun]).toEqual(["idle", 9, { wind_speed_m_s: 9 }]);
    for (let i = 0; i < 30; i++) await session.step();
    expectSame(session, first);
  });

  it("a shared run has the same bits if the run had branched after parameter changes", async () => {
    const first = await sessionOf(fromGallery("offshore_vessel_moored"));
    const { name, value } = first.run!.model.parameters.find(({ live }) => live)!;
    await run(first, 2);
    await set(first, name, (value as number) * 0.5);
    await run(first, 2);
    await set(first, name, (value as number) * 0.25);
    await run(first, 1);
    first.scrub(3);
    await run(first, 1);
    await set(first, name, (value as number) * 0.75);
    await run(first, 1);
    const { session, link } = await openedBy(await hashOfRun(first));
    expect(link.changes.map((change) => change.value)).toEqual([(value as number) * 0.5, (value as number) * 0.75]);
    await runTo(session, link.moment!.time_s);
    expectSame(session, first);
    expect(await isSame(session, link)).toBe(true);
  });

  it("a link holds a user's own scenario as its text", async () => {
    const text = read("scenarios/lowering_by_winch.yaml").replace(/^title: .*/m, "title: My winch");
    const first = await sessionOf({ text, file: "mine.yaml", opened: {} });
    await first.setInput("hoist", -5);
    await run(first, 3);
    const { session, link } = await openedBy(await hashOfRun(first));
    expect(link.scenario).toEqual({ file: "mine.yaml", text, opened: {} });
    await run(session, 3);
    expectSame(session, first);
  });

  it("a shared run stops at the link's moment, also between two records, and compares its numbers", async () => {
    const first = await sessionOf(fromGallery("lowering_by_winch"));
    first.start();
    for (let i = 0; i < 20; i++) await first.advance(0.0317);
    const { now } = first.shown.recording!;
    const { session, link } = await openedBy(await hashOfRun(first));
    expect(first.status).toBe("paused");
    expect(link.moment!.time_s).toBe(now.time_s);
    expect(await isSame(session, link)).toBeNull();
    await runTo(session, link.moment!.time_s);
    expect(session.shown.recording!.now.time_s).toBe(now.time_s);
    expect(bits(session.shown.moment!.row)).toEqual(bits(now.row));
    expect(await isSame(session, link)).toBe(true);
    expect(await isSame(session, { ...link, moment: { ...link.moment!, digest: "00000000" } })).toBe(false);
  });

  it("a link from an earlier moment has only the changes up to that moment", async () => {
    const first = await sessionOf(fromGallery("lowering_by_winch"));
    await run(first, 2);
    await first.setInput("hoist", -20);
    await run(first, 2);
    await first.setInput("hoist", 30);
    await run(first, 2);
    first.scrub(3.5);
    const link = await runIn(await hashOfRun(first));
    expect(link.changes.map(({ value }) => value)).toEqual([-20]);
    expect(link.moment!.time_s).toBe(first.shown.time_s);
  });

  it("a shared run drops the link's later changes once the user sets something", async () => {
    const first = await sessionOf(fromGallery("lowering_by_winch"));
    await run(first, 1);
    await first.setInput("hoist", -20);
    await run(first, 1);
    await first.setInput("hoist", 30);
    await run(first, 1);
    const { session, link } = await openedBy(await hashOfRun(first));
    await run(session, 1.5);
    await session.setInput("hoist", 5);
    await runTo(session, link.moment!.time_s);
    expect((await session.changes()).map(({ value }) => value)).toEqual([-20, 5]);
    expect(await isSame(session, link)).toBeNull();
  });

  it("a shared run stops with a message if its scenario no longer has a changed input", async () => {
    const session = await sessionOf({ ...fromGallery("lowering_by_winch"), changes: [{ time_s: 0.5, input: "no_such_lever", value: 1 }] });
    session.start();
    for (let i = 0; i < 20; i++) await session.advance(0.1);
    expect([session.status, session.fault?.kind]).toEqual(["stopped", "followed"]);
    expect(session.fault?.message).toContain("no_such_lever");
    expect(session.shown.recording!.now.time_s).toBeCloseTo(0.5, 9);
  });

  it("the digest of a scenario depends on all its files", async () => {
    const source = fromGallery("barge");
    const files = JSON.parse(await filesOf(source.text)) as Record<string, string>;
    const digest = (changed: Record<string, string>) => new Runner((...of) => new Simulation(...of), () => 0).open(source.text, source.file, {}, changed).digest;
    const [name] = Object.keys(files);
    expect(digest({ ...files })).toBe(digest(Object.fromEntries(Object.entries(files).reverse())));
    expect(digest({ ...files, [name]: `${files[name]} ` })).not.toBe(digest(files));
  });
});
