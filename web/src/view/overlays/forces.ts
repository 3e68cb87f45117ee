import type { Run } from "../../app/session";
import type { Moment } from "../../app/recording/recording";
import type { Channel } from "../../engine/engine";
import { pointsOf } from "../craft/anchors";
import { Place } from "../craft/place";
import { rolesOf } from "../craft/roles";
import type { Vec3 } from "../fit";
import { vec3 } from "../fit";

/** A force or a moment with its point of action, world frame, N or N m. */
export interface Load {
  at: Vec3;
  vector: Vec3;
  unit: "N" | "N m";
}

const AXES = ["x", "y", "z"] as const;

/**
 * Returns the forces that can be drawn at their points of action: weights of the bodies that ships carry, tensions of
 * lines, thrusts of tubes, forces of the water on a hull, and force and moment in the joint below a crane's column.
 */
export function loadsAt(run: Run, moment: Moment): Load[] {
  return [...weights(run, moment), ...tensions(run, moment), ...onHulls(run, moment), ...underColumns(run, moment)].filter(({ vector }) => vector.every(Number.isFinite));
}

/** Returns the weights of all bodies except hulls and quays: a ship's weight would dwarf the weights on the crane. */
function weights({ model }: Run, { poses }: Moment): Load[] {
  const roles = rolesOf(model);
  return model.bodies.flatMap(({ mass_kg }, i): Load[] => {
    if (roles[i] === "hull" || roles[i] === "quay" || model.gravity_m_s2 === 0) return [];
    return [{ at: new Place(poses, i).toWorld([0, 0, 0]), vector: [0, 0, -mass_kg * model.gravity_m_s2], unit: "N" }];
  });
}

/**
 * Returns the forces along lines: a single force with the name of a line pulls at both ends; with the name of a tube it
 * pushes.
 */
function tensions({ lines, channels }: Run, { row, line_points }: Moment): Load[] {
  const places = pointsOf({ lines, line_points });
  return lines.flatMap((line, i): Load[] => {
    const at = forceOf(channels, line.name);
    const own = places[i];
    if (at < 0 || own.length < 2 || line.style === "rod") return [];
    const force = row[at];
    const end = lines.findIndex((one) => one.name === line.name && one.style === "rod");
    const far = end < 0 ? own : places[end];
    const sign = line.style === "line" ? 1 : -1;
    const pull = (from: Vec3, to: Vec3): Load => ({ at: from, vector: along(from, to, sign * force), unit: "N" });
    return [pull(own[0], own[1]), pull(far[far.length - 1], far[far.length - 2])];
  });
}

/** Returns the column with the scalar force of an element. */
function forceOf(channels: readonly Channel[], name: string): number {
  const channel = channels.find(({ unit, labels }) => unit === "N" && labels.length === 1 && labels[0].includes(name));
  return channel ? channel.offset + channel.labels[0].indexOf(name) : -1;
}

function along(from: Vec3, to: Vec3, length: number): Vec3 {
  const way = vec3((k) => to[k] - from[k]);
  const distance = Math.hypot(...way) || 1;
  return vec3((k) => (way[k] * length) / distance);
}

/** Returns the forces of the water on hulls, at the origin of the hull. */
function onHulls({ model, channels }: Run, { row, poses }: Moment): Load[] {
  return model.hulls.flatMap((hull) => {
    const body = model.bodies.findIndex(({ name }) => name === hull.body);
    const place = new Place(poses, body);
    return channels.flatMap((channel): Load[] => {
      const thing = channel.labels[0]?.indexOf(hull.name) ?? -1;
      if (thing < 0 || !channel.of_elements) return [];
      const force = vectorIn(channel, thing, "force_", row);
      return force ? [{ at: place.toWorld(hull.origin_m), vector: inWorld(force, channel.frame, poses, body), unit: "N" }] : [];
    });
  });
}

/**
 * Returns the force and the moment that the joint below a column exerts on the foot of the column; the moment is in the
 * axes of the column.
 */
function underColumns({ model, channels }: Run, { row, poses }: Moment): Load[] {
  const channel = channels.find(({ variable }) => variable === "joint_reaction");
  const roles = rolesOf(model);
  return roles.flatMap((role, i): Load[] => {
    const { shape, name } = model.bodies[i];
    const joint = model.joints.find((one) => one.body === name);
    if (role !== "column" || !channel || !joint || shape?.kind !== "cylinder") return [];
    const thing = channel.labels[0].indexOf(joint.name);
    const at = new Place(poses, i).toWorld([0, 0, -shape.length_m / 2]);
    const turned = (vector: Vec3) => inWorld(vector, "body", poses, i);
    const [force, torque] = [vectorIn(channel, thing, "force_", row), vectorIn(channel, thing, "moment_", row)];
    return [...(force ? [{ at, vector: turned(force), unit: "N" as const }] : []), ...(torque ? [{ at, vector: turned(torque), unit: "N m" as const }] : [])];
  });
}

function vectorIn({ labels, offset }: Channel, thing: number, prefix: string, row: ArrayLike<number>): Vec3 | null {
  const components = labels[1];
  if (thing < 0 || !components) return null;
  const places = AXES.map((axis) => components.indexOf(prefix + axis));
  if (places.some((at) => at < 0)) return null;
  return vec3((k) => row[offset + thing * components.length + places[k]]);
}

/**
 * Transforms a vector to the world frame: body axes by the full rotation, a slow frame or a heading frame only by the
 * ship's course.
 */
function inWorld(vector: Vec3, frame: Channel["frame"], poses: ArrayLike<number>, body: number): Vec3 {
  if (frame === "world") return vector;
  const place = new Place(poses, body);
  const middle = place.toWorld([0, 0, 0]);
  if (frame === "body") return minus(place.toWorld(vector), middle);
  const ahead = minus(place.toWorld([1, 0, 0]), middle);
  const course = Math.atan2(ahead[1], ahead[0]);
  const [c, s] = [Math.cos(course), Math.sin(course)];
  return [c * vector[0] - s * vector[1], s * vector[0] + c * vector[1], vector[2]];
}

function minus(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}
