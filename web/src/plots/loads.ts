import type { Channel, ModelInfo } from "../engine/engine";
import type { PlotKind, Quantity } from "./quantities";

const PER_THOUSAND = 1e-3;
/** Shown by the thousand. */
const BY_THE_THOUSAND = ["N", "N m", "J"];
const COLOURS = ["roll", "pitch", "yaw"] as const;
/** Columns that fit into one figure. */
const MOST = COLOURS.length;

/** What joints and loops carry, and whatever the engine's elements show: a figure for each thing, variable and unit. */
export function loadsOf(model: ModelInfo, channels: Channel[]): PlotKind[] {
  const labels = (variable: string) => channels.find((channel) => channel.variable === variable)?.labels[0] ?? [];
  const afloat = new Set(model.bodies.filter(({ floats }) => floats).map(({ name }) => name));
  const floating = new Set(model.joints.filter(({ body }) => afloat.has(body)).map(({ name }) => name));
  const others = channels.filter(({ of_elements }) => of_elements);
  return [
    ...labels("joint_reaction").filter((name) => !floating.has(name)).map((name) => carried(name, "joint_reaction")),
    ...labels("loop_reaction").map((name) => carried(name, "loop_reaction")),
    ...others.flatMap(ofThings),
  ];
}

/** The length of the force in a joint or a loop: of a hanging load's joint the hook load. */
function carried(name: string, variable: string): PlotKind {
  const column = `${name}.${variable}.force`;
  const lengthOf = ["x", "y", "z"].map((axis) => `${column}_${axis}`);
  return figure(`${name}: force carried`, "N", [{ key: "plain", label: "Force", column, lengthOf }]);
}

/** Of a variable a figure for each thing, and of forces and moments one for each unit. */
function ofThings(channel: Channel): PlotKind[] {
  const [things, components = [""]] = channel.labels;
  return things.flatMap((thing, at) => {
    const own = components.map((component, k) => ({ component, place: at * components.length + k }));
    const units = [...new Set(own.map(({ place }) => channel.units[place]))];
    return units.flatMap((unit) => {
      const columns = own.filter(({ place }) => channel.units[place] === unit).slice(0, MOST);
      const what = `${thing}: ${channel.long_name}`;
      const quantities = columns.map(({ component, place }, i): Quantity => ({
        key: columns.length === 1 ? "plain" : COLOURS[i],
        label: component === "" ? channel.long_name : component.replaceAll("_", " "),
        column: channel.columns[place],
      }));
      return [figure(units.length > 1 ? `${what} (${shown(unit)})` : what, unit, quantities)];
    });
  });
}

function shown(unit: string): string {
  return BY_THE_THOUSAND.includes(unit) ? `k${unit}` : unit;
}

function figure(title: string, unit: string, quantities: Quantity[]): PlotKind {
  if (unit === "rad") return { title, quantities, units: { deg: "°", rad: "rad" }, turns: true, wraps: false };
  const scale = BY_THE_THOUSAND.includes(unit) ? PER_THOUSAND : undefined;
  return { title, quantities, units: { deg: shown(unit), rad: shown(unit) }, turns: false, scale, wraps: false };
}
