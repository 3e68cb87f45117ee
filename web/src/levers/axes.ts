import type { Run } from "../app/run";
import type { InputInfo } from "../engine/engine";
import { cross, rotate } from "../view/fit";
import type { Vec3 } from "../view/fit";

/** Axes of the two sticks: across (x, positive to the right) and along (y, positive away from the hand). */
export const AXES = ["left_x", "left_y", "right_x", "right_y"] as const;
export type Axis = (typeof AXES)[number];

/** An input on an axis of a stick; `reversed` if a positive deflection gives a negative input. */
export interface Place {
  input: string;
  reversed: boolean;
}

export type Places = Partial<Record<Axis, Place>>;

/**
 * slew: about a vertical axis; raise: a boom about a horizontal axis; hoist: a drum that turns about its own centre;
 * other: does not follow from the model.
 */
type Motion = "slew" | "raise" | "hoist" | "other";

interface Moved extends Place {
  motion: Motion;
  /** Number of bodies between the moved body and the ground. */
  depth: number;
}

/**
 * Assigns inputs to axes by default: slewing and the first boom on the left stick, hoisting and the next boom on the
 * right, others on free axes.
 */
export function placesOf(run: Run, poses: ArrayLike<number>): Places {
  const waiting = onSticks(run.inputs)
    .map((input) => movedBy(run, poses, input.name))
    .sort((a, b) => a.depth - b.depth);
  const take = (fits: (moved: Moved) => boolean): Place | undefined => {
    const at = waiting.findIndex(fits);
    if (at < 0) return undefined;
    const [{ input, reversed }] = waiting.splice(at, 1);
    return { input, reversed };
  };
  const first = (motion: Motion) => take((moved) => moved.motion === motion);
  const places: Places = { left_x: first("slew"), left_y: first("raise"), right_y: first("hoist"), right_x: first("raise") };
  for (const axis of ["right_y", "left_x", "left_y", "right_x"] as const) places[axis] ??= take(() => true);
  return places;
}

/** Returns the inputs for a self-centring stick: they are set by hand, and zero lies between their bounds. */
export function onSticks(inputs: readonly InputInfo[]): InputInfo[] {
  return inputs.filter(({ signal, lower, upper }) => !signal && lower < 0 && upper > 0);
}

/**
 * Returns the motion of the body that an input moves: the body of its drive's joint, or the last of the bodies that the
 * drive connects.
 */
function movedBy({ model, jointAxes }: Run, poses: ArrayLike<number>, input: string): Moved {
  const parents = new Map(model.bodies.map(({ name, parent }) => [name, parent]));
  const facts = model.elements.find(({ name, group }) => name === input && group === "drives")?.facts ?? [];
  const named = model.joints.find(({ name }) => name === facts.find(({ label }) => label === "joint")?.value);
  let body = named?.body ?? facts.filter(({ value }) => parents.has(value)).at(-1)?.value;
  // A fixed body moves with its parent.
  while (body !== undefined && parents.has(body) && model.joints.find((joint) => joint.body === body)?.kind === "fixed") body = parents.get(body);
  const joint = jointAxes.find((one) => one.body === body);
  if (!joint || model.joints.find((one) => one.body === body)?.kind !== "revolute") return { input, motion: "other", reversed: false, depth: Infinity };
  const place = (name: string | undefined) => model.bodies.findIndex((one) => one.name === name);
  const axis = turned(joint.axis, poses, place(parents.get(joint.body)));
  const motion = motionAbout(axis, turned(joint.arm_m, poses, place(joint.body)), named !== undefined);
  return { input, ...motion, depth: depthOf(parents, joint.body) };
}

/**
 * Returns the kind of a motion, and whether the stick is reversed: a stick to the right slews to the right, seen from
 * above; a stick pushed away lowers and pays out. `arm` is the vector from the child's centre to the joint.
 */
function motionAbout(axis: Vec3, arm: Vec3, isOfJoint: boolean): { motion: Motion; reversed: boolean } {
  if (Math.abs(axis[2]) > Math.hypot(axis[0], axis[1])) return { motion: "slew", reversed: axis[2] > 0 };
  if (Math.hypot(...arm) < 1e-9) return { motion: "hoist", reversed: false };
  // A drive between two bodies pushes a boom up.
  const raises = isOfJoint ? cross(axis, arm)[2] < 0 : true;
  return { motion: "raise", reversed: raises };
}

/**
 * Transforms a vector from a body's axes to the world's; poses are x y z qw qx qy qz for each body, without the world.
 */
function turned(vector: Vec3, poses: ArrayLike<number>, body: number): Vec3 {
  if (body < 0) return vector;
  const at = 7 * body + 3;
  return rotate([poses[at], poses[at + 1], poses[at + 2], poses[at + 3]], vector);
}

function depthOf(parents: ReadonlyMap<string, string>, body: string): number {
  let depth = 0;
  for (let at: string | undefined = body; at !== undefined; at = parents.get(at)) depth += 1;
  return depth;
}
