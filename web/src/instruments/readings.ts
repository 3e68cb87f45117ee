import type { Channel, ModelInfo } from "../engine/engine";

/**
 * Readings for a crane operator, selected by the end of the variable's name: tensions of ropes, angles, crane capacity,
 * gaps, drives, wind and waves.
 */
const READ = [
  "_tension", "_offlead", "_sidelead", "_daf", "load_radius", "rated_load",
  "hook_load", "clearance", "air_gap", "_utilisation",
  "wave_elevation", "wind_speed", "wind_direction",
];
/** Displayed unit of an SI unit, and the factor from the SI unit to it. */
export const SHOWN: Record<string, [string, number]> = { N: ["kN", 1e-3], kg: ["t", 1e-3], rad: ["°", 180 / Math.PI], "1": ["", 1] };

/** Length of the past over which the range of a motion is shown, s. */
export const RANGE_S = 60;

/** A reading: a column of the results with its name and unit. */
export interface Reading {
  /** Element, body or point to which the reading belongs. */
  thing: string;
  label: string;
  column: string;
  unit: string;
}

/** Returns the readings for a crane operator, element by element. */
export function readingsOf(channels: readonly Channel[]): Reading[] {
  const scalar = channels.filter(({ of_elements, labels }) => of_elements && labels.length === 1);
  return scalar
    .filter(({ variable }) => READ.some((ending) => variable.endsWith(ending)))
    .flatMap(({ variable, labels, long_name, description, columns, units }) => {
      const alike = scalar.some((other) => other.variable !== variable && other.long_name === long_name);
      const label = alike ? `${withoutThing(long_name)}${description.replace(long_name, "")}` : withoutThing(long_name);
      return labels[0].map((thing, k) => ({ thing, label, column: columns[k], unit: units[k] }));
    });
}

/** Leaves out of a description the words that follow from its element: "tension of a line" becomes "tension". */
function withoutThing(long_name: string): string {
  return long_name.replace(/ (of|from|above|that) .*$/, "");
}

/** A named point whose heave is shown. */
export interface PointReading {
  name: string;
  height: string;
  speed: string;
}

/** Returns the named points of bodies that move. */
export function pointsOf(channels: readonly Channel[]): PointReading[] {
  const of = (variable: string) => channels.find((channel) => channel.variable === variable);
  const [position, velocity] = [of("point_position"), of("point_velocity")];
  if (!position || !velocity) return [];
  const vertical = position.labels[1].indexOf("z");
  const width = position.labels[1].length;
  return position.labels[0].map((name, k) => ({
    name,
    height: position.columns[k * width + vertical],
    speed: velocity.columns[k * width + vertical],
  }));
}

/** Returns the body of the first hull; null if there is none. */
export function hullBodyOf({ hulls }: ModelInfo): string | null {
  return hulls[0]?.body ?? null;
}
