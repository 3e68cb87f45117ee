import { Color, Group, Matrix4, Mesh, Vector3 } from "three";
import type { InstancedMesh, InterleavedBufferAttribute } from "three";
import type { Line2 } from "three/addons/lines/Line2.js";
import { expect, it } from "vitest";
import type { BodyInfo, DrawnLine, ModelInfo } from "../src/engine/engine";
import { DrawnLines } from "../src/view/lines";
import { Linkages } from "../src/view/linkages";
import type { Palette } from "../src/view/palette";

const BODY = { parent: "world", floats: false, shape: null, colour: null, mass_kg: 1, inertia_kg_m2: [] } as unknown as BodyInfo;
const MODEL: ModelInfo = {
  title: "A boom on a post",
  description: "",
  duration_s: 1,
  step_s: 0.01,
  record_every_s: 0.1,
  integrator: "rk4",
  parts: [],
  bodies: [
    { ...BODY, name: "post" },
    { ...BODY, name: "boom" },
  ],
  joints: [],
  wind: null,
  tanks: [],
  elements: [],
  connections: [],
  steps: [],
  task: null,
  loops: [
    {
      name: "pin",
      first: { body: "boom", position_m: [1, 0, 0] },
      second: { body: "world", position_m: [0, 0, 7] },
      constraints: ["distance"],
    },
  ],
  sea: null,
  hulls: [],
  objects_in_water: [],
  limits: [],
  view: { camera: "", plots: [] },
  live_settings: [],
  gravity_m_s2: 0,
  parameters: [],
  warnings: [],
};

const colours = new Color();
const PALETTE = { barrel: colours, rod: colours, pin: colours, line: colours } as Palette;

/** Draws post and boom with their linkages; the boom is at x, y, z, rotated by 90 degrees about z. */
function drawn(x: number, y: number, z: number) {
  const [world, post, boom] = [new Group(), new Group(), new Group()];
  world.add(post, boom);
  const linkages = new Linkages(MODEL, [post, boom], [1, 0.5], world, PALETTE);
  boom.position.set(x, y, z);
  boom.quaternion.set(0, 0, Math.SQRT1_2, Math.SQRT1_2);
  linkages.place();
  world.updateMatrixWorld(true);
  return { world, post, boom };
}

/** Returns both ends of each part of a line in the world. */
function spans(line: Group): [Vector3, Vector3][] {
  return line.children.map((part) => [part.localToWorld(new Vector3()), part.localToWorld(new Vector3(0, 1, 0))]);
}

const TELESCOPE: DrawnLine[] = [
  { name: "luffing", style: "barrel", radius_m: 0.07, points: 2, seabed: null },
  { name: "luffing", style: "rod", radius_m: 0.04, points: 2, seabed: null },
  { name: "luffing", style: "pin", radius_m: 0.08, points: 1, seabed: null },
  { name: "bow", style: "line", radius_m: 0, points: 3, seabed: null },
];

it("tubes, pins and ropes are placed at the engine's points", () => {
  const world = new Group();
  const lines = new DrawnLines(TELESCOPE, world, PALETTE);
  for (const y of [3, 4]) {
    lines.place([0, 0, 1, 0, 1.75, 1, 0, 0.875, 1, 0, y, 1, 0, y, 1, 5, 5, 5, 6, 5, 4, 7, 5, 5]);
    world.updateMatrixWorld(true);
    const [tubes, pins, rope] = world.children as [InstancedMesh, InstancedMesh, Line2];
    const placed = (mesh: InstancedMesh, at: number, place: Vector3) => {
      const matrix = new Matrix4();
      mesh.getMatrixAt(at, matrix);
      return place.applyMatrix4(matrix);
    };
    const ends = (at: number) => [placed(tubes, at, new Vector3()), placed(tubes, at, new Vector3(0, 1, 0))];
    const [barrel, collar, rod] = [0, 1, 2].map(ends);
    expect(barrel[0].distanceTo(new Vector3(0, 0, 1))).toBeCloseTo(0, 12);
    expect(barrel[1].distanceTo(new Vector3(0, 1.75, 1))).toBeCloseTo(0, 12);
    expect(collar[1].distanceTo(barrel[1])).toBeCloseTo(0, 6);
    expect(rod[1].distanceTo(new Vector3(0, y, 1))).toBeCloseTo(0, 12);
    expect(placed(pins, 0, new Vector3()).toArray()).toEqual([0, y, 1]);
    const { data } = rope.geometry.getAttribute("instanceStart") as InterleavedBufferAttribute;
    expect(Array.from(data.array)).toEqual([5, 5, 5, 6, 5, 4, 6, 5, 4, 7, 5, 5]);
  }
});

it("pins are fixed to bodies or the world, and a rod joins the pins of a distance", () => {
  const { world, post, boom } = drawn(0, 1, 3);
  expect(post.children.length).toBe(0);
  expect(boom.children.map((pin) => (pin as Mesh).position.toArray())).toEqual([[1, 0, 0]]);
  const [rod] = spans(world.children.at(-1) as Group);
  expect(rod[0].distanceTo(new Vector3(0, 2, 3))).toBeCloseTo(0, 12);
  expect(rod[1].distanceTo(new Vector3(0, 0, 7))).toBeCloseTo(0, 12);
});
