import { describe, expect, it } from "vitest";
import { Place } from "../src/view/craft/place";
import { floatingSignsOf } from "../src/view/overlays/floating_signs";
import { loadsAt } from "../src/view/overlays/forces";
import { jointAxesOf } from "../src/view/overlays/joint_axes";
import { ArrowScale, barOf, written } from "../src/view/overlays/scale";
import { gallery } from "./gallery";
import { opened } from "./opened";

describe("forces at their points of action", () => {
  it.each(gallery)("drawn forces are finite: %s", async (name) => {
    const { simulation, run, moment } = await opened(name);
    simulation.step(5);
    for (const { at, vector } of loadsAt(run, moment())) expect([...at, ...vector].every(Number.isFinite)).toBe(true);
  });

  it("a load at rest on its line has its weight and the pull of the line", async () => {
    const { run, moment } = await opened("paper_on_a_rope");
    const now = moment();
    const loads = loadsAt(run, now);
    const body = run.model.bodies.findIndex(({ name }) => name === "lift");
    const [weight] = loads.filter(({ at, vector }) => vector[2] < 0 && at.every((part, k) => Math.abs(part - now.poses[7 * body + k]) < 1e-9));
    expect(weight.vector[2]).toBeCloseTo(-1000 * run.model.gravity_m_s2, 6);
    const pulls = loads.filter((load) => load !== weight).filter(({ vector }) => Math.abs(Math.hypot(...vector) - run.columns.read(now.row, "hoist_rope.rope_tension")) < 1e-6);
    expect(pulls.length).toBe(2);
    expect(pulls[0].vector[2]).toBeLessThan(0);
    expect(pulls[1].vector[2]).toBeGreaterThan(0);
  });

  it("a positive force of a cylinder pushes its ends apart", async () => {
    const { simulation, run, moment } = await opened("knuckle_boom_crane");
    simulation.step(500);
    const now = moment();
    const force = run.columns.read(now.row, "main_luffing.cylinder_force");
    const pushes = loadsAt(run, now).filter(({ vector }) => Math.abs(Math.hypot(...vector) - Math.abs(force)) < 1e-6);
    expect(pushes.length).toBe(2);
    expect(force).toBeGreaterThan(0);
    expect(Math.sign(pushes[0].vector[2])).toBe(-1);
    expect(Math.sign(pushes[1].vector[2])).toBe(1);
  });

  it("the force below a column equals the weight on it", async () => {
    const { run, moment } = await opened("offshore_vessel");
    const found = loadsAt(run, moment()).filter(({ vector, unit }) => unit === "N" && vector[2] > 0);
    // Weight of pedestal, boom and load, at rest.
    expect(Math.max(...found.map(({ vector }) => vector[2])) / (85_000 * run.model.gravity_m_s2)).toBeCloseTo(1, 3);
  });
});

describe("joint axes", () => {
  it("drawn joint axes agree with the joints of the scenario", async () => {
    const { simulation, run } = await opened("dual_draglink_crane");
    const poses = simulation.poses();
    const axes = jointAxesOf(run.model, JSON.parse(simulation.equations_json()), poses);
    const names = run.model.bodies.map(({ name }) => name);
    const axis = (body: string) => axes.find((one) => one.body === names.indexOf(body))!;
    const world = ({ body, point }: (typeof axes)[number]) => new Place(poses, body).toWorld(point);
    expect(axis("column").direction.map(Math.abs)).toEqual([expect.closeTo(0, 9), expect.closeTo(0, 9), expect.closeTo(1, 9)]);
    // The boom's hinge is 0.8 m in front of the column's axis, on its top.
    const hinge = new Place(poses, names.indexOf("column")).toBody(world(axis("boom")));
    expect([hinge[0], hinge[2]]).toEqual([expect.closeTo(0.8, 6), expect.closeTo(2.5, 6)]);
    const pivot = new Place(poses, names.indexOf("column")).toBody(world(axis("drag_link_port")));
    expect([pivot[0], pivot[2]]).toEqual([expect.closeTo(-2, 6), expect.closeTo(5.5, 6)]);
  });
});

describe("heights above the keel", () => {
  it("the drawn metacentre is above the centre of mass by the GM of the hydrostatics", async () => {
    const { simulation, run } = await opened("offshore_vessel");
    const report = JSON.parse(simulation.hydrostatics_json());
    const [{ letters, buoyancy }] = floatingSignsOf(run.model, report, simulation.poses());
    const height = (text: string) => letters.find((one) => one.text === text)!.at[2];
    expect(height("M") - height("G")).toBeCloseTo(report.hulls[0].metacentric_height_m[0], 3);
    expect(height("K")).toBeLessThan(height("B"));
    expect(buoyancy.force_N).toBeCloseTo(5_519_000 * run.model.gravity_m_s2, -4);
  });
});

describe("scale of arrows", () => {
  it("the scale of arrows is constant until an arrow would be too long", () => {
    const scale = new ArrowScale();
    const load = (N: number) => [{ at: [0, 0, 0] as const, vector: [0, 0, N] as const, unit: "N" as const }];
    const first = scale.of(load(100), 10);
    expect(100 * first).toBeCloseTo(4, 12);
    expect(scale.of(load(20), 10)).toBe(first);
    expect(scale.of(load(140), 10)).toBe(first);
    expect(1000 * scale.of(load(1000), 10)).toBeCloseTo(4, 12);
  });

  it("the scale bar has a round value", () => {
    expect(barOf(0.001, 90)).toEqual({ value: 50_000, px: expect.closeTo(50, 9) });
    expect(barOf(0.0004, 90)).toEqual({ value: 200_000, px: expect.closeTo(80, 9) });
    expect(barOf(0, 90)).toBeNull();
    expect([written(200_000, "N"), written(5e6, "N m"), written(0.5, "N")]).toEqual(["200 kN", "5 MN m", "0.5 N"]);
  });
});
