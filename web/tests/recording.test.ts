import { describe, expect, it } from "vitest";
import { posesBetween } from "../src/app/recording/between";
import { Playback } from "../src/app/recording/playback";
import { DEPTH, Recording } from "../src/app/recording/recording";
import { Series } from "../src/app/recording/series";
import { Columns } from "../src/engine/columns";
import type { Engine } from "../src/engine/engine";
import type { Frame } from "../src/engine/messages";
import { Runner } from "../src/engine/runner";
import { LINES } from "../src/engine/surface";
import { bits } from "./gallery";
import { CHANNELS, FakeEngine } from "./fake";

const columns = new Columns(CHANNELS);
const WIDTH = columns.width;
/** Pose of a body that rotates at a constant rate about an oblique axis and moves straight. */
const poseAt = (t: number) => {
  const half = 0.35 * t;
  const [c, s] = [Math.cos(half), Math.sin(half)];
  return Float64Array.of(3 + 2 * t, -t, 5 * t, c, 0.6 * s, 0, 0.8 * s);
};

function frameAt(t: number, isRecord: boolean, more: Partial<Frame> = {}): Frame {
  const row = new Float64Array(WIDTH).fill(Math.sin(t));
  row[0] = t;
  const line_points = Float64Array.of(0, 0, t);
  const passed = (one: Float64Array) => (isRecord ? one : new Float64Array());
  const empty = { surface: null, warnings: [], events: [], keyframes: [], changes: [], isPart: false, fault: null };
  return { rows: passed(row), row_poses: passed(poseAt(t)), row_line_points: passed(line_points), row, poses: poseAt(t), line_points, ...empty, ...more };
}

const keyframe = (time_s: number, isChange = false) => ({ time_s, bytes: new Uint8Array(4000), isChange });

describe("series of items over time", () => {
  it("a full series thins its older part evenly and keeps the start and the newest quarter", () => {
    const series = new Series<{ time_s: number }>(1000);
    for (let i = 0; i < 50000; i++) series.push({ time_s: i });
    const times = series.items.map(({ time_s }) => time_s);
    expect(times.length).toBeLessThanOrEqual(1000);
    expect(times.length).toBeGreaterThan(700);
    expect(times[0]).toBe(0);
    expect(times.slice(-150)).toEqual(Array.from({ length: 150 }, (_, k) => 50000 - 150 + k));
    // Fifty times as many items as the capacity: no gap is much wider than with even spacing.
    const gaps = times.slice(1).map((time, i) => time - times[i]);
    expect(Math.max(...gaps)).toBeLessThanOrEqual(4 * (50000 / 750));
    expect([...times].sort((a, b) => a - b)).toEqual(times);
  });

  it("a series drops protected items last, and then the oldest", () => {
    const series = new Series<{ time_s: number; stays: boolean }>(100, ({ stays }) => !stays);
    for (let i = 0; i < 300; i++) series.push({ time_s: i, stays: i % 5 === 0 });
    expect(series.items.filter(({ stays }) => stays).length).toBe(60);
    for (let i = 300; i < 1000; i++) series.push({ time_s: i, stays: true });
    expect(series.items.length).toBe(100);
    expect(series.last?.time_s).toBe(999);
  });

  it("a series returns the items around a time, and drops the items after one", () => {
    const series = new Series<{ time_s: number }>(10);
    for (const time_s of [0, 1, 2, 4]) series.push({ time_s });
    const around = (time: number) => series.around(time).map(({ time_s }) => time_s);
    expect([around(-1), around(0), around(0.5), around(2), around(3.9), around(9)]).toEqual([[0, 1], [0, 1], [0, 1], [2, 4], [2, 4], [4, 4]]);
    series.dropAfter(2);
    expect(series.items.map(({ time_s }) => time_s)).toEqual([0, 1, 2]);
    series.dropAfter(-1);
    expect(series.items).toEqual([]);
  });
});

