import type { Channel, HullInfo, ModelInfo } from "../engine/engine";
import { loadsOf } from "./loads";

/** One drawn line: what it is called, its colour, which column it comes from. */
export interface Quantity {
  key: "pitch" | "yaw" | "roll" | "plain";
  label: string;
  /** Name of the column; of a length the name of the vector. */
  column: string;
  /** Columns of the vector whose length it is. */
  lengthOf?: string[];
  /** Added to the column, in its unit. */
  offset?: number;
}

/** What one figure can show. */
export interface PlotKind {
  /** As the choice names it. */
  title: string;
  quantities: Quantity[];
  units: Record<Unit, string>;
  /** Whether the columns are in radians and may be shown in degrees. */
  turns: boolean;
  /** Factor from the columns to these units; 1 unless given. */
  scale?: number;
  /** Angles jump from +180 to -180 degrees: no line is drawn there. */
  wraps: boolean;
}

export type Unit = "deg" | "rad";

export type FigureKey = "rates" | "angles";

export const PER_RADIAN: Record<Unit, number> = { deg: 180 / Math.PI, rad: 1 };
const DECIMALS: Record<Unit, number> = { deg: 2, rad: 5 };
const PLAIN_DECIMALS = 4;
const SCALED_DECIMALS = 2;

/** Factor from a column to what is shown. */
export function scaleOf(kind: PlotKind, unit: Unit): number {
  return kind.turns ? PER_RADIAN[unit] : (kind.scale ?? 1);
}

export function decimalsOf(kind: PlotKind, unit: Unit): number {
  return kind.turns ? DECIMALS[unit] : kind.scale ? SCALED_DECIMALS : PLAIN_DECIMALS;
}

/** What each figure can show of a model, the first by default. */
export function kindsOf(model: ModelInfo, channels: Channel[]): Record<FigureKey, PlotKind[]> {
  const labels = (variable: string) => channels.find((channel) => channel.variable === variable)?.labels[0] ?? [];
  const floating = model.bodies.filter(({ floats }) => floats).map(({ name }) => name);
  const bodies = floating.length > 0 ? floating : model.bodies.slice(0, 1).map((body) => body.name);
  const coordinates = labels("joint_position");
  const unitOf = coordinateUnits(channels);
  const [turning, heaving] = [bodies.map(bodyAngles), model.hulls.map(heave)];
  return {
    rates: [
      ...bodies.map(bodyRates),
      ...coordinates.map((name) => coordinate(name, "rate", "joint_velocity", unitOf(name), { m: "m/s", rad: "rad/s", deg: "°/s" })),
      ...coordinates.map((name) => effort(name, unitOf(name))),
      ...loadsOf(model, channels),
      ...labels("point_velocity").map((name) => point(name, "velocity", "m/s")),
    ],
    angles: [
      // A hull by itself heaves; what stands on one turns it.
      ...(model.bodies.length === 1 ? [...heaving, ...turning] : [...turning, ...heaving]),
      ...coordinates.map((name) => coordinate(name, "position", "joint_position", unitOf(name), { m: "m", rad: "rad", deg: "°" })),
      ...labels("point_position").map((name) => point(name, "position", "m")),
    ],
  };
}

/** Whether a coordinate is an angle or a length, by the unit of its column. */
function coordinateUnits(channels: Channel[]): (name: string) => "rad" | "m" {
  const channel = channels.find(({ variable }) => variable === "joint_position");
  return (name) => (channel?.units[channel.labels[0].indexOf(name)] === "m" ? "m" : "rad");
}

function bodyRates(body: string): PlotKind {
  return {
    title: `Rates of ${body}`,
    quantities: [
      { key: "pitch", label: "Pitch", column: `${body}.angular_velocity.y` },
      { key: "yaw", label: "Yaw", column: `${body}.angular_velocity.z` },
      { key: "roll", label: "Roll", column: `${body}.angular_velocity.x` },
    ],
    units: { deg: "°/s", rad: "rad/s" },
    turns: true,
    wraps: false,
  };
}

function bodyAngles(body: string): PlotKind {
  return {
    title: `Angles of ${body}`,
    quantities: [
      { key: "pitch", label: "Pitch", column: `${body}.pitch` },
      { key: "yaw", label: "Yaw", column: `${body}.yaw` },
      { key: "roll", label: "Roll", column: `${body}.roll` },
    ],
    units: { deg: "°", rad: "rad" },
    turns: true,
    wraps: true,
  };
}

/** Rise of a hull's centre of mass above its place at the draught of its data, beside the wave. */
function heave({ name, body, origin_m }: HullInfo): PlotKind {
  return {
    title: `Heave of ${body}`,
    quantities: [
      { key: "pitch", label: "Heave", column: `${body}.position.z`, offset: origin_m[2] },
      { key: "yaw", label: "Wave", column: `${name}.wave_elevation` },
    ],
    units: { deg: "m", rad: "m" },
    turns: false,
    wraps: false,
  };
}

function coordinate(name: string, what: string, variable: string, unit: "rad" | "m", units: Record<"m" | Unit, string>): PlotKind {
  const turns = unit === "rad";
  return {
    title: `${name}: ${what}`,
    quantities: [{ key: "plain", label: what, column: `${name}.${variable}` }],
    units: turns ? { deg: units.deg, rad: units.rad } : { deg: units.m, rad: units.m },
    turns,
    wraps: false,
  };
}

function effort(name: string, unit: "rad" | "m"): PlotKind {
  const [what, shown] = unit === "rad" ? ["torque", "N m"] : ["force", "N"];
  return {
    title: `${name}: ${what}`,
    quantities: [{ key: "plain", label: what, column: `${name}.joint_force` }],
    units: { deg: shown, rad: shown },
    turns: false,
    wraps: false,
  };
}

function point(name: string, what: "position" | "velocity", unit: string): PlotKind {
  return {
    title: `${name}: ${what}`,
    quantities: (["roll", "pitch", "yaw"] as const).map((key, i) => {
      const axis = "xyz"[i];
      return { key, label: axis, column: `${name}.point_${what}.${axis}` };
    }),
    units: { deg: unit, rad: unit },
    turns: false,
    wraps: false,
  };
}
