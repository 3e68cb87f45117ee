import { describe, expect, it } from "vitest";
import { Stretch } from "../src/plots/stretch";
import { rangeInSight, timeRange, windowLength, wrapPlaces } from "../src/plots/window";

describe("lines over a part of the recording", () => {
  const rows = Array.from({ length: 137 }, (_, i) => ({ time_s: i, row: Float64Array.of(i, -i, 3 * i, 4 * i), poses: new Float64Array(), line_points: new Float64Array() }));
  const lines = [[1], [2, 3], [-1]];

  it("columns, magnitudes of vectors and missing columns are copied in displayed units", () => {
    const stretch = new Stretch();
    stretch.fill(rows, [10, 20], lines, (value, line) => (line === 0 ? 2 * value : value));
    const [times, column, length, missing] = stretch.data.map((one) => Array.from(one));
    expect(times).toEqual([10, 11, 12, 13, 14, 15, 16, 17, 18, 19]);
    expect(column).toEqual(times.map((time) => -2 * time));
    expect(length).toEqual(times.map((time) => 5 * time));
    expect(missing.every(Number.isNaN)).toBe(true);
  });

  it("copying another part of the recording allocates no memory", () => {
    const stretch = new Stretch();
    stretch.fill(rows, [0, 30], lines, (value) => value);
    const { buffer } = stretch.data[0];
    stretch.fill(rows, [100, 137], lines, (value) => value);
    expect(stretch.data[0].buffer).toBe(buffer);
    expect(stretch.data[0].at(-1)).toBe(136);
    stretch.fill(rows, [0, 0], lines, (value) => value);
    expect(stretch.data.map(({ length }) => length)).toEqual([0, 0, 0, 0]);
  });
});

describe("visible time of the plots", () => {
  it("the visible time grows with a long run", () => {
    expect(timeRange(0, 600, 600)).toEqual([0, 15]);
    expect(timeRange(15.2, 600, 600)).toEqual([0, 30]);
    expect(timeRange(100, 600, 600)).toEqual([0, 120]);
    expect(timeRange(241, 600, 600)).toEqual([0, 600]);
    expect(timeRange(5, 18, 18)).toEqual([0, 18]);
    // If not all records can be shown, the last ones are.
    expect(timeRange(300, 3600, 200)).toEqual([100, 300]);
  });

  it("the visible time is the duration of a short run, then a moving window", () => {
    expect(timeRange(0, 3, 10)).toEqual([0, 3]);
    expect(timeRange(2, 3, 10)).toEqual([0, 3]);
    expect(timeRange(7, 3, 10)).toEqual([0, 7]);
    expect(timeRange(25, 3, 10)).toEqual([15, 25]);
  });

  it("the visible time moves back only if an earlier shown moment is outside it", () => {
    expect(rangeInSight(25, 20, 3, 10)).toEqual([15, 25]);
    expect(rangeInSight(25, 12, 3, 10)).toEqual([7, 17]);
    expect(rangeInSight(25, 2, 3, 10)).toEqual([0, 10]);
    expect(rangeInSight(100, 3, 600, 600)).toEqual([0, 120]);
  });

  it("the window is at least ten seconds, unless this needs too many records", () => {
    expect(windowLength(3, 0.01)).toEqual({ window_s: 10, capacity: 1002 });
    expect(windowLength(600, 0.1).window_s).toBe(600);
    const fine = windowLength(3600, 0.001);
    expect(fine.capacity).toBe(20000);
    expect(fine.window_s).toBeCloseTo(20, 1);
  });
});

it("finds where an angle jumps by a full turn", () => {
  expect(wrapPlaces([170, 179, -179, -170, 175], 0, 4, 180)).toEqual([[1, 2], [3, 4]]);
  expect(wrapPlaces([1, 2, 3], 0, 2, 180)).toEqual([]);
});
