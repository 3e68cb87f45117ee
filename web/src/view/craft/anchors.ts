import type { DrawnLine, ModelInfo } from "../../engine/engine";
import type { Box, Vec3 } from "../fit";
import { vec3 } from "../fit";
import { edgesOf } from "../solids";
import { distance, nearestOf, Place } from "./place";
import type { Role } from "./roles";

/** Attachment of a line or link to a body, in body axes. */
export interface Anchor {
  body: number;
  point: Vec3;
  /** Kind of the attached object. */
  kind: "line" | "tube" | "link" | "loop";
  /** Direction of the line or link from the attachment, body axes, not normalised; zero if unknown. */
  towards: Vec3;
  /** Radius of the pin, m. */
  radius: number;
  /** Length of the line or link, m. */
  length: number;
}

/** Sheave over which a line runs. */
export interface Sheave {
  body: number;
  middle: Vec3;
  radius: number;
  /** Axis of the sheave, body axes. */
  axis: Vec3;
}

/** Model, shapes and poses from which attachments are found. */
export interface Scene {
  model: ModelInfo;
  lines: readonly DrawnLine[];
  boxes: readonly Box[];
  roles: readonly Role[];
  poses: ArrayLike<number>;
  line_points: ArrayLike<number>;
}

/** Largest distance of a link's end from its body, relative to the length of the link. */
const LINK_REACH = 0.5;
/**
 * Largest distance of a line's end from a body, relative to the diagonal of the body; an end farther away is on the
 * seabed or on land.
 */
const REACH = 0.5;
/** Smallest angle by which a line turns at a sheave, rad. */
const WRAP = 0.15;

/** Returns the attachments of lines, links and loops to bodies. */
export function anchorsOf(scene: Scene): Anchor[] {
  return [...lineAnchors(scene), ...linkAnchors(scene), ...loopAnchors(scene)];
}

/** Returns the bodies to which a line can be attached: those that its element names, or the two bodies of its joint. */
function bodiesNamed({ model }: Scene, name: string): number[] {
  const joint = model.joints.find((one) => one.name === name);
  const tied = model.bodies.find((one) => one.name === joint?.body);
  const words = (model.elements.find((one) => one.name === name)?.facts ?? []).flatMap(({ value }) => value.split(/[^\w.]+/));
  const named = new Set(tied ? [tied.name, tied.parent] : [...words, ...jointsIn(model, words)]);
  return model.bodies.flatMap((body, i) => (named.has(body.name) ? [i] : []));
}

function jointsIn(model: ModelInfo, words: readonly string[]): string[] {
  return model.joints.filter((joint) => words.includes(joint.name)).map((joint) => joint.body);
}

/** Returns the distance of a position in the world from a body's solid, m. */
export function distanceFrom({ model, boxes, poses }: Scene, body: number, world: Vec3): number {
  const point = new Place(poses, body).toBody(world);
  return distance(point, nearestOf(model.bodies[body], boxes[body], point));
}

function nearestBody(scene: Scene, among: readonly number[], world: Vec3): number {
  const distances = among.map((body) => distanceFrom(scene, body, world));
  return among[distances.indexOf(Math.min(...distances))] ?? -1;
}

/** Returns the points of each line. */
export function pointsOf({ lines, line_points }: Pick<Scene, "lines" | "line_points">): Vec3[][] {
  let from = 0;
  return lines.map(({ points }) => {
    const places = Array.from({ length: points }, (_, i): Vec3 => vec3((k) => line_points[from + 3 * i + k]));
    from += 3 * points;
    return places;
  });
}

/**
 * Returns the attachments of lines and tubes. The barrel and the rod of a cylinder meet each other; only their pins are
 * attached to bodies.
 */
function lineAnchors(scene: Scene): Anchor[] {
  const places = pointsOf(scene);
  return scene.lines.flatMap((line, at) => {
    const among = bodiesNamed(scene, line.name);
    const own = places[at];
    const tie = (world: Vec3, next: Vec3, kind: Anchor["kind"]): Anchor[] => {
      const within = among.filter((body) => distanceFrom(scene, body, world) <= REACH * Math.hypot(...edgesOf(scene.boxes[body])));
      const body = nearestBody(scene, within, world);
      if (body < 0) return [];
      const place = new Place(scene.poses, body);
      const [point, to] = [place.toBody(world), place.toBody(next)];
      const length = own.slice(1).reduce((sum, place, i) => sum + distance(place, own[i]), 0);
      return [{ body, point, kind, radius: line.radius_m, length, towards: [to[0] - point[0], to[1] - point[1], to[2] - point[2]] }];
    };
    if (line.points === 1) return tie(own[0], own[0], "tube");
    if (line.radius_m > 0) return [];
    return [...tie(own[0], own[1], "line"), ...tie(own[own.length - 1], own[own.length - 2], "line")];
  });
}

