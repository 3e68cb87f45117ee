import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, it } from "vitest";
import type { Value } from "../src/engine/engine";
import { gathered } from "../src/engine/files";
import { Runner } from "../src/engine/runner";
import init, { file_names, Simulation } from "../src/engine/pkg/kingpost_wasm.js";

interface Golden {
  name: string;
  overrides: Record<string, Value>;
  steps: number;
  row: number[];
}

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const read = (path: string) => readFileSync(here(`../../${path}`), "utf8");
const goldensOf = (scenario: string): Golden[] => JSON.parse(read(`crates/kingpost/tests/golden/${scenario}.json`));
const paper = read("scenarios/paper.yaml");
const paperGoldens = goldensOf("paper");
const cases = ["paper", "barge"].flatMap((scenario) => goldensOf(scenario).map((golden) => ({ scenario, ...golden })));
await init({ module_or_path: readFileSync(here("../src/engine/pkg/kingpost_wasm_bg.wasm")) });

const bits = (row: ArrayLike<number>) => Array.from(new BigUint64Array(Float64Array.from(row).buffer), String);

it.each(cases)("gives the native run's bits in WASM: $scenario, $name", async ({ scenario, overrides, steps, row }) => {
  const text = read(`scenarios/${scenario}.yaml`);
  const files = await gathered(
    (texts) => JSON.parse(file_names(text, scenario, "{}", JSON.stringify(texts))),
    async (names) => Object.fromEntries(names.map((name) => [name, read(`scenarios/${name.replace("gallery:", "")}`)])),
  );
  const simulation = new Simulation(text, scenario, JSON.stringify(overrides), JSON.stringify(files));
  simulation.step(steps);
  expect(bits(simulation.row())).toEqual(bits(row));
});

it("gives the same bits in frames of any length as in one go", () => {
  const golden = paperGoldens.find(({ name }) => name === "page")!;
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
