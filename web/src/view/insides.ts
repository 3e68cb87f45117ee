import { FrontSide, Material, Mesh } from "three";
import type { Object3D } from "three";
import type { ModelInfo } from "../engine/engine";
import { Place } from "./craft/place";
import type { Role } from "./craft/roles";
import type { Box, Vec3 } from "./fit";
import { vec3 } from "./fit";

/** Opacity of a hull whose inside is shown. */
const GLASS = 0.32;
/** Slack with which a body counts as inside a hull, m. */
const SLACK_M = 0.05;
/** Order of drawing: after opaque bodies, before the sea. */
const BEFORE_THE_SEA = -0.5;

/** Bodies inside hulls. */
export interface Insides {
  /** Hulls that are seen through: they carry tanks or moving bodies that the scenario's plots show. */
  glass: ReadonlySet<number>;
  /** Weights that are fixed inside hulls. */
  weights: ReadonlySet<number>;
  /** Liquids in tanks. */
  liquids: ReadonlySet<number>;
}

/** Finds what is inside hulls, from the boxes around the bodies and their poses at the start. */
export function insidesOf(model: ModelInfo, roles: readonly Role[], boxes: readonly Box[], poses: ArrayLike<number>): Insides {
  const indexOf = (name: string) => model.bodies.findIndex((body) => body.name === name);
  const isShown = subjectsOf(model);
  const glass = new Set(model.tanks.flatMap(({ name, body }) => (isShown(name) ? [indexOf(body)] : [])));
  const liquids = new Set(model.tanks.map(({ name }) => indexOf(name)));
  const weights = new Set<number>();
  model.bodies.forEach(({ name, parent }, i) => {
    const hull = indexOf(parent);
    if (roles[hull] !== "hull" || liquids.has(i) || !isWithin(boxes, poses, i, hull)) return;
    if (roles[i] === "tank") weights.add(i);
    else if (isShown(name)) glass.add(hull);
  });
  return { glass, weights, liquids };
}

/**
 * Returns whether a tank or a body is a subject of the scenario: a plot that it names shows it or its joint. Without plots
 * everything is.
 */
function subjectsOf({ view, joints }: ModelInfo): (name: string) => boolean {
  const columns = view.plots.flat();
  const isNamed = (name: string) => columns.some((column) => column.startsWith(`${name}.`));
  return (name) => columns.length === 0 || isNamed(name) || joints.some((joint) => joint.body === name && isNamed(joint.name));
}

/** Whether the top and the middle of a body are inside the box of another one. */
function isWithin(boxes: readonly Box[], poses: ArrayLike<number>, body: number, hull: number): boolean {
  const { low, high } = boxes[hull];
  const top: Vec3 = [0, 0, boxes[body].high[2]];
  return [vec3(() => 0), top].every((point) => {
    const at = new Place(poses, hull).toBody(new Place(poses, body).toWorld(point));
    return at.every((value, k) => value > low[k] - SLACK_M && value < high[k] + SLACK_M);
  });
}

/**
 * Makes a body see-through. Only its nearest faces are drawn: a first pass writes their depth, the second their colour.
 */
export function seeThrough(body: Object3D): void {
  const meshes: Mesh[] = [];
  body.traverse((part) => part instanceof Mesh && meshes.push(part));
  for (const mesh of meshes) {
    const material = mesh.material as Material;
    const depth = new Mesh(mesh.geometry, material.clone());
    depth.material.colorWrite = false;
    depth.material.side = FrontSide;
    depth.renderOrder = BEFORE_THE_SEA - 0.1;
    Object.assign(material, { transparent: true, opacity: GLASS, depthWrite: false });
    Object.assign(depth.material, { transparent: true });
    mesh.renderOrder = BEFORE_THE_SEA;
    mesh.castShadow = false;
    mesh.parent!.add(depth);
  }
}
