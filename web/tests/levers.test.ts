import { describe, expect, it } from "vitest";
import { placesOf } from "../src/levers/axes";
import { openedDirectly } from "./direct";
import { initEngine } from "./gallery";

await initEngine();

/** The axes of a scenario's inputs, one that goes the other way with a minus. */
async function placesIn(scenario: string, overrides = {}): Promise<Record<string, string>> {
  const session = await openedDirectly(scenario, overrides);
  expect(session.fault).toBeNull();
  const places = placesOf(session.run!, session.shown.moment!.poses);
  return Object.fromEntries(Object.entries(places).filter(([, place]) => place).map(([axis, place]) => [axis, `${place.reversed ? "-" : ""}${place.input}`]));
}

describe("the axes of the sticks", () => {
  it.each([
    ["quayside_lift", {}, { left_x: "-slewing_gear", left_y: "-main_luffing", right_x: "-knuckle_luffing", right_y: "hoist" }],
    ["container_to_quay", { timeline: false }, { left_x: "-slewing", right_y: "hoist" }],
    ["lowering_by_winch", {}, { right_y: "hoist" }],
    ["a_frame_over_the_stern", { timeline: false }, { left_y: "-luff_port", right_x: "-luff_starboard", right_y: "hoist" }],
    ["container_to_quay", {}, {}],
    ["loss_of_hook_load", { timeline: false }, {}],
    ["paper", {}, {}],
  ])("are those of what the inputs move: %s, %j", async (scenario, overrides, places) => {
    expect(await placesIn(scenario, overrides)).toEqual(places);
  });
});
