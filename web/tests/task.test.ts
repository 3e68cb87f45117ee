import { describe, expect, it } from "vitest";
import type { LimitInfo } from "../src/engine/engine";
import type { Happened } from "../src/engine/messages";
import { LimitTrack } from "../src/instruments/limits";
import { outcomeAt } from "../src/instruments/task";
import type { Session } from "../src/app/session";
import { openedDirectly } from "./direct";
import { initEngine } from "./gallery";

await initEngine();

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

/** Moves a lever, and runs for a number of seconds. */
async function hold(session: Session, lever: string, value: number, seconds: number): Promise<void> {
  await session.setInput(lever, value);
  session.start();
  const end_s = session.shown.time_s + seconds;
  while (session.shown.time_s < end_s - 1e-9) await session.advance(Math.min(0.25, end_s - session.shown.time_s));
  session.pause();
}

/** Lifts the box from the deck over the mark by the levers, and lowers it at a rate of the drum, rad/s, until it stands, with a slack rope. */
async function lift(lowering_rad_s: number) {
  const session = await openedDirectly("quayside_lift");
  const { model, columns } = session.run!;
  const moves: [string, number, number][] = [["hoist", 0, 20], ["hoist", -1.5, 15], ["hoist", 0, 6], ["slewing_gear", -0.0523, 30], ["slewing_gear", 0, 24]];
  for (const [lever, value, seconds] of moves) await hold(session, lever, value, seconds);
  const stands = () => columns.read(session.shown.moment!.row, "on_quay.contact_normal_force") > 3e4;
  for (let k = 0; k < 60 && !stands(); k++) await hold(session, "hoist", lowering_rad_s, 1);
  await hold(session, "hoist", 0.4, 3);
  await hold(session, "hoist", 0, 5);
  const { rows, events } = session.shown.recording!;
  const tracks = model.limits.map((limit) => new LimitTrack(limit, columns.at(limit.column)));
  for (const { time_s, row } of rows.items) tracks.forEach((track) => track.see(time_s, row));
  return outcomeAt(session.shown.time_s, columns.read(session.shown.moment!.row, "task.operation_step"), events, tracks);
}

describe("the lift from the deck to the quay by hand", () => {
  it("is won by a box that is lowered gently on the mark, and lost by one that is dropped on it", async () => {
    expect(await lift(0.8)).toMatchObject({ state: "done" });
    expect(await lift(2)).toMatchObject({ state: "failed", limit: "touch" });
  });
});
