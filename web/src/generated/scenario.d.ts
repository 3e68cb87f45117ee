/* Generated from schema/scenario.schema.json by `npm run types`; do not edit. */

/**
 * A part in its place. What stands on the world in the part's file stands on the mounting here.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export type Mounting = {
  /**
   * A part of the gallery by its name, or a YAML or JSON file, its path from this file's folder.
   */
  part: string;
  /**
   * What the names of the part's bodies, joints, forces, drives, loops and parameters begin with here, before a `_`;
   * without it, the name of this entry. Empty, they stay as they are.
   */
  prefix?: string | null;
  /**
   * The body that the part stands on, or `world`.
   */
  on?: string;
  /**
   * Origin of the part in the drawing frame of that body, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The part's axes in that body's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
  /**
   * Values for the part, by the names of its parameters or by dotted paths of its fields. Parameters without a value here
   * are parameters of the whole.
   */
  parameters?: {
    [k: string]: unknown;
  };
};
/**
 * A rigid body. Its geometry is written in a drawing frame of its own; the shape is centred on the centre of mass.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export type Body = {
  [k: string]: unknown;
} & {
  /**
   * Off leaves out this body and all that hangs on it.
   */
  enabled?: boolean;
  /**
   * The body that this one hangs on, or `world`.
   */
  parent?: string;
  /**
   * Mass, kg.
   */
  mass_kg?: number;
  /**
   * The same as `mass_kg`, in the unit of this name.
   */
  mass_t?: number;
  /**
   * Colour in the views, `#rrggbb`.
   */
  colour?: string | null;
  /**
   * The solid that gives the inertia, unless `inertia` does, and the picture.
   */
  shape?: Shape | null;
  /**
   * The inertia in numbers; it replaces that of the shape.
   */
  inertia?: Inertia | null;
  /**
   * Makes this body a beam that bends, twists and shears.
   */
  flexible?: Flexible | null;
  /**
   * The centre of mass in the drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  centre_of_mass_m?: [number, number, number];
  /**
   * How this body moves against its parent.
   */
  joint:
    | {
        floating: FloatingJoint;
      }
    | {
        revolute: RevoluteJoint;
      }
    | {
        prismatic: PrismaticJoint;
      }
    | {
        cylindrical: CylindricalJoint;
      }
    | {
        universal: UniversalJoint;
      }
    | {
        planar: PlanarJoint;
      }
    | {
        spherical: SphericalJoint;
      }
    | {
        fixed: FixedJoint;
      }
    | {
        moved_by_waves: MovedByWaves;
      };
  /**
   * Named points of this body, reported in the results.
   */
  points?: {
    [k: string]: Point;
  };
};
/**
 * A homogeneous solid, or a point mass.
 */
export type Shape =
  | {
      box: BoxShape;
    }
  | {
      cylinder: CylinderShape;
    }
  | {
      sphere: SphereShape;
    }
  | {
      point: PointShape;
    };
/**
 * Inertia in numbers, about the centre of mass in body axes.
 */
export type Inertia =
  | {
      tensor: InertiaTensor;
    }
  | {
      radii_of_gyration: RadiiOfGyration;
    };
/**
 * Moments and products of inertia about the centre of mass in body axes.
 */
