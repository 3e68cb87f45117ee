import { describe, expect, it } from "vitest";
import { afloat } from "../src/app/afloat";
import { Columns } from "../src/engine/columns";
import type { ModelInfo } from "../src/engine/engine";
import { readModel } from "../src/engine/engine";
import { LINES, SurfaceGrid } from "../src/engine/surface";
import { channelOf, CHANNELS, FakeEngine } from "./fake";

/** The box of the fake engine as a hull of 20 m; the origin of its data is 1.5 m above its centre of mass. */
function model(wave_components: number): ModelInfo {
  return {
    ...readModel(new FakeEngine().model_json()),
    sea: { density_kg_m3: 1025, depth_m: null, current_m_s: [0, 0], wave_components, cut_spectra: [] },
    hulls: [{ name: "water", body: "ship", origin_m: [0, 0, 1.5], draught_m: 2, length_m: 20, beam_m: 10, is_linear: true, mesh: null }],
  };
}

const at = (x: number, y: number, z = 0) => [x, y, z, 1, 0, 0, 0];

describe("the sea around the ship", () => {
  it("the sea is computed on lines that stay fixed while the ship drifts", () => {
    const engine = new FakeEngine();
    engine.step(20);
    const grid = SurfaceGrid.around(model(3))!;
    const [one, drifted, away] = [at(0, 0), at(0.3, -0.2), at(100, 40)].map((poses) => grid.surface(engine, poses));
    expect([one.x_m, one.y_m]).toEqual([drifted.x_m, drifted.y_m]);
    const middle = (LINES - 1) / 2;
    const spacing = one.x_m[middle + 1] - one.x_m[middle];
    const lines = (away.x_m[0] - one.x_m[0]) / spacing;
    expect(lines).toBeCloseTo(Math.round(lines), 9);
    expect(Math.abs(away.x_m[middle] - 100)).toBeLessThanOrEqual(spacing / 2);
    // The fake engine's elevation is the time, everywhere.
    expect(one.elevation_m.length).toBe(LINES * LINES);
    expect(new Set(one.elevation_m)).toEqual(new Set([engine.time_s()]));
  });

  it("the grid's lines are a twentieth of the hull apart near it, and the grid reaches ten lengths", () => {
    const { x_m } = SurfaceGrid.around(model(3))!.surface(new FakeEngine(), at(0, 0));
    const apart = Array.from(x_m.slice(1), (x, i) => x - x_m[i]);
    apart.forEach((distance, i) => {
      expect(distance).toBeGreaterThan(0.999);
      if (Math.abs(x_m[i]) <= 20 && Math.abs(x_m[i + 1]) <= 20) expect(distance).toBeCloseTo(1, 9);
    });
    expect(x_m[LINES - 1]).toBeGreaterThan(200);
    expect(x_m[0]).toBeCloseTo(-x_m[LINES - 1], 9);
  });

  it("the sea is level without waves, and absent without a hull", () => {
    const engine = new FakeEngine();
    engine.step(20);
    expect(new Set(SurfaceGrid.around(model(0))!.surface(engine, at(0, 0)).elevation_m)).toEqual(new Set([0]));
    expect(SurfaceGrid.around({ ...model(3), hulls: [] })).toBeNull();
    expect(SurfaceGrid.around({ ...model(3), sea: null })).toBeNull();
  });

  it("the sea is drawn around a ship that is moved by the waves and has no hull data", () => {
    const { joints, bodies, ...rest } = { ...model(3), hulls: [] };
    const moved = joints.map((joint) => (joint.body === "ship" ? { ...joint, kind: "moved_by_waves" } : joint));
    const box = bodies.map((body) => (body.name === "ship" ? { ...body, shape: { kind: "box" as const, length_m: 40, width_m: 10, height_m: 4 } } : body));
    const grid = SurfaceGrid.around({ ...rest, joints: moved, bodies: box })!;
    expect(grid.surface(new FakeEngine(), at(0, 0)).x_m[LINES - 1]).toBeGreaterThan(400);
  });
});

describe("how a hull floats", () => {
  const wave = channelOf("wave_elevation", ["hull"], [["water"]], ["m"], 13);
  const columns = new Columns([...CHANNELS, wave]);
  const row = Float64Array.of(0, 0, 0, 0, 0.02, -0.01, 0, 0, 0, 0, 0, 0, 0, 0.7);

  it("a hull's heel is its roll and its trim is its pitch", () => {
    expect(afloat(model(0), columns, row, at(3, 4, -1.6))).toEqual({ heel_rad: 0.02, trim_rad: -0.01, draught_m: expect.closeTo(2.1, 12), wave_m: 0.7 });
    expect(afloat({ ...model(0), hulls: [] }, columns, row, at(0, 0))).toBeNull();
  });

  it("the draught of an inclined ship is measured along the vertical", () => {
    // A quarter turn about x carries z to -y; one about y carries x to -z.
    const half = Math.SQRT1_2;
    const one = { ...model(0), hulls: [{ ...model(0).hulls[0], origin_m: [5, 2, 1.5] as [number, number, number] }] };
    expect(afloat(one, columns, row, [0, 0, 0, half, half, 0, 0])!.draught_m).toBeCloseTo(-2, 12);
    expect(afloat(one, columns, row, [0, 0, 0, half, 0, half, 0])!.draught_m).toBeCloseTo(5, 12);
    // The depth of the keel, not the distance to it: T cos(heel) if the origin stays on the water.
    const level = { ...model(0), hulls: [{ ...model(0).hulls[0], origin_m: [0, 0, 0] as [number, number, number] }] };
    const heel = 0.1;
    expect(afloat(level, columns, row, [0, 0, 0, Math.cos(heel / 2), Math.sin(heel / 2), 0, 0])!.draught_m).toBeCloseTo(2 * Math.cos(heel), 12);
  });
});
