import { describe, expect, it } from "vitest";
import { readingsOf } from "../src/instruments/readings";
import { channelOf } from "./fake";

const named = (variable: string, thing: string, long_name: string, unit: string) => ({ ...channelOf(variable, ["thing"], [[thing]], [unit]), long_name });

describe("readings", () => {
  it("a crane's radius, rated load, hook load and utilisation have the name of its rope", () => {
    const channels = [
      named("load_radius", "hoist", "radius of a crane", "m"),
      named("rated_load", "hoist", "rated load of a crane", "kg"),
      named("hook_load", "hoist", "hook load of a crane", "kg"),
      named("load_utilisation", "hoist", "utilisation of a crane", "1"),
    ];
    expect(readingsOf(channels)).toEqual([
      { thing: "hoist", label: "radius", column: "hoist.load_radius", unit: "m" },
      { thing: "hoist", label: "rated load", column: "hoist.rated_load", unit: "kg" },
      { thing: "hoist", label: "hook load", column: "hoist.hook_load", unit: "kg" },
      { thing: "hoist", label: "utilisation", column: "hoist.load_utilisation", unit: "1" },
    ]);
  });

  it("distinguishes readings of one name by their descriptions", () => {
    const tension = (variable: string, where: string) => ({ ...named(variable, "hoist", "tension of a rope", "N"), description: `tension of a rope ${where}` });
    const channels = [tension("rope_tension", "at its last end"), tension("rope_first_tension", "at its first end")];
    expect(readingsOf(channels).map(({ label }) => label)).toEqual(["tension at its last end", "tension at its first end"]);
  });

  it("readings include the speed and direction of the wind, but no flow speed", () => {
    const channels = [
      named("flow_speed", "wind_on_hull", "speed of the wind or current that acts", "m/s"),
      named("wind_speed", "hull", "wind speed", "m/s"),
      named("mean_wind_speed", "hull", "mean wind speed", "m/s"),
      named("wind_direction", "hull", "wind direction from where it blows", "rad"),
    ];
    expect(readingsOf(channels).map(({ label, column }) => [label, column])).toEqual([
      ["wind speed", "hull.wind_speed"],
      ["mean wind speed", "hull.mean_wind_speed"],
      ["wind direction", "hull.wind_direction"],
    ]);
  });
});
