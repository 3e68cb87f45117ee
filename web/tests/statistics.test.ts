import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { evenEnd, isResolved, linesThatHold, loadTransform, peakOf, segmentLength, spectraOf, welch } from "../src/plots/spectrum";
import { armAt, heelToSide } from "../src/plots/stability";
import { statisticsOf } from "../src/plots/statistics";

const STEP_S = 0.1;
const times = (count: number, step_s = STEP_S) => Float64Array.from({ length: count }, (_, i) => i * step_s);
const transformOf = await loadTransform();

describe("statistics", () => {
  it("statistics of a sine over whole periods follow from its amplitude and period", () => {
    // 25 periods of 8 s, heeled by 2.
    const t = times(2000);
    const found = statisticsOf(t, t.map((time) => 2 + 3 * Math.sin((2 * Math.PI * time) / 8 + 0.3)));
    expect(found.mean).toBeCloseTo(2, 12);
    expect(found.standard_deviation).toBeCloseTo(3 / Math.SQRT2, 12);
    expect(found.significant_double_amplitude).toBeCloseTo(12 / Math.SQRT2, 12);
    expect(found.zero_up_crossing_period).toBeCloseTo(8, 6);
    expect([found.minimum, found.maximum].map((one) => one.toFixed(3))).toEqual(["-1.000", "5.000"]);
  });

  it("statistics have no period with fewer than two up-crossings of the mean", () => {
    expect(statisticsOf([0, 1, 2], [1, 2, 3]).zero_up_crossing_period).toBeNaN();
    expect(statisticsOf([0, 1, 2, 3], [0, 2, 0, 2]).zero_up_crossing_period).toBeCloseTo(2, 12);
  });

  it("statistics weight records of a thinned part by their duration", () => {
    // Every fourth record of the first half is left.
    const all = times(4001);
    const kept = all.filter((_, i) => i >= 2000 || i % 4 === 0);
    const wave = (time: number) => Math.sin((2 * Math.PI * time) / 20) + (time < 200 ? 0 : 10);
    const [dense, thinned] = [statisticsOf(all, all.map(wave)), statisticsOf(kept, kept.map(wave))];
    expect(thinned.mean).toBeCloseTo(dense.mean, 2);
    expect(thinned.standard_deviation).toBeCloseTo(dense.standard_deviation, 2);
    // Without the weights the mean would be nearer to the mean of the newer half.
    expect(kept.reduce((sum, time) => sum + wave(time), 0) / kept.length).toBeGreaterThan(dense.mean + 2);
  });

  it("statistics of no records are NaN", () => {
    expect(Object.values(statisticsOf([], [])).every((one) => Number.isNaN(one))).toBe(true);
  });
});

