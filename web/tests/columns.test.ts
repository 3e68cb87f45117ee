import { expect, it } from "vitest";
import { Columns } from "../src/engine/columns";
import { asFault } from "../src/engine/engine";
import { CHANNELS, FakeEngine } from "./fake";

it("columns have the names of the CSV files", () => {
  const { names } = new Columns(CHANNELS);
  expect(names.slice(0, 5)).toEqual([
    "time",
    "ship.angular_velocity.x",
    "ship.angular_velocity.y",
    "ship.angular_velocity.z",
    "ship.roll",
  ]);
  expect(names.slice(10)).toEqual(["slew.joint_reaction.force_x", "slew.joint_reaction.force_y", "slew.joint_reaction.force_z"]);
});

it("a value is read from a row by column name; NaN if there is no such column", () => {
  const columns = new Columns(CHANNELS);
  const row = new FakeEngine().row();
  expect(columns.read(row, "ship.angular_velocity.z")).toBe(0.1);
  expect(columns.read(row, "ship.heave")).toBeNaN();
  expect(columns.byName(row).kinetic_energy).toBe(50);
});

it("a fault keeps the fields of an engine's error and wraps any other exception", () => {
  const thrown = { kind: "scenario", message: "a.yaml:1:2: no", file: "a.yaml", line: 1, column: null };
  expect(asFault(thrown)).toEqual({ kind: "scenario", message: "a.yaml:1:2: no", file: "a.yaml", line: 1 });
  expect(asFault(new Error("boom"))).toEqual({ kind: "internal", message: "boom" });
  expect(asFault("boom")).toEqual({ kind: "internal", message: "boom" });
});
