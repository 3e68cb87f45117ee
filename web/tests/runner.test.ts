import { describe, expect, it } from "vitest";
import { Runner } from "../src/engine/runner";
import { FakeEngine } from "./fake";

function opened(engine = new FakeEngine(), now = () => 0) {
  const runner = new Runner(() => engine, now);
  return { runner, engine, opened: runner.open("text", "file.yaml", {}) };
}

const times = (rows: Float64Array, width = 13) =>
  Array.from({ length: rows.length / width }, (_, i) => Number(rows[i * width].toFixed(9)));

describe("the runner", () => {
  it("the runner records the first row when it opens a scenario", () => {
    const { opened: answer } = opened();
    expect(times(answer.frame.rows)).toEqual([0]);
    expect(answer.model.bodies[0].shape).toEqual({ kind: "box", length_m: 2, width_m: 1, height_m: 1 });
  });

  it("a step of the runner ends at the next recording time", () => {
    const { runner } = opened();
    for (let i = 1; i <= 50; i++) expect(times(runner.step().rows)).toEqual([Number((i * 0.01).toFixed(9))]);
  });

  it("the runner follows wall time times speed, and records only at recording times", () => {
    const { runner, engine } = opened();
    const rows = Array.from({ length: 60 }, () => times(runner.advance(1 / 60, 1)!.rows)).flat();
    expect(engine.time_s()).toBeCloseTo(1, 9);
    expect(rows).toEqual(Array.from({ length: 100 }, (_, i) => Number(((i + 1) * 0.01).toFixed(9))));
  });

  it("the runner carries fractions of a step to the next frame at a slow speed", () => {
    const { runner, engine } = opened();
    for (let i = 0; i < 60; i++) runner.advance(1 / 60, 0.1);
    expect(engine.time_s()).toBeCloseTo(0.1, 9);
  });

  it("the runner does not catch up after a long frame", () => {
    const { runner, engine } = opened();
    runner.advance(30, 1);
    expect(engine.time_s()).toBeCloseTo(0.25, 9);
  });

  it("the runner returns no frame if no step is due", () => {
    const { runner, engine } = opened(new FakeEngine({}, 0.05, 0.05));
    const before = engine.posed;
    expect(runner.advance(1 / 60, 1)).toBeNull();
    expect(engine.posed).toBe(before);
    expect(times([runner.advance(1 / 60, 1), runner.advance(1 / 60, 1)].at(-1)!.rows)).toEqual([0.05]);
  });

  it("a long Step is divided into parts within a frame's time budget, and ends at the same recording time", () => {
    const engine = new FakeEngine({}, 1e-6, 0.01);
    const { runner } = opened(engine, () => engine.taken.reduce((sum, n) => sum + n, 0));
    const parts: number[] = [];
    let frame = runner.step();
    for (; frame.isPart; frame = runner.step()) {
      expect(frame.rows.length).toBe(0);
      parts.push(engine.taken.splice(0).reduce((sum, n) => sum + n, 0));
    }
    expect(parts.length).toBeGreaterThan(100);
    expect(Math.max(...parts)).toBeLessThan(60);
    expect(times(frame.rows)).toEqual([0.01]);
  });

  it("the runner drops steps that exceed the time budget of a frame", () => {
    let now = 0;
    const { runner, engine } = opened(new FakeEngine(), () => (now += 10));
    runner.advance(0.2, 1);
    const reached = engine.time_s();
    expect(reached).toBeLessThan(0.2);
    runner.advance(0.001, 1);
    expect(engine.time_s()).toBeCloseTo(reached + 0.001, 9);
  });

  it("the runner records every step that is longer than the recording interval", () => {
    const { runner } = opened(new FakeEngine({}, 0.05));
    expect(times(runner.step().rows)).toEqual([0.05]);
  });

  it("the runner reports divergence, keeps the last valid row and stops", () => {
    const { runner, engine } = opened(new FakeEngine({}, 0.001, 0.01, 0.0355));
    const frame = runner.advance(0.1, 1)!;
    expect(frame.fault).toMatchObject({ kind: "diverged", body: "ship" });
    expect(times(frame.rows).slice(-2)).toEqual([0.03, 0.035]);
    const { length } = engine.taken;
    expect(runner.step().fault?.kind).toBe("diverged");
    expect(engine.taken.length).toBe(length);
  });

  it("a run that diverges after a recording time has that row once", () => {
    const { runner } = opened(new FakeEngine({}, 0.001, 0.01, 0.03));
    expect(times(runner.advance(0.1, 1)!.rows)).toEqual([0.01, 0.02, 0.03]);
  });

  it("a hull that cannot float gives a warning", () => {
    const { runner } = opened(new FakeEngine());
    expect(runner.hydrostatics()).toEqual({ hulls: [], warnings: ["the box cannot float"] });
  });

  it("the runner passes on the warnings of the engine", () => {
    const { runner } = opened(new FakeEngine());
    expect(runner.step().warnings).toEqual([]);
    for (let i = 0; i < 100; i++) runner.step();
    expect(runner.step().warnings).toEqual([{ time_s: 1, code: "taut", name: "painter", value: null, bound: null, unit: "", text: "it is taut" }]);
  });

  it("the runner keeps its engine when another scenario does not open", () => {
    const engine = new FakeEngine();
    const runner = new Runner((text) => {
      if (text === "bad") throw { kind: "scenario", message: "no" };
      return engine;
    }, () => 0);
    runner.open("good", "a.yaml", {});
    expect(() => runner.open("bad", "b.yaml", {})).toThrow();
    expect(times(runner.step().rows)).toEqual([0.01]);
  });
});
