import { describe, expect, it } from "vitest";
import { faultOfSaving, savedFile } from "../src/app/saved";
import { yamlOf } from "../src/app/yaml";
import { Columns } from "../src/engine/columns";
import type { Values } from "../src/engine/engine";
import { resolved, Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { Runner } from "../src/engine/runner";
import { bits, filesOf, gallery, initEngine, read } from "./gallery";
import { cases, KINDS } from "./lane.mjs";
import { opened as sharedly } from "./opened";

await initEngine();

const simulationOf = async (text: string, file: string, overrides: Values = {}) =>
  new Simulation(text, file, JSON.stringify(overrides), await filesOf(text));

/** A scenario of the gallery, opened as the app opens it. */
async function opened(name: string, overrides: Values = {}) {
  const text = read(`scenarios/${name}.yaml`);
  const runner = new Runner((...of) => new Simulation(...of), () => 0);
  const { channels } = runner.open(text, `${name}.yaml`, overrides, JSON.parse(await filesOf(text)));
  const columns = new Columns(channels);
  const save = () => savedFile(`${name}.yaml`, { ...runner.replay(), files: [] });
  const step = (times: number) => Array.from({ length: times }, () => runner.step()).at(-1)!;
  return { runner, columns, save, step };
}

/** Runs a saved file to a time and returns its row by column. */
async function ran(text: string, time_s: number): Promise<Record<string, number>> {
  const simulation = await simulationOf(text, "saved.yaml");
  simulation.step(Math.round(time_s / simulation.step_s()));
  return new Columns(JSON.parse(simulation.channels_json())).byName(simulation.row());
}

function expectSameBits(again: Record<string, number>, first: Record<string, number>) {
  expect(Object.keys(again)).toEqual(expect.arrayContaining(Object.keys(first)));
  for (const [name, value] of Object.entries(first)) expect([name, ...bits([again[name]])]).toEqual([name, ...bits([value])]);
}

it.each(cases(gallery, (name) => KINDS.includes(name)))("a saved scenario resolves to the loaded one in any folder: %s", async (name) => {
  const json = (await sharedly(name)).simulation.resolved_json();
  const saved = yamlOf(json);
  expect(resolved(saved, "saved.yaml", "{}", await filesOf(saved))).toBe(json);
});

describe("a saved scenario", () => {
  it.each([
    ["lowering_by_winch", { waves: true, load_t: 13.7 }, ["hoist"]],
    ["lift_off_from_barge", { timeline: false, significant_height_m: 0.7 }, ["hoist"]],
    ["container_to_quay", { timeline: false }, []],
  ] as [string, Values, string[]][])("a saved scenario repeats a run steered by hand to the same bits: %s", async (name, overrides, levers) => {
    const { runner, columns, save, step } = await opened(name, overrides);
    let frame = runner.step();
    for (const [value, steps] of [[1.5, 7], [-3.1, 12], [-11.7, 1], [0.123456789, 20]]) {
      for (const lever of levers) runner.input(lever, value);
      frame = step(steps);
    }
    const file = await save();
    expect([file.name, file.differs]).toEqual([`${name}-saved.yaml`, null]);
    expect(file.text.includes("the 4 lever moves made by hand")).toBe(levers.length > 0);
    expectSameBits(await ran(file.text, frame.row[0]), columns.byName(frame.row));
  });

  it("a saved scenario keeps its own operation if no lever was moved", async () => {
    const { columns, save, step } = await opened("lift_off_from_barge");
    const { row } = step(10);
    const { text } = await save();
    expect(text).toContain("wait with a slack rope");
    expectSameBits(await ran(text, row[0]), columns.byName(row));
  });

  it("a saved scenario lists parameters that were set during the run, because a run of it differs", async () => {
    const { runner, columns, save, step } = await opened("offshore_vessel_on_dp");
    step(5);
    runner.parameter("wind_speed_m_s", 15);
    const { row } = step(20);
    const { text, differs } = await save();
    expect(differs).toContain("wind_speed_m_s at 1 s");
    expect(text).toContain(`# ${differs}`);
    expect(bits([(await ran(text, row[0]))["hull.position.x"]])).not.toEqual(bits([columns.byName(row)["hull.position.x"]]));
  });

  it("a saved scenario has the duration of the run", async () => {
    const { runner, save, step } = await opened("lowering_by_winch", { "simulation.duration_s": 0.5 });
    runner.input("hoist", -1);
    step(10);
    expect((await simulationOf((await save()).text, "")).resolved_json()).toContain('"duration_s": 1.0');
  });

  it("a saved scenario names the files that must be in its folder", async () => {
    const replay = { scenario: '{"version": 1}', time_s: 1.25, integrator: "newmark", moves: 1, parameters: [], lost: 0, files: ["hydro/mine.hydro.json"] };
    const { name, text } = await savedFile("ships/mine-saved.yaml", replay);
    expect(name).toBe("mine-saved.yaml");
    expect(text).toContain("# It needs these files in the same folder: hydro/mine.hydro.json.\n");
    expect(text).toContain("the lever move made by hand");
    expect(text).toContain("not to the last bit");
    expect(text.endsWith("\n\nversion: 1\n")).toBe(true);
  });

  it("a saved scenario tells of changes that were made before the engine was replaced", async () => {
    const replay = { scenario: '{"version": 1}', time_s: 1.25, integrator: "rk4", moves: 0, parameters: [], lost: 2, files: [] };
    const { text, differs } = await savedFile("mine.yaml", replay);
    expect(differs).toContain("2 changes were made before the engine was replaced");
    expect(text).toContain(`# ${differs}\n`);
  });

  it("a run with lever moves and an enabled operation is not saved, and the message gives the remedy", () => {
    const fault = { kind: "input", message: "operation: found one in the scenario, allowed: operation.enabled: false" };
    expect(faultOfSaving(fault)).toMatchObject({ kind: "two_operations", message: expect.stringContaining("move all levers by hand") });
    expect(faultOfSaving({ kind: "internal", message: "no scenario is open" })).toEqual({ kind: "unsaved", message: "no scenario is open" });
  });
});