describe("interpolation of poses", () => {
  it("interpolated poses of a body with constant velocity and rotation are exact", () => {
    for (const [from, to] of [[0, 0.5], [1, 1.05], [2, 4]]) {
      for (const share of [0, 0.1, 0.5, 0.77, 1]) {
        const found = posesBetween(poseAt(from), poseAt(to), share);
        poseAt(from + share * (to - from)).forEach((one, k) => expect(found[k]).toBeCloseTo(one, 14));
      }
    }
  });

  it("interpolation takes the shorter rotation for a negative quaternion, and none between equal poses", () => {
    const negative = poseAt(0.5).map((one, k) => (k < 3 ? one : -one));
    posesBetween(poseAt(0), negative, 0.5).forEach((one, k) => expect(one).toBeCloseTo(poseAt(0.25)[k], 14));
    posesBetween(poseAt(1), poseAt(1), 0.3).forEach((one, k) => expect(one).toBeCloseTo(poseAt(1)[k], 14));
  });
});

describe("a recording", () => {
  const recording = (frame = frameAt(0, true, { keyframes: [keyframe(0)] })) => new Recording(columns, 0.1, frame, {});

  it("a recording has the engine's rows and poses at recorded times, and interpolated poses in between", () => {
    const run = recording();
    for (let i = 1; i <= 40; i++) run.add(frameAt(0.05 * i, i % 2 === 0), {});
    for (let i = 0; i < 40; i += 2) {
      const { row, poses } = run.at(0.05 * i);
      expect(bits(row)).toEqual(bits(frameAt(0.05 * i, true).row));
      expect(bits(poses)).toEqual(bits(poseAt(0.05 * i)));
    }
    const between = run.at(1.234);
    expect(between.time_s).toBe(1.234);
    expect(between.row[0]).toBeCloseTo(1.2, 12);
    between.poses.forEach((one, k) => expect(one).toBeCloseTo(poseAt(1.234)[k], 14));
    expect(between.line_points[2]).toBeCloseTo(1.234, 14);
    expect(run.at(99)).toBe(run.now);
    expect([run.nearest(1.234), run.nearest(-3), run.nearest(9)].map((time) => Number(time.toFixed(9)))).toEqual([1.2, 0, 2]);
    const at = run.nearest(1.2);
    expect([run.beside(at, 1), run.beside(at, -1), run.beside(0, -1), run.beside(2, 1)].map((time) => Number(time.toFixed(9)))).toEqual([1.3, 1.1, 0, 2]);
  });

  it("the newest moment of a recording can be between recording times", () => {
    const run = recording();
    run.add(frameAt(0.1, true), {});
    run.add(frameAt(0.13, false), {});
    run.add(frameAt(0.16, false), {});
    expect(run.now.row[0]).toBe(0.16);
    expect([run.beside(0.16, -1), run.beside(0.1, -1), run.beside(0.1, 1)]).toEqual([0.1, 0, 0.16]);
    run.at(0.15).poses.forEach((one, k) => expect(one).toBeCloseTo(poseAt(0.15)[k], 14));
    expect(run.at(0.15).row[0]).toBe(0.1);
  });

  it("the sea is interpolated between two surfaces, unless its grid has moved", () => {
    const surface = (t: number, x: number) => ({ x_m: Float64Array.of(x), y_m: Float64Array.of(0), elevation_m: Float64Array.of(t) });
    const run = recording(frameAt(0, true, { surface: surface(0, 0) }));
    run.add(frameAt(0.1, true, { surface: surface(0.1, 0) }), {});
    run.add(frameAt(0.2, true, { surface: surface(0.2, 5) }), {});
    run.add(frameAt(0.3, true, { surface: surface(0.3, 5) }), {});
    expect(run.at(0.05).surface!.elevation_m[0]).toBeCloseTo(0.05, 6);
    expect(run.at(0.15).surface!.elevation_m[0]).toBeCloseTo(0.1, 6);
    expect(run.at(0.25).surface!.elevation_m[0]).toBeCloseTo(0.25, 6);
  });

  it("a recording drops data after a moment, and keeps earlier warnings when the engine's list starts again", () => {
    const warn = (time_s: number) => ({ time_s, code: "slack", name: "rope", value: null, bound: null, unit: "", text: `slack at ${time_s}` });
    const run = recording();
    for (let i = 1; i <= 30; i++) run.add(frameAt(0.1 * i, true, { keyframes: [keyframe(0.1 * i)], warnings: [warn(0.5), warn(2)].filter(({ time_s }) => time_s <= 0.1 * i) }), {});
    run.dropAfter(frameAt(run.nearest(1), false));
    expect(run.now.time_s).toBeCloseTo(1, 12);
    expect(run.rows.last?.time_s).toBeCloseTo(1, 12);
    expect(run.keyframeAt(99)?.time_s).toBeCloseTo(1, 12);
    expect(run.marks).toEqual([warn(0.5)]);
    run.add(frameAt(1.1, true, { warnings: [] }), {});
    run.add(frameAt(1.2, true, { warnings: [warn(1.15)] }), {});
    expect(run.warnings).toEqual([warn(0.5), warn(1.15)]);
    expect(run.marks).toEqual([warn(0.5), warn(1.15)]);
  });

  it("a recording returns the last state before a moment; of two at one time, the one after the change", () => {
    const run = recording();
    run.add(frameAt(0.1, true, { keyframes: [keyframe(0.1), keyframe(0.1, true)] }), { wind: 3 });
    expect(run.keyframeAt(0.05)).toMatchObject({ time_s: 0, values: {} });
    expect(run.keyframeAt(0.1)).toMatchObject({ isChange: true, values: { wind: 3 } });
  });

  it("a recording of half an hour in waves stays within its memory limit and covers the whole run", () => {
    const grid = { x_m: new Float64Array(LINES), y_m: new Float64Array(LINES) };
    const at = (i: number) => {
      const surface = { ...grid, elevation_m: new Float32Array(LINES * LINES) };
      return frameAt(0.1 * i, true, { surface, keyframes: i % 10 === 0 ? [keyframe(0.1 * i)] : [] });
    };
    const run = recording(at(0));
    for (let i = 1; i <= 18000; i++) run.add(at(i), {});
    const { pictures, keyframes, rows } = run as unknown as Record<string, Series<{ time_s: number }>>;
    expect(pictures.items.length * 4 * LINES * LINES).toBeLessThan(DEPTH.pictures);
    expect(keyframes.items.length * 4000).toBeLessThan(DEPTH.keyframes);
    expect(rows.items.length * 8 * (WIDTH + 10)).toBeLessThan(DEPTH.rows);
    for (const series of [pictures, keyframes, rows]) {
      expect(series.items[0].time_s).toBe(0);
      const gaps = series.items.slice(1).map(({ time_s }, i) => time_s - series.items[i].time_s);
      expect(Math.max(...gaps)).toBeLessThan(4);
    }
    // No record keeps the buffer of its frame in memory.
    expect(rows.items.every((one) => (one as unknown as { row: Float64Array }).row.buffer.byteLength === 8 * WIDTH)).toBe(true);
  });
});