/** Returns the attachments of both ends of slim links, on the nearest bodies that are not links. */
function linkAnchors(scene: Scene): Anchor[] {
  const { model, roles, poses } = scene;
  return roles.flatMap((role, i) => {
    const { shape } = model.bodies[i];
    if (role !== "link" || shape?.kind !== "cylinder") return [];
    const axis = "xyz".indexOf(shape.axis);
    const others = roles.flatMap((one, k) => (one === "column" || one === "boom" || one === "hull" ? [k] : []));
    return [-1, 1].flatMap((side): Anchor[] => {
      const end = vec3((k) => (k === axis ? (side * shape.length_m) / 2 : 0));
      const world = new Place(poses, i).toWorld(end);
      const body = nearestBody(scene, others, world);
      if (body < 0 || distanceFrom(scene, body, world) > LINK_REACH * shape.length_m) return [];
      return [{ body, point: new Place(poses, body).toBody(world), kind: "link", radius: 1.6 * shape.radius_m, length: shape.length_m, towards: [0, 0, 0] }];
    });
  });
}

function loopAnchors({ model }: Scene): Anchor[] {
  return model.loops.flatMap(({ first, second }) =>
    [first, second].flatMap(({ body, position_m }): Anchor[] => {
      const at = model.bodies.findIndex(({ name }) => name === body);
      return at < 0 ? [] : [{ body: at, point: position_m, kind: "loop", radius: 0, length: 0, towards: [0, 0, 0] }];
    }),
  );
}

/** Returns the sheaves of lines: where a line turns, the circle that is tangent to its two straight parts. */
export function sheavesOf(scene: Scene): Sheave[] {
  return pointsOf(scene).flatMap((all, at) => {
    const line = scene.lines[at];
    if (line.radius_m > 0 || line.points < 4) return [];
    const places = all.filter((place, i) => i === 0 || distance(place, all[i - 1]) > 1e-4);
    return wrapsOf(places).flatMap(({ middle, radius, axis }) => {
      const body = nearestBody(scene, bodiesNamed(scene, line.name), middle);
      if (body < 0) return [];
      const place = new Place(scene.poses, body);
      const [point, tip] = [place.toBody(middle), place.toBody(vec3((k) => middle[k] + axis[k]))];
      return [{ body, middle: point, radius, axis: vec3((k) => tip[k] - point[k]) }];
    });
  });
}

interface Wrap {
  middle: Vec3;
  radius: number;
  axis: Vec3;
}

/** Returns the turns of a polyline between its straight parts, each as a circle. */
function wrapsOf(places: readonly Vec3[]): Wrap[] {
  const ways = places.slice(1).map((place, i) => over(minus(place, places[i]), distance(place, places[i])));
  const turns = ways.slice(1).map((way, i) => Math.acos(Math.min(1, Math.max(-1, inner(way, ways[i])))));
  const wraps: Wrap[] = [];
  for (let i = 0; i < turns.length; i++) {
    if (turns[i] < WRAP) continue;
    let last = i;
    while (last + 1 < turns.length && turns[last + 1] > 1e-3 && last - i < 3) last += 1;
    const wrap = tangentTo(places[i + 1], ways[i], places[last + 1], ways[last + 1]);
    if (wrap) wraps.push(wrap);
    i = last;
  }
  return wraps;
}

/** Returns the circle that is tangent to a line before and after a turn; null if its radius is not that of a sheave. */
function tangentTo(from: Vec3, come: Vec3, to: Vec3, go: Vec3): Wrap | null {
  const along = inner(come, go);
  const normal = (of: Vec3, less: Vec3, sign: number): Vec3 => {
    const way = vec3((k) => sign * (of[k] - along * less[k]));
    return over(way, Math.hypot(...way) || 1);
  };
  const [inFrom, inTo] = [normal(go, come, 1), normal(come, go, -1)];
  const apart = minus(inTo, inFrom);
  const radius = inner(minus(from, to), apart) / Math.max(1e-9, inner(apart, apart));
  if (!(radius > 0.05 && radius < 3)) return null;
  const middle = vec3((k) => from[k] + radius * inFrom[k]);
  const axis: Vec3 = [come[1] * go[2] - come[2] * go[1], come[2] * go[0] - come[0] * go[2], come[0] * go[1] - come[1] * go[0]];
  return { middle, radius, axis: over(axis, Math.hypot(...axis) || 1) };
}

function minus(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function over(a: Vec3, by: number): Vec3 {
  return [a[0] / by, a[1] / by, a[2] / by];
}

function inner(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

