import type { Channel, ModelInfo } from "../engine/engine";
import type { PlotKind, Quantity } from "./quantities";

const PER_THOUSAND = 1e-3;

/** What of the sea, the wind and the current acts on a hull, by its channel. */
const ON_HULLS: Record<string, string> = {
  excitation_force: "Wave",
  drift_force: "Wave drift",
  radiation_force: "Radiation",
};

/** The loads that a model has channels for: what joints, loops, cylinders and lines carry, what thrusters, water and wind do, kN and kN m. */
export function loadsOf(model: ModelInfo, channels: Channel[]): PlotKind[] {
  const labels = (variable: string) => channels.find((channel) => channel.variable === variable)?.labels[0] ?? [];
  const floating = new Set(model.joints.filter((joint) => joint.kind === "floating").map((joint) => joint.name));
  const bodyOf = (hull: string) => model.hulls.find(({ name }) => name === hull)?.body ?? hull;
  return [
    ...labels("joint_reaction").filter((name) => !floating.has(name)).map((name) => carried(name, "joint_reaction")),
    ...labels("loop_reaction").map((name) => carried(name, "loop_reaction")),
    ...labels("cylinder_force").map((name) => load(`${name}: force`, "kN", [{ key: "plain", label: "Push", column: `${name}.cylinder_force` }])),
    ...labels("line_tension").map(tension),
    ...Object.entries(ON_HULLS).flatMap(([variable, what]) =>
      labels(variable).flatMap((name) => wrench((part) => `${what} ${part} on ${bodyOf(name)}`, `${name}.${variable}`)),
    ),
    ...labels("station_force").map((name) =>
      load(`${name}: force of the thrusters`, "kN", [
        { key: "roll", label: "Surge", column: `${name}.station_force.surge` },
        { key: "pitch", label: "Sway", column: `${name}.station_force.sway` },
      ]),
    ),
    ...labels("thruster_thrust").map((name) => load(`${name}: thrust`, "kN", [{ key: "plain", label: "Thrust", column: `${name}.thruster_thrust` }])),
    ...labels("flow_force").flatMap((name) => wrench((part) => `${name}: ${part}`, `${name}.flow_force`)),
  ];
}

/** The length of the force in a joint or a loop: of a hanging load's joint the hook load. */
function carried(name: string, variable: string): PlotKind {
  const column = `${name}.${variable}.force`;
  const lengthOf = ["x", "y", "z"].map((axis) => `${column}_${axis}`);
  return load(`${name}: force carried`, "kN", [{ key: "plain", label: "Force", column, lengthOf }]);
}

function tension(name: string): PlotKind {
  return load(`${name}: tension`, "kN", [
    { key: "pitch", label: "First end", column: `${name}.line_tension` },
    { key: "yaw", label: "Second end", column: `${name}.line_end_tension` },
  ]);
}

function wrench(title: (part: string) => string, column: string): PlotKind[] {
  return [["force", "kN"], ["moment", "kN m"]].map(([part, unit]) =>
    load(title(part), unit, (["roll", "pitch", "yaw"] as const).map((key, i) => ({ key, label: "xyz"[i], column: `${column}.${part}_${"xyz"[i]}` }))),
  );
}

function load(title: string, unit: string, quantities: Quantity[]): PlotKind {
  return { title, quantities, units: { deg: unit, rad: unit }, turns: false, scale: PER_THOUSAND, wraps: false };
}
