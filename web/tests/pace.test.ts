import { expect, it } from "vitest";
import { Pace } from "../src/app/pace";

/** Returns the pace after a run of this wall time in frames of this length. */
function ran(factor: number, wall_s: number, frames_s = 1 / 60): Pace {
  const pace = new Pace();
  for (let s = 0; s <= wall_s; s += frames_s) pace.see(100 + s, factor * s);
  return pace;
}

it("the pace is simulated over wall time, also with few long frames", () => {
  expect(ran(0.7, 5).factor).toBeCloseTo(0.7, 9);
  expect(ran(17, 5, 0.9).factor).toBeCloseTo(17, 9);
});

it("the pace is NaN without enough data, and starts again when the speed changes", () => {
  const pace = ran(1, 0.5);
  expect(pace.factor).toBeNaN();
  expect(pace.isSlow(1)).toBe(false);
  const other = ran(1, 5);
  other.begin();
  expect(other.factor).toBeNaN();
});

it("the pace ignores times before its averaging window", () => {
  const pace = ran(1, 5);
  for (let s = 0; s < 4; s += 0.1) pace.see(105 + s, 5 + 0.5 * s);
  expect(pace.factor).toBeCloseTo(0.5, 6);
});

it("a run is slow if its pace is below the chosen speed", () => {
  expect(ran(0.7, 5).isSlow(1)).toBe(true);
  expect(ran(0.99, 5).isSlow(1)).toBe(false);
  expect(ran(17, 5).isSlow(20)).toBe(true);
});
