import { describe, expect, it } from "vitest";
import { cornersOf, cross, dot, frame, unit } from "../src/view/fit";
import type { Vec3 } from "../src/view/fit";
import { boxOf, shapedHullOf } from "../src/view/solids";
import { craftOf } from "../src/view/craft/craft";
import { viewpointOf } from "../src/view/viewpoint";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { filesOf, gallery, read } from "./gallery";
import { opened } from "./opened";
import { PALETTE } from "./palette";

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

  it("a scenario of the gallery names a camera that its picture offers, and up to three plots of columns of one unit", async () => {
    const { run, start } = await opened(name);
    const { camera, plots } = run.model.view;
    const { load, cab, bridge } = craftOf(run, start, PALETTE);
    const offered = ["free", "top", ...(load === null ? [] : ["load"]), ...(cab ? ["cab"] : []), ...(bridge ? ["bridge"] : [])];
    const asked = viewpointOf(camera);
    expect(typeof asked === "string" ? offered : "a place").toContain(typeof asked === "string" ? asked : "place");
    expect(plots.length).toBeGreaterThan(0);
    expect(plots.length).toBeLessThanOrEqual(3);
    const units = new Map(run.channels.flatMap(({ columns, units }) => columns.map((column, i) => [column, units[i]] as const)));
    for (const plot of plots) {
      expect(plot.length).toBeGreaterThan(0);
      expect(new Set(plot.map((column) => units.get(column) ?? `no ${column}`)).size).toBe(1);
      expect(plot.filter((column) => !units.has(column))).toEqual([]);
    }
  });

  it("a scenario of the gallery opens with each choice of its parameters: its plots do not depend on them", async () => {
    const { run } = await opened(name);
    const text = read(`scenarios/${name}.yaml`);
    const files = await filesOf(text);
    for (const { name: parameter, kind, value, choices } of run.model.parameters) {
      const others = kind === "boolean" ? [!value] : (choices ?? []).filter((choice) => choice !== value);
      for (const other of others) expect(() => new Simulation(text, name, JSON.stringify({ [parameter]: other }), files).free(), `${parameter}: ${other}`).not.toThrow();
    }
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
