import { Group, Mesh } from "three";
import { describe, expect, it } from "vitest";
import { inTheSea } from "../src/engine/surface";
import { rolesOf } from "../src/view/craft/roles";
import { backOf } from "../src/view/fit";
import { turnOf } from "../src/view/flow_arrows";
import { insidesOf } from "../src/view/insides";
import { reachesDown, sightOf } from "../src/view/sight";
import { boxOf, shapedHullOf } from "../src/view/solids";
import { levelIn, Tanks } from "../src/view/tanks";
import { opened } from "./opened";
import { PALETTE } from "./palette";

const boxesOf = ({ run }: Awaited<ReturnType<typeof opened>>) => run.model.bodies.map((body) => boxOf(body, shapedHullOf(run.model, body.name)));

describe("the line of sight under water", () => {
  it("the sea is clear above a load that is below its surface, and not above one in the air", async () => {
    const lowered = await opened("heave_compensation");
    const { model } = lowered.run;
    const load = model.bodies.findIndex(({ name }) => name === "lift");
    const poses = Float64Array.from(lowered.start.poses);
    const sight = sightOf(model, boxesOf(lowered), poses, load)!;
    expect(sight.top).toEqual([poses[7 * load], poses[7 * load + 1], 0]);
    expect(sight.bottom[2]).toBeCloseTo(poses[7 * load + 2], 9);
    expect(sight.radius_m).toBeGreaterThan(-0.1 * sight.bottom[2]);
    poses[7 * load + 2] = 5;
    expect(sightOf(model, boxesOf(lowered), poses, load)).toBeNull();
    expect(sightOf({ ...model, sea: null }, boxesOf(lowered), lowered.start.poses, load)).toBeNull();
  });

  it("lines that end far below the ship make the sea clear, hoisting ropes do not", () => {
    expect(reachesDown([0, 0, 5, 0, 0, -60], 80)).toBe(true);
    expect(reachesDown([0, 0, 25, 0, 0, -20], 80)).toBe(false);
  });

  it("water is drawn around a body that swims, and around the ship if there is one", async () => {
    expect(inTheSea((await opened("underwater_vehicle")).run.model)).toEqual([{ body: "vehicle", length_m: 12 }]);
    expect(inTheSea((await opened("subsea_lowering")).run.model).map(({ body }) => body)).toEqual(["hull"]);
    expect(inTheSea((await opened("chain")).run.model)).toEqual([]);
  });
});

describe("insides of hulls", () => {
  const insideOf = async (scenario: string) => {
    const found = await opened(scenario);
    const { model } = found.run;
    const { glass, weights, liquids } = insidesOf(model, rolesOf(model), boxesOf(found), found.start.poses);
    const names = (bodies: ReadonlySet<number>) => [...bodies].map((body) => model.bodies[body].name);
    return { glass: names(glass), weights: names(weights), liquids: names(liquids) };
  };

  it("a hull with tanks or with wheels inside is seen through; ballast inside is hidden", async () => {
    expect(await insideOf("roll_reduction_tank")).toEqual({ glass: ["hull"], weights: [], liquids: ["tank"] });
    expect((await insideOf("roll_reduction_gyros")).glass).toEqual(["hull"]);
    expect(await insideOf("supply_boat_lift")).toEqual({ glass: [], weights: ["ballast"], liquids: [] });
    expect((await insideOf("gyro_wave_energy")).glass).toEqual([]);
  });

  it("a hull stays opaque if the scenario's plots do not show the tank in it", async () => {
    expect(await insideOf("feeder_cycle")).toEqual({ glass: [], weights: [], liquids: ["tank"] });
  });
});

describe("liquids in tanks", () => {
  it("the levels follow the columns of the run, and stay between bottom and top", async () => {
    const { run, simulation, moment } = await opened("roll_reduction_tank");
    const [tank] = run.model.tanks;
    const [port, starboard, duct] = tank.rooms;
    expect(tank).toMatchObject({ name: "tank", body: "hull" });
    expect(port.level_m).toBeCloseTo(3.35, 9);
    expect(levelIn(duct, () => NaN)).toBeCloseTo(0.7, 9);
    simulation.step(600);
    const { row } = moment();
    const read = (column: string) => run.columns.read(row, column);
    const [left, right] = [port, starboard].map((room) => levelIn(room, read));
    expect(left + right).toBeCloseTo(2 * 3.35, 9);
    expect(Math.abs(left - right)).toBeGreaterThan(1e-6);
    expect(levelIn(port, () => 100)).toBeCloseTo(port.high_m[2] - port.low_m[2], 9);
    expect(levelIn(port, () => -100)).toBe(0);
  });

  it("a room of a tank is drawn in its place on the hull", async () => {
    const { run } = await opened("roll_reduction_flooded_tanks");
    const bodies = run.model.bodies.map(() => new Group());
    new Tanks(run.model, bodies, PALETTE).fill(() => 4);
    const boxes = bodies[0].children.filter((part): part is Mesh => part instanceof Mesh);
    expect(boxes.length).toBe(2);
    expect(boxes.map(({ position }) => position.y)).toEqual([7.5, -7.5]);
    expect(boxes[0].scale.z).toBe(4);
  });
});

it("an eye at a given place steps back in a picture that shows less than the place needs", () => {
  const least = { fov: 0.5, aspect: 1.6 };
  expect(backOf({ fov: 0.5, aspect: 2.5 }, least)).toBe(1);
  expect(backOf({ fov: 0.5, aspect: 0.8 }, least)).toBeCloseTo(2, 12);
  expect(backOf({ fov: 0.25, aspect: 2.5 }, least)).toBeCloseTo(Math.tan(0.25) / Math.tan(0.125), 12);
});

it("arrows of wind and current turn with the view: upwards is away from the eye", () => {
  expect(turnOf([1, 0], [1, 0])).toBeCloseTo(0, 9);
  expect(turnOf([0, 1], [1, 0])).toBeCloseTo(-90, 9);
  expect(turnOf([1, 0], [0, 1])).toBeCloseTo(90, 9);
  expect(Math.abs(turnOf([-1, 0], [1, 0]))).toBeCloseTo(180, 9);
});
