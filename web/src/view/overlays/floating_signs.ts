import type { Hydrostatics, ModelInfo } from "../../engine/engine";
import { Place } from "../craft/place";
import type { Vec3 } from "../fit";
import { vec3 } from "../fit";

/** Points that decide the stability of a hull, world frame. */
export interface FloatingSigns {
  letters: { text: string; at: Vec3 }[];
  /** Line from the keel to the metacentre. */
  line: readonly [Vec3, Vec3];
  /** The centre of buoyancy, and the buoyancy, N. */
  buoyancy: { at: Vec3; force_N: number };
}

/**
 * Returns, for each hull at rest with the crane in its present pose, the keel, the centres of buoyancy and mass, and
 * the transverse metacentre.
 */
export function floatingSignsOf(model: ModelInfo, { hulls }: Hydrostatics, poses: ArrayLike<number>): FloatingSigns[] {
  return hulls.flatMap((hull): FloatingSigns[] => {
    const described = model.hulls.find(({ name }) => name === hull.force);
    const body = model.bodies.findIndex(({ name }) => name === hull.body);
    if (!described || body < 0) return [];
    const place = new Place(poses, body);
    const [x, y] = centreOf(model, poses, body);
    const keel = described.origin_m[2] - described.draught_m;
    const at = (height: number) => place.toWorld([x, y, keel + height]);
    const heights = { K: 0, B: hull.keel_to_buoyancy_m, G: hull.fluid_keel_to_gravity_m[0], M: hull.keel_to_metacentre_m[0] };
    const letters = Object.entries(heights).map(([text, height]) => ({ text, at: at(height) }));
    const buoyancy = { at: at(heights.B), force_N: hull.displacement_kg * model.gravity_m_s2 };
    return [{ letters, line: [at(0), at(Math.max(...Object.values(heights)))], buoyancy }];
  });
}

/**
 * Returns the centre of mass of a body with all bodies that it carries, in the axes of the body; at rest it is
 * vertically above the centre of buoyancy.
 */
function centreOf(model: ModelInfo, poses: ArrayLike<number>, body: number): Vec3 {
  const carried = new Set([model.bodies[body].name]);
  const place = new Place(poses, body);
  let [mass_kg, sum] = [0, [0, 0, 0]];
  model.bodies.forEach((one, i) => {
    if (!carried.has(one.name) && !carried.has(one.parent)) return;
    carried.add(one.name);
    const at = place.toBody(new Place(poses, i).toWorld([0, 0, 0]));
    sum = sum.map((part, k) => part + one.mass_kg * at[k]);
    mass_kg += one.mass_kg;
  });
  return vec3((k) => sum[k] / mass_kg);
}
