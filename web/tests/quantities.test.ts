import { describe, expect, it } from "vitest";
import { readModel } from "../src/engine/engine";
import type { Channel, ModelInfo } from "../src/engine/engine";
import { channelOf, FakeEngine } from "./fake";
import { decimalsOf, kindsOf, scaleOf } from "../src/plots/quantities";

function channel(variable: string, labels: string[], ...units: string[]): Channel {
  const [dims, along] = variable.startsWith("point") ? [["point", "axis"], [labels, ["x", "y", "z"]]] : [["coordinate"], [labels]];
  return channelOf(variable, dims, along, units);
}

type Joint = Pick<ModelInfo["joints"][number], "name" | "body" | "kind">;

function model(joints: Joint[]): ModelInfo {
  const described = readModel(new FakeEngine().model_json());
  const bodies = joints.map(({ body, kind }) => ({ ...described.bodies[0], name: body, floats: kind === "floating" }));
  return { ...described, bodies, joints: joints.map((joint) => ({ ...joint, free_coordinates: [], prescribed: [] })) };
}

const SHIP = { name: "ship", body: "ship", kind: "floating" } as const;
const SLEW = { name: "slew", body: "tower", kind: "revolute" } as const;
const TELESCOPE = { name: "telescope", body: "tube", kind: "prismatic" } as const;

