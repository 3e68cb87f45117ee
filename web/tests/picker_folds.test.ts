import { expect, it } from "vitest";
import { foldPoints, hasWords, labelOf, linesOf } from "../src/plots/lines";
import type { Channel, ModelInfo } from "../src/engine/engine";
import { channelOf } from "./fake";

const NAMES = ["port_bow", "line_2"];
const POINTS = 21;
const along = {
  lines: NAMES.flatMap((name) => Array<string>(POINTS).fill(name)),
  shares: NAMES.flatMap(() => Array.from({ length: POINTS }, (_, i) => i / (POINTS - 1))),
  length: "line_length",
};
const labels = NAMES.flatMap((name) => Array.from({ length: POINTS }, (_, i) => `${name}.point_${i + 1}`));
const CHANNELS: Channel[] = [channelOf("line_tension", ["line"], [NAMES], ["N"]), { ...channelOf("line_tension_along", ["line_point"], [labels], ["N"]), along }, channelOf("line_length", ["line"], [NAMES], ["m"])];
const lines = linesOf({ hulls: [] } as unknown as ModelInfo, CHANNELS);

it("points along a line are lines of the element, with the column as their id", () => {
  const point = lines.find(({ id }) => id === "port_bow.point_8.line_tension_along")!;
  expect([point.thing, labelOf(point), point.columns]).toEqual(["port_bow", "port bow line tension along point 8", [point.id]]);
  expect(labelOf(lines.find(({ id }) => id === "line_2.point_21.line_tension_along")!)).toBe("line 2 tension along point 21");
  expect(new Set(lines.map(labelOf)).size).toBe(lines.length);
  expect(new Set(lines.map(({ thing }) => thing))).toEqual(new Set(NAMES));
});

it("the list has one entry for the points of each line, in the place of the first", () => {
  expect(lines.length).toBe(2 + 2 * POINTS + 2);
  const entries = foldPoints(lines).map((one) => ("lines" in one ? [one.name, one.lines.length] : one.id));
  expect(entries).toEqual(["port_bow.line_tension", "line_2.line_tension", ["line tension along", POINTS], ["tension along", POINTS], "port_bow.line_length", "line_2.line_length"]);
});

it("a search for a point finds it within its entry", () => {
  const found = foldPoints(lines.filter((line) => hasWords(line, "port_bow point_21")));
  expect(found).toEqual([{ name: "line tension along", lines: [lines.find(({ id }) => id === "port_bow.point_21.line_tension_along")] }]);
});
