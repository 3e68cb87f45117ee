import { describe, expect, it } from "vitest";
import { channelOf } from "./fake";
import type { LimitInfo } from "../src/engine/engine";
import { hookOf, worstOf } from "../src/instruments/cockpit";
import { joined } from "../src/plots/bound_labels";
import { gravest, LimitTrack, marginOf } from "../src/instruments/limits";

const HEEL: LimitInfo = { name: "heel", column: "hull.roll", unit: "deg", unit_si: Math.PI / 180, at_least: -5, at_most: 5, from_s: 0, until_s: null, steps: [], percentile: 100 };
const GAP: LimitInfo = { ...HEEL, name: "gap", column: "gap", unit: "m", unit_si: 1, at_least: 0, at_most: null };
const deg = (value: number) => [0, (value * Math.PI) / 180];

function tracked(limit: LimitInfo, values: number[], interval_s = 1): LimitTrack {
  const track = new LimitTrack(limit, 1);
  values.forEach((value, k) => track.see(k * interval_s, [k * interval_s, value * limit.unit_si]));
  return track;
}

describe("a limit", () => {
  it("a limit converts an SI column to the unit of the limit", () => {
    expect(new LimitTrack(HEEL, 1).valueIn(deg(3))).toBeCloseTo(3, 12);
  });

  it("a limit is near within a tenth of half its span, and exceeded beyond a bound, on both sides", () => {
    const track = new LimitTrack(HEEL, 1);
    const states = [0, 4.4, 4.6, -4.6, 5.1, -5.1].map((value) => track.state(0, deg(value)));
    expect(states).toEqual(["ok", "ok", "near", "near", "exceeded", "exceeded"]);
  });

  it("NaN exceeds a limit", () => {
    expect(marginOf(HEEL, NaN)).toBe(-Infinity);
    expect(new LimitTrack(HEEL, 1).state(0, [0, NaN])).toBe("exceeded");
  });

  it("a bound of zero is near within a tenth of the largest value so far", () => {
    const track = tracked(GAP, [4, 2, 3]);
    expect([1, 0.3, -0.1].map((value) => track.state(3, [3, value]))).toEqual(["ok", "near", "exceeded"]);
  });

  it("a limit with steps and an end applies in these steps until its end", () => {
    const track = new LimitTrack({ ...GAP, until_s: 5, steps: [2, 3] }, 1, 2);
    expect([[1, -1, 1], [2, -1, 2], [5, -1, 3], [6, -1, 3]].map((row) => track.state(row[0], row))).toEqual(["waiting", "exceeded", "exceeded", "waiting"]);
    [[1, -9, 1], [2, 4, 2], [3, 3, 2], [6, -2, 2]].forEach((row) => track.see(row[0], row));
    expect(track.worstUntil(9)).toEqual({ time_s: 3, value: 3 });
  });

  it("a limit does not apply before its start time", () => {
    const track = tracked({ ...HEEL, from_s: 2 }, [9, 9, 1]);
    expect(track.state(1, [1, 9])).toBe("waiting");
    expect(track.worstUntil(1)).toBeNull();
    expect(track.worstUntil(2)).toEqual({ time_s: 2, value: expect.closeTo(1, 12) });
  });

  it("a limit with a percentile allows its share of rows beyond the bound", () => {
    const track = tracked({ ...HEEL, percentile: 80 }, [1, 7, 2, 3, 6]);
    expect([1, 3, 4].map((time_s) => track.worstUntil(time_s)!.value)).toEqual([7, 7, 6].map((value) => expect.closeTo(value, 12)));
    expect(track.state(4, deg(1))).toBe("exceeded");
    [1, 1, 1, 1, 1].forEach((value, k) => track.see(5 + k, deg(value)));
    expect(track.worstUntil(9)!.value).toBeCloseTo(3, 12);
    expect(track.state(9, deg(1))).toBe("ok");
  });

  it("the worst value so far is the one with the smallest margin to a bound", () => {
    const track = tracked(HEEL, [1, -2, 1.5, -4, 3]);
    const worsts = [0, 1, 2, 3, 4].map((time_s) => track.worstUntil(time_s)!.value);
    expect(worsts.map((value) => Number(value.toFixed(9)))).toEqual([1, -2, -2, -4, -4]);
  });

  it("a limit drops values after the moment from which the run continues", () => {
    const track = tracked(HEEL, [1, -2, 4]);
    track.dropAfter(1);
    track.see(2, deg(3));
    expect(track.worstUntil(9)!.value).toBeCloseTo(3, 12);
  });

  it("the bar of a limit contains its bounds and all values", () => {
    const [low, high] = tracked(HEEL, [1, -8, 4]).range();
    expect(low).toBeLessThanOrEqual(-8);
    expect(high).toBeGreaterThan(5);
    const ofGap = tracked(GAP, [4, 2]).range();
    expect(ofGap[0]).toBeLessThan(0);
    expect(ofGap[1]).toBeGreaterThan(4);
  });
});

it("several limits have the worst of their states", () => {
  expect(gravest(["ok", "near", "waiting"])).toBe("near");
  expect(gravest(["near", "exceeded"])).toBe("exceeded");
  expect(gravest([])).toBe("waiting");
});

describe("the cockpit", () => {
  const channel = (variable: string, unit: string) => channelOf(variable, ["rope"], [["hoist"]], [unit]);
  const tension = new LimitTrack({ ...GAP, name: "tension", column: "hoist.rope_tension", unit: "kN", unit_si: 1000, at_least: null, at_most: 60 }, 1);

  it("reads the hook load of a load chart with its rated load, otherwise the first rope with its limit", () => {
    const rope = channel("rope_tension", "N");
    expect(hookOf([rope, channel("hook_load", "kg"), channel("rated_load", "kg")], [tension])).toEqual({ column: "hoist.hook_load", unit: "kg", rated: "hoist.rated_load", track: null });
    expect(hookOf([rope], [tension])).toEqual({ column: "hoist.rope_tension", unit: "N", rated: null, track: tension });
    expect(hookOf([], [tension])).toBeNull();
  });

  it("shows the limit with the least room for its scale, among those that apply", () => {
    const [heel, gap] = [new LimitTrack(HEEL, 1), new LimitTrack({ ...GAP, at_least: 3, from_s: 10 }, 2)];
    const row = (degrees: number, gap_m: number) => [0, (degrees * Math.PI) / 180, gap_m];
    expect(worstOf([heel, gap], 0, row(1, 3.1))).toBe(heel);
    expect(worstOf([heel, gap], 10, row(1, 3.1))).toBe(gap);
    expect(worstOf([heel, gap], 10, row(6, 3.1))).toBe(heel);
    expect(worstOf([gap], 0, row(0, 9))).toBeNull();
    expect(heel.boundNear(-3)).toBe(-5);
  });
});

describe("labels of limits in a plot", () => {
  it("joins labels that would be printed over each other", () => {
    const labels = [{ name: "sling port", y: 100 }, { name: "leg", y: 60 }, { name: "sling starboard", y: 100 }, { name: "sling port", y: 104 }];
    expect(joined(labels, 13)).toEqual([{ name: "leg", y: 60 }, { name: "sling port and 1 more", y: 100 }]);
    expect(joined([{ name: "heel", y: 10 }, { name: "heel", y: 90 }], 13).length).toBe(2);
  });
});
