import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, it } from "vitest";
import { Columns } from "../src/engine/columns";
import { readModel } from "../src/engine/engine";
import type { Channel } from "../src/engine/engine";
import { Figures } from "../src/plots/figures";
import { shownUnit } from "../src/plots/units";
import { FakeEngine } from "./fake";

/**
 * Table of the engine for an element that exists only in a test: crates/kingpost/tests/mechanics/new_element.rs checks
 * the file.
 */
const file = fileURLToPath(new URL("../../crates/kingpost/tests/golden/new_element.channels.json", import.meta.url));
const channels = JSON.parse(readFileSync(file, "utf8")) as Channel[];

it("columns of an element of a new kind are offered as plots in their units", () => {
  const figures = new Figures(readModel(new FakeEngine().model_json()), channels);
  const own = figures.lines.filter(({ thing }) => thing === "governor");
  expect(own.map(({ id, what, unit }) => [id, what, shownUnit(unit, "deg").unit])).toEqual([
    ["governor.governor_rate", "governor rate", "°/s"],
    ...["x", "y", "z"].map((axis) => [`governor.governor_moment.${axis}`, `governor moment ${axis}`, "kN m"]),
  ]);
  const together = figures.all.filter(({ title }) => title.startsWith("governor"));
  expect(together.map(({ title, labels }) => [title, labels])).toEqual([["governor: moment", ["x", "y", "z"]]]);
});

it("columns of an element of a new kind are read at the offsets of the table", () => {
  const columns = new Columns(channels);
  const row = Float64Array.from({ length: columns.width }, (_, at) => at + 0.5);
  for (const channel of channels) {
    channel.columns.forEach((name, k) => expect(columns.read(row, name)).toBe(channel.offset + k + 0.5));
  }
});
