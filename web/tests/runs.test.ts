import { BoxGeometry, Group, Mesh, MeshBasicMaterial } from "three";
import { beforeEach, describe, expect, it } from "vitest";
import { Recording } from "../src/app/recording/recording";
import { Session } from "../src/app/session";
import type { Run } from "../src/app/session";
import { Columns } from "../src/engine/columns";
import type { EngineClient } from "../src/engine/client";
import type { Channel, Value, Values } from "../src/engine/engine";
import { readModel } from "../src/engine/engine";
import type { Frame, LeverMove, Snapshot } from "../src/engine/messages";
import { Runner } from "../src/engine/runner";
import { rowsAsCsv, rowsOfRunsAsCsv } from "../src/export/csv";
import { DrawnLine } from "../src/plots/drawn";
import { Figures } from "../src/plots/figures";
import { read, Stretch } from "../src/plots/stretch";
import { fileOf, fileOfAll, recordedOf } from "../src/runs/files";
import type { KeptRun } from "../src/runs/kept";
import { bytesOf, KEPT_BYTES } from "../src/runs/memory";
import { OtherLines } from "../src/runs/other_lines";
import { MOST_SHOWN, Runs } from "../src/runs/runs";
import { Ghost } from "../src/view/overlays/ghost";
import { bits } from "./gallery";
import { channelOf, CHANNELS, FakeEngine } from "./fake";
import { until } from "./until";

/** A client without a worker, for the box that turns. */
function clientOf(): EngineClient {
  const runner = new Runner((_text, _file, json) => new FakeEngine(JSON.parse(json) as Values), () => 0);
  const later = <T>(work: () => T) => Promise.resolve().then(work);
  return {
    open: (text: string, file: string, values: Values) => later(() => runner.open(text, file, values)),
    step: () => later(() => runner.step()),
    snapshot: () => later(() => runner.snapshot()),
    restore: (snapshot: Uint8Array, moves: LeverMove[]) => later(() => runner.restore(snapshot, moves)),
    resume: (keyframe: Snapshot) => later(() => runner.resume(keyframe)),
    parameter: (name: string, value: Value) => later(() => runner.parameter(name, value)),
  } as unknown as EngineClient;
}

/** Advances a session by a number of records, from the moment that is shown. */
async function step(session: Session, records: number): Promise<void> {
  const end_s = session.shown.time_s + 0.01 * records;
  while (session.shown.recording!.now.time_s < end_s - 1e-9 || session.shown.isBack) {
    await session.step();
    await until(() => expect(session.isWaiting).toBeFalsy());
  }
}

const times = ({ rows }: KeptRun) => rows.map(({ time_s }) => Number(time_s.toFixed(2)));

