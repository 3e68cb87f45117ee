import { describe, expect, it } from "vitest";
import { History } from "../src/plots/history";
import { timeRange, windowLength, wrapPlaces } from "../src/plots/window";

describe("history", () => {
  it("keeps the last records, contiguous, in bounded memory", () => {
    const history = new History(2, 10);
    for (let i = 0; i < 137; i++) {
      history.push([i, -i]);
      const kept = Math.min(i + 1, 10);
      expect(history.length).toBe(kept);
      expect(Array.from(history.column(0))).toEqual(Array.from({ length: kept }, (_, k) => i - kept + 1 + k));
    }
    expect(history.last(1)).toBe(-136);
    expect(history.column(0).buffer.byteLength).toBe(20 * 8);
    history.clear();
    expect(history.length).toBe(0);
    expect(history.last(0)).toBeNaN();
  });
});

describe("the window of time", () => {
  it("grows with the time shown, so that the start of a long run can be read", () => {
    expect(timeRange(0, 600, 600)).toEqual([0, 15]);
    expect(timeRange(15.2, 600, 600)).toEqual([0, 30]);
    expect(timeRange(100, 600, 600)).toEqual([0, 120]);
    expect(timeRange(241, 600, 600)).toEqual([0, 600]);
    expect(timeRange(5, 18, 18)).toEqual([0, 18]);
    // A run whose records do not all fit shows the last of them.
    expect(timeRange(300, 3600, 200)).toEqual([100, 300]);
  });

  it("shows the duration of a short run first and rolls after it", () => {
    expect(timeRange(0, 3, 10)).toEqual([0, 3]);
    expect(timeRange(2, 3, 10)).toEqual([0, 3]);
    expect(timeRange(7, 3, 10)).toEqual([0, 7]);
    expect(timeRange(25, 3, 10)).toEqual([15, 25]);
  });

  it("looks back at least ten seconds, and less where memory would run out", () => {
    expect(windowLength(3, 0.01)).toEqual({ window_s: 10, capacity: 1002 });
    expect(windowLength(600, 0.1).window_s).toBe(600);
    const fine = windowLength(3600, 0.001);
    expect(fine.capacity).toBe(20000);
    expect(fine.window_s).toBeCloseTo(20, 1);
  });
});

it("finds where an angle jumps around the circle", () => {
  expect(wrapPlaces([170, 179, -179, -170, 175], 0, 4, 180)).toEqual([[1, 2], [3, 4]]);
  expect(wrapPlaces([1, 2, 3], 0, 2, 180)).toEqual([]);
});
