import { describe, expect, it } from "vitest";
import { cornersOf, cross, dot, frame, unit } from "../src/view/fit";
import type { Vec3 } from "../src/view/fit";
import { boxOf, shapedHullOf } from "../src/view/solids";
import { gallery } from "./gallery";
import { opened } from "./opened";

/** View from the starboard quarter and above, in a desktop window. */
const BACK = unit([-0.62, -1, 0.62]);
const UP: Vec3 = [0, 0, 1];
const LENS = { fov: (32 * Math.PI) / 180, aspect: 1.6 };

/** Positions of points in the picture of a fitted camera, from -1 to 1 across and upwards. */
function seen(points: readonly Vec3[]): [number, number][] {
  const { target, distance } = frame(points, BACK, UP, LENS);
  const right = unit(cross(UP, BACK));
  const top = cross(BACK, right);
  return points.map((point) => {
    const from: Vec3 = [point[0] - target[0], point[1] - target[1], point[2] - target[2]];
    const half = (distance - dot(from, BACK)) * Math.tan(LENS.fov / 2);
    return [dot(from, right) / (half * LENS.aspect), dot(from, top) / half];
  });
}

describe.each(gallery)("%s of the gallery", (name) => {
  it("a scenario of the gallery has a title and a description", async () => {
    const { model } = (await opened(name)).run;
    expect(model.title).not.toBe("");
    expect(model.description.length).toBeGreaterThan(80);
  });

  it("a scenario of the gallery runs with finite numbers, and a body moves", async () => {
    const { simulation, run, start, moment } = await opened(name);
    expect(simulation.time_s()).toBe(0);
    simulation.step(Math.ceil(0.2 / simulation.step_s() - 1e-9));
    const { time_s, row } = moment();
    expect(time_s).toBeGreaterThanOrEqual(0.2 - 1e-9);
    const wrong = Object.entries(run.columns.byName(row)).filter(([, value]) => !Number.isFinite(value));
    expect(wrong).toEqual([]);
    expect(run.columns.byName(row)).not.toEqual({ ...run.columns.byName(start.row), time: time_s });
  });

  it("a scenario of the gallery fills the picture of a fitted camera, with all bodies inside", async () => {
    const { run, start } = await opened(name);
    const places = seen(cornersOf(start.poses, run.model.bodies.map((body) => boxOf(body, shapedHullOf(run.model, body.name)))));
    const farthest = Math.max(...places.flat().map(Math.abs));
    expect(farthest).toBeCloseTo(1, 6);
    for (const k of [0, 1]) {
      const values = places.map((place) => place[k]);
      expect(Math.max(...values) - Math.min(...values)).toBeGreaterThan(0.1);
    }
  });
});