describe("kept runs", () => {
  let session: Session;
  let runs: Runs;

  beforeEach(async () => {
    session = new Session(clientOf());
    runs = new Runs(session);
    await session.open({ text: "good", file: "good.yaml" }, {});
  });

  it("a kept run has the title of its scenario as its name, and outlives a reset and another scenario", async () => {
    await step(session, 5);
    const run = runs.keep()!;
    expect([run.mark, run.name]).toEqual(["A", "A box"]);
    await session.reset();
    expect(times(run)).toEqual([0, 0.01, 0.02, 0.03, 0.04, 0.05]);
    await session.open({ text: "good", file: "other.yaml" }, {});
    expect(runs.all).toEqual([run]);
    runs.remove(...runs.all);
    expect(runs.all).toEqual([]);
  });

  it("a run with changed values is named by them, also by a value that was set during the run", async () => {
    session.set("load", true);
    await until(() => expect(session.pending()).toEqual([]));
    await step(session, 3);
    expect(runs.keep()!.name).toBe("Load off → on");
    session.set("wind", 12);
    await until(() => expect(session.pending()).toEqual([]));
    await step(session, 1);
    expect(runs.keep()!.name).toBe("Load off → on, Wind 8 → 12 m/s");
  });

  it("a run that is kept twice without a new record is kept once, and equal names get a number", async () => {
    await step(session, 2);
    expect(runs.keep()).toBe(runs.keep());
    await step(session, 1);
    expect(runs.keep()!.name).toBe("A box (2)");
    expect(runs.all.map(({ mark }) => mark)).toEqual(["A", "B"]);
  });

  it("a run that is left at an earlier moment is kept whole and shares the records before it", async () => {
    await step(session, 8);
    const before = [...session.shown.recording!.rows.items];
    session.scrub(0.04);
    await step(session, 2);
    const [left] = runs.all;
    expect(left.name).toBe("Left at 0.04 s: A box");
    expect(left.rows).toEqual(before);
    const present = session.shown.recording!.rows.items;
    expect(present.slice(0, 5).every((row, i) => row === left.rows[i])).toBe(true);
    expect(session.shown.recording!.now.time_s).toBeCloseTo(0.06, 9);
  });

  it("ten branches of one run are kept, and cost less than two copies", async () => {
    await step(session, 20);
    runs.keep();
    const one = bytesOf(runs.all);
    for (let i = 0; i < 10; i++) {
      session.scrub(0.19);
      await step(session, 2);
    }
    // The first branch leaves the run that is kept already.
    expect(runs.all.map(({ rows }) => rows.length)).toEqual(Array(10).fill(21).map((rows, i) => (i === 0 ? rows : 22)));
    expect(bytesOf(runs.all)).toBeLessThan(2 * one);
  });

  it("a run that a reset ends is kept only if the user has chosen so", async () => {
    await step(session, 3);
    await session.reset();
    expect(runs.all).toEqual([]);
    runs.keepsAtReset = true;
    await step(session, 4);
    await session.reset();
    await session.reset();
    expect(runs.all.map(times)).toEqual([[0, 0.01, 0.02, 0.03, 0.04]]);
  });

  it("a run that was steered by hand is kept when another value restarts it, and not at a plain reset", async () => {
    const restartWith = async (load: boolean) => {
      session.start();
      session.set("load", load);
      await until(() => expect([session.pending(), session.status]).toEqual([[], "running"]));
      session.pause();
    };
    await step(session, 3);
    await restartWith(true);
    expect(runs.all).toEqual([]);
    await step(session, 2);
    session.set("wind", 12);
    await until(() => expect(session.pending()).toEqual([]));
    await step(session, 2);
    await restartWith(false);
    expect(runs.all.length).toBe(1);
    await step(session, 2);
    session.set("wind", 9);
    await until(() => expect(session.pending()).toEqual([]));
    await session.reset();
    expect(runs.all.length).toBe(1);
  });

  it("runs in the plots have different colours, and no more are shown than there are colours", async () => {
    for (let i = 0; i < MOST_SHOWN + 2; i++) {
      await step(session, 1);
      runs.keep();
    }
    expect(new Set(runs.shown.map(({ colour }) => colour)).size).toBe(MOST_SHOWN);
    const hidden = runs.all[MOST_SHOWN];
    runs.show(hidden, true);
    expect(hidden.isShown).toBe(false);
    runs.show(runs.all[2], false);
    runs.show(hidden, true);
    expect(hidden.colour).toBe(runs.all[2].colour);
    runs.recolour(hidden);
    expect(new Set(runs.shown.map(({ colour }) => colour)).size).toBe(MOST_SHOWN);
  });

  it("the CSV file of a kept run is that of the run while it was present, to the same bits", async () => {
    await step(session, 6);
    const present = [...rowsAsCsv(session.run!.columns.names, session.shown.recording!.rows.items.map(({ row }) => row))].join("");
    const run = runs.keep()!;
    session.scrub(0.02);
    await step(session, 1);
    const file = await fileOf(run);
    expect(file.name).toBe("good-A.csv");
    expect(await file.content.text()).toBe(present);
    const all = await (await fileOfAll(session, runs.all)).content.text();
    expect(all.split("\n").map((line) => line.split(",")[0])).toEqual(["run", ...Array(4).fill("Present"), ...Array(7).fill("A: A box"), ""]);
  });
});

