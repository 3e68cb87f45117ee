import { expect, it } from "vitest";
import type { Channel, DrawnLine } from "../src/engine/engine";
import { Seabed } from "../src/view/seabed";
import { Tensions } from "../src/view/tension";
import { channelOf } from "./fake";

const LINES: DrawnLine[] = [
  { name: "rope", style: "line", radius_m: 0, points: 2, seabed: null },
  { name: "bow", style: "line", radius_m: 0, points: 5, seabed: { height_m: -60, gradient: [0, 0] } },
  { name: "stern", style: "line", radius_m: 0, points: 3, seabed: null },
];
const points = ["bow.point_1", "bow.point_2", "bow.point_3", "stern.point_1", "stern.point_2"];
const along = { lines: ["bow", "bow", "bow", "stern", "stern"], shares: [0, 0.5, 1, 0, 1], length: "line_length" };
const CHANNELS: Channel[] = [channelOf("line_tension", ["line"], [["rope", "bow", "stern"]], ["N"], 1), { ...channelOf("line_tension_along", ["line_point"], [points], ["N"], 4), along }];

/** Row with tensions at the points. */
const row = (...tensions: number[]) => Float64Array.of(0, 1, 1, 1, ...tensions);

it("colours are the tension over the largest of each line so far, linear between its points", () => {
  const tensions = new Tensions(LINES, CHANNELS);
  const [bow, stern] = tensions.read(row(400, 200, 0, 10, 30));
  expect([bow.at, stern.at]).toEqual([1, 2]);
  expect([...bow.shares]).toEqual([1, 0.75, 0.5, 0.25, 0]);
  expect([...stern.shares].map((share) => Number(share.toFixed(6)))).toEqual([0.333333, 0.666667, 1]);
  const later = tensions.read(row(800, 200, 0, 10, 20));
  expect([...later[0].shares]).toEqual([1, 0.625, 0.25, 0.125, 0]);
  const [back] = tensions.read(row(400, 200, 0, 10, 30));
  expect(back.shares[0]).toBe(0.5);
  expect(tensions.largest).toEqual([{ name: "bow", largest_N: 800 }, { name: "stern", largest_N: 30 }]);
});

it("a run without tensions along lines has no colours, and a slack line has the colour of no tension", () => {
  expect(new Tensions(LINES, CHANNELS.slice(0, 1)).read(row(1, 1, 1, 1, 1))).toEqual([]);
  const [bow] = new Tensions(LINES, CHANNELS).read(row(0, 0, 0, 0, 0));
  expect([...bow.shares]).toEqual([0, 0, 0, 0, 0]);
});

it("the seabed is below the lines that can lie on it, and reaches beyond them", () => {
  const seabed = new Seabed();
  const lines = LINES.slice(0, 2);
  const at = Float64Array.of(0, 0, 0, 0, 0, 9, ...[0, 100, 200, 300, 400].flatMap((x) => [x, 300 * (x / 400), -60]));
  seabed.place(lines, at);
  expect(seabed.visible).toBe(true);
  expect([seabed.position.x, seabed.position.y]).toEqual([200, 150]);
  expect(seabed.scale.x).toBeGreaterThan(250);
  expect(seabed.position.z).toBeLessThan(-60);
  expect(seabed.position.z).toBeGreaterThan(-62);
  seabed.place(lines.slice(0, 1), at);
  expect(seabed.visible).toBe(false);
});

it("in a sea of finite depth the seabed is around the model even without lines on it", () => {
  const seabed = new Seabed();
  seabed.place([], [], { x: 3, y: 4, depth_m: 40, radius_m: 240 });
  expect(seabed.visible).toBe(true);
  expect([seabed.position.x, seabed.position.y, seabed.scale.x]).toEqual([3, 4, 240]);
  expect(seabed.position.z).toBeCloseTo(-40, 0);
});
