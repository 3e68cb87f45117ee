import { describe, expect, it } from "vitest";
import { readModel } from "../src/engine/engine";
import type { Equations } from "../src/engine/engine";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { blocksOf, inCell, stretchesOf } from "../src/equations/blocks";
import { highlightOf } from "../src/equations/highlight";
import { unitOf } from "../src/equations/matrix_table";
import { energyEllipsoid, inertiaOf, momentumOf, momentumSphere, rigidsOf, sizeOf } from "../src/equations/momentum";
import type { Vector } from "../src/equations/momentum";
import { bodyFinder, motionsOf } from "../src/equations/moved";
import { filesOf, initEngine, read } from "./gallery";

await initEngine();

async function opened(scenario: string, overrides = {}) {
  const text = read(`scenarios/${scenario}.yaml`);
  const simulation = new Simulation(text, scenario, JSON.stringify(overrides), await filesOf(text));
  const model = readModel(simulation.model_json());
  const bodyOf = bodyFinder(model.bodies.map(({ name }) => name), model.joints);
  return { simulation, model, bodyOf, equations: () => JSON.parse(simulation.equations_json()) as Equations };
}

const sorted = (values: number[]) => values.map((value) => value + 0).sort((a, b) => a - b);
const named = ({ matrices }: Equations, name: string) => matrices.find((matrix) => matrix.name === name)!;

describe("blocks of a matrix", () => {
  it.each(["paper", "offshore_vessel", "chain", "dual_draglink_crane", "slew_and_land"])("blocks contain every entry of a matrix once, and each belongs to a body: %s", async (scenario) => {
    const { equations, bodyOf } = await opened(scenario);
    for (const matrix of equations().matrices.filter(({ name }) => ["B", "B_dot", "M", "D", "F", "M_star", "N_star", "F_star"].includes(name))) {
      const rows = stretchesOf(matrix.row_labels, matrix.row_units, bodyOf);
      const columns = stretchesOf(matrix.column_labels, matrix.column_units, bodyOf);
      const entries = blocksOf(matrix, rows, columns).flat().flatMap(({ values }) => values.flat());
      expect(entries).toHaveLength(matrix.data.length);
      expect(sorted(entries)).toEqual(sorted(matrix.data));
      expect(rows.every(({ body }) => body >= 0)).toBe(true);
    }
  });

  it("blocks of B agree with the formula of the paper's crane without its load", async () => {
    const { equations, bodyOf } = await opened("paper");
    const found = equations();
    const b = named(found, "B");
    const [rows, columns] = [stretchesOf(b.row_labels, b.row_units, bodyOf), stretchesOf(b.column_labels, b.column_units, bodyOf)];
    const formula = found.formulas.find(({ name }) => name === "B")!;
    expect([rows.length, columns.length]).toEqual([formula.rows.length, formula.columns.length]);
    const isZero = blocksOf(b, rows, columns).map((line) => line.map((block) => block.isZero));
    expect(isZero).toEqual(formula.blocks.map((line) => line.map((latex) => latex === "0")));
  });

  it("entries are written with at most three digits", () => {
    expect([0.5, -12.345, 123456, 0.00123, 1].map(inCell)).toEqual(["0.5", "−12.3", "1.2e5", "1.2e−3", "1"]);
  });

  it("the unit of an entry is the unit of its row over the unit of its column", () => {
    expect([unitOf("m/s", "rad/s"), unitOf("m/s", "m/s"), unitOf("N m", "1"), unitOf("1", "1")]).toEqual(["(m/s)/(rad/s)", "", "N m", ""]);
  });
});