describe("the engine's frames", () => {
  it("frames have poses at every recording time, and states at intervals and after a change by hand", () => {
    const engine = new FakeEngine();
    const runner = new Runner(() => engine, () => 0);
    const { frame } = runner.open("text", "file.yaml", {});
    expect(frame.keyframes).toMatchObject([{ time_s: 0, isChange: false }]);
    const frames = Array.from({ length: 25 }, () => runner.advance(0.013, 1)!);
    const poses = frames.flatMap(({ row_poses }) => Array.from(row_poses));
    expect(poses.length).toBe(7 * 32);
    expect(poses[6]).toBeCloseTo(Math.sin(0.05 * 0.01), 12);
    expect(frames.flatMap(({ keyframes }) => keyframes.map(({ time_s }) => Number(time_s.toFixed(9))))).toEqual([0.1, 0.2, 0.3]);
    runner.parameter("wind", 9);
    runner.parameter("wind", 10);
    expect(runner.advance(0.005, 1)!.keyframes).toMatchObject([{ time_s: expect.closeTo(0.325, 9), isChange: true }]);
    expect(runner.advance(0.005, 1)!.keyframes).toEqual([]);
  });

  it("frames report no release of a lever that springs back, but a position that is set to zero", () => {
    const engine: Engine = new FakeEngine();
    const lever = { value: 0, lower: -1, upper: 1, signal: null };
    engine.inputs_json = () => JSON.stringify([{ ...lever, name: "slewing", unit: "rad/s" }, { ...lever, name: "boom", unit: "rad" }]);
    const moves = [["slewing", 0.5], ["slewing", 0], ["boom", 0]].map(([input, value], k) => ({ time_s: 2 * k, input, value }));
    engine.lever_moves_json = () => JSON.stringify(moves);
    const runner = new Runner(() => engine, () => 0);
    runner.open("text", "file.yaml", {});
    expect(runner.step().events.map(({ name, text }) => [name, text])).toEqual([["slewing", "set to 0.5 by hand"], ["boom", "set to 0 by hand"]]);
  });

  it("frames report events, and of a dragged lever only its last move", () => {
    const engine: Engine = new FakeEngine();
    engine.lever_moves_json = () => JSON.stringify([0.1, 0.2, 3].map((time_s) => ({ time_s, input: "hoist", value: -time_s })));
    const runner = new Runner(() => engine, () => 0);
    const moves = [-0.2, -3].map((value) => ({ time_s: -value, code: "input_set", name: "hoist", text: `set to ${value} by hand` }));
    runner.open("text", "file.yaml", {});
    expect(runner.step().events).toEqual(moves);
    const happened = Array.from({ length: 70 }, (_, k) => ({
      ...(k ? { element: "deck", code: "slides", what: "slides" } : { element: "rope", code: "goes_slack", what: "goes slack" }),
      time_s: k,
    }));
    const asked: number[] = [];
    engine.events_json = (first) => (asked.push(first), JSON.stringify(happened.slice(first, first + 60)));
    expect(runner.step().events.slice(0, 2)).toEqual([
      { time_s: 0, code: "goes_slack", name: "rope", text: "goes slack" },
      { time_s: 1, code: "slides", name: "deck", text: "slides" },
    ]);
    // A repeated event is listed 50 times; only new events are requested until the run goes back.
    expect(runner.step().events.length).toBe(51 + moves.length);
    runner.restore(runner.snapshot());
    expect(asked).toEqual([0, 60, 0]);
  });

  it("a run as fast as possible takes as many steps as the time budget allows", () => {
    const engine = new FakeEngine();
    let now = 0;
    const runner = new Runner(() => engine, () => (now += 1));
    runner.open("text", "file.yaml", {});
    const frame = runner.advance(0, Infinity)!;
    expect(engine.time_s()).toBeGreaterThan(0.1);
    expect(frame.row[0]).toBe(engine.time_s());
    expect(runner.advance(0.005, 1)!.row[0]).toBeCloseTo(frame.row[0] + 0.005, 9);
  });
});

describe("drawn time", () => {
  it("the drawn time advances evenly, one frame behind frames that come every 50 ms", () => {
    const playback = new Playback();
    playback.begin(0, 0);
    const drawn: number[] = [];
    for (let ms = 10; ms <= 500; ms += 10) {
      if (ms % 50 === 0) playback.hear(ms / 1000, ms / 1000);
      drawn.push(playback.at(ms / 1000));
    }
    drawn.slice(5).forEach((time, i) => expect(time).toBeCloseTo(0.01 * (i + 1), 9));
  });

  it("the drawn time never exceeds the engine's or decreases, also with uneven or missing frames", () => {
    const playback = new Playback();
    playback.begin(3, 10);
    let [time, newest] = [3, 3];
    for (let ms = 0; ms < 4000; ms += 7) {
      if (ms % (ms < 2000 ? 91 : 35) === 0 && ms < 3000) playback.hear((newest += 0.05), 10 + ms / 1000);
      const next = playback.at(10 + ms / 1000);
      expect(next).toBeGreaterThanOrEqual(time);
      expect(next).toBeLessThanOrEqual(newest);
      time = next;
    }
    expect(time).toBe(newest);
  });
});
