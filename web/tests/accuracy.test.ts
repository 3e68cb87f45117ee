import { expect, it } from "vitest";
import { Accuracy } from "../src/app/accuracy";
import { Columns } from "../src/engine/columns";
import { channelOf } from "./fake";

const NAMES = ["energy_scale", "potential_energy", "energy_error", "momentum_scale", "momentum_error"];
const columns = new Columns(NAMES.map((name, i) => channelOf(name, [], [], ["1"], i)));

function errorsOf(...rows: number[][]) {
  const accuracy = new Accuracy(columns);
  rows.forEach((row) => accuracy.see(row));
  return accuracy.errors(rows.at(-1)!);
}

it("divides the energy error by the largest exchanged energy so far", () => {
  expect(errorsOf([50, 0, 1e-6, 20, 1e-7], [20, 0, -2e-6, 10, 2e-7])).toMatchObject({ energy: 4e-8, momentum: 1e-8 });
});

it("gives no relative energy error for a ship at rest, whose error is a rounding of the stored energy", () => {
  // Two ships at rest: 1.9e8 J are stored, one unit in the last place is 3e-8 J.
  const { energy, energy_J } = errorsOf([1.4e-21, -1.9e8, -3e-8, 0, 0]);
  expect([energy, energy_J]).toEqual([NaN, 3e-8]);
  expect(errorsOf([1e-6, 1.9e8, 3e-8, 0, 0]).energy).toBeNaN();
  // 43 uJ of exchanged energy are a thousand rounding errors of 1.9e8 J.
  expect(errorsOf([5e-5, 1.9e8, 3e-8, 0, 0]).energy).toBeCloseTo(6e-4, 12);
});

it("gives no relative errors before anything moves", () => {
  expect(errorsOf([0, 0, 0, 0, 0])).toMatchObject({ energy: NaN, momentum: NaN, energy_J: 0 });
});
