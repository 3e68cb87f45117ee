/* Generated from schema/hydrostatics.schema.json by `npm run types`; do not edit. */

/**
 * The hulls of a scenario, and warnings.
 */
export interface HydrostaticReport {
  /**
   * One for each hull in the water.
   */
  hulls: HullAfloat[];
  /**
   * Warnings.
   */
  warnings: string[];
}
/**
 * A hull at rest in still water with all that its joints carry. Pairs are across the ship, for heel,
 * and along it, for trim.
 */
export interface HullAfloat {
  /**
   * Name of the force in the scenario.
   */
  force: string;
  /**
   * The body that is the hull.
   */
  body: string;
  /**
   * Mass of the hull and all that its joints carry, kg.
   */
  mass_kg: number;
  /**
   * Mass of the water that it displaces, kg.
   */
  displacement_kg: number;
  /**
   * V, m^3.
   */
  displacement_m3: number;
  /**
   * Depth of the keel below the database's origin, m; the keel is the point `draught_m` of the database below the
   * origin, in hull axes.
   */
  draught_m: number;
  /**
   * The draught of the database, m.
   */
  database_draught_m: number;
  /**
   * Heel to starboard, rad.
   */
  heel_rad: number;
  /**
   * Trim by the bow, rad.
   */
  trim_rad: number;
  /**
   * KB, m: all heights above the keel are along the hull's z.
   */
  keel_to_buoyancy_m: number;
  /**
   * BM, `I / V`, m.
   *
   * @minItems 2
   * @maxItems 2
   */
  metacentric_radius_m: [number, number];
  /**
   * KM, `KB + BM`, m.
   *
   * @minItems 2
   * @maxItems 2
   */
  keel_to_metacentre_m: [number, number];
  /**
   * KG, m, with every load and the liquid in slack tanks in their present position.
   */
  keel_to_gravity_m: number;
  /**
   * KG, m, with hanging loads at their suspension points, plus the reduction of GM by free surfaces.
   *
   * @minItems 2
   * @maxItems 2
   */
  fluid_keel_to_gravity_m: [number, number];
  /**
   * GM with every load fixed in its present position, m.
   *
   * @minItems 2
   * @maxItems 2
   */
  solid_metacentric_height_m: [number, number];
  /**
   * GM, m, with hanging loads at their suspension points, less the reduction by free surfaces.
   *
   * @minItems 2
   * @maxItems 2
   */
  metacentric_height_m: [number, number];
  /**
   * The hanging loads.
   */
  hanging: HangingLoad[];
  /**
   * The free surfaces of slack tanks, U-tanks and free-flooding tanks.
   */
  free_surfaces: FreeSurface[];
  /**
   * GZ to the side that the ship lists to; `None` without a mesh.
   */
  righting_arm: RightingArmCurve | null;
  /**
   * Whether volume, KB and BM are those of the floating mesh; else they follow from the waterplane at the database's
   * draught, moved along the hull's z.
   */
  by_mesh: boolean;
  /**
   * Whether the buoyancy of the run, which gives this position, is the mesh's; else it is linear, and the righting
   * arms, which are always the mesh's, may pass through zero at another heel.
   */
  rests_by_mesh: boolean;
}
/**
 * A load that hangs on a joint, or on lines.
 *
 * A load hangs on a joint if the centre of all that the joint carries is below it, at least one rotation is free, no
 * spring, brake, servo or motor acts on that rotation, and no closed loop, cylinder, spring line or hull is attached
 * to the bodies that it carries.
 *
 * A load hangs on spring lines or ropes if they start from one point of the ship, or are legs of one rope with ends
 * close together, and carry a body with a floating joint that nothing else holds: no water, loop, cylinder, contact or
 * other line. Slack ropes carry nothing. The end of a leg at a sheave is the sheave's centre.
 */
export interface HangingLoad {
  /**
   * The joint or the line that it hangs from.
   */
  joint: string;
  /**
   * The body under the joint.
   */
  body: string;
  /**
   * Mass of the body and all that it carries, less that of the water that it displaces as a lifted object, kg.
   */
  mass_kg: number;
  /**
   * Distance of their centre below the joint, m.
   */
  length_m: number;
  /**
   * The share of that length by which the effective centre of gravity rises, for heel and for trim: `|P u|^2`, with
   * u the axis of heel or trim and P the projection on the joint's free axes. For a load that swings about one axis
   * at an angle a to u it is `cos^2 a`.
   *
   * @minItems 2
   * @maxItems 2
   */
  free_share: [number, number];
}
/**
 * The free surface of a slack tank or a free-flooding tank, or the two of a U-tank, in a hull, or in a body that its joints
 * carry without hanging.
 */
export interface FreeSurface {
  /**
   * Name of the force in the scenario.
   */
  force: string;
  /**
   * The body that the tank is in.
   */
  body: string;
  /**
   * Mass of the liquid, kg; that of a slack tank is part of the body's mass.
   */
  liquid_kg: number;
  /**
   * Height of the liquid's centre above the keel in the present position, along the hull's z, m.
   */
  keel_to_liquid_m: number;
  /**
   * Reduction of GM across and along the ship, `rho i / M`, with i the second moment of its present surface about
   * its centroid and M the floating mass, m (Barrass & Derrett, *Ship Stability for Masters and Mates*, ch. on free
   * surface). For a U-tank i is that of two levels, `A d^2 / 2`, each of the area A, at the distance d: its columns
   * are narrow, and nothing keeps the liquid from its level. For a tank that is open to the sea i is what her waterplane
   * loses by it, `A (y - y') (y - y_0)`, with the centres of flotation y_0 without and y' with all openings.
   *
   * @minItems 2
   * @maxItems 2
   */
  correction_m: [number, number];
}
/**
 * GZ over the heel to one side, at constant displacement, free to trim, with hanging loads at their suspension points
 * and slack tanks level.
 *
 * For a listing ship it is to the side of the list, where the arms are smaller; for an upright ship to the side with
 * the smaller largest arm, and to starboard if both are equal.
 */
export interface RightingArmCurve {
  /**
   * Side to which the ship heels.
   */
  side: "port" | "starboard";
  /**
   * Points at heel angles from 0 to 60 deg.
   */
  points: RightingArmPoint[];
  /**
   * Heel to that side at which the arm becomes positive, rad: the list, or the angle of loll; negative if it lies on the
   * other side, as by linear buoyancy a ship may list to one side and by her mesh to the other. `None` if there is none
   * up to 90 deg.
   */
  equilibrium_rad: number | null;
  /**
   * The largest arm beyond it, m, and its heel, rad, from a parabola through three angles one degree apart.
   */
  largest: LargestArm | null;
  /**
   * Heel at which the arm becomes negative, rad; `None` if it does not up to 90 deg. The range of positive stability
   * is from the equilibrium to this angle.
   */
  vanishing_rad: number | null;
}
/**
 * One point of a righting-arm curve.
 */
export interface RightingArmPoint {
  /**
   * Heel to the curve's side, rad.
   */
  heel_rad: number;
  /**
   * Trim by the bow, rad.
   */
  trim_rad: number;
  /**
   * GZ, m: positive if it turns the ship back.
   */
  arm_m: number;
}
/**
 * The top of a righting-arm curve.
 */
export interface LargestArm {
  /**
   * Heel to the curve's side, rad.
   */
  heel_rad: number;
  /**
   * GZ, m.
   */
  arm_m: number;
}
