import { expect, it } from "vitest";
import type { Values } from "../src/engine/engine";
import { Runner } from "../src/engine/runner";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { bits, filesOf, initEngine, read } from "./gallery";

interface Golden {
  name: string;
  overrides: Record<string, unknown>;
  steps: number;
  row: number[];
}

const SCENARIOS = ["paper", "barge", "lift_off_from_barge", "lowering_by_winch"];

const goldensOf = (scenario: string): Golden[] => JSON.parse(read(`crates/kingpost/tests/golden/${scenario}.json`));
const paper = read("scenarios/paper.yaml");
const paperGoldens = goldensOf("paper");
const cases = SCENARIOS.flatMap((scenario) => goldensOf(scenario).map((golden) => ({ scenario, ...golden })));
await initEngine();

it.each(cases)("WASM gives the same bits as the native engine: $scenario, $name", async ({ scenario, overrides, steps, row }) => {
  const text = read(`scenarios/${scenario}.yaml`);
  const simulation = new Simulation(text, scenario, JSON.stringify(overrides), await filesOf(text));
  simulation.step(steps);
  expect(bits(simulation.row())).toEqual(bits(row));
});

it("a run in frames of any length gives the same bits as a run in one call", () => {
  const golden = paperGoldens.find(({ name }) => name === "page")!;
  const runner = new Runner((text, file, overrides, files) => new Simulation(text, file, overrides, files), () => 0);
  const { settings, frame } = runner.open(paper, "paper.yaml", golden.overrides as Values);
  const end_s = golden.steps * settings.step_s;
  let row = frame.row;
  for (let i = 0; end_s - row[0] > 0.03; i++) row = runner.advance(0.001 * (1 + (i % 17)), 1)!.row;
  while (end_s - row[0] > 0.0005) row = runner.advance(0.001, 1)!.row;
  expect(bits(row)).toEqual(bits(golden.row));
});

it("an error of the scenario reader has its file and line", () => {
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