describe("effect of a block on the ship", () => {
  it("the columns of B times the coordinate rates give the velocity of the arm", async () => {
    const { simulation, model, equations, bodyOf } = await opened("paper", { motor_1: true });
    simulation.step(500);
    const found = equations();
    const b = named(found, "B");
    // Sum over all coordinates of B times their rates: the velocity of the arm, X' = B q'.
    const rates = named(found, "q_dot");
    const channels = JSON.parse(simulation.channels_json()) as { columns: string[]; offset: number }[];
    const row = simulation.row();
    const place = (column: string) => channels.flatMap(({ columns, offset }) => columns.map((name, k) => [name, offset + k] as const)).find(([name]) => name === column)![1];
    const arm = model.bodies.findIndex(({ name }) => name === "arm");
    const sum = [0, 0, 0];
    rates.row_labels.forEach((label, k) => {
      const motion = motionsOf(b, b.column_labels.indexOf(label), bodyOf).find(({ body }) => body === arm);
      motion?.linear.forEach((value, axis) => (sum[axis] += value * rates.data[k]));
    });
    const velocity = ["x", "y", "z"].map((axis) => row[place(`arm.velocity.${axis}`)]);
    sum.forEach((value, axis) => expect(value).toBeCloseTo(velocity[axis], 10));
    expect(sizeOf(velocity as Vector)).toBeGreaterThan(0.01);
  });

  it("a block of M* for slewing and luffing highlights the arm and not the tower", async () => {
    const { model, equations, bodyOf } = await opened("paper");
    const found = equations();
    const m = named(found, "M_star");
    const at = (label: string) => ({ from: m.row_labels.indexOf(label), length: 1, body: bodyOf(label) });
    const { bodies } = highlightOf(found, m, { rows: at("slew"), columns: at("luff"), values: [[0]], isZero: false }, bodyOf);
    expect(bodies.map((body) => model.bodies[body].name)).toEqual(["arm"]);
  });
});

describe("momentum and energy", () => {
  const INERTIA = [
    [4, 0.3, -0.2],
    [0.3, 9, 0.5],
    [-0.2, 0.5, 6],
  ];
  const omega: Vector = [0.4, -1.1, 0.7];

  it("the angular momentum of a body is on its momentum sphere and energy ellipsoid", () => {
    const momentum = momentumOf(INERTIA, omega);
    const energy = (momentum[0] * omega[0] + momentum[1] * omega[1] + momentum[2] * omega[2]) / 2;
    const sphere = momentumSphere(sizeOf(momentum));
    expect(sizeOf(sphere([0, 0.6, 0.8]))).toBeCloseTo(sizeOf(momentum), 12);
    // The unit vector that the ellipsoid maps to this momentum, from its lower triangle.
    const surface = energyEllipsoid(INERTIA, energy);
    const columns = [surface([1, 0, 0]), surface([0, 1, 0]), surface([0, 0, 1])];
    const x = momentum[0] / columns[0][0];
    const y = (momentum[1] - x * columns[0][1]) / columns[1][1];
    const z = (momentum[2] - x * columns[0][2] - y * columns[1][2]) / columns[2][2];
    expect(Math.hypot(x, y, z)).toBeCloseTo(1, 12);
  });

  it("angular momentum and energy of a thrown racket are constant if all its parts are included", async () => {
    const { simulation, model } = await opened("tennis_racket");
    const rigids = rigidsOf(model);
    expect(rigids).toHaveLength(1);
    expect(rigids[0]).toHaveLength(model.bodies.length);
    const channels = JSON.parse(simulation.channels_json()) as { columns: string[]; offset: number }[];
    const first = model.bodies[0].name;
    const found = channels.find(({ columns }) => columns[0] === `${first}.angular_velocity.x`)!;
    const sizes = [0, 0.5, 1, 2].map((time_s) => {
      simulation.step(Math.round((time_s - simulation.time_s()) / simulation.step_s()));
      const row = simulation.row();
      const omega = [...row.slice(found.offset, found.offset + 3)] as Vector;
      const momentum = momentumOf(inertiaOf(rigids[0], model.bodies, simulation.poses()), omega);
      return { momentum: sizeOf(momentum), energy: (momentum[0] * omega[0] + momentum[1] * omega[1] + momentum[2] * omega[2]) / 2, omega };
    });
    // RK4 at 5 ms keeps both to 1e-7 over these rotations; for one part alone they vary far more.
    for (const { momentum, energy } of sizes) {
      expect(Math.abs(momentum / sizes[0].momentum - 1)).toBeLessThan(1e-7);
      expect(Math.abs(energy / sizes[0].energy - 1)).toBeLessThan(1e-7);
    }
    expect(Math.abs(sizes[3].omega[1] - sizes[0].omega[1])).toBeGreaterThan(1);
  });

  it("bodies that a moving joint connects are in different groups", async () => {
    const { model } = await opened("paper");
    expect(rigidsOf(model).map((rigid) => rigid.map((body) => model.bodies[body].name))).toContainEqual(["ship"]);
  });

  it("the energy ellipsoid of a body at rest, or without inertia, is a point", () => {
    expect(sizeOf(energyEllipsoid(INERTIA, 0)([1, 0, 0]))).toBe(0);
    expect(sizeOf(energyEllipsoid([[0, 0, 0], [0, 0, 0], [0, 0, 0]], 3)([0, 1, 0]))).toBe(0);
  });
});