describe("the table of several runs", () => {
  it("the table of several runs has all their columns, and empty cells where a run has none", () => {
    const runs = [{ run: "Present", names: ["time", "a"], rows: [[0, 1]] }, { run: "A: x, y", names: ["time", "b"], rows: [[0, 2]] }];
    expect([...rowsOfRunsAsCsv(runs)].join("")).toBe('run,time,a,b\nPresent,0.0,1.0,\n"A: x, y",0.0,,2.0\n');
  });
});

const MINUTES = 30;
const EVERY_S = 0.1;
/** Number of columns of a ship in waves. */
const WIDE = 180;
const wide: Channel[] = [channelOf("time", [], [], ["s"], 0), channelOf("tension", ["rope"], [Array.from({ length: WIDE }, (_, i) => `r${i}`)], ["N"], 1)];

/** A session of half an hour, without an engine. */
function longSession(): { session: Session; recording: Recording; leaves(from_s: number): void } {
  const columns = new Columns(wide);
  const frameAt = (time_s: number): Frame => {
    const row = new Float64Array(columns.width).fill(Math.sin(time_s));
    row[0] = time_s;
    const [poses, line_points] = [new Float64Array(21), new Float64Array(30)];
    return { rows: row, row_poses: poses, row_line_points: line_points, row, poses, line_points, surface: null, warnings: [], events: [], keyframes: [], changes: [], isPart: false, fault: null };
  };
  const recording = new Recording(columns, EVERY_S, frameAt(0), {});
  for (let i = 1; i <= (60 * MINUTES) / EVERY_S; i++) recording.add(frameAt(EVERY_S * i), {});
  const model = { ...readModel(new FakeEngine().model_json()), record_every_s: EVERY_S };
  const run = { model, channels: wide, columns } as unknown as Run;
  const listeners: Parameters<Session["listen"]>[0][] = [];
  const session = { run, source: null, shown: { recording }, values: { begun: {} }, listen: (one: (typeof listeners)[number]) => listeners.push(one) };
  return { session: session as unknown as Session, recording, leaves: (from_s) => listeners.forEach((one) => one.leaves?.(run, recording, from_s)) };
}

describe("the memory of kept runs", () => {
  it("five runs of half an hour stay under the cap: each is thinned, and covers its whole time", { timeout: 60_000 }, () => {
    const { session } = longSession();
    const runs = new Runs(session);
    for (let i = 0; i < 5; i++) {
      Object.assign(session, longSession().session, { listen: session.listen });
      runs.keep();
      expect(bytesOf(runs.all)).toBeLessThanOrEqual(KEPT_BYTES);
    }
    expect(runs.all.length).toBe(5);
    // Without a cap they would need more than it.
    expect(runs.all.reduce((sum, run) => sum + recordedOf(run), 0) * 8 * (WIDE + 52)).toBeGreaterThan(1.5 * KEPT_BYTES);
    for (const run of runs.all) {
      expect([run.start_s, run.end_s]).toEqual([0, 60 * MINUTES]);
      const gaps = run.rows.slice(1).map(({ time_s }, i) => time_s - run.rows[i].time_s);
      expect(Math.max(...gaps)).toBeLessThan(8.1 * EVERY_S);
      expect(run.rows.every(({ time_s, row }) => row[1] === Math.sin(time_s))).toBe(true);
    }
  });

  it("ten branches of half an hour cost hardly more than one run, and share their rows also when they are thinned", { timeout: 60_000 }, () => {
    const { session, leaves } = longSession();
    const runs = new Runs(session, 20e6);
    runs.keep();
    const one = bytesOf(runs.all);
    const { recording } = session.shown;
    for (let i = 0; i < 10; i++) {
      recording!.rows.push({ ...recording!.rows.last!, time_s: 60 * MINUTES + EVERY_S * (i + 1) });
      leaves(60 * MINUTES - 60);
    }
    expect(runs.all.length).toBe(11);
    expect(bytesOf(runs.all)).toBeLessThanOrEqual(20e6);
    // Eleven copies of so many rows would need five times the limit.
    const [{ rows: [{ row }] }] = runs.all;
    expect(runs.all.reduce((sum, run) => sum + run.rows.length, 0) * 8 * row.length).toBeGreaterThan(4 * 20e6);
    for (const run of runs.all) expect([run.start_s, run.rows.length > 4000]).toEqual([0, true]);
    expect(one).toBeGreaterThan(10e6);
  });

  it("a run that does not fit is refused with a message, and the others stay", async () => {
    const session = new Session(clientOf());
    const runs = new Runs(session, 60_000);
    await session.open({ text: "good", file: "good.yaml" }, {});
    await step(session, 4);
    let kept = 0;
    while (runs.keep() && kept < 200) {
      kept = runs.all.length;
      await session.reset();
      await step(session, 4);
    }
    expect(kept).toBeGreaterThan(1);
    expect(runs.all.length).toBe(kept);
    expect(session.fault?.message).toContain("Remove some");
  });
});

