import { describe, expect, it } from "vitest";
import { Conditioned } from "../src/forecast/conditioned";
import { Outlook } from "../src/forecast/outlook";
import { fanOf, LEVELS, quantile } from "../src/forecast/quantiles";
import { Random } from "../src/forecast/random";
import { TrackRecord } from "../src/forecast/score";
import { Fan } from "../src/plots/fan";
import { bits } from "./gallery";

/** Solves A x = b by Gaussian elimination. */
function solved(a: number[][], b: number[]): number[] {
  const rows = a.map((row, i) => [...row, b[i]]);
  rows.forEach((pivot, i) => {
    for (const row of rows) {
      if (row === pivot) continue;
      const share = row[i] / pivot[i];
      row.forEach((_, k) => (row[k] -= share * pivot[k]));
    }
  });
  return rows.map((row, i) => row[b.length] / row[i]);
}

describe("unknowns with measurements", () => {
  const H = [[1, 0.5, -0.3], [0.2, -1, 0.7]];
  const measured = { rows: Float64Array.from(H.flat()), values: Float64Array.of(0.8, -1.1), noise: 0.4 };
  // Information form, which the samples do not use: precision 1 + H^T H / R, mean precision^-1 H^T y / R.
  const square = measured.noise ** 2;
  const precision = [0, 1, 2].map((i) => [0, 1, 2].map((j) => (i === j ? 1 : 0) + H.reduce((sum, row) => sum + (row[i] * row[j]) / square, 0)));
  const mean = solved(precision, [0, 1, 2].map((i) => H.reduce((sum, row, k) => sum + (row[i] * measured.values[k]) / square, 0)));
  const covariance = [0, 1, 2].map((j) => solved(precision, [0, 1, 2].map((i) => (i === j ? 1 : 0))));

  it("unknowns have the mean of the normal distribution given the measurements", () => {
    new Conditioned(3, measured).mean().forEach((value, i) => expect(value).toBeCloseTo(mean[i], 12));
  });

  it("samples of the unknowns have the mean and covariance given the measurements", () => {
    const known = new Conditioned(3, measured);
    const random = new Random(5);
    const draws = Array.from({ length: 40_000 }, () => known.draw(random));
    const average = (of: (draw: Float64Array) => number) => draws.reduce((sum, draw) => sum + of(draw), 0) / draws.length;
    for (let i = 0; i < 3; i++) {
      // Four standard errors of a mean and of a covariance.
      expect(Math.abs(average((x) => x[i]) - mean[i])).toBeLessThan(4 * Math.sqrt(covariance[i][i] / draws.length));
      for (let j = 0; j <= i; j++) {
        const found = average((x) => (x[i] - mean[i]) * (x[j] - mean[j]));
        const error = Math.sqrt((covariance[i][i] * covariance[j][j] + covariance[i][j] ** 2) / draws.length);
        expect(Math.abs(found - covariance[i][j])).toBeLessThan(4 * error);
      }
    }
  });

  it("unknowns without measurements keep their distribution", () => {
    const known = new Conditioned(2, { rows: new Float64Array(), values: new Float64Array(), noise: 0.1 });
    expect(Array.from(known.draw(new Random(3)))).toEqual(Array.from(new Random(3).normals(2)));
  });
});

describe("random numbers", () => {
  it("random numbers are normal, and equal for equal seeds", () => {
    const numbers = new Random(1).normals(100_000);
    const moment = (power: number) => numbers.reduce((sum, x) => sum + x ** power, 0) / numbers.length;
    // Four standard errors of each: the variances of x, x^2 and x^4 are 1, 2 and 96.
    expect(Math.abs(moment(1))).toBeLessThan(4 / Math.sqrt(numbers.length));
    expect(Math.abs(moment(2) - 1)).toBeLessThan(4 * Math.sqrt(2 / numbers.length));
    expect(Math.abs(moment(4) - 3)).toBeLessThan(4 * Math.sqrt(96 / numbers.length));
    expect(bits(new Random(1).normals(9))).toEqual(bits(numbers.subarray(0, 9)));
    expect(new Random(2).normal()).not.toBe(numbers[0]);
  });
});

describe("lines of a fan", () => {
  it("the lines of a fan are at their quantiles for any number of futures", () => {
    // For the sorted numbers 1 to n: a further value is below the position p (n + 1) with probability p.
    for (const n of [32, 64, 199]) {
      const ascending = Array.from({ length: n }, (_, i) => i + 1);
      for (const level of LEVELS) expect(quantile(ascending, level)).toBeCloseTo(level * (n + 1), 12);
    }
  });

  it("the lines of a fan end at the outermost of few futures, and leave out NaN", () => {
    expect(quantile([2, 3], 0.05)).toBe(2);
    expect(quantile([2, 3], 0.95)).toBe(3);
    expect(quantile([], 0.5)).toBeNaN();
    const [low, , middle, , high] = fanOf([Float64Array.of(3, NaN, 1, 2)]);
    expect([low[0], middle[0], high[0]]).toEqual([1, 2, 3]);
  });
});

describe("scores of the forecast", () => {
  it("each minute is judged once, and the newest six count", () => {
    const record = new TrackRecord();
    expect(record.due(59)).toEqual([]);
    expect(record.due(125)).toEqual([60, 0]);
    record.add(60, { held: 9, of: 10 });
    record.add(0, null);
    expect(record.due(125)).toEqual([]);
    expect(record.newest).toEqual({ held: 9, of: 10, minutes: 1 });
    for (const start_s of record.due(600)) record.add(start_s, { held: 8, of: 10 });
    expect(record.newest).toEqual({ held: 48, of: 60, minutes: 6 });
    record.dropAfter(110);
    expect(record.due(125)).toEqual([60]);
  });
});

describe("drawing of futures", () => {
  /** Returns futures whose second column has the value i k for future i at time k. */
  function outlookOf(count: number): Outlook {
    const outlook = new Outlook(count, 2);
    for (let i = 1; i <= count; i++) {
      const rows = Float32Array.from({ length: 2 * 9 }, (_, at) => (at % 2 === 1 ? i * Math.floor(at / 2) : 0));
      outlook.add({ seed: i, start_s: 10, every_s: 0.5, rows, waves: 1, isGusty: false, past_s: 5, fault: null });
    }
    return outlook;
  }

  it("futures are drawn as a fan in the units of the plot, with its range and a table", () => {
    const fan = new Fan();
    fan.fill(outlookOf(19), [[1]], (value) => 10 * value);
    // With 19 futures the smallest and the largest are the levels 5 and 95 %.
    expect(fan.range).toEqual([0, 19 * 8 * 10]);
    const rows = fan.rows((value) => value.toFixed(1));
    expect(rows.map((cells) => cells.length)).toEqual([2, 2, 2, 2]);
    expect(rows.at(-1)![0]).toContain("14.0");
    expect(rows.at(-1)![1]).toBe("80.0 to 1520.0");
    fan.fill(null, [[1]], (value) => value);
    expect(fan.range).toEqual([Infinity, -Infinity]);
    expect(fan.rows(String)).toEqual([]);
  });
});
