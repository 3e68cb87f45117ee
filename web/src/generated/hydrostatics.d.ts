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
 * A hull at rest in still water, with all bodies that its joints carry. The first number of a pair is for
 * heel (across the ship), the second for trim (along the ship).
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
   * GZ to the side of the list; `None` without a mesh.
   */
  righting_arm: RightingArmCurve | null;
  /**
   * Whether volume, KB and BM are computed from the floating mesh; otherwise they follow from the
   * waterplane at the database's draught, moved along the hull's z.
   */
  by_mesh: boolean;
  /**
   * Whether this position is computed with the mesh's buoyancy, like the run; otherwise with linear
   * buoyancy. The righting arms always use the mesh, so with linear buoyancy they can pass through zero at
   * another heel.
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
   * Joint or line from which the load hangs.
   */
  joint: string;
  /**
   * The body under the joint.
   */
  body: string;
  /**
   * Mass of the body and of all bodies that it carries, less the mass of the water that lifted objects
   * among them displace, kg.
   */
  mass_kg: number;
  /**
   * Distance of their common centre of mass below the joint, m.
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
 * Free surface of a slack tank or a free-flooding tank, or both free surfaces of a U-tank. The tank is in a
 * hull, or in a body that the hull's joints carry and that does not hang.
 */
export interface FreeSurface {
  /**
   * Name of the force in the scenario.
   */
  force: string;
  /**
   * Body that contains the tank.
   */
  body: string;
  /**
   * Mass of the liquid, kg; that of a slack tank is part of the body's mass.
   */
  liquid_kg: number;
  /**
   * Height of the liquid's centre of mass above the keel in the present position, along the hull's z, m.
   */
  keel_to_liquid_m: number;
  /**
   * Reduction of GM across and along the ship, `rho i / M`, with i the second moment of its present
   * surface about its centroid and M the floating mass, m (Barrass & Derrett, *Ship Stability for Masters
   * and Mates*, ch. on free surface). For a U-tank i is that of both levels, `A d^2 / 2`, with the area A
   * of each and their distance d: the columns are narrow, and the liquid flows freely. For a tank that is
   * open to the sea i is the loss of the ship's waterplane, `A (y - y') (y - y_0)`, with the centres of
   * flotation y_0 without and y' with all openings.
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
 * For a listing ship the curve is for the side of the list, where the arms are smaller; for an upright ship
 * for the side with the smaller maximum arm, or for starboard if both are equal.
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
   * Heel to the curve's side at which the arm becomes positive, rad: the list, or the angle of loll.
   * Negative if it is on the other side: linear buoyancy and the mesh can give lists to different sides.
   * `None` if there is none up to 90 deg.
   */
  equilibrium_rad: number | null;
  /**
   * Largest arm beyond the equilibrium, m, and its heel, rad, from a parabola through three angles one
   * degree apart.
   */
  largest: LargestArm | null;
  /**
   * Heel at which the arm becomes negative, rad; `None` if this does not occur up to 90 deg. The range of
   * positive stability is from the equilibrium to this angle.
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
   * GZ, m: positive if it rights the ship.
   */
  arm_m: number;
}
/**
 * Maximum of a righting-arm curve.
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