describe("a spectrum", () => {
  it("the spectrum of a sine has its variance, and its peak at its frequency", () => {
    const [length, line] = [256, 16];
    const omega = (2 * Math.PI * line) / (length * STEP_S);
    const found = welch(times(2048).map((t) => 3 * Math.sin(omega * t + 1)), STEP_S, length, transformOf);
    expect(peakOf(found)).toBe(line);
    expect(found.omega[line]).toBeCloseTo(omega, 12);
    expect(found.resolution).toBeCloseTo((2 * Math.PI) / 25.6, 12);
    expect(found.segments).toBe(15);
    // A Hann window gives a line its height and a quarter of it on either side: A^2 / 2 in total.
    const variance = found.density.reduce((sum, value) => sum + value, 0) * found.resolution;
    expect(variance).toBeCloseTo(9 / 2, 10);
    expect(found.density[line] * found.resolution).toBeCloseTo(9 / 3, 10);
    expect(found.density[line + 1] / found.density[line]).toBeCloseTo(1 / 4, 10);
    expect(found.density[line + 4]).toBeLessThan(1e-20);
    expect(linesThatHold(found, 0.99)).toBe(line + 2);
  });

  it("the spectrum of noise satisfies Parseval's theorem", () => {
    let seed = 12345;
    const noise = Float64Array.from({ length: 640 }, () => ((seed = (seed * 1103515245 + 12345) % 2 ** 31) / 2 ** 30 - 1));
    const length = 128;
    const found = welch(noise, STEP_S, length, transformOf);
    const mean = noise.reduce((sum, value) => sum + value, 0) / noise.length;
    const window = Float64Array.from({ length }, (_, i) => Math.sin((Math.PI * i) / length) ** 2);
    const square = window.reduce((sum, one) => sum + one ** 2, 0);
    let expected = 0;
    for (let start = 0; start + length <= noise.length; start += length / 2) {
      for (let i = 0; i < length; i++) expected += ((noise[start + i] - mean) * window[i]) ** 2 / square;
    }
    const all = found.density.reduce((sum, value) => sum + value, 0) * found.resolution;
    expect(all).toBeCloseTo(expected / found.segments, 12);
  });

  it("a spectrum uses the evenly spaced records up to the last", () => {
    expect(evenEnd(times(100))).toEqual([0, 100]);
    expect(evenEnd([0, 2, 4, 5, 6, 7, 8])).toEqual([2, 7]);
    // A run that ended off the grid.
    expect(evenEnd([0, 1, 2, 3, 3.4])).toEqual([0, 4]);
    expect(evenEnd([])).toEqual([0, 0]);
  });

  it("the spectrum of a slow motion uses fewer segments until three periods fit into one", () => {
    const roll = (seconds: number) => times(10 * seconds).map((t) => 0.1 * Math.sin((2 * Math.PI * t) / 14));
    const [found] = spectraOf([roll(120)], STEP_S, 8, transformOf);
    expect(isResolved(found)).toBe(true);
    // The period is known to the frequency resolution.
    const omega = found.omega[peakOf(found)];
    expect(Math.abs(omega - (2 * Math.PI) / 14)).toBeLessThan(found.resolution);
    // A fast motion has the requested number of segments.
    const [fast] = spectraOf([times(1200).map((t) => Math.sin(4 * t))], STEP_S, 8, transformOf);
    expect(fast.resolution).toBeCloseTo((2 * Math.PI) / 12.8, 12);
  });

  it("the spectrum of less than three periods has no resolved peak", () => {
    const [found] = spectraOf([times(200).map((t) => Math.sin((2 * Math.PI * t) / 14))], STEP_S, 8, transformOf);
    expect(isResolved(found)).toBe(false);
  });

  it("the spectrum of a constant has the requested segments, and too few records give none", () => {
    const [found] = spectraOf([times(1200).map(() => 0)], STEP_S, 8, transformOf);
    expect(found.resolution).toBeCloseTo((2 * Math.PI) / 12.8, 12);
    expect(spectraOf([times(7)], STEP_S, 8, transformOf)).toEqual([]);
    expect(spectraOf([], STEP_S, 8, transformOf)).toEqual([]);
  });

  it("a segment has a power of two of records, and too few records give none", () => {
    expect(segmentLength(4001, 8)).toBe(256);
    expect(segmentLength(64, 8)).toBe(8);
    expect(segmentLength(63, 8)).toBe(0);
  });
});

describe("righting arms", () => {
  const curve = { side: "port" as const, points: [0, 0.1, 0.2].map((heel_rad, i) => ({ heel_rad, trim_rad: 0, arm_m: [0, 0.3, 0.4][i] })) };

  it("righting arms are interpolated linearly at the heel to the side of the curve", () => {
    expect(heelToSide(curve, -0.05)).toBe(0.05);
    expect(heelToSide({ side: "starboard" }, -0.05)).toBe(-0.05);
    expect(armAt(curve, 0.05)).toBeCloseTo(0.15, 12);
    expect(armAt(curve, 0.1)).toBe(0.3);
    expect(armAt(curve, 0.15)).toBeCloseTo(0.35, 12);
  });

  it("righting arms are NaN on the other side and beyond the last point", () => {
    expect(armAt(curve, -0.01)).toBeNaN();
    expect(armAt(curve, 0.3)).toBeNaN();
    expect(armAt(curve, 0)).toBe(0);
  });
});

it("statistics and spectra agree with Python's, which python/tests/test_app_files.py checks against the same file", () => {
  const stored = JSON.parse(readFileSync(new URL("golden/statistics.json", import.meta.url), "utf8"));
  const t = times(stored.records, stored.step_s);
  const values = t.map((time) => stored.sines.reduce((sum: number, [a, omega, phase]: number[]) => sum + a * Math.sin(omega * time + phase), stored.mean));
  const found = statisticsOf(t, values);
  for (const [name, value] of Object.entries(found)) expect(Math.abs(value - stored.statistics[name]), name).toBeLessThan(1e-12 * Math.max(1, Math.abs(value)));
  const { density, omega } = welch(values, stored.step_s, stored.segment, transformOf);
  expect(density.length).toBe(stored.density.length);
  density.forEach((value, k) => expect(Math.abs(value - stored.density[k])).toBeLessThan(1e-9 * stored.density[k] + 1e-12));
  omega.forEach((value, k) => expect(value).toBeCloseTo(stored.omega[k], 10));
});
