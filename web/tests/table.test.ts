import { expect, it } from "vitest";
import { places, rowsOf } from "../src/plots/table";

it("a table has evenly spaced times, including the first and the last", () => {
  expect(places(0)).toEqual([]);
  expect(places(1)).toEqual([0]);
  expect(places(3)).toEqual([0, 1, 2]);
  expect(places(1001, 5)).toEqual([0, 250, 500, 750, 1000]);
});

it("a table has the smallest and the largest value of each line, and its values at these times", () => {
  const rows = rowsOf([0, 0.01, 0.02], [[0, -2, 1], [5, 5, 4]], (value) => value.toFixed(1));
  expect(rows).toEqual([
    ["Min", "-2.0", "4.0"],
    ["Max", "1.0", "5.0"],
    ["0 s", "0.0", "5.0"],
    ["0.01 s", "-2.0", "5.0"],
    ["0.02 s", "1.0", "4.0"],
  ]);
  expect(rowsOf([], [[]], String)).toEqual([]);
});
