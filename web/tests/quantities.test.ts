import { describe, expect, it } from "vitest";
import type { Channel, ModelInfo } from "../src/engine/engine";
import { decimalsOf, kindsOf, scaleOf } from "../src/plots/quantities";

function channel(variable: string, labels: string[], unit: string): Channel {
  const dims = variable.startsWith("point") ? ["point", "axis"] : ["coordinate"];
  return { variable, long_name: "", unit, frame: "none", dims, labels: [labels], offset: 0, len: labels.length };
}

function model(joints: ModelInfo["joints"]): ModelInfo {
  const bodies = joints.map(({ body }) => ({ name: body, parent: "world", shape: null, colour: null, mass_kg: 1 }));
  const settings = { duration_s: 1, step_s: 0.1, record_every_s: 0.1, integrator: "rk4" };
  return { title: "", description: "", ...settings, bodies, joints, loops: [], cylinders: [], sea: null, hulls: [], parameters: [] };
}

const SHIP = { name: "ship", body: "ship", kind: "floating" } as const;
const SLEW = { name: "slew", body: "tower", kind: "revolute" } as const;
const TELESCOPE = { name: "telescope", body: "tube", kind: "prismatic" } as const;

describe("what the figures can show", () => {
  it("begins with the ship, then has every joint coordinate and point", () => {
    const channels = [
      channel("joint_position", ["slew", "telescope"], "rad or m"),
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
    const { angles } = kindsOf(model([SHIP, SLEW, TELESCOPE]), [channel("joint_position", ["slew", "telescope"], "rad or m")]);
    const [, slew, telescope] = angles;
    expect([slew.units.deg, telescope.units.deg]).toEqual(["°", "m"]);
    expect([scaleOf(slew, "deg"), scaleOf(telescope, "deg")]).toEqual([180 / Math.PI, 1]);
    expect([decimalsOf(slew, "rad"), decimalsOf(telescope, "rad")]).toEqual([5, 4]);
  });

  it("knows which axes of a joint of several slide", () => {
    const beam = { name: "boom.1", body: "boom.1", kind: "elastic" } as const;
    const { angles } = kindsOf(model([beam]), [channel("joint_position", ["boom.1.shear_z", "boom.1.bending_y"], "rad or m")]);
    expect(angles.slice(1).map(({ units }) => units.rad)).toEqual(["m", "rad"]);
  });

  it("has the heave of each hull beside the wave, from its draught at rest", () => {
    const hull = { name: "water", body: "ship", origin_m: [0, 0, 1.5] as [number, number, number], draught_m: 2, length_m: 20, beam_m: 4, mesh: null };
    const { angles } = kindsOf({ ...model([SHIP, SLEW]), hulls: [hull] }, []);
    expect(angles.map(({ title }) => title)).toEqual(["Angles of ship", "Heave of ship"]);
    expect(angles[1].quantities.map(({ column, offset }) => [column, offset ?? 0])).toEqual([["ship.position.z", 1.5], ["water.wave_elevation", 0]]);
    expect([angles[1].units.deg, angles[1].turns]).toEqual(["m", false]);
    const alone = kindsOf({ ...model([SHIP]), hulls: [hull] }, []);
    expect(alone.angles.map(({ title }) => title)).toEqual(["Heave of ship", "Angles of ship"]);
  });

  it("has the hook load, tensions and the loads of sea and wind, in kN", () => {
    const labelled = (variable: string, thing: string): Channel => ({ ...channel(variable, [thing], "N"), dims: [thing] });
    const channels = [
      { ...channel("joint_reaction", ["ship", "pendant"], "N, N m"), dims: ["joint", "component"] },
      labelled("line_tension", "bow"),
      labelled("excitation_force", "water"),
      labelled("flow_force", "gale"),
      { ...channel("station_force", ["dp"], "N, N m"), dims: ["station", "planar"] },
      { ...channel("thruster_thrust", ["dp.bow"], "N"), dims: ["thruster"] },
    ];
    const hull = { name: "water", body: "ship", origin_m: [0, 0, 1.5] as [number, number, number], draught_m: 2, length_m: 20, beam_m: 4, mesh: null };
    const { rates } = kindsOf({ ...model([SHIP, SLEW]), hulls: [hull] }, channels);
    expect(rates.slice(1).map(({ title, units }) => [title, units.deg])).toEqual([
      ["pendant: force carried", "kN"],
      ["bow: tension", "kN"],
      ["Wave force on ship", "kN"],
      ["Wave moment on ship", "kN m"],
      ["dp: force of the thrusters", "kN"],
      ["dp.bow: thrust", "kN"],
      ["gale: force", "kN"],
      ["gale: moment", "kN m"],
    ]);
    const [, hook, bow, wave] = rates;
    expect(rates.slice(-4, -2).flatMap(({ quantities }) => quantities.map(({ column }) => column))).toEqual(
      ["dp.station_force.surge", "dp.station_force.sway", "dp.bow.thruster_thrust"],
    );
    expect(hook.quantities[0].lengthOf).toEqual(["x", "y", "z"].map((axis) => `pendant.joint_reaction.force_${axis}`));
    expect(bow.quantities.map(({ column }) => column)).toEqual(["bow.line_tension", "bow.line_end_tension"]);
    expect(wave.quantities[2].column).toBe("water.excitation_force.force_z");
    expect([scaleOf(hook, "deg"), decimalsOf(hook, "deg")]).toEqual([1e-3, 2]);
  });

  it("shows the first body where none floats", () => {
    const { rates } = kindsOf(model([SLEW]), []);
    expect(rates.map(({ title }) => title)).toEqual(["Rates of tower"]);
  });
});