describe("lines of kept runs beside those of a plot", () => {
  const columns = new Columns(CHANNELS);
  const model = readModel(new FakeEngine().model_json());
  const figures = new Figures(model, CHANNELS);
  const rowsOf = (step_s: number, of: (time_s: number) => number) => Array.from({ length: Math.round(1 / step_s) + 1 }, (_, i) => {
    const row = new Float64Array(columns.width);
    row[0] = i * step_s;
    row[columns.at("ship.yaw")] = row[columns.at("kinetic_energy")] = of(i * step_s);
    return { time_s: i * step_s, row, poses: new Float64Array(7), line_points: new Float64Array() };
  });
  const drawn = (id: string) => new DrawnLine(figures.line(id)!, id, "yaw", columns, "rad", []);

  async function keptWith(rows: ReturnType<typeof rowsOf>): Promise<KeptRun> {
    const session = new Session(clientOf());
    const runs = new Runs(session);
    await session.open({ text: "good", file: "good.yaml" }, {});
    const run = runs.keep()!;
    run.rows = rows;
    return run;
  }

  function differences(run: KeptRun, lines: DrawnLine[], present: ReturnType<typeof rowsOf>): { others: OtherLines; at(time_s: number): number } {
    const others = new OtherLines({ runs: [run], isDifference: true }, lines, "rad");
    const stretch = new Stretch();
    stretch.fill(present, [0, present.length], lines.map(({ places }) => places), (value, i) => lines[i].scaled(value));
    others.fill([0, 1], stretch);
    return { others, at: (time_s) => others.shownAt(others.all[0], time_s, lines[0].scaled(read(present.find((one) => one.time_s === time_s)!.row, lines[0].places))) };
  }

  it("differences at equal times are exact and are not interpolated", async () => {
    const [present, before] = [rowsOf(0.1, (t) => Math.exp(t)), rowsOf(0.1, (t) => Math.cos(t))];
    const { others, at } = differences(await keptWith(before), [drawn("kinetic_energy")], present);
    const line = drawn("kinetic_energy");
    const found = present.map(({ time_s }) => at(time_s));
    expect(bits(found)).toEqual(bits(present.map(({ time_s }) => line.scaled(Math.exp(time_s)) - line.scaled(Math.cos(time_s)))));
    expect(others.notes).toEqual([]);
  });

  it("differences between recorded times are interpolated, which a note says", async () => {
    const { others, at } = differences(await keptWith(rowsOf(0.2, (t) => 1000 * t)), [drawn("kinetic_energy")], rowsOf(0.1, (t) => 3000 * t));
    expect(at(0.2)).toBeCloseTo(0.4, 12);
    expect(at(rowsOf(0.1, () => 0)[3].time_s)).toBeCloseTo(0.6, 12);
    expect(others.notes).toEqual(["A: interpolated linearly where recorded times differ from those of the present run"]);
  });

  it("the difference of two headings on both sides of 180 degrees is the small angle between them", async () => {
    const { at } = differences(await keptWith(rowsOf(0.1, () => Math.PI - 0.01)), [drawn("ship.yaw")], rowsOf(0.1, () => 0.02 - Math.PI));
    expect(at(0.5)).toBeCloseTo(0.03, 12);
  });

  it("a run without the column of a line has no line beside it, and a run of another time has no difference", async () => {
    const run = await keptWith(rowsOf(0.1, () => 1));
    const lines = [drawn("kinetic_energy"), new DrawnLine({ ...figures.line("kinetic_energy")!, id: "crane.energy" }, "", "yaw", columns, "rad", [])];
    expect(new OtherLines({ runs: [run], isDifference: false }, lines, "rad").all.map(({ place }) => place)).toEqual([0]);
    expect(new OtherLines({ runs: [run], isDifference: true }, lines, "rad").valueAt({ run, place: 0, own: lines[0] }, 1.2)).toBeNaN();
  });

  it("a drawn line of more rows than are drawn keeps its largest and smallest value, also where only one row has them", async () => {
    const run = await keptWith(rowsOf(5e-5, (t) => (Math.abs(t - 0.33335) < 1e-6 ? 9000 : Math.abs(t - 0.71) < 1e-6 ? -7000 : 1000 * Math.sin(50 * t))));
    const others = new OtherLines({ runs: [run], isDifference: false }, [drawn("kinetic_energy")], "rad");
    others.fill([0, 1], new Stretch());
    expect(others.rangeOf([0])).toEqual([-7, 9]);
    expect(others.rangeOf([1])).toEqual([Infinity, -Infinity]);
  });

  it("the path of a kept run has its second line over its first one, and a run that lacks one of them has none", async () => {
    const run = await keptWith(rowsOf(0.25, (t) => 1000 * t));
    const of = (...ids: string[]) => new OtherLines({ runs: [run], isDifference: false }, ids.map(drawn), "rad").phases([0.25, 0.75]);
    expect(of("kinetic_energy", "ship.yaw").map(({ points }) => points)).toEqual([[[0.25, 250], [0.5, 500], [0.75, 750]]]);
    expect(of("kinetic_energy")).toEqual([]);
  });

  it("poses of a kept run are those of its records, interpolated between them, and none outside", async () => {
    const run = await keptWith(rowsOf(0.1, () => 1));
    run.rows = run.rows.map((row) => ({ ...row, poses: Float64Array.of(row.time_s, 0, 0, 1, 0, 0, 0) }));
    expect(run.posesAt(0.2, model)![0]).toBe(0.2);
    expect(run.posesAt(0.25, model)![0]).toBeCloseTo(0.25, 12);
    expect([run.posesAt(-0.1, model), run.posesAt(1.1, model)]).toEqual([null, null]);
  });

  it("bodies of a kept run stand for those with their name and shape, whatever their order, and for no others", async () => {
    const run = await keptWith(rowsOf(0.1, () => 1).map((row) => ({ ...row, poses: Float64Array.of(5, 0, 0, 1, 0, 0, 0) })));
    const [ship] = model.bodies;
    const others = { ...model, bodies: [{ ...ship, name: "crane" }, ship] };
    const poses = run.posesAt(0.3, others)!;
    expect([poses.length, poses[0], poses[7]]).toEqual([14, NaN, 5]);
    const longer = { ...model, bodies: [{ ...ship, shape: null }] };
    expect([run.hasBodyOf(others), run.hasBodyOf(longer)]).toEqual([true, false]);
  });
});

describe("the ghost of a kept run", () => {
  it("copies of bodies stand at the other poses; those that coincide with a body, or have no pose, are hidden", () => {
    const bodies = [0, 1, 2].map(() => new Group().add(new Mesh(new BoxGeometry(), new MeshBasicMaterial())));
    const pose = (x: number) => [x, 0, 0, 1, 0, 0, 0];
    const ghost = new Ghost();
    ghost.show(bodies, [...pose(0), ...pose(3), ...pose(NaN)]);
    ghost.compare(bodies, 1);
    expect(ghost.children.map(({ visible }) => visible)).toEqual([false, true, false]);
    expect(ghost.children[1].position.x).toBe(3);
    ghost.place([...pose(2), ...pose(0), ...pose(0)]);
    ghost.compare(bodies, 1);
    expect(ghost.children.map(({ visible }) => visible)).toEqual([true, false, false]);
  });
});
