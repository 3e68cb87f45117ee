import { describe, expect, it } from "vitest";
import { placesOf } from "../src/levers/axes";
import { placed } from "../src/levers/dialog";
import { namesOf } from "../src/levers/names";
import { Lever, withoutDeadZone } from "../src/levers/lever";
import { openedDirectly } from "./direct";
import { initEngine } from "./gallery";

await initEngine();

/** Returns the inputs on the axes of a scenario; a minus marks a reversed axis. */
async function placesIn(scenario: string, overrides = {}): Promise<Record<string, string>> {
  const session = await openedDirectly(scenario, overrides);
  expect(session.fault).toBeNull();
  const places = placesOf(session.run!, session.shown.moment!.poses);
  return Object.fromEntries(Object.entries(places).filter(([, place]) => place).map(([axis, place]) => [axis, `${place.reversed ? "-" : ""}${place.input}`]));
}

describe("axes of the sticks", () => {
  it.each([
    ["quayside_lift", {}, { left_x: "-slewing_gear", left_y: "-main_luffing", right_x: "-knuckle_luffing", right_y: "hoist" }],
    ["container_to_quay", { timeline: false }, { left_x: "-slewing", right_y: "hoist" }],
    ["lowering_by_winch", {}, { right_y: "hoist" }],
    ["a_frame_over_the_stern", { timeline: false }, { left_y: "-luff_port", right_x: "-luff_starboard", right_y: "hoist" }],
    ["container_to_quay", {}, {}],
    ["loss_of_hook_load", { timeline: false }, {}],
    ["paper", {}, {}],
  ])("inputs are assigned to axes by the motion that they cause: %s, %j", async (scenario, overrides, places) => {
    expect(await placesIn(scenario, overrides)).toEqual(places);
  });
});

/** Returns the lever of an input on its default axis. */
async function leverOf(scenario: string, name: string, overrides = {}) {
  const session = await openedDirectly(scenario, overrides);
  const { run, shown } = session;
  const [axis, place] = Object.entries(placesOf(run!, shown.moment!.poses)).find(([, one]) => one?.input === name)!;
  const lever = new Lever(axis as "left_x", place, run!.inputs.find((input) => input.name === name)!, run!);
  return { session, lever };
}

describe("a lever", () => {
  it("a lever has a dead zone in the middle, full deflection at its ends, and coarse steps", () => {
    expect([0, 0.05, -0.08, 1, -1.7].map(withoutDeadZone)).toEqual([0, 0, 0, 1, -1]);
    expect(withoutDeadZone(0.54)).toBeCloseTo(0.5, 9);
    expect(withoutDeadZone(0.541)).toBe(withoutDeadZone(0.54));
  });

  it("a lever maps its deflection to the range of its input, reversed if the axis is reversed", async () => {
    const { lever } = await leverOf("quayside_lift", "hoist");
    lever.take("thumb", -0.5);
    expect(lever.value).toBe(-1);
    expect(lever.deflectionOf(-1)).toBe(-0.5);
    const { lever: slew } = await leverOf("quayside_lift", "slewing_gear");
    slew.take("keys", 1);
    expect(slew.value).toBeCloseTo((-3 * Math.PI) / 180, 12);
    expect(slew.deflectionOf(slew.value)).toBe(1);
  });

  it("a lever follows the device with the largest deflection, and returns to zero when all release it", async () => {
    const { lever } = await leverOf("quayside_lift", "hoist");
    lever.take("gamepad", 0.2);
    lever.take("keys", -1);
    expect(lever.deflection).toBe(-1);
    lever.take("keys", null);
    expect(lever.deflection).toBe(0.2);
    lever.take("gamepad", null);
    expect([lever.isHeld, lever.value]).toEqual([false, 0]);
  });

  it("a lever for an angle changes it at up to the drive's largest speed, within the bounds of the input", async () => {
    const { lever } = await leverOf("lowering_by_winch", "hoist");
    expect(lever.isPosition).toBe(true);
    lever.take("thumb", 0.5);
    expect(lever.valueAfter(10, 2)).toBeCloseTo(10 + 0.5 * 1.2 * 2, 12);
    expect(lever.valueAfter(lever.input.upper, 2)).toBe(lever.input.upper);
  });

  it("a lever reads the rate of its drive and the reached limits from a row", async () => {
    const { session, lever } = await leverOf("quayside_lift", "hoist");
    const doing = () => lever.drive.doing(session.shown.moment!.row);
    expect(doing()).toMatchObject({ limits: [] });
    await session.setInput("hoist", 2);
    session.start();
    for (let i = 0; i < 40; i++) await session.advance(0.1);
    expect(doing().limits).toEqual(["speed"]);
    expect(doing().share).toBeCloseTo(1, 2);
    expect(lever.drive.unit).toBe("rad/s");
    const { lever: knuckle } = await leverOf("quayside_lift", "knuckle_luffing");
    expect([knuckle.drive.unit, knuckle.drive.greatest]).toEqual(["m/s", 0.05]);
  });
});

it("an input has only one axis, and keeps its direction when it moves to another axis", () => {
  const places = { left_x: { input: "slew", reversed: true }, right_y: { input: "hoist", reversed: false } };
  expect(placed(places, "left_y", "slew")).toEqual({ left_y: { input: "slew", reversed: true }, right_y: places.right_y });
  expect(placed(places, "right_y", "")).toEqual({ left_x: places.left_x });
});

describe("names of inputs", () => {
  it("leaves out the elements of an input unless another one has the same ending", () => {
    const names = (...all: string[]) => [...namesOf(all.map((name) => ({ name }))).values()];
    expect(names("slewing_gear", "hoist")).toEqual(["slewing gear", "hoist"]);
    expect(names("learned.choice.policy.slewing", "regulator.choice.lqr.slewing", "hoist.drum")).toEqual(["slewing (learned)", "slewing (regulator)", "drum"]);
    expect(names("choice.policy.slewing", "choice.lqr.slewing")).toEqual(["choice policy slewing", "choice lqr slewing"]);
  });
});
