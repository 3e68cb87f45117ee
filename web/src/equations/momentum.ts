import type { BodyInfo, ModelInfo } from "../engine/engine";
import { rotate, vec3 } from "../view/fit";

export type Vector = [number, number, number];
export type Inertia = Vector[];

/** A group of bodies between which no joint moves. The first body carries the others. */
export type Rigid = number[];

/** Divides the bodies of a model into groups between which no joint moves, in the order of their first bodies. */
export function rigidsOf({ bodies, joints }: ModelInfo): Rigid[] {
  const rigids: Rigid[] = [];
  bodies.forEach(({ name, parent }, at) => {
    const joint = joints.find(({ body }) => body === name);
    const isStill = joint !== undefined && joint.free_coordinates.length + joint.prescribed.length === 0;
    const carrier = isStill ? rigids.find((rigid) => rigid.some((body) => bodies[body].name === parent)) : undefined;
    if (carrier) carrier.push(at);
    else rigids.push([at]);
  });
  return rigids;
}

/**
 * Returns the inertia of a group about its centre of mass, in the axes of its first body; poses are x y z qw qx qy qz
 * for each body.
 */
export function inertiaOf(rigid: Rigid, bodies: readonly BodyInfo[], poses: ArrayLike<number>): Inertia {
  const placeOf = (body: number) => vec3((k) => poses[7 * body + k]);
  const mass = rigid.reduce((sum, body) => sum + bodies[body].mass_kg, 0);
  const centre = [0, 1, 2].map((k) => rigid.reduce((sum, body) => sum + bodies[body].mass_kg * placeOf(body)[k], 0) / (mass || 1));
  const first = axesOf(rigid[0], poses);
  const total: Inertia = [[0, 0, 0], [0, 0, 0], [0, 0, 0]];
  for (const body of rigid) {
    const own = axesOf(body, poses);
    // Axes of the body, and its position relative to the group's centre of mass, in the axes of the first body.
    const turned = first.map((axis) => own.map((other) => dot(axis, other)));
    const d = first.map((axis) => dot(axis, placeOf(body).map((value, k) => value - centre[k])));
    const { mass_kg, inertia_kg_m2 } = bodies[body];
    for (let i = 0; i < 3; i++) {
      for (let j = 0; j < 3; j++) {
        const about = dot(turned[i], inertia_kg_m2.map((row) => dot(row, turned[j])));
        total[i][j] += about + mass_kg * ((i === j ? dot(d, d) : 0) - d[i] * d[j]);
      }
    }
  }
  return total;
}

/** Returns the axes of a body in the world frame. */
function axesOf(body: number, poses: ArrayLike<number>): number[][] {
  const at = 7 * body + 3;
  const turn = [poses[at], poses[at + 1], poses[at + 2], poses[at + 3]] as const;
  return ([[1, 0, 0], [0, 1, 0], [0, 0, 1]] as const).map((axis) => [...rotate(turn, axis)]);
}

function dot(a: readonly number[], b: readonly number[]): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** A surface, given as the image of the unit sphere. */
export type Surface = (unit: Vector) => Vector;

/** Returns the angular momentum about the centre of mass, J omega, in body axes, N m s. */
export function momentumOf(inertia: readonly (readonly number[])[], omega: Vector): Vector {
  return vec3((k) => dot(inertia[k], omega));
}

export function sizeOf(vector: Vector): number {
  return Math.hypot(...vector);
}

/** Returns the sphere of angular momenta of this magnitude; a body without moments stays on it. */
export function momentumSphere(size: number): Surface {
  return ([x, y, z]) => [size * x, size * y, size * z];
}

/**
 * Returns the ellipsoid of angular momenta h with kinetic energy T (MacCullagh's ellipsoid): h' J^-1 h = 2 T. With J =
 * C C' (Cholesky) its points are sqrt(2 T) C u for unit vectors u.
 */
export function energyEllipsoid(inertia: readonly (readonly number[])[], energy_J: number): Surface {
  const [[a], [b, c], [d, e, f]] = cholesky(inertia);
  const size = Math.sqrt(2 * Math.max(0, energy_J));
  return ([x, y, z]) => [size * a * x, size * (b * x + c * y), size * (d * x + e * y + f * z)];
}

function cholesky(m: readonly (readonly number[])[]): [[number], [number, number], Vector] {
  const root = (square: number) => Math.sqrt(Math.max(0, square));
  const over = (value: number, by: number) => (by > 0 ? value / by : 0);
  const a = root(m[0][0]);
  const b = over(m[1][0], a);
  const c = root(m[1][1] - b * b);
  const d = over(m[2][0], a);
  const e = over(m[2][1] - d * b, c);
  return [[a], [b, c], [d, e, root(m[2][2] - d * d - e * e)]];
}

const STEPS = 48;
const MERIDIANS = 6;
const PARALLELS = 5;

/** Returns the meridians and parallels of a surface, for drawing. */
export function circlesOf(surface: Surface): Vector[][] {
  const circle = (point: (angle: number) => Vector) => Array.from({ length: STEPS + 1 }, (_, k) => surface(point((2 * Math.PI * k) / STEPS)));
  const meridians = Array.from({ length: MERIDIANS }, (_, k) => (Math.PI * k) / MERIDIANS).map((at) =>
    circle((angle) => [Math.cos(at) * Math.cos(angle), Math.sin(at) * Math.cos(angle), Math.sin(angle)]),
  );
  const parallels = Array.from({ length: PARALLELS }, (_, k) => (Math.PI * (k + 1)) / (PARALLELS + 1) - Math.PI / 2).map((at) =>
    circle((angle) => [Math.cos(at) * Math.cos(angle), Math.cos(at) * Math.sin(angle), Math.sin(at)]),
  );
  return [...meridians, ...parallels];
}
