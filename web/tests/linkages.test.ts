import { Color, Group, Mesh, Vector3 } from "three";
import { expect, it } from "vitest";
import type { ModelInfo } from "../src/engine/engine";
import { Linkages } from "../src/view/linkages";
import type { Palette } from "../src/view/palette";

const BODY = { parent: "world", shape: null, colour: null, mass_kg: 1 };
const MODEL: ModelInfo = {
  title: "A boom on a post",
  description: "",
  duration_s: 1,
  step_s: 0.01,
  record_every_s: 0.1,
  integrator: "rk4",
  bodies: [
    { ...BODY, name: "post" },
    { ...BODY, name: "boom" },
  ],
  joints: [],
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
  cylinders: [
    {
      name: "luffing",
      first: { body: "post", position_m: [0, 0, 1] },
      second: { body: "boom", position_m: [1, 0, 0] },
      shortest_m: 2,
      longest_m: 3.5,
    },
  ],
  parameters: [],
};

const colours = new Color();
const PALETTE = { barrel: colours, rod: colours, pin: colours } as Palette;

/** Post and boom with their linkages, the boom turned a quarter about z at x, y, z. */
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

/** Both ends of each part of a line in the world. */
function spans(line: Group): [Vector3, Vector3][] {
  return line.children.map((part) => [part.localToWorld(new Vector3()), part.localToWorld(new Vector3(0, 1, 0))]);
}

it("spans barrel and rod between the pins, wherever the bodies are", () => {
  for (const y of [1.5, 2]) {
    const { world } = drawn(0, y, 1);
    const [tube, rod] = spans(world.children.at(-1) as Group);
    expect(tube[0].distanceTo(new Vector3(0, 0, 1))).toBeCloseTo(0, 12);
    expect(tube[1].distanceTo(new Vector3(0, 0.88 * 2, 1))).toBeCloseTo(0, 12);
    expect(rod[1].distanceTo(new Vector3(0, y + 1, 1))).toBeCloseTo(0, 12);
    expect(rod[0].y).toBeLessThan(tube[1].y);
  }
});

it("hangs pins on the bodies and on the world, and a rod between those of a distance", () => {
  const { world, post, boom } = drawn(0, 1, 3);
  expect(post.children.length).toBe(1);
  expect(boom.children.map((pin) => (pin as Mesh).position.toArray())).toEqual([[1, 0, 0], [1, 0, 0]]);
  const [rod] = spans(world.children.at(-2) as Group);
  expect(rod[0].distanceTo(new Vector3(0, 2, 3))).toBeCloseTo(0, 12);
  expect(rod[1].distanceTo(new Vector3(0, 0, 7))).toBeCloseTo(0, 12);
});
