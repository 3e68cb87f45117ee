import { expect, it } from "vitest";
import { duration, fixed, inBrief, scientific } from "../src/app/format";
import { sliderRange, sliderStep, withoutRounding } from "../src/ui/items";

it("writes negative numbers with a minus sign, and zero without one", () => {
  expect(fixed(-1.005, 2)).toBe("−1.00");
  expect(fixed(-0.0001, 2)).toBe("0.00");
  expect(fixed(NaN, 2)).toBe("–");
});

it("cuts long texts between characters, and marks the cut", () => {
  expect(inBrief("a ship", 6)).toBe("a ship");
  expect(inBrief("a ship", 5)).toBe("a sh…");
  expect(inBrief("⛴️🚢🚢🚢🚢", 4)).toBe("⛴️🚢…");
  expect(inBrief("x".repeat(1_500_000), 200).length).toBe(200);
});

it("writes errors with a power of ten", () => {
  expect(scientific(1.87e-7)).toBe("1.9×10⁻⁷");
  expect(scientific(0.0244)).toBe("2.4×10⁻²");
  expect(scientific(123456)).toBe("1.2×10⁵");
  expect(scientific(1.53)).toBe("1.5");
  expect(scientific(0)).toBe("0");
  expect(scientific(NaN)).toBe("–");
});

it("writes time steps in ms or s", () => {
  expect(duration(0.001)).toBe("1 ms");
  expect(duration(0.00025)).toBe("0.25 ms");
  expect(duration(2)).toBe("2 s");
});

it("gives sliders round steps", () => {
  expect(sliderStep(-10, 10)).toBe(0.1);
  expect(sliderStep(-5, 5)).toBe(0.05);
  expect(sliderStep(0, 250)).toBe(1);
  expect(sliderStep(0, 0)).toBe(1);
});

it("writes a number of degrees without rounding errors of the conversion to radians and back", () => {
  expect(withoutRounding(-59.99999999999999)).toBe("-60");
  expect(withoutRounding(4.486)).toBe("4.486");
  expect(withoutRounding(1.23456789e-7)).toBe("1.23456789e-7");
});

it("the slider of a position has a fixed range, and the slider of a speed or torque its limits", () => {
  expect(sliderRange({ unit: "rad", lower: -1e6, upper: 1e6 })).toEqual([-100, 100]);
  expect(sliderRange({ unit: "m", lower: 0, upper: 4 })).toEqual([0, 4]);
  expect(sliderRange({ unit: "N m", lower: -2e6, upper: 2e6 })).toEqual([-2e6, 2e6]);
});
