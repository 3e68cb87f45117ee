import type { BodyInfo, ModelInfo } from "../../engine/engine";
import { dot } from "../fit";
import type { Vec3 } from "../fit";

/** The role of a body, from its shape and its carrier. */
export type Role = "hull" | "column" | "boom" | "link" | "drum" | "cargo" | "quay" | "tank" | "gimbal" | "wheel" | "other";

/** Smallest ratio of length to radius, or to depth, of a boom, and of a slim link. */
const SLIM = { boom: 5, link: 40 };
/** Largest ratio of length to radius of a drum. */
const DRUM = 4;
/** Kinds of joints that a boom does not have: booms turn or slide on their carrier, or are fixed to another boom. */
const SWINGS = new Set(["universal", "spherical", "floating"]);

/** Returns the role of each body. */
export function rolesOf(model: ModelInfo): Role[] {
  const roles: Role[] = [];
  model.bodies.forEach((body) => roles.push(roleOf(model, body, roles)));
  return roles;
}

function roleOf(model: ModelInfo, body: BodyInfo, known: readonly Role[]): Role {
  const { shape } = body;
  const parent = model.bodies.findIndex(({ name }) => name === body.parent);
  const joint = jointOf(model, body.name);
  const children = model.bodies.filter((one) => one.parent === body.name);
  if (isHull(model, body)) return "hull";
  if (parent < 0) return shape?.kind === "box" && !body.floats ? "quay" : shape?.kind === "box" || shape?.kind === "sphere" ? "cargo" : "other";
  if (shape?.kind === "box" && joint === "fixed" && known[parent] === "hull") return "tank";
  if (wheelIn(model, body) !== undefined) return "gimbal";
  if (known[parent] === "gimbal") return "wheel";
  if (shape?.kind === "cylinder" && children.length === 0 && joint === "revolute" && shape.length_m <= DRUM * shape.radius_m) return "drum";
  if (shape?.kind === "cylinder" && known[parent] === "hull" && shape.axis === "z" && children.length > 0) return "column";
  if (shape?.kind === "cylinder" && shape.length_m >= SLIM.link * shape.radius_m) return "link";
  const isBorne = ["column", "boom", "hull"].includes(known[parent]) && !SWINGS.has(joint);
  if (isBorne && slimness(body) >= SLIM.boom) return "boom";
  return shape?.kind === "box" && known[parent] !== "other" ? "cargo" : "other";
}

/** Largest cosine between the axes about which a wheel and its gimbal turn. */
const CROSSED = 0.5;

/** Returns the wheel of a gimbal: the disc that spins in a frame, across the axis about which the frame turns. */
export function wheelIn(model: ModelInfo, { name, shape }: BodyInfo): BodyInfo | undefined {
  const turns = axisOf(model, name);
  if (shape?.kind !== "box" || !turns) return undefined;
  return model.bodies.find((one) => {
    const spins = one.parent === name && one.shape?.kind === "cylinder" ? axisOf(model, one.name) : null;
    return spins !== null && Math.abs(dot(spins, turns)) < CROSSED && slimness(one) < DRUM && !model.bodies.some(({ parent }) => parent === one.name);
  });
}

/** Returns the axis about which a body turns on its carrier; null if it has none, or several. */
function axisOf(model: ModelInfo, body: string): Vec3 | null {
  return model.joints.find((joint) => joint.body === body)?.axis ?? null;
}

/**
 * Whether a body is a hull: it floats at the surface and carries a moving body, has hydrodynamic data, or is moved by
 * the waves.
 */
function isHull(model: ModelInfo, { name, floats, is_submerged, shape }: BodyInfo): boolean {
  if (model.hulls.some((hull) => hull.body === name)) return true;
  if (!floats || is_submerged || shape?.kind !== "box") return false;
  const carries = model.bodies.some((one) => one.parent === name && jointOf(model, one.name) !== "fixed");
  return carries || jointOf(model, name) !== "floating";
}

function jointOf(model: ModelInfo, body: string): string {
  return model.joints.find((joint) => joint.body === body)?.kind ?? "";
}

/**
 * Returns the slenderness of a shape: its longest extent over the next one; for a cylinder, its length over its radius.
 */
function slimness({ shape }: BodyInfo): number {
  if (shape?.kind === "cylinder") return shape.length_m / shape.radius_m;
  if (shape?.kind !== "box") return 0;
  const [longest, next] = [shape.length_m, shape.width_m, shape.height_m].sort((a, b) => b - a);
  return longest / next;
}
