import { describe, expect, it } from "vitest";
import type { LimitInfo } from "../src/engine/engine";
import type { Happened } from "../src/engine/messages";
import { LimitTrack } from "../src/instruments/limits";
import { outcomeAt } from "../src/instruments/task";

const LANDING: LimitInfo = { name: "landing", column: "speed", unit: "m/s", unit_si: 1, at_least: null, at_most: 0.3, from_s: 0, until_s: null, steps: [], percentile: 100 };
const END: Happened = { time_s: 60, code: "operation_ends", name: "task", text: "ends" };

/** Returns the track of a limit whose value jumps at a time. */
function jumping(at_s: number, limit = LANDING): LimitTrack {
  const track = new LimitTrack(limit, 1);
  for (const time_s of [0, at_s - 1, at_s, at_s + 1]) track.see(time_s, [time_s, time_s < at_s ? 0.1 : 0.5]);
  return track;
}

describe("the outcome of a task", () => {
  it("a task is under way in its stage, from the first", () => {
    expect([0, 2].map((stage) => outcomeAt(5, stage, [], []))).toEqual([{ state: "under_way", stage: 1 }, { state: "under_way", stage: 2 }]);
  });

  it("a task is done from the end of its last stage on, also when the user looks back", () => {
    const events: Happened[] = [{ ...END, time_s: 20, name: "operation" }, { ...END, time_s: 30, code: "step_begins" }, END];
    expect(outcomeAt(59, 2, events, [jumping(80)])).toEqual({ state: "under_way", stage: 2 });
    expect(outcomeAt(90, 3, events, [jumping(80)])).toEqual({ state: "done", time_s: 60 });
  });

  it("a task is failed by the first limit that is exceeded before its end", () => {
    const tracks = [jumping(50), jumping(40, { ...LANDING, name: "heel" })];
    expect(outcomeAt(39, 2, [END], tracks)).toEqual({ state: "under_way", stage: 2 });
    expect(outcomeAt(90, 3, [END], tracks)).toEqual({ state: "failed", time_s: 40, limit: "heel" });
  });

  it("a limit with a percentile does not fail a task", () => {
    expect(outcomeAt(90, 3, [END], [jumping(40, { ...LANDING, percentile: 95 })])).toEqual({ state: "done", time_s: 60 });
  });
});