export type InertiaTensor = {
  [k: string]: unknown;
} & {
  /**
   * Ixx, Iyy, Izz, kg m^2. No one of them may exceed the sum of the other two.
   *
   * @minItems 3
   * @maxItems 3
   */
  moments_kg_m2?: [number, number, number];
  /**
   * The same as `moments_kg_m2`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  moments_t_m2?: [number, number, number];
  /**
   * Ixy, Ixz, Iyz, kg m^2, as entries of the tensor: Ixy = -integral(x y dm).
   *
   * @minItems 3
   * @maxItems 3
   */
  products_kg_m2?: [number, number, number];
  /**
   * The same as `products_kg_m2`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  products_t_m2?: [number, number, number];
};
/**
 * Makes a body a uniform beam along its x axis, centred on its centre of mass. Its mass is the body's, its length
 * that of the shape unless it is given.
 *
 * The beam is cut into pieces with an elastic joint in the middle of each. The body keeps its name for the first
 * half piece, with the body's joint; the segments after it are `boom.1`, `boom.2`, and so on. What hangs on the body
 * hangs on the segment at its `position_m`.
 */
export type Flexible = {
  [k: string]: unknown;
} & {
  /**
   * Number of elastic joints along the beam, from 1 to 64.
   */
  segments: number;
  /**
   * Young's modulus, Pa.
   */
  youngs_modulus_Pa?: number;
  /**
   * The same as `youngs_modulus_Pa`, in the unit of this name.
   */
  youngs_modulus_GPa?: number;
  /**
   * Poisson's ratio, between -1 and 0.5; the shear modulus is E / (2 (1 + nu)).
   */
  poissons_ratio?: number;
  /**
   * The cross-section.
   */
  section:
    | {
        circular_tube: CircularTube;
      }
    | {
        rectangular_tube: RectangularTube;
      }
    | {
        general: GeneralSection;
      };
  /**
   * Length, m.
   */
  length_m?: number | null;
  /**
   * Damping in proportion to the stiffness; none when absent.
   */
  damping?: FlexibleDamping | null;
};
/**
 * Damping in proportion to the stiffness: each elastic joint's moment is K (angle + time rate).
 */
export type FlexibleDamping =
  | {
      ratio: DampingRatio;
    }
  | {
      stiffness_time: StiffnessTime;
    };
/**
 * Where the body is and how it moves at the start.
 */
export type InitialMotion = {
  /**
   * Position of the centre of mass in the world, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * Roll, pitch, yaw (intrinsic z-y-x angles), rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
  /**
   * Velocity of the centre of mass in the world, m/s.
   *
   * @minItems 3
   * @maxItems 3
   */
  velocity_m_s?: [number, number, number];
  /**
   * Angular velocity in body axes: roll, pitch, yaw rate, rad/s.
   *
   * @minItems 3
   * @maxItems 3
   */
  angular_velocity_rad_s?: [number, number, number];
  /**
   * The same as `angular_velocity_rad_s`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  angular_velocity_deg_s?: [number, number, number];
};
/**
 * A hinge.
 */
export type RevoluteJoint = {
  /**
   * Name of the joint; the body's when absent.
   */
  name?: string | null;
  /**
   * The axis in this body's axes, of any length but 0.
   *
   * @minItems 3
   * @maxItems 3
   */
  axis: [number, number, number];
  /**
   * The joint in the parent's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The joint in this body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  child_position_m?: [number, number, number];
  /**
   * This body's axes in the parent's at angle 0: roll, pitch, yaw (intrinsic z-y-x angles), rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
  /**
   * Angle at the start, rad.
   */
  initial_angle_rad?: number;
  /**
   * The same as `initial_angle_rad`, in the unit of this name.
   */
  initial_angle_deg?: number;
  /**
   * Rate at the start, rad/s.
   */
  initial_rate_rad_s?: number;
  /**
   * The same as `initial_rate_rad_s`, in the unit of this name.
   */
  initial_rate_deg_s?: number;
  /**
   * Viscous damping moment per rate, N m s.
   */
  damping_N_m_s?: number;
  /**
   * The same as `damping_N_m_s`, in the unit of this name.
   */
  damping_kN_m_s?: number;
  /**
   * Dry friction.
   */
  friction?: AngleFriction | null;
  /**
   * A spring.
   */
  spring?: AngleSpring | null;
  /**
   * Stops at the ends of the travel.
   */
  limits?: AngleLimits | null;
  /**
   * Moment of inertia of the motor's rotor about its own axis, kg m^2.
   */
  rotor_inertia_kg_m2?: number;
  /**
   * The same as `rotor_inertia_kg_m2`, in the unit of this name.
   */
  rotor_inertia_t_m2?: number;
  /**
   * Turns of the rotor for one turn about the axis.
   */
  gear_ratio?: number;
  /**
   * Free, held or prescribed.
   */
  mode?:
    | "free"
    | "held"
    | {
        prescribed: PrescribedRate;
      }
    | {
        travel: AngleTravel;
      };
};
/**
 * Dry friction against turning, `torque rate / sqrt(rate^2 + smoothing^2)`.
 */
export type AngleFriction = {
  [k: string]: unknown;
} & {
  /**
   * Its torque, N m.
   */
  torque_N_m?: number;
  /**
   * The same as `torque_N_m`, in the unit of this name.
   */
  torque_kN_m?: number;
  /**
   * Rate about which it changes its sign smoothly, rad/s; what should stick creeps below it.
   */
  smoothing_rad_s?: number;
  /**
   * The same as `smoothing_rad_s`, in the unit of this name.
   */
  smoothing_deg_s?: number;
};
/**
 * A linear spring about an axis.
 */
export type AngleSpring = {
  [k: string]: unknown;
} & {
  /**
   * Moment per angle, N m/rad.
   */
  stiffness_N_m_per_rad?: number;
  /**
   * The same as `stiffness_N_m_per_rad`, in the unit of this name.
   */
  stiffness_kN_m_per_rad?: number;
  /**
   * Angle at which it is slack, rad.
   */
  rest_rad?: number;
  /**
   * The same as `rest_rad`, in the unit of this name.
   */
  rest_deg?: number;
};
/**
 * Stops that push back with `stiffness d (1 + dissipation d')` at the depth d beyond a limit, never outwards.
 */
export type AngleLimits = {
  [k: string]: unknown;
} & {
  /**
   * Smallest angle, rad; none when absent.
   */
  lower_rad?: number;
  /**
   * The same as `lower_rad`, in the unit of this name.
   */
  lower_deg?: number;
  /**
   * Largest angle, rad; none when absent.
   */
  upper_rad?: number;
  /**
   * The same as `upper_rad`, in the unit of this name.
   */
  upper_deg?: number;
  /**
   * Moment per angle beyond a limit, N m/rad.
   */
  stiffness_N_m_per_rad?: number;
  /**
   * The same as `stiffness_N_m_per_rad`, in the unit of this name.
   */
  stiffness_kN_m_per_rad?: number;
  /**
   * What is lost: of a small rate u a stop gives back about `u (1 - 2/3 dissipation u)`, s/rad.
   */
  dissipation_s_per_rad?: number;
  /**
   * The same as `dissipation_s_per_rad`, in the unit of this name.
   */
  dissipation_s_per_deg?: number;
};
/**
 * A rate of turning as a given function of time.
 */
export type PrescribedRate = {
  [k: string]: unknown;
} & {
  /**
   * Full rate, rad/s.
   */
  rate_rad_s?: number;
  /**
   * The same as `rate_rad_s`, in the unit of this name.
   */
  rate_deg_s?: number;
  /**
   * How the rate goes with time.
   */
  history?: "constant" | "pulse" | "list" | "lever";
  /**
   * The times of the history `pulse`.
   */
  pulse?: RatePulse | null;
  /**
   * The times and shares of the history `list`; a rate cannot jump.
   */
  list?: HistoryList | null;
};
/**
 * Turning by an angle, from rest to rest: the rate goes up in `ramp_s`, holds, and goes back to 0 in `ramp_s`. Between the
 * ramps it is `angle / (duration_s - ramp_s)`.
 */
export type AngleTravel = {
  [k: string]: unknown;
} & {
  /**
   * How far it turns, positive about the axis, rad.
   */
  angle_rad?: number;
  /**
   * The same as `angle_rad`, in the unit of this name.
   */
  angle_deg?: number;
  /**
   * When it begins, s.
   */
  start_s?: number;
  /**
   * From rest to rest, both ramps included, s.
   */
  duration_s: number;
  /**
   * Length of a ramp, s; at most half of the duration.
   */
  ramp_s: number;
};
/**
 * A slide.
 */
export type PrismaticJoint = {
  /**
   * Name of the joint; the body's when absent.
   */
  name?: string | null;
  /**
   * The axis in this body's axes, of any length but 0.
   *
   * @minItems 3
   * @maxItems 3
   */
  axis: [number, number, number];
  /**
   * The joint in the parent's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The joint in this body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  child_position_m?: [number, number, number];
  /**
   * This body's axes in the parent's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
  /**
   * Extension at the start, m.
   */
  initial_extension_m?: number;
  /**
   * Speed at the start, m/s.
   */
  initial_speed_m_s?: number;
  /**
   * Viscous damping force per speed, N s/m.
   */
  damping_N_s_m?: number;
  /**
   * The same as `damping_N_s_m`, in the unit of this name.
   */
  damping_kN_s_m?: number;
  /**
   * Dry friction.
   */
  friction?: LengthFriction | null;
  /**
   * A spring.
   */
  spring?: LengthSpring | null;
  /**
   * Stops at the ends of the travel.
   */
  limits?: LengthLimits | null;
  /**
   * Moment of inertia of the motor's rotor about its own axis, kg m^2.
   */
  rotor_inertia_kg_m2?: number;
  /**
   * The same as `rotor_inertia_kg_m2`, in the unit of this name.
   */
  rotor_inertia_t_m2?: number;
  /**
   * Angle of the rotor per extension, rad/m.
   */
  gear_ratio_rad_per_m?: number;
  /**
   * Free, held or prescribed.
   */
  mode?:
    | "free"
    | "held"
    | {
        prescribed: PrescribedSpeed;
      }
    | {
        travel: LengthTravel;
      };
};
/**
 * Dry friction against sliding, `force speed / sqrt(speed^2 + smoothing^2)`.
 */
export type LengthFriction = {
  [k: string]: unknown;
} & {
  /**
   * Its force, N.
   */
  force_N?: number;
  /**
   * The same as `force_N`, in the unit of this name.
   */
  force_kN?: number;
  /**
   * Speed about which it changes its sign smoothly, m/s; what should stick creeps below it.
   */
  smoothing_m_s?: number;
};
/**
 * A linear spring along an axis.
 */
export type LengthSpring = {
  [k: string]: unknown;
} & {
  /**
   * Force per extension, N/m.
   */
  stiffness_N_per_m?: number;
  /**
   * The same as `stiffness_N_per_m`, in the unit of this name.
   */
  stiffness_kN_per_m?: number;
  /**
   * Extension at which it is slack, m.
   */
  rest_m?: number;
};
/**
 * Stops that push back with `stiffness d (1 + dissipation d')` at the depth d beyond a limit, never outwards.
 */
export type LengthLimits = {
  [k: string]: unknown;
} & {
  /**
   * Smallest extension, m; none when absent.
   */
  lower_m?: number;
  /**
   * Largest extension, m; none when absent.
   */
  upper_m?: number;
  /**
   * Force per extension beyond a limit, N/m.
   */
  stiffness_N_per_m?: number;
  /**
   * The same as `stiffness_N_per_m`, in the unit of this name.
   */
  stiffness_kN_per_m?: number;
  /**
   * What is lost: of a small speed u a stop gives back about `u (1 - 2/3 dissipation u)`, s/m.
   */
  dissipation_s_per_m?: number;
};
/**
 * Turns about and slides along one axis. Its coordinates are `rotation` and `translation`.
 */
export type CylindricalJoint = {
  /**
   * Name of the joint; the body's when absent.
   */
  name?: string | null;
  /**
   * The axis in this body's axes, of any length but 0.
   *
   * @minItems 3
   * @maxItems 3
   */
  axis: [number, number, number];
  /**
   * The joint in the parent's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The joint in this body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  child_position_m?: [number, number, number];
  /**
   * This body's axes in the parent's where all coordinates are 0: roll, pitch, yaw (intrinsic z-y-x angles), rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
  rotation?: AngleAxis;
  translation?: LengthAxis;
};
/**
 * The turning about the axis.
 */
export type AngleAxis = {
  /**
   * Angle at the start, rad.
   */
  initial_angle_rad?: number;
  /**
   * The same as `initial_angle_rad`, in the unit of this name.
   */
  initial_angle_deg?: number;
  /**
   * Rate at the start, rad/s.
   */
  initial_rate_rad_s?: number;
  /**
   * The same as `initial_rate_rad_s`, in the unit of this name.
   */
  initial_rate_deg_s?: number;
  /**
   * Free, held or prescribed.
   */
  mode?:
    | "free"
    | "held"
    | {
        prescribed: PrescribedRate;
      }
    | {
        travel: AngleTravel;
      };
  /**
   * Viscous damping moment per rate, N m s.
   */
  damping_N_m_s?: number;
  /**
   * The same as `damping_N_m_s`, in the unit of this name.
   */
  damping_kN_m_s?: number;
  /**
   * Dry friction.
   */
  friction?: AngleFriction | null;
  /**
   * A spring.
   */
  spring?: AngleSpring | null;
  /**
   * Stops at the ends of the travel.
   */
  limits?: AngleLimits | null;
  /**
   * Moment of inertia of the motor's rotor about its own axis, kg m^2.
   */
  rotor_inertia_kg_m2?: number;
  /**
   * The same as `rotor_inertia_kg_m2`, in the unit of this name.
   */
  rotor_inertia_t_m2?: number;
  /**
   * Turns of the rotor for one turn about the axis.
   */
  gear_ratio?: number;
};
/**
 * The sliding along the axis.
 */
export type LengthAxis = {
  /**
   * Extension at the start, m.
   */
  initial_extension_m?: number;
  /**
   * Speed at the start, m/s.
   */
  initial_speed_m_s?: number;
  /**
   * Free, held or prescribed.
   */
  mode?:
    | "free"
    | "held"
    | {
        prescribed: PrescribedSpeed;
      }
    | {
        travel: LengthTravel;
      };
  /**
   * Viscous damping force per speed, N s/m.
   */
  damping_N_s_m?: number;
  /**
   * The same as `damping_N_s_m`, in the unit of this name.
   */
  damping_kN_s_m?: number;
  /**
   * Dry friction.
   */
  friction?: LengthFriction | null;
  /**
   * A spring.
   */
  spring?: LengthSpring | null;
  /**
   * Stops at the ends of the travel.
   */
  limits?: LengthLimits | null;
  /**
   * Moment of inertia of the motor's rotor about its own axis, kg m^2.
   */
  rotor_inertia_kg_m2?: number;
  /**
   * The same as `rotor_inertia_kg_m2`, in the unit of this name.
   */
  rotor_inertia_t_m2?: number;
  /**
   * Angle of the rotor per extension, rad/m.
   */
  gear_ratio_rad_per_m?: number;
};
/**
 * Turns about an axis that stays with the parent, then about one that stays with this body. Its coordinates are
 * `first` and `second`.
 */
export type UniversalJoint = {
  /**
   * Name of the joint; the body's when absent.
   */
  name?: string | null;
  /**
   * The axis that stays with the parent, in this body's axes at angle 0, of any length but 0.
   *
   * @minItems 3
   * @maxItems 3
   */
  first_axis: [number, number, number];
  /**
   * The axis that stays with this body, in its axes, perpendicular to the first.
   *
   * @minItems 3
   * @maxItems 3
   */
  second_axis: [number, number, number];
  /**
   * The joint in the parent's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The joint in this body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  child_position_m?: [number, number, number];
  /**
   * This body's axes in the parent's where all coordinates are 0: roll, pitch, yaw (intrinsic z-y-x angles), rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
  first?: AngleAxis1;
  second?: AngleAxis2;
};
/**
 * The turning about the first axis.
 */
export type AngleAxis1 = {
  /**
   * Angle at the start, rad.
   */
  initial_angle_rad?: number;
  /**
   * The same as `initial_angle_rad`, in the unit of this name.
   */
  initial_angle_deg?: number;
  /**
   * Rate at the start, rad/s.
   */
  initial_rate_rad_s?: number;
  /**
   * The same as `initial_rate_rad_s`, in the unit of this name.
   */
  initial_rate_deg_s?: number;
  /**
   * Free, held or prescribed.
   */
  mode?:
    | "free"
    | "held"
    | {
        prescribed: PrescribedRate;
      }
    | {
        travel: AngleTravel;
      };
  /**
   * Viscous damping moment per rate, N m s.
   */
  damping_N_m_s?: number;
  /**
   * The same as `damping_N_m_s`, in the unit of this name.
   */
  damping_kN_m_s?: number;
  /**
   * Dry friction.
   */
  friction?: AngleFriction | null;
  /**
   * A spring.
   */
  spring?: AngleSpring | null;
  /**
   * Stops at the ends of the travel.
   */
  limits?: AngleLimits | null;
  /**
   * Moment of inertia of the motor's rotor about its own axis, kg m^2.
   */
  rotor_inertia_kg_m2?: number;
  /**
   * The same as `rotor_inertia_kg_m2`, in the unit of this name.
   */
  rotor_inertia_t_m2?: number;
  /**
   * Turns of the rotor for one turn about the axis.
   */
  gear_ratio?: number;
};
/**
 * The turning about the second axis.
 */
export type AngleAxis2 = {
  /**
   * Angle at the start, rad.
   */
  initial_angle_rad?: number;
  /**
   * The same as `initial_angle_rad`, in the unit of this name.
   */
  initial_angle_deg?: number;
  /**
   * Rate at the start, rad/s.
   */
  initial_rate_rad_s?: number;
  /**
   * The same as `initial_rate_rad_s`, in the unit of this name.
   */
  initial_rate_deg_s?: number;
  /**
   * Free, held or prescribed.
   */
  mode?:
    | "free"
    | "held"
    | {
        prescribed: PrescribedRate;
      }
    | {
        travel: AngleTravel;
      };
  /**
   * Viscous damping moment per rate, N m s.
   */
  damping_N_m_s?: number;
  /**
   * The same as `damping_N_m_s`, in the unit of this name.
   */
  damping_kN_m_s?: number;
  /**
   * Dry friction.
   */
  friction?: AngleFriction | null;
  /**
   * A spring.
   */
  spring?: AngleSpring | null;
  /**
   * Stops at the ends of the travel.
   */
  limits?: AngleLimits | null;
  /**
   * Moment of inertia of the motor's rotor about its own axis, kg m^2.
   */
  rotor_inertia_kg_m2?: number;
  /**
   * The same as `rotor_inertia_kg_m2`, in the unit of this name.
   */
  rotor_inertia_t_m2?: number;
  /**
   * Turns of the rotor for one turn about the axis.
   */
  gear_ratio?: number;
};
/**
 * Slides in a plane that stays with the parent and turns about its normal. Its coordinates are `x`, `y` and
 * `rotation`.
 */
export type PlanarJoint = {
  /**
   * Name of the joint; the body's when absent.
   */
  name?: string | null;
  /**
   * The plane's normal in this body's axes, of any length but 0.
   *
   * @minItems 3
   * @maxItems 3
   */
  normal: [number, number, number];
  /**
   * The direction of x in the plane, in this body's axes at angle 0, perpendicular to the normal; y is the normal
   * times x.
   *
   * @minItems 3
   * @maxItems 3
   */
  x_axis: [number, number, number];
  /**
   * The joint in the parent's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The joint in this body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  child_position_m?: [number, number, number];
  /**
   * This body's axes in the parent's where all coordinates are 0: roll, pitch, yaw (intrinsic z-y-x angles), rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
  x?: LengthAxis1;
  y?: LengthAxis2;
  rotation?: AngleAxis3;
};
/**
 * The sliding along x.
 */
export type LengthAxis1 = {
  /**
   * Extension at the start, m.
   */
  initial_extension_m?: number;
  /**
   * Speed at the start, m/s.
   */
  initial_speed_m_s?: number;
  /**
   * Free, held or prescribed.
   */
  mode?:
    | "free"
    | "held"
    | {
        prescribed: PrescribedSpeed;
      }
    | {
        travel: LengthTravel;
      };
  /**
   * Viscous damping force per speed, N s/m.
   */
  damping_N_s_m?: number;
  /**
   * The same as `damping_N_s_m`, in the unit of this name.
   */
  damping_kN_s_m?: number;
  /**
   * Dry friction.
   */
  friction?: LengthFriction | null;
  /**
   * A spring.
   */
  spring?: LengthSpring | null;
  /**
   * Stops at the ends of the travel.
   */
  limits?: LengthLimits | null;
  /**
   * Moment of inertia of the motor's rotor about its own axis, kg m^2.
   */
  rotor_inertia_kg_m2?: number;
  /**
   * The same as `rotor_inertia_kg_m2`, in the unit of this name.
   */
  rotor_inertia_t_m2?: number;
  /**
   * Angle of the rotor per extension, rad/m.
   */
  gear_ratio_rad_per_m?: number;
};
/**
 * The sliding along y.
 */
export type LengthAxis2 = {
  /**
   * Extension at the start, m.
   */
  initial_extension_m?: number;
  /**
   * Speed at the start, m/s.
   */
  initial_speed_m_s?: number;
  /**
   * Free, held or prescribed.
   */
  mode?:
    | "free"
    | "held"
    | {
        prescribed: PrescribedSpeed;
      }
    | {
        travel: LengthTravel;
      };
  /**
   * Viscous damping force per speed, N s/m.
   */
  damping_N_s_m?: number;
  /**
   * The same as `damping_N_s_m`, in the unit of this name.
   */
  damping_kN_s_m?: number;
  /**
   * Dry friction.
   */
  friction?: LengthFriction | null;
  /**
   * A spring.
   */
  spring?: LengthSpring | null;
  /**
   * Stops at the ends of the travel.
   */
  limits?: LengthLimits | null;
  /**
   * Moment of inertia of the motor's rotor about its own axis, kg m^2.
   */
  rotor_inertia_kg_m2?: number;
  /**
   * The same as `rotor_inertia_kg_m2`, in the unit of this name.
   */
  rotor_inertia_t_m2?: number;
  /**
   * Angle of the rotor per extension, rad/m.
   */
  gear_ratio_rad_per_m?: number;
};
/**
 * The turning about the normal.
 */
export type AngleAxis3 = {
  /**
   * Angle at the start, rad.
   */
  initial_angle_rad?: number;
  /**
   * The same as `initial_angle_rad`, in the unit of this name.
   */
  initial_angle_deg?: number;
  /**
   * Rate at the start, rad/s.
   */
  initial_rate_rad_s?: number;
  /**
   * The same as `initial_rate_rad_s`, in the unit of this name.
   */
  initial_rate_deg_s?: number;
  /**
   * Free, held or prescribed.
   */
  mode?:
    | "free"
    | "held"
    | {
        prescribed: PrescribedRate;
      }
    | {
        travel: AngleTravel;
      };
  /**
   * Viscous damping moment per rate, N m s.
   */
  damping_N_m_s?: number;
  /**
   * The same as `damping_N_m_s`, in the unit of this name.
   */
  damping_kN_m_s?: number;
  /**
   * Dry friction.
   */
  friction?: AngleFriction | null;
  /**
   * A spring.
   */
  spring?: AngleSpring | null;
  /**
   * Stops at the ends of the travel.
   */
  limits?: AngleLimits | null;
  /**
   * Moment of inertia of the motor's rotor about its own axis, kg m^2.
   */
  rotor_inertia_kg_m2?: number;
  /**
   * The same as `rotor_inertia_kg_m2`, in the unit of this name.
   */
  rotor_inertia_t_m2?: number;
  /**
   * Turns of the rotor for one turn about the axis.
   */
  gear_ratio?: number;
};
/**
 * Turns about a point. Its coordinates `x`, `y` and `z` are the angular velocity against the parent in this body's
 * axes.
 */
export type SphericalJoint = {
  /**
   * Name of the joint; the body's when absent.
   */
  name?: string | null;
  /**
   * The joint in the parent's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The joint in this body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  child_position_m?: [number, number, number];
  /**
   * This body's axes in the parent's where all coordinates are 0: roll, pitch, yaw (intrinsic z-y-x angles), rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
  /**
   * This body's axes at the start in those that `orientation_rad` gives: roll, pitch, yaw (intrinsic z-y-x angles),
   * rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  initial_orientation_rad?: [number, number, number];
  /**
   * The same as `initial_orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  initial_orientation_deg?: [number, number, number];
  /**
   * Angular velocity against the parent at the start, in this body's axes, rad/s.
   *
   * @minItems 3
   * @maxItems 3
   */
  initial_angular_velocity_rad_s?: [number, number, number];
  /**
   * The same as `initial_angular_velocity_rad_s`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  initial_angular_velocity_deg_s?: [number, number, number];
  /**
   * Viscous damping moment per angular velocity, N m s.
   */
  damping_N_m_s?: number;
  /**
   * The same as `damping_N_m_s`, in the unit of this name.
   */
  damping_kN_m_s?: number;
  /**
   * Holds the orientation against the parent as it is.
   */
  held?: boolean;
};
/**
 * No motion against the parent.
 */
export type FixedJoint = {
  /**
   * Name of the joint; the body's when absent.
   */
  name?: string | null;
  /**
   * The joint in the parent's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The joint in this body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  child_position_m?: [number, number, number];
  /**
   * This body's axes in the parent's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
};
/**
 * A body that moves with the waves of the sea by displacement RAOs, whatever acts on it. Its parent is the world. Its
 * coordinates `x`, `y`, `z`, `yaw`, `pitch` and `roll` are those of the RAOs' vessel axes about their mean place.
 */
export type MovedByWaves = {
  /**
   * Name of the joint; the body's when absent.
   */
  name?: string | null;
  /**
   * The file of the RAOs: CSV whose names state its conventions, or OrcaFlex's YAML with one vessel type.
   */
  raos: string;
  /**
   * Whether port is as starboard, where a CSV file holds waves from 0 to 180 degrees only.
   */
  symmetric?: boolean | null;
  /**
   * The origin of the file's vessel axes in this body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  origin_m?: [number, number, number];
  /**
   * Mean place of that origin in the world, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * Mean heading, from the world's x axis counter-clockwise, rad.
   */
  heading_rad?: number;
  /**
   * The same as `heading_rad`, in the unit of this name.
   */
  heading_deg?: number;
};
/**
 * Where it is tied to one body. Constraints are along and about these axes.
 */
export type Attachment = {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * The point in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The axes in the body's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
};
/**
 * Where it is tied to the other.
 */
export type Attachment1 = {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * The point in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The axes in the body's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
};
/**
 * One equation between the two attachments.
 */
export type Constraint =
  | "x"
  | "y"
  | "z"
  | "roll"
  | "pitch"
  | "yaw"
  | {
      distance: Distance;
    };
/**
 * One wave system of the sea. Directions are those that the waves go to, from the world's x axis towards y: 180 degrees
 * is a head sea for a ship at heading 0.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export type Waves =
  | {
      regular: RegularWave;
    }
  | {
      jonswap: Jonswap;
    }
  | {
      pierson_moskowitz: PiersonMoskowitz;
    }
  | {
      ochi_hubble: OchiHubble;
    }
  | {
      torsethaugen: PiersonMoskowitz;
    }
  | {
      spectrum: SpectrumTable;
    }
  | {
      record: ElevationRecord;
    };
/**
 * A regular wave.
 */
export type RegularWave = {
  /**
   * Whether it runs.
   */
  enabled?: boolean;
  /**
   * From trough to crest, m.
   */
  height_m: number;
  /**
   * Period, s.
   */
  period_s: number;
  /**
   * Where it goes to, rad.
   */
  direction_rad?: number;
  /**
   * The same as `direction_rad`, in the unit of this name.
   */
  direction_deg?: number;
  /**
   * Phase at the world's origin at time 0, rad: with 0 a crest is there.
   */
  phase_rad?: number;
  /**
   * The same as `phase_rad`, in the unit of this name.
   */
  phase_deg?: number;
};
/**
 * A sea by the JONSWAP spectrum, scaled to the significant height numerically.
 */
export type Jonswap = {
  /**
   * Whether it runs.
   */
  enabled?: boolean;
  /**
   * Significant wave height Hs, m.
   */
  significant_height_m: number;
  /**
   * Period at the spectrum's peak, s.
   */
  peak_period_s: number;
  /**
   * Peak enhancement gamma, from 1 to 10; 1 is Pierson and Moskowitz' spectrum.
   */
  gamma?: number;
  /**
   * Mean direction that the waves go to, rad.
   */
  direction_rad?: number;
  /**
   * The same as `direction_rad`, in the unit of this name.
   */
  direction_deg?: number;
  realisation?: WaveRealisation;
};
/**
 * How the realisation is made.
 */
export type WaveRealisation = {
  /**
   * Number of components.
   */
  components?: number;
  /**
   * Whether amplitudes are random too, as in a record of the sea, or those of the spectrum.
   */
  amplitudes?: "deterministic" | "random";
  /**
   * s of the spreading cos^(2 s) of half the angle from the mean direction; without it, the crests are long.
   */
  spreading_exponent?: number | null;
  /**
   * Waves of less than this frequency are cut off, rad/s, their energy with them; without it, none are.
   */
  lowest_rad_s?: number | null;
  /**
   * The same as `lowest_rad_s`, in the unit of this name.
   */
  lowest_deg_s?: number | null;
  /**
   * Waves of more than this frequency are cut off, rad/s, their energy with them; without it, none are.
   */
  highest_rad_s?: number | null;
  /**
   * The same as `highest_rad_s`, in the unit of this name.
   */
  highest_deg_s?: number | null;
};
/**
 * A sea by significant height and peak period: the Pierson-Moskowitz spectrum, or Torsethaugen's.
 */
export type PiersonMoskowitz = {
  /**
   * Whether it runs.
   */
  enabled?: boolean;
  /**
   * Significant wave height Hs, m.
   */
  significant_height_m: number;
  /**
   * Period at the spectrum's peak, s.
   */
  peak_period_s: number;
  /**
   * Mean direction that the waves go to, rad.
   */
  direction_rad?: number;
  /**
   * The same as `direction_rad`, in the unit of this name.
   */
  direction_deg?: number;
  realisation?: WaveRealisation1;
};
/**
 * How the realisation is made.
 */
export type WaveRealisation1 = {
  /**
   * Number of components.
   */
  components?: number;
  /**
   * Whether amplitudes are random too, as in a record of the sea, or those of the spectrum.
   */
  amplitudes?: "deterministic" | "random";
  /**
   * s of the spreading cos^(2 s) of half the angle from the mean direction; without it, the crests are long.
   */
  spreading_exponent?: number | null;
  /**
   * Waves of less than this frequency are cut off, rad/s, their energy with them; without it, none are.
   */
  lowest_rad_s?: number | null;
  /**
   * The same as `lowest_rad_s`, in the unit of this name.
   */
  lowest_deg_s?: number | null;
  /**
   * Waves of more than this frequency are cut off, rad/s, their energy with them; without it, none are.
   */
  highest_rad_s?: number | null;
  /**
   * The same as `highest_rad_s`, in the unit of this name.
   */
  highest_deg_s?: number | null;
};
/**
 * A sea of two parts, each with a spectrum of three parameters.
 */
export type OchiHubble = {
  /**
   * Whether it runs.
   */
  enabled?: boolean;
  swell: OchiHubblePart;
  wind_sea: OchiHubblePart1;
  /**
   * Mean direction that the waves of both go to, rad.
   */
  direction_rad?: number;
  /**
   * The same as `direction_rad`, in the unit of this name.
   */
  direction_deg?: number;
  realisation?: WaveRealisation2;
};
/**
 * How the realisation is made.
 */
export type WaveRealisation2 = {
  /**
   * Number of components.
   */
  components?: number;
  /**
   * Whether amplitudes are random too, as in a record of the sea, or those of the spectrum.
   */
  amplitudes?: "deterministic" | "random";
  /**
   * s of the spreading cos^(2 s) of half the angle from the mean direction; without it, the crests are long.
   */
  spreading_exponent?: number | null;
  /**
   * Waves of less than this frequency are cut off, rad/s, their energy with them; without it, none are.
   */
  lowest_rad_s?: number | null;
  /**
   * The same as `lowest_rad_s`, in the unit of this name.
   */
  lowest_deg_s?: number | null;
  /**
   * Waves of more than this frequency are cut off, rad/s, their energy with them; without it, none are.
   */
  highest_rad_s?: number | null;
  /**
   * The same as `highest_rad_s`, in the unit of this name.
   */
  highest_deg_s?: number | null;
};
/**
 * A sea whose spectrum is given as a table.
 */
export type SpectrumTable = {
  /**
   * Whether it runs.
   */
  enabled?: boolean;
  /**
   * Angular frequency, rad/s, and density S of the elevation's variance, m^2 s/rad, row by row; linear between rows, no
   * waves outside.
   */
  rows: [number, number][];
  /**
   * Mean direction that the waves go to, rad.
   */
  direction_rad?: number;
  /**
   * The same as `direction_rad`, in the unit of this name.
   */
  direction_deg?: number;
  realisation?: WaveRealisation3;
};
/**
 * How the realisation is made.
 */
export type WaveRealisation3 = {
  /**
   * Number of components.
   */
  components?: number;
  /**
   * Whether amplitudes are random too, as in a record of the sea, or those of the spectrum.
   */
  amplitudes?: "deterministic" | "random";
  /**
   * s of the spreading cos^(2 s) of half the angle from the mean direction; without it, the crests are long.
   */
  spreading_exponent?: number | null;
  /**
   * Waves of less than this frequency are cut off, rad/s, their energy with them; without it, none are.
   */
  lowest_rad_s?: number | null;
  /**
   * The same as `lowest_rad_s`, in the unit of this name.
   */
  lowest_deg_s?: number | null;
  /**
   * Waves of more than this frequency are cut off, rad/s, their energy with them; without it, none are.
   */
  highest_rad_s?: number | null;
  /**
   * The same as `highest_rad_s`, in the unit of this name.
   */
  highest_deg_s?: number | null;
};
/**
 * Waves that were measured at one point, in a direction that one point cannot tell. The sea repeats after the record's
 * length; its mean is left out.
 */
export type ElevationRecord = {
  /**
   * Whether it runs.
   */
  enabled?: boolean;
  /**
   * CSV file beside the scenario's own, with the header `time_s,elevation_m` and equal intervals of time.
   */
  file: string;
  /**
   * Where it was measured, x and y in the world, m.
   *
   * @minItems 2
   * @maxItems 2
   */
  position_m?: [number, number];
  /**
   * Direction that the waves go to, rad.
   */
  direction_rad?: number;
  /**
   * The same as `direction_rad`, in the unit of this name.
   */
  direction_deg?: number;
  /**
   * Waves of less than this frequency are left out, rad/s; without it, none.
   */
  lowest_rad_s?: number | null;
  /**
   * The same as `lowest_rad_s`, in the unit of this name.
   */
  lowest_deg_s?: number | null;
  /**
   * Waves of more than this frequency are left out, rad/s; without it, those above half the sampling frequency.
   */
  highest_rad_s?: number | null;
  /**
   * The same as `highest_rad_s`, in the unit of this name.
   */
  highest_deg_s?: number | null;
};
/**
 * The current at given depths, its components linear between them and below the last as there.
 */
export type CurrentTable = {
  [k: string]: unknown;
} & {
  /**
   * Depths under the still water, m, from 0 on, increasing.
   */
  depths_m: number[];
  /**
   * Speed at each depth, m/s.
   */
  speeds_m_s: number[];
  /**
   * Direction that the current goes to at each depth, from the world's x axis, counter-clockwise, rad.
   */
  directions_rad?: number[];
  /**
   * The same as `directions_rad`, in the unit of this name.
   */
  directions_deg?: number[];
};
/**
 * The wind: the same everywhere at one height, steady or with gusts.
 */
export type Wind = {
  [k: string]: unknown;
} & {
  /**
   * Mean speed at the reference height, m/s.
   */
  speed_m_s: number;
  /**
   * Direction that the wind goes to, from the world's x axis, counter-clockwise, rad.
   */
  direction_rad?: number;
  /**
   * The same as `direction_rad`, in the unit of this name.
   */
  direction_deg?: number;
  /**
   * Height above the still water that the speed is given at, m.
   */
  reference_height_m?: number;
  /**
   * How the mean speed goes with the height.
   */
  profile?:
    | "uniform"
    | {
        power_law: PowerLaw;
      }
    | {
        logarithmic: Logarithmic;
      }
    | "npd";
  /**
   * What the speed does about its mean; without it, the wind is steady.
   */
  gusts?: Gusts | null;
  /**
   * Density of the air, kg/m^3.
   */
  air_density_kg_m3?: number;
};
/**
 * What acts on the bodies from outside.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export type Force =
  | {
      gravity: Gravity;
    }
  | {
      viscous_damping: ViscousDamping;
    }
  | {
      quadratic_damping: QuadraticDamping;
    }
  | {
      hydrodynamics: Hydrodynamics;
    }
  | {
      slack_tank: SlackTank;
    }
  | {
      submerged: Submerged;
    }
  | {
      spring_line: SpringLine;
    }
  | {
      catenary_line: CatenaryLine;
    }
  | {
      rope: Rope;
    }
  | {
      tugger_line: TuggerLine;
    }
  | {
      contact: Contact;
    }
  | {
      wind_load: WindLoad;
    }
  | {
      current_load: CurrentLoad;
    }
  | {
      dynamic_positioning: DynamicPositioning;
    }
  | {
      soft_hold: SoftHold;
    };
/**
 * A force and a moment against a body's velocity and angular velocity, each in body axes.
 */
export type ViscousDamping = {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The body.
   */
  body: string;
  /**
   * What its velocity is relative to.
   */
  relative_to?: "water" | "earth";
  /**
   * The point that the force acts at, and whose velocity counts, in the body's drawing frame, m; without it, the
   * centre of mass.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number] | null;
  /**
   * Force per velocity of the point along x, y, z of the body, N s/m.
   *
   * @minItems 3
   * @maxItems 3
   */
  linear_N_s_m?: [number, number, number];
  /**
   * The same as `linear_N_s_m`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  linear_kN_s_m?: [number, number, number];
  /**
   * Moment per roll, pitch, yaw rate, N m s.
   *
   * @minItems 3
   * @maxItems 3
   */
  angular_N_m_s?: [number, number, number];
  /**
   * The same as `angular_N_m_s`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  angular_kN_m_s?: [number, number, number];
  /**
   * Added to these: rows of force x, y, z (N) and moment x, y, z (N m), columns of velocity x, y, z (m/s) and roll,
   * pitch, yaw rate (rad/s). No motion may gain energy from it.
   *
   * @minItems 6
   * @maxItems 6
   */
  matrix?:
    | [
        [number, number, number, number, number, number],
        [number, number, number, number, number, number],
        [number, number, number, number, number, number],
        [number, number, number, number, number, number],
        [number, number, number, number, number, number],
        [number, number, number, number, number, number]
      ]
    | null;
};
/**
 * The water on a hull, by potential theory at zero forward speed: buoyancy, added mass, the waves that the hull makes
 * and those that come. Weight is no part of it: that is gravity's, on every body.
 */
export type Hydrodynamics = {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The body that is the hull; its joint is floating.
   */
  body: string;
  /**
   * File of the hydrodynamic database, beside the scenario's own.
   */
  database: string;
  /**
   * The database's origin in the body's drawing frame, m; the axes are the body's. It lies on the water plane at the
   * database's draught.
   *
   * @minItems 3
   * @maxItems 3
   */
  origin_m?: [number, number, number];
  /**
   * How buoyancy is computed.
   */
  hydrostatics?: "linear" | "mesh" | "none";
  /**
   * Whether the infinite-frequency added mass moves with the hull.
   */
  added_mass?: boolean;
  /**
   * Whether the waves that the hull makes act on it.
   */
  radiation?: boolean;
  /**
   * Whether the sea's waves act on it.
   */
  excitation?: boolean;
  /**
   * Whether the waves' own pressure acts on what their surface wets of the mesh, instead of the linear Froude-Krylov
   * force: large motions and high waves. Excitation is then by diffraction alone. Needs `hydrostatics: mesh`.
   */
  wave_pressure?: boolean;
  /**
   * Whether the mean and slowly varying drift forces of the waves act on it, by Newman's approximation: surge and sway
   * force, yaw moment. The database's coefficients hold for the loading that they were computed for. Not beside
   * `wave_pressure`.
   */
  wave_drift?: boolean;
  /**
   * Whether the drift forces change with the velocity of the hull through the water, by Aranha's formula for deep water:
   * damping of slow surge and sway by the waves, and more or less drift in a current. Needs `wave_drift`.
   */
  wave_drift_damping?: boolean;
  /**
   * First-order wave loads are taken at the place and heading that pass a filter of sixth order with this cut-off, rad/s:
   * well below the waves' frequencies, above those of the ship's drift, which it follows without lag.
   */
  slow_motion_cutoff_rad_s?: number;
  /**
   * The same as `slow_motion_cutoff_rad_s`, in the unit of this name.
   */
  slow_motion_cutoff_deg_s?: number;
};
/**
 * The water that moves with it.
 */
export type SubmergedAddedMass = {
  /**
   * C_A along x, y and z of the body (DNV-RP-N103, appendix A).
   *
   * @minItems 3
   * @maxItems 3
   */
  coefficients?: [number, number, number];
  /**
   * V_R that the coefficients refer to, m^3; without it, the volume of the solid.
   */
  reference_volume_m3?: number | null;
  /**
   * Added moments of inertia about x, y and z through the solid's centre, kg m^2.
   *
   * @minItems 3
   * @maxItems 3
   */
  moments_kg_m2?: [number, number, number];
  /**
   * The same as `moments_kg_m2`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  moments_t_m2?: [number, number, number];
  /**
   * Open area over the whole of the plates, from 0 to 0.5: it reduces the coefficients.
   */
  perforation?: number;
  /**
   * How it grows with the share of the volume that is under water; without it, in proportion.
   */
  growth?: SubmergedGrowth | null;
};
/**
 * Drag.
 */
export type SubmergedDrag = {
  /**
   * C_D along x, y and z of the body, in oscillating flow (DNV-RP-N103, appendix B).
   *
   * @minItems 3
   * @maxItems 3
   */
  coefficients?: [number, number, number];
  /**
   * A_p across x, y and z that the coefficients refer to, m^2; without it, the solid's shadow.
   *
   * @minItems 3
   * @maxItems 3
   */
  areas_m2?: [number, number, number] | null;
  /**
   * c along x, y and z of the body, N s/m.
   *
   * @minItems 3
   * @maxItems 3
   */
  linear_N_s_m?: [number, number, number];
  /**
   * The same as `linear_N_s_m`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  linear_kN_s_m?: [number, number, number];
};
/**
 * A line without weight between two points on bodies, or on a body and in the world: a spring that pulls when it is
 * longer than its unstretched length.
 */
export type SpringLine = {
  [k: string]: unknown;
} & {
  /**
   * Whether it is there.
   */
  enabled?: boolean;
  first: Pin;
  second: Pin1;
  /**
   * Length without tension, m.
   */
  unstretched_length_m: number;
  /**
   * EA: tension per strain, N.
   */
  axial_stiffness_N?: number;
  /**
   * The same as `axial_stiffness_N`, in the unit of this name.
   */
  axial_stiffness_kN?: number;
  /**
   * Damping along the line: a in T = EA/L0 s (1 + a s') at the stretch s, never less than 0, s/m.
   */
  dissipation_s_per_m?: number;
};
/**
 * A mooring line from a fairlead to an anchor: at every moment the elastic catenary in which it would rest, without
 * inertia, drag and seabed friction of its own.
 */
export type CatenaryLine = {
  [k: string]: unknown;
} & {
  /**
   * Whether it is there.
   */
  enabled?: boolean;
  fairlead: Pin2;
  /**
   * The lower end in the world, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  anchor_m: [number, number, number];
  /**
   * Length without tension, m.
   */
  unstretched_length_m: number;
  /**
   * Weight less buoyancy of the unstretched length, N/m.
   */
  weight_in_water_N_per_m?: number;
  /**
   * The same as `weight_in_water_N_per_m`, in the unit of this name.
   */
  weight_in_water_kN_per_m?: number;
  /**
   * EA: tension per strain, N.
   */
  axial_stiffness_N?: number;
  /**
   * The same as `axial_stiffness_N`, in the unit of this name.
   */
  axial_stiffness_kN?: number;
  /**
   * Whether the anchor stands on a flat seabed, at the anchor's depth everywhere, that carries the line. Without it
   * the line hangs freely.
   */
  seabed?: boolean;
};
/**
 * A rope without inertia that runs over sheaves: a hoist, a sling, a tugger line. It pulls where its path is longer than the rope,
 * else it is slack. Without a stiffness it is inextensible: it comes taut without a rebound, and its tension there is none that
 * a load could be sized by.
 */
export type Rope = {
  /**
   * Whether it is there.
   */
  enabled?: boolean;
  /**
   * What it runs over, from its first end to its last: it begins at a point or a drum and ends at a point.
   */
  path: RopeStation[];
  /**
   * Length without tension of the rope on its path at the start, m; without it, the rope is just taut at the start.
   */
  unstretched_length_m?: number | null;
  /**
   * EA: tension per strain, N; without it, the rope itself does not stretch.
   */
  axial_stiffness_N?: number | null;
  /**
   * The same as `axial_stiffness_N`, in the unit of this name.
   */
  axial_stiffness_kN?: number | null;
  /**
   * Stiffness of what gives way in series with the rope, the crane's boom and foundation say, N/m; without it, nothing
   * does.
   */
  series_stiffness_N_per_m?: number | null;
  /**
   * The same as `series_stiffness_N_per_m`, in the unit of this name.
   */
  series_stiffness_kN_per_m?: number | null;
  /**
   * Damping over stiffness, s: at the rate e' of its stretch the rope pulls k tau e' beside k e. For wire ropes it is 0.01
   * to 0.02 s.
   */
  damping_time_s?: number;
  /**
   * Its mass, kg/m, which is weight alone; without it, the rope weighs nothing. Its legs stay straight.
   */
  mass_kg_per_m?: number | null;
  /**
   * Diameter of the circle that displaces as much water as the rope below the still water line, m; without it, none.
   */
  diameter_m?: number | null;
  /**
   * Tension at which the rope parts, N; without it, it does not.
   */
  breaking_load_N?: number | null;
  /**
   * The same as `breaking_load_N`, in the unit of this name.
   */
  breaking_load_kN?: number | null;
  /**
   * What hangs on it: its dynamic amplification factor is its tension over that of this load at rest in air.
   */
  carries?: CarriedByRope[];
  /**
   * What the crane may lift by it at which radius; without it, nothing is known of that.
   */
  load_chart?: LoadChart | null;
  /**
   * Whether it can be released: an input in [0, 1] of the rope's name begins at 0, and at 0.5 the load is lost.
   */
  can_be_released?: boolean;
};
/**
 * A place on a rope's path.
 */
export type RopeStation =
  | {
      point: RopePoint;
    }
  | {
      sheave: Sheave;
    }
  | {
      drum: RopeDrum;
    };
/**
 * The load chart of a crane: rated loads over the radius, which is the distance from the slewing axis to where the rope leaves
 * the crane for the load. The results have `load_radius` (m), `rated_load` and `hook_load` (kg) and `load_utilisation`, hook load
 * over rated load; a run warns where that passes 1, and of a radius outside of the chart.
 */
export type LoadChart = {
  [k: string]: unknown;
} & {
  /**
   * The revolute joint by which the crane slews.
   */
  joint: string;
  /**
   * Radii that increase, m: two or more.
   */
  radii_m: number[];
  /**
   * The rated load at each radius, with what hangs between rope and load, kg: linear between, before the first and beyond the
   * last as there.
   */
  rated_loads_kg?: number[];
  /**
   * The same as `rated_loads_kg`, in the unit of this name.
   */
  rated_loads_t?: number[];
};
/**
 * A line whose winch pays out and hauls in so that its tension stays: a tugger line or a tag line. The winch stands at its
 * first end.
 */
export type TuggerLine = {
  [k: string]: unknown;
} & {
  /**
   * Whether it is there.
   */
  enabled?: boolean;
  /**
   * What it runs over, from its winch to the load: it begins and ends at a point.
   */
  path: RopeStation[];
  /**
   * Its tension at the load, N.
   */
  tension_N?: number;
  /**
   * The same as `tension_N`, in the unit of this name.
   */
  tension_kN?: number;
};
/**
 * Contact of a load with a surface: it is pressed out, and held by friction.
 */
export type Contact = {
  [k: string]: unknown;
} & {
  /**
   * Whether it is there.
   */
  enabled?: boolean;
  load: ContactLoad;
  surface: ContactSurface;
  /**
   * Stiffness of each point that touches, N/m: a box that stands on four corners has four times as much.
   */
  stiffness_N_per_m?: number;
  /**
   * The same as `stiffness_N_per_m`, in the unit of this name.
   */
  stiffness_kN_per_m?: number;
  /**
   * What is left of the speed of an impact at `restitution_speed_m_s`, from 0.1 to 1; slower impacts leave more.
   */
  restitution?: number;
  /**
   * The speed of impact that the restitution is for, m/s.
   */
  restitution_speed_m_s?: number;
  /**
   * Coulomb's coefficient of friction; 0 for a smooth surface.
   */
  friction_coefficient: number;
  /**
   * Stiffness of each point along the surface while friction holds it, N/m; without it, that of the contact.
   */
  friction_stiffness_N_per_m?: number | null;
  /**
   * The same as `friction_stiffness_N_per_m`, in the unit of this name.
   */
  friction_stiffness_kN_per_m?: number | null;
  /**
   * Penetration that is refused where a run begins, and that a run warns of, m.
   */
  penetration_tolerance_m?: number;
};
/**
 * What touches.
 */
export type ContactLoad = {
  /**
   * The body.
   */
  body: string;
  /**
   * The centre of the shape in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The shape's axes in the body's: roll, pitch, yaw, rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
  /**
   * What touches.
   */
  shape:
    | {
        box: BoxShape;
      }
    | {
        cylinder: CylinderShape;
      }
    | {
        sphere: SphereShape;
      }
    | {
        points: ContactPoints;
      };
};
/**
 * What it touches: a deck, a quay, the seabed, a bumper.
 */
export type ContactSurface = {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * A point of the plane, or the centre of the shape, in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The shape's axes in the body's: roll, pitch, yaw, rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
  /**
   * What is touched.
   */
  shape:
    | {
        plane: ContactPlane;
      }
    | {
        box: BoxShape;
      }
    | {
        sphere: SphereShape;
      };
};
/**
 * The coefficients.
 */
export type FlowCoefficients = {
  [k: string]: unknown;
} & {
  /**
   * Directions that the flow goes to, from the body's x axis, counter-clockwise, rad, increasing: 0 from astern, pi
   * from ahead, as OCIMF's.
   */
  directions_rad?: number[];
  /**
   * The same as `directions_rad`, in the unit of this name.
   */
  directions_deg?: number[];
  /**
   * Whether port is as starboard: the directions go from 0 to pi and are mirrored.
   */
  symmetric: boolean;
  /**
   * C_x at each direction, forward.
   */
  surge: number[];
  /**
   * C_y at each direction, to port.
   */
  sway: number[];
  /**
   * C_n at each direction, bow to port.
   */
  yaw: number[];
  /**
   * A_x, m^2.
   */
  frontal_area_m2: number;
  /**
   * A_y, m^2.
   */
  lateral_area_m2: number;
  /**
   * L, m.
   */
  length_m: number;
};
/**
 * The coefficients.
 */
export type FlowCoefficients1 = {
  [k: string]: unknown;
} & {
  /**
   * Directions that the flow goes to, from the body's x axis, counter-clockwise, rad, increasing: 0 from astern, pi
   * from ahead, as OCIMF's.
   */
  directions_rad?: number[];
  /**
   * The same as `directions_rad`, in the unit of this name.
   */
  directions_deg?: number[];
  /**
   * Whether port is as starboard: the directions go from 0 to pi and are mirrored.
   */
  symmetric: boolean;
  /**
   * C_x at each direction, forward.
   */
  surge: number[];
  /**
   * C_y at each direction, to port.
   */
  sway: number[];
  /**
   * C_n at each direction, bow to port.
   */
  yaw: number[];
  /**
   * A_x, m^2.
   */
  frontal_area_m2: number;
  /**
   * A_y, m^2.
   */
  lateral_area_m2: number;
  /**
   * L, m.
   */
  length_m: number;
};
/**
 * Where.
 */
export type StationTarget = {
  /**
   * x in the world, m.
   */
  x_m?: number;
  /**
   * y in the world, m.
   */
  y_m?: number;
  /**
   * From the world's x axis, counter-clockwise, rad.
   */
  heading_rad?: number;
  /**
   * The same as `heading_rad`, in the unit of this name.
   */
  heading_deg?: number;
};
/**
 * Along the ship.
 */
export type TranslationTuning = {
  [k: string]: unknown;
} & {
  /**
   * Mass, with that of the water that moves with the ship at low frequency, kg.
   */
  mass_kg?: number;
  /**
   * The same as `mass_kg`, in the unit of this name.
   */
  mass_t?: number;
  /**
   * Natural period, s.
   */
  period_s: number;
  /**
   * Damping ratio.
   */
  damping_ratio?: number;
  /**
   * T_i, s; without it 10 / omega.
   */
  integral_time_s?: number | null;
};
/**
 * Athwartships.
 */
export type TranslationTuning1 = {
  [k: string]: unknown;
} & {
  /**
   * Mass, with that of the water that moves with the ship at low frequency, kg.
   */
  mass_kg?: number;
  /**
   * The same as `mass_kg`, in the unit of this name.
   */
  mass_t?: number;
  /**
   * Natural period, s.
   */
  period_s: number;
  /**
   * Damping ratio.
   */
  damping_ratio?: number;
  /**
   * T_i, s; without it 10 / omega.
   */
  integral_time_s?: number | null;
};
/**
 * About the vertical.
 */
export type RotationTuning = {
  [k: string]: unknown;
} & {
  /**
   * Moment of inertia about the vertical, with that of the water, kg m^2.
   */
  inertia_kg_m2?: number;
  /**
   * The same as `inertia_kg_m2`, in the unit of this name.
   */
  inertia_t_m2?: number;
  /**
   * Natural period, s.
   */
  period_s: number;
  /**
   * Damping ratio.
   */
  damping_ratio?: number;
  /**
   * T_i, s; without it 10 / omega.
   */
  integral_time_s?: number | null;
};
/**
 * Gains as numbers: of surge and sway, and of yaw.
 */
export type StatedGains = {
  [k: string]: unknown;
} & {
  /**
   * Force per error, N/m.
   *
   * @minItems 2
   * @maxItems 2
   */
  stiffness_N_per_m?: [number, number];
  /**
   * The same as `stiffness_N_per_m`, in the unit of this name.
   *
   * @minItems 2
   * @maxItems 2
   */
  stiffness_kN_per_m?: [number, number];
  /**
   * Force per velocity, N s/m.
   *
   * @minItems 2
   * @maxItems 2
   */
  damping_N_s_per_m?: [number, number];
  /**
   * The same as `damping_N_s_per_m`, in the unit of this name.
   *
   * @minItems 2
   * @maxItems 2
   */
  damping_kN_s_per_m?: [number, number];
  /**
   * Rate of the force per error, N/(m s).
   *
   * @minItems 2
   * @maxItems 2
   */
  integral_N_per_m_s?: [number, number];
  /**
   * Moment per error, N m/rad.
   */
  yaw_stiffness_N_m_per_rad?: number;
  /**
   * The same as `yaw_stiffness_N_m_per_rad`, in the unit of this name.
   */
  yaw_stiffness_kN_m_per_rad?: number;
  /**
   * Moment per rate, N m s/rad.
   */
  yaw_damping_N_m_s_per_rad?: number;
  /**
   * The same as `yaw_damping_N_m_s_per_rad`, in the unit of this name.
   */
  yaw_damping_kN_m_s_per_rad?: number;
  /**
   * Rate of the moment per error, N m/(rad s).
   */
  yaw_integral_N_m_per_rad_s?: number;
  /**
   * The same as `yaw_integral_N_m_per_rad_s`, in the unit of this name.
   */
  yaw_integral_N_m_per_deg_s?: number;
};
/**
 * A thruster.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export type Thruster =
  | {
      tunnel: TunnelThruster;
    }
  | {
      main_propeller: MainPropeller;
    }
  | {
      azimuth: AzimuthThruster;
    };
/**
 * A propeller in a tunnel.
 */
export type TunnelThruster = {
  [k: string]: unknown;
} & {
  /**
   * Whether it runs.
   */
  enabled?: boolean;
  /**
   * Where it acts, in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
  /**
   * Direction of its positive thrust from the body's x axis to port, rad.
   */
  direction_rad?: number;
  /**
   * The same as `direction_rad`, in the unit of this name.
   */
  direction_deg?: number;
  /**
   * Largest thrust, both ways, N.
   */
  max_thrust_N?: number;
  /**
   * The same as `max_thrust_N`, in the unit of this name.
   */
  max_thrust_kN?: number;
  /**
   * Time constant of the thrust behind its command, s.
   */
  time_constant_s: number;
  /**
   * Weight of its use against that of the others in the allocation.
   */
  weight?: number;
};
/**
 * A propeller on a fixed shaft.
 */
export type MainPropeller = {
  [k: string]: unknown;
} & {
  /**
   * Whether it runs.
   */
  enabled?: boolean;
  /**
   * Where it acts, in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
  /**
   * Direction of its thrust ahead from the body's x axis to port, rad.
   */
  direction_rad?: number;
  /**
   * The same as `direction_rad`, in the unit of this name.
   */
  direction_deg?: number;
  /**
   * Largest thrust ahead, N.
   */
  max_thrust_N?: number;
  /**
   * The same as `max_thrust_N`, in the unit of this name.
   */
  max_thrust_kN?: number;
  /**
   * Largest thrust astern, N.
   */
  max_astern_thrust_N?: number;
  /**
   * The same as `max_astern_thrust_N`, in the unit of this name.
   */
  max_astern_thrust_kN?: number;
  /**
   * Time constant of the thrust behind its command, s.
   */
  time_constant_s: number;
  /**
   * Weight of its use against that of the others in the allocation.
   */
  weight?: number;
};
/**
 * A propeller that turns about the vertical: its thrust is two components, whose length has a limit.
 */
export type AzimuthThruster = {
  [k: string]: unknown;
} & {
  /**
   * Whether it runs.
   */
  enabled?: boolean;
  /**
   * Where it acts, in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
  /**
   * Largest thrust in any direction, N.
   */
  max_thrust_N?: number;
  /**
   * The same as `max_thrust_N`, in the unit of this name.
   */
  max_thrust_kN?: number;
  /**
   * Time constant of both components of the thrust behind their commands, s.
   */
  time_constant_s: number;
  /**
   * Weight of its use against that of the others in the allocation.
   */
  weight?: number;
};
/**
 * A place and a heading.
 */
export type StationTarget1 = {
  /**
   * x in the world, m.
   */
  x_m?: number;
  /**
   * y in the world, m.
   */
  y_m?: number;
  /**
   * From the world's x axis, counter-clockwise, rad.
   */
  heading_rad?: number;
  /**
   * The same as `heading_rad`, in the unit of this name.
   */
  heading_deg?: number;
};
/**
 * What acts between two bodies, mostly in the joint that connects them.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export type Drive =
  | {
      motor: Motor;
    }
  | {
      linear_motor: LinearMotor;
    }
  | {
      servo: Servo;
    }
  | {
      linear_servo: LinearServo;
    }
  | {
      controlled_drive: ControlledDrive;
    }
  | {
      linear_controlled_drive: LinearControlledDrive;
    }
  | {
      brake: Brake;
    }
  | {
      linear_brake: LinearBrake;
    }
  | {
      cylinder: Cylinder;
    };
/**
 * A torque in a revolute joint; the reaction acts on the parent.
 */
export type Motor = {
  [k: string]: unknown;
} & {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The revolute joint, or `joint.axis` for an axis that another joint turns about.
   */
  joint: string;
  /**
   * Full torque, positive about the joint's axis, N m.
   */
  torque_N_m?: number;
  /**
   * The same as `torque_N_m`, in the unit of this name.
   */
  torque_kN_m?: number;
  /**
   * How the torque goes with time.
   */
  history?: "constant" | "pulse" | "list" | "lever";
  /**
   * The times of the history `pulse`.
   */
  pulse?: Pulse | null;
  /**
   * The times and shares of the history `list`.
   */
  list?: HistoryList | null;
};
/**
 * A force in a prismatic joint; the reaction acts on the parent.
 */
export type LinearMotor = {
  [k: string]: unknown;
} & {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The prismatic joint, or `joint.axis` for an axis that another joint slides along.
   */
  joint: string;
  /**
   * Full force, positive along the joint's axis, N.
   */
  force_N?: number;
  /**
   * The same as `force_N`, in the unit of this name.
   */
  force_kN?: number;
  /**
   * How the force goes with time.
   */
  history?: "constant" | "pulse" | "list" | "lever";
  /**
   * The times of the history `pulse`.
   */
  pulse?: Pulse | null;
  /**
   * The times and shares of the history `list`.
   */
  list?: HistoryList | null;
};
/**
 * A torque `stiffness (target - angle) - damping rate` in a revolute joint, clipped at the torque limit.
 */
export type Servo = {
  [k: string]: unknown;
} & {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The revolute joint, or `joint.axis` for an axis that another joint turns about.
   */
  joint: string;
  /**
   * The angle to hold, rad.
   */
  target_rad?: number;
  /**
   * The same as `target_rad`, in the unit of this name.
   */
  target_deg?: number;
  /**
   * Torque per angle, N m/rad.
   */
  stiffness_N_m_per_rad?: number;
  /**
   * The same as `stiffness_N_m_per_rad`, in the unit of this name.
   */
  stiffness_kN_m_per_rad?: number;
  /**
   * Torque per rate, N m s/rad.
   */
  damping_N_m_s_per_rad?: number;
  /**
   * The same as `damping_N_m_s_per_rad`, in the unit of this name.
   */
  damping_kN_m_s_per_rad?: number;
  /**
   * Largest torque, N m.
   */
  torque_limit_N_m?: number;
  /**
   * The same as `torque_limit_N_m`, in the unit of this name.
   */
  torque_limit_kN_m?: number;
};
/**
 * A force `stiffness (target - extension) - damping speed` in a prismatic joint, clipped at the force limit.
 */
export type LinearServo = {
  [k: string]: unknown;
} & {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The prismatic joint, or `joint.axis` for an axis that another joint slides along.
   */
  joint: string;
  /**
   * The extension to hold, m.
   */
  target_m: number;
  /**
   * Force per extension, N/m.
   */
  stiffness_N_per_m?: number;
  /**
   * The same as `stiffness_N_per_m`, in the unit of this name.
   */
  stiffness_kN_per_m?: number;
  /**
   * Force per speed, N s/m.
   */
  damping_N_s_per_m?: number;
  /**
   * The same as `damping_N_s_per_m`, in the unit of this name.
   */
  damping_kN_s_per_m?: number;
  /**
   * Largest force, N.
   */
  force_limit_N?: number;
  /**
   * The same as `force_limit_N`, in the unit of this name.
   */
  force_limit_kN?: number;
};
/**
 * A drive that turns an axis as its set-point says, within its limits: a winch, a slewing gear.
 */
export type ControlledDrive = {
  [k: string]: unknown;
} & {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The revolute joint, or `joint.axis` for an axis that another joint turns about.
   */
  joint: string;
  /**
   * What it follows. An input, named as the drive, adds to it.
   */
  set_point:
    | {
        torque: TorqueSetPoint;
      }
    | {
        speed: RateSetPoint;
      }
    | {
        position: AngleSetPoint;
      };
  /**
   * Largest rate of its reference, rad/s.
   */
  speed_limit_rad_s?: number;
  /**
   * The same as `speed_limit_rad_s`, in the unit of this name.
   */
  speed_limit_deg_s?: number;
  /**
   * Largest acceleration of its reference, rad/s^2.
   */
  acceleration_limit_rad_s2?: number;
  /**
   * The same as `acceleration_limit_rad_s2`, in the unit of this name.
   */
  acceleration_limit_deg_s2?: number;
  /**
   * Largest jerk of its reference, rad/s^3; without it, the acceleration may jump.
   */
  jerk_limit_rad_s3?: number | null;
  /**
   * The same as `jerk_limit_rad_s3`, in the unit of this name.
   */
  jerk_limit_deg_s3?: number | null;
  /**
   * Largest torque, N m.
   */
  torque_limit_N_m?: number;
  /**
   * The same as `torque_limit_N_m`, in the unit of this name.
   */
  torque_limit_kN_m?: number;
  /**
   * Largest power that it gives, W; braking is limited by its torque alone.
   */
  power_limit_W?: number | null;
  /**
   * The same as `power_limit_W`, in the unit of this name.
   */
  power_limit_kW?: number | null;
  /**
   * Torque per angle that it is behind its reference, N m/rad.
   */
  stiffness_N_m_per_rad?: number;
  /**
   * The same as `stiffness_N_m_per_rad`, in the unit of this name.
   */
  stiffness_kN_m_per_rad?: number;
  /**
   * Torque per rate that it is behind its reference, N m s/rad.
   */
  damping_N_m_s_per_rad?: number;
  /**
   * The same as `damping_N_m_s_per_rad`, in the unit of this name.
   */
  damping_kN_m_s_per_rad?: number;
  /**
   * Time in which its reference comes to a new rate where no limit holds, s; with a limit of jerk it is longer where the
   * acceleration takes longer to come.
   */
  response_time_s?: number;
};
/**
 * A torque to give.
 */
export type TorqueSetPoint = {
  /**
   * The torque, N m.
   */
  torque_N_m?: number;
  /**
   * The same as `torque_N_m`, in the unit of this name.
   */
  torque_kN_m?: number;
};
/**
 * A rate to keep.
 */
export type RateSetPoint = {
  /**
   * The rate, rad/s.
   */
  rate_rad_s?: number;
  /**
   * The same as `rate_rad_s`, in the unit of this name.
   */
  rate_deg_s?: number;
};
/**
 * An angle to go to.
 */
export type AngleSetPoint = {
  /**
   * The angle, rad.
   */
  angle_rad?: number;
  /**
   * The same as `angle_rad`, in the unit of this name.
   */
  angle_deg?: number;
};
/**
 * A drive that moves an axis as its set-point says, within its limits.
 */
export type LinearControlledDrive = {
  [k: string]: unknown;
} & {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The prismatic joint, or `joint.axis` for an axis that another joint slides along.
   */
  joint: string;
  /**
   * What it follows. An input, named as the drive, adds to it.
   */
  set_point:
    | {
        force: ForceSetPoint;
      }
    | {
        speed: SpeedSetPoint;
      }
    | {
        position: ExtensionSetPoint;
      };
  /**
   * Largest speed of its reference, m/s.
   */
  speed_limit_m_s: number;
  /**
   * Largest acceleration of its reference, m/s^2.
   */
  acceleration_limit_m_s2: number;
  /**
   * Largest jerk of its reference, m/s^3; without it, the acceleration may jump.
   */
  jerk_limit_m_s3?: number | null;
  /**
   * Largest force, N.
   */
  force_limit_N?: number;
  /**
   * The same as `force_limit_N`, in the unit of this name.
   */
  force_limit_kN?: number;
  /**
   * Largest power that it gives, W; braking is limited by its force alone.
   */
  power_limit_W?: number | null;
  /**
   * The same as `power_limit_W`, in the unit of this name.
   */
  power_limit_kW?: number | null;
  /**
   * Force per extension that it is behind its reference, N/m.
   */
  stiffness_N_per_m?: number;
  /**
   * The same as `stiffness_N_per_m`, in the unit of this name.
   */
  stiffness_kN_per_m?: number;
  /**
   * Force per speed that it is behind its reference, N s/m.
   */
  damping_N_s_per_m?: number;
  /**
   * The same as `damping_N_s_per_m`, in the unit of this name.
   */
  damping_kN_s_per_m?: number;
  /**
   * Time in which its reference comes to a new speed where no limit holds, s; with a limit of jerk it is longer where the
   * acceleration takes longer to come.
   */
  response_time_s?: number;
};
/**
 * A force to give.
 */
export type ForceSetPoint = {
  /**
   * The force, N.
   */
  force_N?: number;
  /**
   * The same as `force_N`, in the unit of this name.
   */
  force_kN?: number;
};
/**
 * Dry friction about an axis, `torque rate / sqrt(rate^2 + smoothing^2)` when set.
 */
export type Brake = {
  [k: string]: unknown;
} & {
  /**
   * Whether it is there.
   */
  enabled?: boolean;
  /**
   * The revolute joint, or `joint.axis` for an axis that another joint turns about.
   */
  joint: string;
  /**
   * Capacity: the torque that it can hold, N m.
   */
  torque_N_m?: number;
  /**
   * The same as `torque_N_m`, in the unit of this name.
   */
  torque_kN_m?: number;
  /**
   * Rate about which its torque changes its sign smoothly, rad/s; what it holds creeps below it.
   */
  smoothing_rad_s?: number;
  /**
   * The same as `smoothing_rad_s`, in the unit of this name.
   */
  smoothing_deg_s?: number;
  /**
   * Set, released, or by a lever.
   */
  state?: "set" | "released" | "lever";
};
/**
 * Dry friction along an axis, `force speed / sqrt(speed^2 + smoothing^2)` when set.
 */
export type LinearBrake = {
  [k: string]: unknown;
} & {
  /**
   * Whether it is there.
   */
  enabled?: boolean;
  /**
   * The prismatic joint, or `joint.axis` for an axis that another joint slides along.
   */
  joint: string;
  /**
   * Capacity: the force that it can hold, N.
   */
  force_N?: number;
  /**
   * The same as `force_N`, in the unit of this name.
   */
  force_kN?: number;
  /**
   * Speed about which its force changes its sign smoothly, m/s; what it holds creeps below it.
   */
  smoothing_m_s?: number;
  /**
   * Set, released, or by a lever.
   */
  state?: "set" | "released" | "lever";
};
/**
 * A hydraulic cylinder between two pins: a force `stiffness (wanted length - length) - damping rate` along the line
 * between them, clipped at what it can push and pull. The length wanted moves at the speed limit at most.
 */
export type Cylinder = {
  [k: string]: unknown;
} & {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  first: Pin3;
  second: Pin4;
  /**
   * Length between the pins where the cylinder is drawn in, m: a stop.
   */
  shortest_m: number;
  /**
   * Length between the pins where it is all the way out, m: a stop.
   */
  longest_m: number;
  /**
   * What it is after.
   */
  target?:
    | "hold"
    | {
        length: TargetLength;
      }
    | "lever";
  /**
   * Largest speed of the length wanted, m/s.
   */
  speed_limit_m_s: number;
  /**
   * Largest force outwards, N.
   */
  push_limit_N?: number;
  /**
   * The same as `push_limit_N`, in the unit of this name.
   */
  push_limit_kN?: number;
  /**
   * Largest force inwards, N.
   */
  pull_limit_N?: number;
  /**
   * The same as `pull_limit_N`, in the unit of this name.
   */
  pull_limit_kN?: number;
  /**
   * Force per length, N/m.
   */
  stiffness_N_per_m?: number;
  /**
   * The same as `stiffness_N_per_m`, in the unit of this name.
   */
  stiffness_kN_per_m?: number;
  /**
   * Force per speed, N s/m.
   */
  damping_N_s_per_m?: number;
  /**
   * The same as `damping_N_s_per_m`, in the unit of this name.
   */
  damping_kN_s_per_m?: number;
  /**
   * Force per length of the stops at both ends of the stroke, N/m.
   */
  stop_stiffness_N_per_m?: number;
  /**
   * The same as `stop_stiffness_N_per_m`, in the unit of this name.
   */
  stop_stiffness_kN_per_m?: number;
  /**
   * Dissipation of the stops, s/m: at a speed u into a stop its force is 1 + dissipation u times that of its spring.
   */
  stop_dissipation_s_per_m?: number;
};
/**
 * What measures: a motion reference unit at its own ticks, the others in every row of the results.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export type Sensor =
  | {
      motion_reference_unit: MotionReferenceUnit;
    }
  | {
      clearance: Clearance;
    }
  | {
      air_gap: AirGap;
    };
/**
 * What it is to stay clear of.
 */
export type ClearanceFrom = {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * The name of one of the body's `points`.
   */
  point?: string | null;
  /**
   * The point, a point of the plane, or the centre of the solid, in the body's drawing frame, m; from the named point,
   * where there is one.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The solid's axes in the body's: roll, pitch, yaw, rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad?: [number, number, number];
  /**
   * The same as `orientation_rad`, in the unit of this name.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_deg?: [number, number, number];
  /**
   * The solid; without it, the point.
   */
  shape?: ClearanceShape | null;
};
/**
 * What a point is to stay clear of.
 */
export type ClearanceShape =
  | "own"
  | {
      plane: ContactPlane;
    }
  | {
      box: BoxShape;
    }
  | {
      cylinder: CylinderShape;
    }
  | {
      sphere: SphereShape;
    };
/**
 * What ends a step of an operation.
 */
export type Condition =
  | {
      after_s: number;
    }
  | {
      value: ColumnRange;
    }
  | {
      all: Condition[];
    }
  | {
      any: Condition[];
    };

/**
 * One description of a run: bodies and joints, the forces and drives that act on them, and the settings.
 */
export interface Scenario {
  /**
   * The version of the file format: 1.
   */
  version: 1;
  /**
   * One line that says what this is.
   */
  title: string;
  /**
   * What a reader should know: the source, the choices made.
   */
  description?: string;
  /**
   * The knobs of this scenario, in the order in which views show them.
   */
  parameters?: Parameter[];
  simulation?: SimulationSettings;
  /**
   * Other files that this scenario is made of, by name. A resolved scenario has them among its own bodies, loops, forces,
   * drives and parameters.
   */
  parts?: {
    [k: string]: Mounting;
  };
  /**
   * The bodies by name.
   */
  bodies?: {
    [k: string]: Body;
  };
  /**
   * What ties bodies together beside their joints, by name.
   */
  loops?: {
    [k: string]: Loop;
  };
  /**
   * The water, its depth and its waves.
   */
  sea?: Sea | null;
  /**
   * The wind.
   */
  wind?: Wind | null;
  /**
   * What acts on the bodies from outside, by name.
   */
  forces?: {
    [k: string]: Force;
  };
  /**
   * What acts between the bodies, in their joints, by name.
   */
  drives?: {
    [k: string]: Drive;
  };
  /**
   * What measures, by name.
   */
  sensors?: {
    [k: string]: Sensor;
  };
  /**
   * Inputs that take what is measured, by name.
   */
  wires?: {
    [k: string]: Wire;
  };
  /**
   * The timeline that moves its levers and set-points.
   */
  operation?: Operation | null;
  /**
   * What columns of the results are to keep, by name.
   */
  limits?: {
    [k: string]: Limit;
  };
}
/**
 * A knob of a scenario. Command line, Python and the app set the fields that it writes by this name.
 */
export interface Parameter {
  /**
   * The name by which it is set; no field at the top of the file may have it.
   */
  name: string;
  /**
   * What views show; the name when absent.
   */
  label?: string;
  /**
   * Unit, for display.
   */
  unit?: string;
  /**
   * The value written unless another is given; when absent, what stands at the first field.
   */
  default?: boolean | number | string | null;
  /**
   * Least and largest value of a number.
   *
   * @minItems 2
   * @maxItems 2
   */
  range?: [number, number] | null;
  /**
   * The texts allowed.
   */
  choices?: string[] | null;
  /**
   * Whether it may change during a run; else it takes effect at reset.
   */
  live?: boolean;
  /**
   * The fields that it writes, as dotted paths: `bodies.ship.mass_kg`.
   */
  writes: string[];
}
/**
 * Time stepping and recording.
 */
export interface SimulationSettings {
  /**
   * The scheme that steps the state.
   */
  integrator?:
    | "forward_euler"
    | "midpoint_euler"
    | "semi_implicit_euler"
    | "rk4"
    | "dormand_prince"
    | "newmark"
    | "generalized_alpha"
    | "implicit_midpoint";
  /**
   * The form in which the equations of motion are solved.
   */
  form?: "recursive" | "moving_frame" | "moving_frame_without_d";
  /**
   * Time step, s.
   */
  step_s?: number;
  /**
   * Length of the run, s.
   */
  duration_s?: number;
  /**
   * Interval between recorded rows, s.
   */
  record_every_s?: number;
  /**
   * Whether the run begins at the equilibrium near where the bodies are put, found with the waves off: a ship at its
   * draught, heel and trim.
   */
  begin_at_equilibrium?: boolean;
  /**
   * A run diverges when a rate passes this, rad/s or m/s.
   */
  rate_limit?: number;
  /**
   * Seed of every random number in the run.
   */
  seed?: number;
  dormand_prince?: DormandPrinceSettings;
  newmark?: NewmarkSettings;
  generalized_alpha?: GeneralizedAlphaSettings;
}
/**
 * Settings of the dormand_prince integrator.
 */
export interface DormandPrinceSettings {
  /**
   * Error that a step may make on each coordinate, rad or m, and on each rate, rad/s or m/s.
   */
  absolute_tolerance?: number;
  /**
   * Beside it: as a part of the coordinate's motion in the step, and of the rate.
   */
  relative_tolerance?: number;
  /**
   * Largest step of its own, s.
   */
  largest_step_s?: number;
}
/**
 * Settings of the newmark integrator.
 */
export interface NewmarkSettings {
  /**
   * Weight of the acceleration at the end of the step in the position, from 0 to 0.5.
   */
  beta?: number;
  /**
   * Weight of the acceleration at the end of the step in the velocity, from 0.5 to 1: above 0.5 it damps, and the order
   * is 1.
   */
  gamma?: number;
}
/**
 * Settings of the generalized_alpha integrator.
 */
export interface GeneralizedAlphaSettings {
  /**
   * What a step leaves of oscillations far faster than it, from 0, all is gone, to 1, nothing is damped.
   */
  rho_infinity?: number;
}
/**
 * A solid box, its edges along the body's axes.
 */
export interface BoxShape {
  /**
   * Extent along x, m.
   */
  length_m: number;
  /**
   * Extent along y, m.
   */
  width_m: number;
  /**
   * Extent along z, m.
   */
  height_m: number;
}
/**
 * A solid circular cylinder.
 */
export interface CylinderShape {
  /**
   * Radius, m.
   */
  radius_m: number;
  /**
   * Extent along the axis, m.
   */
  length_m: number;
  /**
   * The body axis that the cylinder lies along.
   */
  axis?: "x" | "y" | "z";
}
/**
 * A solid sphere.
 */
export interface SphereShape {
  /**
   * Radius, m.
   */
  radius_m: number;
}
/**
 * A point mass: no extent, no inertia of its own.
 */
export interface PointShape {}
/**
 * Radii of gyration about the centre of mass; the body's axes are its principal axes.
 */
export interface RadiiOfGyration {
  /**
   * kx, ky, kz, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  radii_m: [number, number, number];
}
/**
 * A round tube; a bar where the wall is half of the diameter.
 */
export interface CircularTube {
  /**
   * Outer diameter, m.
   */
  outer_diameter_m: number;
  /**
   * Thickness of the wall, m; at most half of the diameter.
   */
  wall_m: number;
}
/**
 * A rectangular tube with walls of one thickness.
 */
export interface RectangularTube {
  /**
   * Outer extent along y, m.
   */
  width_m: number;
  /**
   * Outer extent along z, m.
   */
  height_m: number;
  /**
   * Thickness of the walls, m; less than half of width and height.
   */
  wall_m: number;
}
/**
 * A cross-section by its numbers.
 */
export interface GeneralSection {
  /**
   * Area, m^2.
   */
  area_m2: number;
  /**
   * Second moments of area about y (integral of z^2) and about z (integral of y^2), m^4.
   *
   * @minItems 2
   * @maxItems 2
   */
  second_moments_m4: [number, number];
  /**
   * Torsion constant, m^4.
   */
  torsion_constant_m4: number;
  /**
   * Shear areas for forces along y and along z, m^2; without them the beam does not shear.
   *
   * @minItems 2
   * @maxItems 2
   */
  shear_areas_m2?: [number, number] | null;
}
/**
 * The damping ratio of a mode; modes of other frequencies have it in proportion to theirs.
 */
export interface DampingRatio {
  /**
   * Damping over critical damping.
   */
  ratio: number;
  /**
   * Frequency of the mode, Hz.
   */
  frequency_Hz: number;
}
/**
 * Damping over stiffness.
 */
export interface StiffnessTime {
  /**
   * s.
   */
  time_s: number;
}
/**
 * A body free in the world. Its parent is the world.
 */
export interface FloatingJoint {
  /**
   * Name of the joint; the body's when absent.
   */
  name?: string | null;
  /**
   * Holds the centre of mass where it is.
   */
  hold_translation?: boolean;
  /**
   * Holds the orientation as it is.
   */
  hold_rotation?: boolean;
  initial?: InitialMotion;
}
/**
 * Times of a pulse of a prescribed rate R, which cannot jump: from 0 to R in `rise_s`, R for `hold_s`, back to 0 in
 * `rise_s`, and 0 from then on; with a `reverse_s` from R to -R in twice `rise_s`, -R for `reverse_s`, and then back to 0.
 * Without a reverse the way is `R (rise_s + hold_s)`.
 */
export interface RatePulse {
  /**
   * When it begins, s.
   */
  start_s?: number;
  /**
   * Length of the ramp from 0 to the full rate, s.
   */
  rise_s: number;
  /**
   * Time at the full rate, s.
   */
  hold_s: number;
  /**
   * Time at the full rate the other way, s; 0 is a pulse that does not reverse.
   */
  reverse_s?: number;
}
/**
 * Shares of the full strength at given times, and straight lines between them: none before the first time, the last
 * share after the last.
 */
export interface HistoryList {
  /**
   * Times, s, none before the one in front of it. The same time twice is a jump, which a motor may make and a
   * prescribed rate may not.
   */
  time_s: number[];
  /**
   * The share at each time: 1 is full, -1 full the other way.
   */
  share: number[];
}
/**
 * A speed of sliding as a given function of time.
 */
export interface PrescribedSpeed {
  /**
   * Full speed, m/s.
   */
  speed_m_s: number;
  /**
   * How the speed goes with time.
   */
  history?: "constant" | "pulse" | "list" | "lever";
  /**
   * The times of the history `pulse`.
   */
  pulse?: RatePulse | null;
  /**
   * The times and shares of the history `list`; a rate cannot jump.
   */
  list?: HistoryList | null;
}
/**
 * Sliding by a length, from rest to rest: the speed goes up in `ramp_s`, holds, and goes back to 0 in `ramp_s`. Between the
 * ramps it is `length / (duration_s - ramp_s)`.
 */
export interface LengthTravel {
  /**
   * How far it slides, positive along the axis, m.
   */
  length_m: number;
  /**
   * When it begins, s.
   */
  start_s?: number;
  /**
   * From rest to rest, both ramps included, s.
   */
  duration_s: number;
  /**
   * Length of a ramp, s; at most half of the duration.
   */
  ramp_s: number;
}
/**
 * A named point of a body.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export interface Point {
  /**
   * Position in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
}
/**
 * A joint that closes a loop, cut out of the tree and written as constraints between the two bodies that it ties. Name
 * only those that the joints do not keep already: a four-bar linkage in the x-z plane needs x and z.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export interface Loop {
  /**
   * Whether it holds.
   */
  enabled?: boolean;
  first: Attachment;
  second: Attachment1;
  /**
   * What it constrains, in any order; none may follow from the others.
   */
  constraints: Constraint[];
  /**
   * The largest gap at the start that is closed by moving the free joints, m, and rad for angles. They move by the
   * least that the masses allow; a larger gap is an error.
   */
  start_gap_m?: number;
}
/**
 * A distance to keep.
 */
export interface Distance {
  /**
   * Length of the rod, m.
   */
  length_m: number;
}
/**
 * The water that hulls float in, and what moves it.
 */
export interface Sea {
  /**
   * Density of the water, kg/m^3.
   */
  density_kg_m3?: number;
  /**
   * Depth of the still water, m; without it, infinite.
   */
  depth_m?: number | null;
  /**
   * The wave systems by name: wind sea, swell.
   */
  waves?: {
    [k: string]: Waves;
  };
  /**
   * Time over which the waves grow from nothing at the start, s.
   */
  ramp_s?: number;
  /**
   * Velocity of the water at the surface along the world's x and y, m/s; of a current by a table left out.
   *
   * @minItems 2
   * @maxItems 2
   */
  current_m_s?: [number, number];
  /**
   * How the current goes with depth: for loads of the current by coefficients; damping, radiation and drift see that at
   * the surface.
   */
  current_profile?:
    | "uniform"
    | {
        power_law: PowerLaw;
      }
    | {
        table: CurrentTable;
      };
}
/**
 * Swell.
 */
export interface OchiHubblePart {
  /**
   * Significant wave height of the part, m.
   */
  significant_height_m: number;
  /**
   * Period at the part's peak, s.
   */
  peak_period_s: number;
  /**
   * Shape lambda, from 0.5 to 20: with 1 the part is a Pierson-Moskowitz spectrum, with more it is narrower.
   */
  shape: number;
}
/**
 * Wind sea.
 */
export interface OchiHubblePart1 {
  /**
   * Significant wave height of the part, m.
   */
  significant_height_m: number;
  /**
   * Period at the part's peak, s.
   */
  peak_period_s: number;
  /**
   * Shape lambda, from 0.5 to 20: with 1 the part is a Pierson-Moskowitz spectrum, with more it is narrower.
   */
  shape: number;
}
/**
 * U(z) = U (z / z_reference)^exponent; of a current U(z) = U ((h + z) / h)^exponent, with h the water's depth.
 */
export interface PowerLaw {
  /**
   * 1/7 unless given.
   */
  exponent?: number;
}
/**
 * U(z) = U ln(z / roughness) / ln(z_reference / roughness).
 */
export interface Logarithmic {
  /**
   * Height at which the law has no wind, m: 0.0001 to 0.01 at sea.
   */
  roughness_m: number;
}
/**
 * Gusts: the speed of the wind about its mean, drawn from a spectrum with the run's seed. They blow along the mean wind and meet
 * the whole ship at once.
 */
export interface Gusts {
  /**
   * Whether they blow.
   */
  enabled?: boolean;
  /**
   * Their spectrum.
   */
  spectrum?:
    | "npd"
    | {
        api: ApiGusts;
      }
    | {
        kaimal: KaimalGusts;
      };
  /**
   * Number of components.
   */
  components?: number;
  /**
   * Whether amplitudes are random too, or those of the spectrum.
   */
  amplitudes?: "deterministic" | "random";
  /**
   * Slower gusts are left out, Hz: 1/3600 unless given, for a mean over one hour.
   */
  lowest_Hz?: number;
  /**
   * Faster gusts are left out, Hz: they are smaller than a ship.
   */
  highest_Hz?: number;
  /**
   * Time over which they grow from nothing at the start, s.
   */
  ramp_s?: number;
}
/**
 * S = sigma^2 / f_p / (1 + 1.5 f / f_p)^(5/3), f_p = c U / z, sigma as API RP 2A has it over the height z.
 */
export interface ApiGusts {
  /**
   * c: 0.01 to 0.1, 0.025 unless given.
   */
  peak_coefficient?: number;
}
/**
 * S = 4 sigma^2 (L / U) / (1 + 6 f L / U)^(5/3), sigma = I U.
 */
export interface KaimalGusts {
  /**
   * I, the deviation of the speed as a share of the mean.
   */
  turbulence_intensity: number;
  /**
   * L, m: by IEC 61400-1 5.67 times the height, from 60 m on 340 m.
   */
  length_scale_m: number;
}
/**
 * Weight of every body, downwards along the world's z axis.
 */
export interface Gravity {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * Acceleration of free fall, m/s^2.
   */
  acceleration_m_s2?: number;
}
/**
 * A force -c |v| v and a moment -c |omega| omega, component by component in body axes.
 */
export interface QuadraticDamping {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The body.
   */
  body: string;
  /**
   * What its velocity is relative to.
   */
  relative_to?: "water" | "earth";
  /**
   * The point that the force acts at, and whose velocity counts, in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * Force per square of velocity along x, y, z of the body, N s^2/m^2.
   *
   * @minItems 3
   * @maxItems 3
   */
  linear_N_s2_m2?: [number, number, number];
  /**
   * Moment per square of the roll, pitch, yaw rate, N m s^2.
   *
   * @minItems 3
   * @maxItems 3
   */
  angular_N_m_s2?: [number, number, number];
}
/**
 * The free surface of a liquid in a box whose sides are along the body's axes. The liquid is part of the body: of its
 * `mass_kg`, `centre_of_mass_m` and inertia, as if it were frozen with the body upright; this adds what its surface,
 * level at once, moves. So its natural period in the tank must be well below the body's in roll and pitch.
 */
export interface SlackTank {
  /**
   * Whether the surface is free; if not, the liquid stays as if it were frozen.
   */
  enabled?: boolean;
  /**
   * The body.
   */
  body: string;
  /**
   * Centre of the box in the body's drawing frame, m. A free surface turns the body by the same moment wherever it is.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
  /**
   * Along the body's x axis, inside, m.
   */
  length_m: number;
  /**
   * Along the body's y axis, inside, m.
   */
  breadth_m: number;
  /**
   * Along the body's z axis, inside, m.
   */
  height_m: number;
  /**
   * Share of the volume that is liquid. An empty tank, 0, and a full one, 1, have no free surface.
   */
  filling: number;
  /**
   * Density of the liquid, kg/m^3; without it, that of the sea.
   */
  density_kg_m3?: number | null;
}
/**
 * The water on an object that is lowered through the surface of the sea, small beside the waves: buoyancy, drag, added
 * mass that grows with immersion, slamming. Several may stand on one body, for a long or a composed one.
 */
export interface Submerged {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The body.
   */
  body: string;
  /**
   * Centre of the solid in the body's drawing frame, m; without it, the centre of mass.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number] | null;
  /**
   * The solid that the surface of the sea cuts; its axes are the body's.
   */
  shape:
    | {
        box: BoxShape;
      }
    | {
        cylinder: CylinderShape;
      }
    | {
        sphere: SphereShape;
      };
  /**
   * V: volume of water that the whole object displaces, m^3, where that is less than the solid's, as of a frame.
   */
  displaced_volume_m3?: number | null;
  added_mass?: SubmergedAddedMass;
  drag?: SubmergedDrag;
  /**
   * Drag of the wind on what is dry.
   */
  wind?: SubmergedWind | null;
  /**
   * Water inside, that comes in and drains through holes.
   */
  entrained_water?: EntrainedWater | null;
}
/**
 * Added mass over the share of the volume that is under water: a smooth curve through points.
 */
export interface SubmergedGrowth {
  /**
   * Shares of the volume, from 0 to 1, increasing.
   */
  shares: number[];
  /**
   * Share of the added mass at each, the first 0.
   */
  factors: number[];
}
/**
 * Drag of the wind on the share of the volume that is dry.
 */
export interface SubmergedWind {
  /**
   * C_D along x, y and z of the body.
   *
   * @minItems 3
   * @maxItems 3
   */
  coefficients: [number, number, number];
  /**
   * Areas across x, y and z that the coefficients refer to, m^2; without it, the solid's shadow.
   *
   * @minItems 3
   * @maxItems 3
   */
  areas_m2?: [number, number, number] | null;
  /**
   * Height above the still water whose wind counts, m.
   */
  height_m?: number;
}
/**
 * Water that an object holds inside, in an upright space of constant section about the centre of the solid, with holes at its
 * floor and open to the air above: it comes in and drains by Torricelli's law. What stands higher than the sea is carried.
 */
export interface EntrainedWater {
  /**
   * Volume of water that it holds when full, m^3; beside the displaced volume in the solid.
   */
  volume_m3: number;
  /**
   * Height of the space along the body's z axis, m.
   */
  height_m: number;
  /**
   * A_h: area of the holes, m^2.
   */
  hole_area_m2: number;
  /**
   * C_d: what the jet through the holes is of their area times Torricelli's speed; about 0.6 of sharp edges.
   */
  discharge_coefficient?: number;
  /**
   * Share of the volume that is water where a run begins; without it, as high as the sea stands.
   */
  initial_filling?: number | null;
}
/**
 * One end: the fairlead, say.
 */
export interface Pin {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * The point in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
}
/**
 * The other end: a bollard on the `world`, or on another body.
 */
export interface Pin1 {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * The point in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
}
/**
 * The upper end, on a body.
 */
export interface Pin2 {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * The point in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
}
/**
 * A point on a rope's path.
 */
export interface RopePoint {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * The point in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * Number of parallel falls between the place before and this one. Together they pull with that many times the tension.
   */
  falls?: number;
}
/**
 * A sheave that a rope runs over.
 */
export interface Sheave {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * The centre in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * To the middle of the rope, m.
   */
  radius_m: number;
  /**
   * The axis in the body's axes, any length: the rope turns about it, by the right hand, on its way from the first end
   * to the last, from -90 to 270 degrees.
   *
   * @minItems 3
   * @maxItems 3
   */
  axis: [number, number, number];
  /**
   * The smaller over the larger tension at the sheave while the rope is hauled in, towards its first end.
   */
  efficiency_hoisting?: number;
  /**
   * The same while it is paid out.
   */
  efficiency_lowering?: number;
}
/**
 * A drum that a rope is wound on.
 */
export interface RopeDrum {
  /**
   * The revolute joint by which the drum turns, on the body that carries it.
   */
  joint: string;
  /**
   * To the middle of the rope that it pays out at the start, m.
   */
  radius_m: number;
  /**
   * Where the rope lies on it in layers; without them it is paid out at one radius.
   */
  layers?: DrumLayers | null;
  /**
   * The rate of the joint that pays out rope. The rope leaves the drum on the side that moves along with it then.
   */
  pays_out?: "with_positive_rate" | "with_negative_rate";
  /**
   * Tension of the rope times the radius over the torque that hauls it in.
   */
  efficiency_hoisting?: number;
  /**
   * The torque that holds the rope over its tension times the radius while it is paid out.
   */
  efficiency_lowering?: number;
}
/**
 * Layers of rope on a drum: its radius falls by the height of a layer for the turns of one.
 */
export interface DrumLayers {
  /**
   * Turns of rope side by side.
   */
  turns_per_layer: number;
  /**
   * Of a layer, m: the diameter of a rope that lies on top of the one below, 0.87 of it in the grooves between.
   */
  height_m: number;
  /**
   * To the middle of the rope in the innermost layer, m. The radius falls no further, and an event says so.
   */
  innermost_radius_m: number;
}
/**
 * A body that hangs on a rope.
 */
export interface CarriedByRope {
  /**
   * The body: the load, the hook block.
   */
  body: string;
  /**
   * Tension of the rope at rest over the weight of the body; without it, one over the number of falls that the rope ends with.
   * Of each of n slings at an angle b to the level it is 1 / (n sin b).
   */
  share?: number | null;
}
/**
 * Points that touch.
 */
export interface ContactPoints {
  /**
   * From the shape's centre, in its axes, m; at most 64.
   */
  positions_m: [number, number, number][];
}
/**
 * A plane.
 */
export interface ContactPlane {
  /**
   * Out of the surface, in its axes, any length.
   *
   * @minItems 3
   * @maxItems 3
   */
  normal?: [number, number, number];
}
/**
 * The wind on a body by coefficients of its relative velocity.
 */
export interface WindLoad {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The body.
   */
  body: string;
  /**
   * The point that the force acts at and whose velocity counts, in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * Height above the still water whose wind the coefficients refer to, m.
   */
  height_m?: number;
  coefficients: FlowCoefficients;
}
/**
 * The current on a body by coefficients of its relative velocity. Do not damp surge, sway and yaw by other
 * forces too.
 */
export interface CurrentLoad {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The body.
   */
  body: string;
  /**
   * The point that the force acts at and whose velocity counts, in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * Draught over which the current is averaged where it has a profile, m.
   */
  draught_m?: number | null;
  /**
   * Which speed counts where the current has a profile.
   */
  speed?:
    | "mean_square"
    | "mean"
    | {
        at_depth: CurrentAtDepth;
      };
  coefficients: FlowCoefficients1;
}
/**
 * A depth.
 */
export interface CurrentAtDepth {
  /**
   * Under the still water, m.
   */
  depth_m: number;
}
/**
 * A controller that keeps a point of a ship over a place and the ship on a heading by its thrusters.
 */
export interface DynamicPositioning {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The ship.
   */
  body: string;
  /**
   * The point that is kept, and that forces and moments refer to, in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  target?: StationTarget;
  /**
   * The controller's gains.
   */
  gains:
    | {
        natural_periods: NaturalPeriods;
      }
    | {
        stated: StatedGains;
      };
  /**
   * What keeps the thrusters from answering each wave; without it they do.
   */
  wave_filter?: WaveFilter | null;
  /**
   * What gives way where a thruster is at its limit.
   */
  priority?: "heading" | "none";
  /**
   * Time within which the integrals follow what the thrusters can give while one of them is at its limit, s; without it
   * sqrt(K_d / K_i), of each of surge, sway and yaw.
   */
  anti_windup_time_s?: number | null;
  /**
   * The thrusters by name.
   */
  thrusters: {
    [k: string]: Thruster;
  };
}
/**
 * K_p = m omega^2, K_d = 2 zeta omega m, K_i = K_p / T_i with omega = 2 pi / period.
 */
export interface NaturalPeriods {
  surge: TranslationTuning;
  sway: TranslationTuning1;
  yaw: RotationTuning;
  /**
   * Whether integrals take up the mean of what pushes the ship.
   */
  integral?: boolean;
}
/**
 * Notches, and a low pass after them, in what the controller makes of errors and rates; not in its integrals.
 */
export interface WaveFilter {
  /**
   * Periods that are notched out, s: the waves' peak period, or several about it.
   */
  notch_periods_s?: number[];
  /**
   * What a notch leaves at its own period: the ratio of the dampings of its numerator and its denominator.
   */
  notch_damping_ratio?: number;
  /**
   * Period of the low pass of second order, s; without it there is none.
   */
  cutoff_period_s?: number | null;
  /**
   * Its damping ratio.
   */
  cutoff_damping_ratio?: number;
}
/**
 * Springs and dampers in surge, sway and yaw that keep a ship near its place, as soft springs keep a model in a wave basin:
 * without force in heave, and without moment in roll and pitch. They act at the centre of mass of the ship with all that it
 * carries, as the scenario puts it, so that they do not roll it as it swings.
 *
 * Stiffness is `m (2 pi / T)^2`, damping `2 zeta m 2 pi / T` with m that same mass (of yaw, moment of inertia) and the added
 * mass of slow motions, at frequency zero.
 */
export interface SoftHold {
  /**
   * Whether it acts.
   */
  enabled?: boolean;
  /**
   * The ship; its joint is floating.
   */
  body: string;
  /**
   * T of surge, sway and yaw, s: ten times the longest wave period of interest leaves the motions with the waves alone.
   *
   * @minItems 3
   * @maxItems 3
   */
  natural_periods_s?: [number, number, number];
  /**
   * zeta of surge, sway and yaw: share of the critical damping.
   *
   * @minItems 3
   * @maxItems 3
   */
  damping_ratios?: [number, number, number];
  /**
   * Where the origin of the body's drawing frame is held, and the heading; without it, where the body starts.
   */
  target?: StationTarget1 | null;
}
/**
 * Times of a pulse of strength T: from 0 to T in `rise_s`, T for `hold_s`, back to 0 in `rise_s`, and 0 from then on;
 * with a `reverse_s` from T to -T in twice `rise_s`, -T for `reverse_s`, and then back to 0.
 */
export interface Pulse {
  /**
   * When it begins, s.
   */
  start_s?: number;
  /**
   * Length of the ramp from 0 to full strength, s; 0 is a jump.
   */
  rise_s: number;
  /**
   * Time at full strength, s.
   */
  hold_s: number;
  /**
   * Time at full strength the other way, s; 0 is a pulse that does not reverse.
   */
  reverse_s?: number;
}
/**
 * A speed to keep.
 */
export interface SpeedSetPoint {
  /**
   * The speed, m/s.
   */
  speed_m_s?: number;
}
/**
 * An extension to go to.
 */
export interface ExtensionSetPoint {
  /**
   * The extension, m.
   */
  extension_m?: number;
}
/**
 * Pin on one body.
 */
export interface Pin3 {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * The point in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
}
/**
 * Pin on the other.
 */
export interface Pin4 {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * The point in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
}
/**
 * A length to go to.
 */
export interface TargetLength {
  /**
   * Length between the pins, m.
   */
  length_m: number;
}
/**
 * Measures the motion of a point of a body, without noise. It shows, as signals for wires, `measured_roll` and
 * `measured_pitch` (rad), `measured_heave` (m, over where the run began), `measured_heave_rate` (m/s) and
 * `measured_angular_velocity.x`, `.y`, `.z` (rad/s, body axes), held between two samples.
 */
export interface MotionReferenceUnit {
  /**
   * Whether it measures.
   */
  enabled?: boolean;
  /**
   * The body.
   */
  body: string;
  /**
   * The point, in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * Time between two samples, s.
   */
  period_s: number;
  /**
   * By how many samples what it shows is late: 0 to 1000.
   */
  delay_samples?: number;
}
/**
 * The distance of a point from another point or from a solid, as `clearance` (m) in the results; negative inside of a
 * solid. Nothing keeps the two apart.
 */
export interface Clearance {
  /**
   * Whether it is measured.
   */
  enabled?: boolean;
  first: OwnPoint;
  second: ClearanceFrom;
}
/**
 * The point.
 */
export interface OwnPoint {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * The name of one of the body's `points`.
   */
  point?: string | null;
  /**
   * The point in the body's drawing frame, m; from the named one, where there is one.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
}
/**
 * The height of a point above the surface of the incident waves where the point is, as `air_gap` (m) in the results; over
 * the still water where there are none. Negative under water.
 */
export interface AirGap {
  /**
   * Whether it is measured.
   */
  enabled?: boolean;
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * The name of one of the body's `points`.
   */
  point?: string | null;
  /**
   * The point in the body's drawing frame, m; from the named one, where there is one.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
}
/**
 * An input that takes a sampled output, from each sample to the next. Both have the same unit.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export interface Wire {
  /**
   * Whether it connects them; if not, a hand sets the input.
   */
  enabled?: boolean;
  /**
   * The output, as its column in the results: `mru.measured_heave`.
   */
  from: string;
  /**
   * The input: a drive's lever by the drive's name, or `winch.target_offset`, which a servo adds to its target.
   */
  to: string;
}
/**
 * Named steps, one after another: each moves levers and set-points, and lasts until its condition holds. The inputs that it
 * sets are not a hand's.
 */
export interface Operation {
  /**
   * Whether it runs; if not, a hand sets the inputs.
   */
  enabled?: boolean;
  /**
   * The steps.
   */
  steps: OperationStep[];
}
/**
 * A step of an operation.
 */
export interface OperationStep {
  /**
   * What is done: "lift off".
   */
  name: string;
  /**
   * What is moved. An input that is not named keeps its value.
   */
  set?: InputMove[];
  /**
   * What ends the step; without it, the end of its last move.
   */
  until?: Condition | null;
  /**
   * The longest that the step may last, s: beyond it the run ends, and says what the step waited for.
   */
  time_out_s?: number | null;
}
/**
 * Moves an input: a lever, a brake, or what is added to a drive's set-point.
 */
export interface InputMove {
  /**
   * The input, mostly by the name of its drive.
   */
  input: string;
  /**
   * The value that it goes to, in `unit`.
   */
  to: number;
  /**
   * Unit of `to`: the input's own in SI (rad, m, rad/s, m/s, N m, N, 1), or deg, deg/s, kN m, kN for it; without it, the SI
   * unit.
   */
  unit?: string | null;
  /**
   * When it begins, s since the step began.
   */
  at_s?: number;
  /**
   * How long it takes, along a straight line from where the input is, s; 0 is at once.
   */
  in_s?: number;
}
/**
 * A range of a column of the results: above a bound, below one, or both.
 */
export interface ColumnRange {
  /**
   * The column, as a table of the results has it: `hook.position.z`, `hoist_rope.rope_tension`.
   */
  column: string;
  /**
   * It is above this.
   */
  above?: number | null;
  /**
   * It is below this.
   */
  below?: number | null;
  /**
   * Unit of the bounds: the column's own in SI, or deg, deg/s, kN, kN m, t and so on for it; without it, the SI unit.
   */
  unit?: string | null;
}
/**
 * What a column of the results is to keep. A run says of each whether it held, and the worst value with its time.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export interface Limit {
  /**
   * Whether it counts.
   */
  enabled?: boolean;
  /**
   * The column, as a table of the results has it: `hull.roll`, `hoist_rope.rope_tension`.
   */
  column: string;
  /**
   * The largest value that is allowed.
   */
  at_most?: number | null;
  /**
   * The smallest value that is allowed.
   */
  at_least?: number | null;
  /**
   * The largest size that is allowed, to either side of zero.
   */
  within?: number | null;
  /**
   * Unit of the bounds: the column's own in SI, or deg, deg/s, kN, kN m, t and so on for it; without it, the SI unit.
   */
  unit?: string | null;
  /**
   * From when on it counts, s: without it, from the start.
   */
  from_s?: number;
}
