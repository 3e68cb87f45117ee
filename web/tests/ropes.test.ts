import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";
import { Columns } from "../src/engine/columns";
import init, { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { readRopes } from "../src/engine/ropes";
import { profileAt, shapeOf } from "../src/view/catenary";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
await init({ module_or_path: readFileSync(here("../src/engine/pkg/kingpost_wasm_bg.wasm")) });

/** A ship that hangs where it is put, with a load on a rope and lines of all kinds; its drawing frame is on its keel. */
const text = (z: number) => `version: 1
title: lines
simulation: {step_s: 0.01, duration_s: 1}
bodies:
  ship:
    mass_t: 1000
    centre_of_mass_m: [1, 0, 3]
    inertia: {radii_of_gyration: {radii_m: [5, 15, 15]}}
    joint: {floating: {initial: {position_m: [0, 0, ${z}]}}}
  load:
    parent: ship
    mass_t: 5
    shape: {sphere: {radius_m: 1}}
    joint: {spherical: {name: rope, position_m: [0, 8, 12], child_position_m: [0, 0, 9]}}
forces:
  slack: {catenary_line: {fairlead: {body: ship, position_m: [20, 3, 5]}, anchor_m: [200, 120, -50], unstretched_length_m: 235, weight_in_water_N_per_m: 800, axial_stiffness_N: 3.0e+8}}
  taut: {catenary_line: {fairlead: {body: ship, position_m: [20, -3, 5]}, anchor_m: [200, -120, -50], unstretched_length_m: 214, weight_in_water_N_per_m: 800, axial_stiffness_N: 3.0e+7}}
  hawser: {spring_line: {first: {body: ship, position_m: [-20, 0, 5]}, second: {body: world, position_m: [-50, 0, 4]}, unstretched_length_m: 31, axial_stiffness_N: 1.0e+6}}
  gone: {spring_line: {enabled: false, first: {body: ship}, second: {body: world}, unstretched_length_m: 31, axial_stiffness_N: 1.0e+6}}
`;

function opened(z: number) {
  const simulation = new Simulation(text(z), "lines.yaml", "{}", "{}");
  const columns = new Columns(JSON.parse(simulation.channels_json()));
  const row = simulation.row();
  const reading = (name: string) => ({
    tension_N: columns.read(row, `${name}.line_tension`),
    end_tension_N: columns.read(row, `${name}.line_end_tension`),
    grounded_length_m: columns.read(row, `${name}.line_grounded_length`),
  });
  return { reading, poses: simulation.poses(), ...readRopes(simulation.resolved_json()) };
}

describe("ropes", () => {
  it("are read from the scenario, with places seen from the centres of mass", () => {
    const { lines, pendants } = opened(0);
    expect(lines.map(({ name }) => name)).toEqual(["slack", "taut", "hawser"]);
    expect(lines[0].first).toEqual({ body: "ship", position_m: [19, 3, 2] });
    expect(lines[0].second).toEqual({ body: "world", position_m: [200, 120, -50] });
    expect([lines[0].weight_in_water_N_per_m, lines[2].weight_in_water_N_per_m]).toEqual([800, 0]);
    expect(pendants).toEqual([{ from: { body: "load", position_m: [0, 0, 9] }, to: { body: "load", position_m: [0, 0, 0] } }]);
  });

  it.each([["slack", 0], ["slack", 3], ["taut", 0], ["taut", -10]])("hang as the engine's catenary from end to end: %s, at %f m", (name, z) => {
    const { lines, reading, poses } = opened(z);
    const line = lines.find((one) => one.name === name)!;
    const found = reading(name);
    expect(found.grounded_length_m > 0).toBe(name === "slack");
    const fairlead = line.first.position_m.map((part, k) => poses[k] + part);
    const way = fairlead.map((part, k) => part - line.second.position_m[k]);
    // The engine solves for these ends; Newton's method there stops at a millionth of the length.
    const top = profileAt(line, found, line.unstretched_length_m);
    expect(top.x).toBeCloseTo(Math.hypot(way[0], way[1]), 3);
    expect(top.z).toBeCloseTo(way[2], 3);
    expect(profileAt(line, found, 0)).toEqual({ x: expect.closeTo(0, 9), z: expect.closeTo(0, 9) });
    const points = shapeOf(line, fairlead as [number, number, number], line.second.position_m, found, 301);
    points[0].forEach((part, k) => expect(part).toBeCloseTo(fairlead[k], 6));
    points[300].forEach((part, k) => expect(part).toBeCloseTo(line.second.position_m[k], 6));
    // As long as the line is, but for its stretch, and never through the seabed.
    const length = points.slice(1).reduce((sum, p, i) => sum + Math.hypot(...p.map((part, k) => part - points[i][k])), 0);
    const stretch = (found.tension_N / line.axial_stiffness_N) * line.unstretched_length_m;
    expect(length - line.unstretched_length_m).toBeGreaterThan(0);
    expect(length - line.unstretched_length_m).toBeLessThan(stretch + 0.01);
    expect(Math.min(...points.map((p) => p[2]))).toBeGreaterThan(-50 - 1e-3);
  });

  it("show the slack of a hawser as a sag, and a taut one straight", () => {
    const { lines, reading } = opened(0);
    const line = lines[2];
    const slack = shapeOf(line, [0, 0, 0], [30, 0, 0], reading("hawser"), 201);
    const length = slack.slice(1).reduce((sum, p, i) => sum + Math.hypot(...p.map((part, k) => part - slack[i][k])), 0);
    expect(length).toBeCloseTo(31, 1);
    expect(shapeOf(line, [0, 0, 0], [32, 0, 0], reading("hawser"), 3)[1]).toEqual([16, 0, expect.closeTo(0, 12)]);
  });
});
