/* Generated from schema/hydrostatics.schema.json by `npm run types`; do not edit. */

/**
 * The hulls of a scenario, and what keeps them from being described.
 */
export interface HydrostaticReport {
  /**
   * One for each hull in the water.
   */
  hulls: HullAfloat[];
  /**
   * What a user should know.
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
   * Of the hull and all that its joints carry, kg.
   */
  mass_kg: number;
  /**
   * Of the water that it displaces, kg.
   */
  displacement_kg: number;
  /**
   * V, m^3.
   */
  displacement_m3: number;
  /**
   * Depth of the keel below the database's origin, m; that point is `draught_m` of the database
   * under the origin, in hull axes.
   */
  draught_m: number;
  /**
   * The draught that the database is for, m.
   */
  database_draught_m: number;
  /**
   * To starboard, rad.
   */
  heel_rad: number;
  /**
   * By the bow, rad.
   */
  trim_rad: number;
  /**
   * KB, m: all heights over the keel are along the hull's z.
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
   * KG, m, with every load where it is, and the liquid in slack tanks.
   */
  keel_to_gravity_m: number;
  /**
   * KG, m, with hanging loads at the joints that they hang from, and raised by what free surfaces take off GM.
   *
   * @minItems 2
   * @maxItems 2
   */
  fluid_keel_to_gravity_m: [number, number];
  /**
   * GM with every load where it is and as if it were fixed there, m.
   *
   * @minItems 2
   * @maxItems 2
   */
  solid_metacentric_height_m: [number, number];
  /**
   * GM, m, with hanging loads at the joints that they hang from, less what free surfaces take off.
   *
   * @minItems 2
   * @maxItems 2
   */
  metacentric_height_m: [number, number];
  /**
   * The loads that hang.
   */
  hanging: HangingLoad[];
  /**
   * The free surfaces of slack tanks.
   */
  free_surfaces: FreeSurface[];
  /**
   * GZ to the side that the ship lists to; `None` without a mesh.
   */
  righting_arm: RightingArmCurve | null;
  /**
   * Whether volume, KB and BM are of the mesh as it floats; else they are of the waterplane at the
   * database's draught, moved along the hull's z.
   */
  by_mesh: boolean;
  /**
   * Whether the run's buoyancy, by which it rests so, is the mesh's; else it is linear, and the righting arms, which
   * are always the mesh's, rise through zero at a heel of their own.
   */
  rests_by_mesh: boolean;
}
/**
 * What hangs on a joint, or on lines.
 *
 * A joint counts where the centre of all that it carries is below it, at least one of its rotations
 * is free, and no spring, brake, servo or motor acts on that; and where no closed loop, cylinder or
 * spring line is tied to what it carries, and it has no hull of its own.
 *
 * Spring lines and ropes count where they end in one point of the ship, or are near legs of one rope, and carry a body that
 * floats by its joint, and nothing else holds that: no water, loop, cylinder, contact or other line. Slack ropes carry nothing.
 * Legs of one rope count where
 * their ends are near each other; where one runs over a sheave, its end is the sheave's centre.
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
   * Of the body and all that it carries, kg.
   */
  mass_kg: number;
  /**
   * How far the centre of that is below the joint, m.
   */
  length_m: number;
  /**
   * The share of that length by which the centre of gravity rises where the ship heels, and where it
   * trims: `|P u|^2`, with u the axis of heel or trim and P the projection on the joint's free axes.
   * Of a load that swings about one axis at an angle a to u it is `cos^2 a`.
   *
   * @minItems 2
   * @maxItems 2
   */
  free_share: [number, number];
}
/**
 * The free surface of a slack tank of a hull, or of what its joints carry without letting it hang.
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
   * Of the liquid, kg; it is part of the body's mass.
   */
  liquid_kg: number;
  /**
   * Height of the liquid's centre over the keel, as it stands, along the hull's z, m.
   */
  keel_to_liquid_m: number;
  /**
   * What it takes off GM across the ship and along it, `rho i / M`, i the second moment of its surface as it
   * stands about its centroid and M the mass afloat, m (Barrass & Derrett, *Ship Stability for Masters and
   * Mates*, ch. on free surface).
   *
   * @minItems 2
   * @maxItems 2
   */
  correction_m: [number, number];
}
/**
 * GZ over the heel to one side, at constant displacement, free to trim, with hanging loads where they hang from
 * and slack tanks level.
 *
 * Of a ship that lists, to the side of its list, where its arms are the lesser; of one that stands upright, to the side
 * whose largest arm is the lesser, starboard where both are the same.
 */
export interface RightingArmCurve {
  /**
   * Which way the ship heels.
   */
  side: "port" | "starboard";
  /**
   * By angles of heel from 0 to 60 deg.
   */
  points: RightingArmPoint[];
  /**
   * Heel to that side at which the arm rises through zero, rad: the list, or the angle of loll. `None` where it
   * does not to 90 deg.
   */
  equilibrium_rad: number | null;
  /**
   * The largest arm beyond that, m, and its heel, rad; a parabola through three angles a degree apart.
   */
  largest: LargestArm | null;
  /**
   * Heel at which the arm falls through zero, rad; `None` where it does not to 90 deg. The range of positive
   * stability is from the equilibrium to there.
   */
  vanishing_rad: number | null;
}
/**
 * One point of a righting-arm curve.
 */
export interface RightingArmPoint {
  /**
   * To the curve's side, rad.
   */
  heel_rad: number;
  /**
   * By the bow, rad.
   */
  trim_rad: number;
  /**
   * GZ, m: above 0 where it turns the ship back.
   */
  arm_m: number;
}
/**
 * The top of a righting-arm curve.
 */
export interface LargestArm {
  /**
   * To the curve's side, rad.
   */
  heel_rad: number;
  /**
   * GZ, m.
   */
  arm_m: number;
}