describe("what the figures can show", () => {
  it("begins with the ship, then has every joint coordinate and point", () => {
    const channels = [
      channel("joint_position", ["slew", "telescope"], "rad", "m"),
      channel("point_position", ["tube.tip"], "m"),
      channel("point_velocity", ["tube.tip"], "m/s"),
    ];
    const { rates, angles } = kindsOf(model([SHIP, SLEW, TELESCOPE]), channels);
    expect(angles.map(({ title }) => title)).toEqual([
      "Angles of ship",
      "slew: position",
      "telescope: position",
      "tube.tip: position",
    ]);
    expect(rates.map(({ title }) => title)).toEqual([
      "Rates of ship",
      "slew: rate",
      "telescope: rate",
      "slew: torque",
      "telescope: force",
      "tube.tip: velocity",
    ]);
    expect(angles[3].quantities.map(({ column }) => column)).toEqual(
      ["x", "y", "z"].map((axis) => `tube.tip.point_position.${axis}`),
    );
  });

  it("shows angles in degrees and lengths in metres", () => {
    const { angles } = kindsOf(model([SHIP, SLEW, TELESCOPE]), [channel("joint_position", ["slew", "telescope"], "rad", "m")]);
    const [, slew, telescope] = angles;
    expect([slew.units.deg, telescope.units.deg]).toEqual(["°", "m"]);
    expect([scaleOf(slew, "deg"), scaleOf(telescope, "deg")]).toEqual([180 / Math.PI, 1]);
    expect([decimalsOf(slew, "rad"), decimalsOf(telescope, "rad")]).toEqual([5, 4]);
  });

  it("knows which axes of a joint of several slide", () => {
    const beam = { name: "boom.1", body: "boom.1", kind: "elastic" } as const;
    const { angles } = kindsOf(model([beam]), [channel("joint_position", ["boom.1.shear_z", "boom.1.bending_y"], "m", "rad")]);
    expect(angles.slice(1).map(({ units }) => units.rad)).toEqual(["m", "rad"]);
  });

  it("has the heave of each hull beside the wave, from its draught at rest", () => {
    const hull = { name: "water", body: "ship", origin_m: [0, 0, 1.5] as [number, number, number], draught_m: 2, length_m: 20, beam_m: 4, is_linear: true, mesh: null };
    const { angles } = kindsOf({ ...model([SHIP, SLEW]), hulls: [hull] }, []);
    expect(angles.map(({ title }) => title)).toEqual(["Angles of ship", "Heave of ship"]);
    expect(angles[1].quantities.map(({ column, offset }) => [column, offset ?? 0])).toEqual([["ship.position.z", 1.5], ["water.wave_elevation", 0]]);
    expect([angles[1].units.deg, angles[1].turns]).toEqual(["m", false]);
    const alone = kindsOf({ ...model([SHIP]), hulls: [hull] }, []);
    expect(alone.angles.map(({ title }) => title)).toEqual(["Heave of ship", "Angles of ship"]);
  });

  it("has the hook load, tensions and the loads of sea and wind, in kN", () => {
    const wrench = (variable: string, thing: string): Channel =>
      channelOf(variable, [thing, "component"], [[thing], ["force_x", "force_y", "force_z", "moment_x", "moment_y", "moment_z"]], ["N", "N", "N", "N m", "N m", "N m"]);
    const labelled = (variable: string, thing: string): Channel => channelOf(variable, [thing], [[thing]], ["N"]);
    const channels = [
      channelOf("joint_reaction", ["joint", "component"], [["ship", "pendant"], ["force_x", "force_y", "force_z"]], ["N"]),
      labelled("line_tension", "bow"),
      wrench("excitation_force", "water"),
      wrench("flow_force", "gale"),
      channelOf("station_force", ["station", "planar"], [["dp"], ["surge", "sway", "yaw"]], ["N", "N", "N m"]),
      channelOf("thruster_thrust", ["thruster"], [["dp.bow"]], ["N"]),
    ];
    const hull = { name: "water", body: "ship", origin_m: [0, 0, 1.5] as [number, number, number], draught_m: 2, length_m: 20, beam_m: 4, is_linear: true, mesh: null };
    const { rates } = kindsOf({ ...model([SHIP, SLEW]), hulls: [hull] }, channels);
    expect(rates.slice(1).map(({ title, units }) => [title, units.deg])).toEqual([
      ["pendant: force carried", "kN"],
      ["bow: line tension", "kN"],
      ["water: excitation force (kN)", "kN"],
      ["water: excitation force (kN m)", "kN m"],
      ["gale: flow force (kN)", "kN"],
      ["gale: flow force (kN m)", "kN m"],
      ["dp: station force (kN)", "kN"],
      ["dp: station force (kN m)", "kN m"],
      ["dp.bow: thruster thrust", "kN"],
    ]);
    const [, hook, bow, wave] = rates;
    expect(rates.slice(-3).flatMap(({ quantities }) => quantities.map(({ column }) => column))).toEqual(
      ["dp.station_force.surge", "dp.station_force.sway", "dp.station_force.yaw", "dp.bow.thruster_thrust"],
    );
    expect(hook.quantities[0].lengthOf).toEqual(["x", "y", "z"].map((axis) => `pendant.joint_reaction.force_${axis}`));
    expect(bow.quantities.map(({ column }) => column)).toEqual(["bow.line_tension"]);
    expect(wave.quantities[2].column).toBe("water.excitation_force.force_z");
    expect([scaleOf(hook, "deg"), decimalsOf(hook, "deg")]).toEqual([1e-3, 2]);
  });

  it("shows a thing of any kind that the engine has a variable of, in its unit", () => {
    const channels = [channelOf("gripper_opening", ["gripper"], [["claw"]], ["rad"]), channelOf("valve_flow", ["valve"], [["main"]], ["m^3/s"])];
    const { rates } = kindsOf(model([SHIP]), channels);
    expect(rates.slice(1).map(({ title, units, turns }) => [title, units.deg, turns])).toEqual([
      ["claw: gripper opening", "°", true],
      ["main: valve flow", "m^3/s", false],
    ]);
  });

  it("shows the heave of a ship that waves move as a length, and its force in N", () => {
    const names = ["ship.z", "ship.roll"];
    const channels = [channelOf("joint_position", ["coordinate"], [names], ["m", "rad"]), channelOf("joint_force", ["coordinate"], [names], ["N", "N m"])];
    const { rates, angles } = kindsOf(model([{ ...SHIP, kind: "moved_by_waves" }]), channels);
    expect(angles.slice(-2).map(({ units }) => units.deg)).toEqual(["m", "°"]);
    expect(rates.slice(-2).map(({ units }) => units.deg)).toEqual(["N", "N m"]);
  });

  it("shows the first body where none floats", () => {
    const { rates } = kindsOf(model([SLEW]), []);
    expect(rates.map(({ title }) => title)).toEqual(["Rates of tower"]);
  });
});
