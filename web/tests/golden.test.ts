import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, it } from "vitest";
import type { Value } from "../src/engine/engine";
import { Runner } from "../src/engine/runner";
import init, { Simulation } from "../src/engine/pkg/kingpost_wasm.js";

interface Golden {
  name: string;
  overrides: Record<string, Value>;
  steps: number;
  row: number[];
}

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const goldens: Golden[] = JSON.parse(readFileSync(here("../../crates/kingpost/tests/golden/paper.json"), "utf8"));
const paper = readFileSync(here("../../scenarios/paper.yaml"), "utf8");
await init({ module_or_path: readFileSync(here("../src/engine/pkg/kingpost_wasm_bg.wasm")) });

const bits = (row: ArrayLike<number>) => Array.from(new BigUint64Array(Float64Array.from(row).buffer), String);

it.each(goldens)("gives the native run's bits in WASM: $name", ({ overrides, steps, row }) => {
  const simulation = new Simulation(paper, "paper.yaml", JSON.stringify(overrides), "{}");
  simulation.step(steps);
  expect(bits(simulation.row())).toEqual(bits(row));
});

it("gives the same bits in frames of any length as in one go", () => {
  const golden = goldens.find(({ name }) => name === "page")!;
  const runner = new Runner((text, file, overrides, files) => new Simulation(text, file, overrides, files), () => 0);
  const { settings, frame } = runner.open(paper, "paper.yaml", golden.overrides);
  const end_s = golden.steps * settings.step_s;
  let row = frame.row;
  for (let i = 0; end_s - row[0] > 0.03; i++) row = runner.advance(0.001 * (1 + (i % 17)), 1).row;
  while (end_s - row[0] > 0.0005) row = runner.advance(0.001, 1).row;
  expect(bits(row)).toEqual(bits(golden.row));
});

it("throws the reader's errors with their place", () => {
  const bad = paper.replace("mass_kg: 10000", "mass_kg: -5");
  const line = bad.split("\n").findIndex((text) => text.includes("mass_kg: -5")) + 1;
  const runner = new Runner((text, file, overrides, files) => new Simulation(text, file, overrides, files), () => 0);
  let thrown: unknown;
  try {
    runner.open(bad, "bad.yaml", {});
  } catch (error) {
    thrown = error;
  }
  expect(thrown).toMatchObject({ kind: "scenario", file: "bad.yaml", line, field: "bodies.ship.mass_kg", found: "-5" });
});
