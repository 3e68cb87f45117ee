/* Generated from schema/scenario.schema.json by `npm run types`; do not edit. */

/**
 * A part and where it is mounted. Bodies that the part's file attaches to the world are attached to the mounting.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export type Mounting = {
  /**
   * The name of a part in the gallery, or the path of a YAML or JSON file from this file's folder.
   */
  part: string;
  /**
   * Prefix of the names of the part's bodies, joints, forces, drives, loops and parameters, followed by `_`; without
   * it, the name of this entry. An empty prefix leaves the names as they are.
   */
  prefix?: string | null;
  /**
   * The body that the part is mounted on, or `world`.
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
   * Orientation of the part's axes in that body's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
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
   * Values for the part, by the names of its parameters or by dotted paths of its fields. Parameters without a value
   * here become parameters of this scenario.
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
   * `false` leaves out this body and every body below it in the tree.
   */
  enabled?: boolean;
  /**
   * The parent body, or `world`: this body's joint connects the two.
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
   * The solid that is drawn, and whose inertia the body has unless `inertia` is given.
   */
  shape?: Shape | null;
  /**
   * The inertia in numbers; it replaces the shape's inertia.
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
   * The joint to the parent: how this body moves relative to it.
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
   * Ixx, Iyy, Izz, kg m^2. None may exceed the sum of the other two.
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
 * Makes a body a uniform beam along its x axis, centred on its centre of mass. Its mass is the body's, its length is
 * the shape's unless it is given.
 *
 * The beam is cut into pieces with an elastic joint in the middle of each. The body keeps its name for the first half
 * piece, with the body's joint; the segments after it are `boom.1`, `boom.2`, and so on. A child of the body is
 * attached to the segment at its `position_m`.
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
   * The same as `youngs_modulus_Pa`, in the unit of this name.
   */
  youngs_modulus_bar?: number;
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
   * Position of the centre of mass in the world, m. With another centre of mass the whole body stands elsewhere: see
   * `drawing_frame_m`.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * Position of the origin of the body's drawing frame in the world, m, instead of `position_m`: the body stays where it
   * is drawn when its centre of mass changes.
   *
   * @minItems 3
   * @maxItems 3
   */
  drawing_frame_m?: [number, number, number] | null;
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
   * Name of the joint; without it, the body's name.
   */
  name?: string | null;
  /**
   * The axis in this body's axes, of any length except 0.
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
   * Orientation of this body's axes in the parent's at angle 0: roll, pitch, yaw (intrinsic z-y-x angles), rad.
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
      }
    | {
        oscillation: AngleOscillation;
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
   * Rate scale over which the friction changes sign smoothly, rad/s. A joint that should stick creeps more slowly
   * than this.
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
   * Angle at which the spring has no moment, rad.
   */
  rest_rad?: number;
  /**
   * The same as `rest_rad`, in the unit of this name.
   */
  rest_deg?: number;
};
/**
 * Stops. At a depth d beyond a limit a stop pushes back with `stiffness d (1 + dissipation d')`; it never pulls.
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
   * Energy loss of the stop, s/rad: after an impact at a small rate u the axis leaves at about `u (1 - 2/3
   * dissipation u)`.
   */
  dissipation_s_per_rad?: number;
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
   * How the rate varies over time.
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
 * A turn by an angle, from rest to rest: the rate rises in `ramp_s`, is constant at `angle / (duration_s - ramp_s)`,
 * and falls to 0 in `ramp_s`.
 */
export type AngleTravel = {
  [k: string]: unknown;
} & {
  /**
   * Angle of the turn, positive about the axis, rad.
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
   * Duration from rest to rest, both ramps included, s.
   */
  duration_s: number;
  /**
   * Duration of a ramp, s; at most half of the whole duration.
   */
  ramp_s: number;
};
/**
 * An oscillation about the initial angle, `A sin(2 pi t / T + phase)`. It grows smoothly from rest in `ramp_s`.
 */
export type AngleOscillation = {
  [k: string]: unknown;
} & {
  /**
   * A, rad.
   */
  amplitude_rad?: number;
  /**
   * The same as `amplitude_rad`, in the unit of this name.
   */
  amplitude_deg?: number;
  /**
   * T, s.
   */
  period_s: number;
  /**
   * Its phase at time 0, rad.
   */
  phase_rad?: number;
  /**
   * The same as `phase_rad`, in the unit of this name.
   */
  phase_deg?: number;
  /**
   * Duration of its growth, s.
   */
  ramp_s: number;
};
/**
 * A slide.
 */
export type PrismaticJoint = {
  /**
   * Name of the joint; without it, the body's name.
   */
  name?: string | null;
  /**
   * The axis in this body's axes, of any length except 0.
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
   * Orientation of this body's axes in the parent's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
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
   * A gas spring, which pushes towards larger extensions.
   */
  gas_spring?: GasSpring | null;
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
      }
    | {
        oscillation: LengthOscillation;
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
   * Speed scale over which the friction changes sign smoothly, m/s. A joint that should stick creeps more slowly
   * than this.
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
   * Extension at which the spring has no force, m.
   */
  rest_m?: number;
};
/**
 * A gas cylinder with its connected vessels, which pushes an axis towards larger extensions: `p V^n` is constant. The
 * axis needs a lower limit at which the gas volume is above 0. Its outputs are `gas_spring_pressure` (Pa) and
 * `gas_spring_force` (N).
 */
export type GasSpring = {
  [k: string]: unknown;
} & {
  /**
   * Area of the piston, m^2.
   */
  piston_area_m2: number;
  /**
   * Volume of all the gas, connected vessels included, at `at_extension_m`, m^3.
   */
  gas_volume_m3: number;
  /**
   * Absolute pressure of the gas at `at_extension_m`, Pa.
   */
  pressure_Pa?: number;
  /**
   * The same as `pressure_Pa`, in the unit of this name.
   */
  pressure_GPa?: number;
  /**
   * The same as `pressure_Pa`, in the unit of this name.
   */
  pressure_bar?: number;
  /**
   * Extension at which the gas has this volume and pressure, m.
   */
  at_extension_m?: number;
  /**
   * n: 1 for slow changes at constant temperature, 1.4 for fast changes of nitrogen or air without exchange of heat.
   */
  polytropic_exponent?: number;
  /**
   * Absolute pressure on the other side of the piston, Pa: that of the atmosphere by default.
   */
  outside_pressure_Pa?: number;
  /**
   * The same as `outside_pressure_Pa`, in the unit of this name.
   */
  outside_pressure_GPa?: number;
  /**
   * The same as `outside_pressure_Pa`, in the unit of this name.
   */
  outside_pressure_bar?: number;
};
/**
 * Stops. At a depth d beyond a limit a stop pushes back with `stiffness d (1 + dissipation d')`; it never pulls.
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
   * Energy loss of the stop, s/m: after an impact at a small speed u the axis leaves at about `u (1 - 2/3
   * dissipation u)`.
   */
  dissipation_s_per_m?: number;
};
/**
 * An oscillation about the initial extension, `A sin(2 pi t / T + phase)`. It grows smoothly from rest in `ramp_s`.
 */
export type LengthOscillation = {
  /**
   * A, m.
   */
  amplitude_m: number;
  /**
   * T, s.
   */
  period_s: number;
  /**
   * Its phase at time 0, rad.
   */
  phase_rad?: number;
  /**
   * The same as `phase_rad`, in the unit of this name.
   */
  phase_deg?: number;
  /**
   * Duration of its growth, s.
   */
  ramp_s: number;
};
/**
 * Turns about and slides along one axis. Its coordinates are `rotation` and `translation`.
 */
export type CylindricalJoint = {
  /**
   * Name of the joint; without it, the body's name.
   */
  name?: string | null;
  /**
   * The axis in this body's axes, of any length except 0.
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
   * Orientation of this body's axes in the parent's where all coordinates are 0: roll, pitch, yaw (intrinsic z-y-x
   * angles), rad.
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
 * The rotation about the axis.
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
      }
    | {
        oscillation: AngleOscillation;
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
 * The translation along the axis.
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
      }
    | {
        oscillation: LengthOscillation;
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
   * A gas spring, which pushes towards larger extensions.
   */
  gas_spring?: GasSpring | null;
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
 * Turns about an axis fixed in the parent, then about an axis fixed in this body. Its coordinates are `first` and
 * `second`.
 */
export type UniversalJoint = {
  /**
   * Name of the joint; without it, the body's name.
   */
  name?: string | null;
  /**
   * The axis fixed in the parent, given in this body's axes at angle 0, of any length except 0.
   *
   * @minItems 3
   * @maxItems 3
   */
  first_axis: [number, number, number];
  /**
   * The axis fixed in this body, in its axes, perpendicular to the first.
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
   * Orientation of this body's axes in the parent's where all coordinates are 0: roll, pitch, yaw (intrinsic z-y-x
   * angles), rad.
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
 * The rotation about the first axis.
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
      }
    | {
        oscillation: AngleOscillation;
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
 * The rotation about the second axis.
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
      }
    | {
        oscillation: AngleOscillation;
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
 * Slides in a plane fixed in the parent and turns about its normal. Its coordinates are `x`, `y` and `rotation`.
 */
export type PlanarJoint = {
  /**
   * Name of the joint; without it, the body's name.
   */
  name?: string | null;
  /**
   * The plane's normal in this body's axes, of any length except 0.
   *
   * @minItems 3
   * @maxItems 3
   */
  normal: [number, number, number];
  /**
   * The direction of x in the plane, in this body's axes at angle 0, perpendicular to the normal; y is the cross
   * product of the normal and x.
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
   * Orientation of this body's axes in the parent's where all coordinates are 0: roll, pitch, yaw (intrinsic z-y-x
   * angles), rad.
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
      }
    | {
        oscillation: LengthOscillation;
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
   * A gas spring, which pushes towards larger extensions.
   */
  gas_spring?: GasSpring | null;
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
      }
    | {
        oscillation: LengthOscillation;
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
   * A gas spring, which pushes towards larger extensions.
   */
  gas_spring?: GasSpring | null;
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
 * The rotation about the normal.
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
      }
    | {
        oscillation: AngleOscillation;
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
 * Turns about a point. Its coordinates `x`, `y` and `z` are the angular velocity relative to the parent in this body's
 * axes.
 */
export type SphericalJoint = {
  /**
   * Name of the joint; without it, the body's name.
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
   * Orientation of this body's axes in the parent's where all coordinates are 0: roll, pitch, yaw (intrinsic z-y-x
   * angles), rad.
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
   * Orientation of this body's axes at the start, relative to that of `orientation_rad`: roll, pitch, yaw (intrinsic
   * z-y-x angles), rad.
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
   * Angular velocity relative to the parent at the start, in this body's axes, rad/s.
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
   * Holds the orientation relative to the parent.
   */
  held?: boolean;
};
/**
 * No motion relative to the parent.
 */
export type FixedJoint = {
  /**
   * Name of the joint; without it, the body's name.
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
   * Orientation of this body's axes in the parent's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
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
 * A body that moves with the waves by displacement RAOs, whatever forces act on it. Its parent is the world. Its
 * coordinates `x`, `y`, `z`, `yaw`, `pitch` and `roll` are those of the RAOs' vessel axes relative to their mean
 * place.
 */
export type MovedByWaves = {
  /**
   * Name of the joint; without it, the body's name.
   */
  name?: string | null;
  /**
   * The file of the RAOs: CSV whose column names state the conventions, or OrcaFlex's YAML with one vessel type.
   */
  raos: string;
  /**
   * Whether port and starboard are alike, for a CSV file with waves from 0 to 180 degrees only.
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
 * The attachment to one body. Constraints are along and about these axes.
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
   * Orientation of the axes in the body's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
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
 * The attachment to the other body.
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
   * Orientation of the axes in the body's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
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
 * The largest misfit of the ends, along and about the constrained axes.
 */
export type MisfitTolerance = {
  /**
   * Distance of the second end from the first, m.
   */
  distance_m?: number;
  /**
   * Angle between the two, rad.
   */
  angle_rad?: number;
  /**
   * The same as `angle_rad`, in the unit of this name.
   */
  angle_deg?: number;
};
/**
 * One wave system of the sea. Directions are those towards which the waves travel, from the world's x axis towards y:
 * 180 degrees is a head sea for a ship at heading 0.
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
   * Whether the sea has these waves.
   */
  enabled?: boolean;
  /**
   * Height from trough to crest, m.
   */
  height_m: number;
  /**
   * Period, s.
   */
  period_s: number;
  /**
   * Direction that the wave goes to, rad.
   */
  direction_rad?: number;
  /**
   * The same as `direction_rad`, in the unit of this name.
   */
  direction_deg?: number;
  /**
   * Phase at the world's origin at time 0, rad: 0 is a crest.
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
   * Whether the sea has these waves.
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
 * Settings of the realisation.
 */
export type WaveRealisation = {
  /**
   * Number of components.
   */
  components?: number;
  /**
   * Whether the amplitudes are random, as in a record of the sea, or those of the spectrum.
   */
  amplitudes?: "deterministic" | "random";
  /**
   * s of the spreading function cos^(2 s)(angle / 2), with the angle from the mean direction; without it, the sea is
   * long-crested.
   */
  spreading_exponent?: number | null;
  /**
   * Waves below this frequency are left out with their energy, rad/s; without it, none are.
   */
  lowest_rad_s?: number | null;
  /**
   * The same as `lowest_rad_s`, in the unit of this name.
   */
  lowest_deg_s?: number | null;
  /**
   * Waves above this frequency are left out with their energy, rad/s; without it, none are.
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
   * Whether the sea has these waves.
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
 * Settings of the realisation.
 */
export type WaveRealisation1 = {
  /**
   * Number of components.
   */
  components?: number;
  /**
   * Whether the amplitudes are random, as in a record of the sea, or those of the spectrum.
   */
  amplitudes?: "deterministic" | "random";
  /**
   * s of the spreading function cos^(2 s)(angle / 2), with the angle from the mean direction; without it, the sea is
   * long-crested.
   */
  spreading_exponent?: number | null;
  /**
   * Waves below this frequency are left out with their energy, rad/s; without it, none are.
   */
  lowest_rad_s?: number | null;
  /**
   * The same as `lowest_rad_s`, in the unit of this name.
   */
  lowest_deg_s?: number | null;
  /**
   * Waves above this frequency are left out with their energy, rad/s; without it, none are.
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
   * Whether the sea has these waves.
   */
  enabled?: boolean;
  swell: OchiHubblePart;
  wind_sea: OchiHubblePart1;
  /**
   * Mean direction that the waves of both parts go to, rad.
   */
  direction_rad?: number;
  /**
   * The same as `direction_rad`, in the unit of this name.
   */
  direction_deg?: number;
  realisation?: WaveRealisation2;
};
/**
 * Settings of the realisation.
 */
export type WaveRealisation2 = {
  /**
   * Number of components.
   */
  components?: number;
  /**
   * Whether the amplitudes are random, as in a record of the sea, or those of the spectrum.
   */
  amplitudes?: "deterministic" | "random";
  /**
   * s of the spreading function cos^(2 s)(angle / 2), with the angle from the mean direction; without it, the sea is
   * long-crested.
   */
  spreading_exponent?: number | null;
  /**
   * Waves below this frequency are left out with their energy, rad/s; without it, none are.
   */
  lowest_rad_s?: number | null;
  /**
   * The same as `lowest_rad_s`, in the unit of this name.
   */
  lowest_deg_s?: number | null;
  /**
   * Waves above this frequency are left out with their energy, rad/s; without it, none are.
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
   * Whether the sea has these waves.
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
 * Settings of the realisation.
 */
export type WaveRealisation3 = {
  /**
   * Number of components.
   */
  components?: number;
  /**
   * Whether the amplitudes are random, as in a record of the sea, or those of the spectrum.
   */
  amplitudes?: "deterministic" | "random";
  /**
   * s of the spreading function cos^(2 s)(angle / 2), with the angle from the mean direction; without it, the sea is
   * long-crested.
   */
  spreading_exponent?: number | null;
  /**
   * Waves below this frequency are left out with their energy, rad/s; without it, none are.
   */
  lowest_rad_s?: number | null;
  /**
   * The same as `lowest_rad_s`, in the unit of this name.
   */
  lowest_deg_s?: number | null;
  /**
   * Waves above this frequency are left out with their energy, rad/s; without it, none are.
   */
  highest_rad_s?: number | null;
  /**
   * The same as `highest_rad_s`, in the unit of this name.
   */
  highest_deg_s?: number | null;
};
/**
 * Waves measured at one point. The record does not contain their direction: give it. The sea repeats after the
 * record's length; the mean elevation is removed.
 */
export type ElevationRecord = {
  /**
   * Whether the sea has these waves.
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
   * Waves below this frequency are left out, rad/s; without it, none are.
   */
  lowest_rad_s?: number | null;
  /**
   * The same as `lowest_rad_s`, in the unit of this name.
   */
  lowest_deg_s?: number | null;
  /**
   * Waves above this frequency are left out, rad/s; without it, those above half the sampling frequency.
   */
  highest_rad_s?: number | null;
  /**
   * The same as `highest_rad_s`, in the unit of this name.
   */
  highest_deg_s?: number | null;
};
/**
 * The current at given depths. Its components are linear between depths and constant below the last.
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
 * The wind: uniform at each height, steady or with gusts.
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
   * Height above the still water at which the speed is given, m.
   */
  reference_height_m?: number;
  /**
   * How the mean speed varies with height.
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
   * Variation of the speed about its mean; without it, the wind is steady.
   */
  gusts?: Gusts | null;
  /**
   * Density of the air, kg/m^3.
   */
  air_density_kg_m3?: number;
};
/**
 * Forces that act on the bodies from outside.
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
      u_tank: UTank;
    }
  | {
      free_flooding_tank: FreeFloodingTank;
    }
  | {
      submerged: Submerged;
    }
  | {
      trailing_edge: TrailingEdge;
    }
  | {
      spring_line: SpringLine;
    }
  | {
      catenary_line: CatenaryLine;
    }
  | {
      line: DynamicLine;
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
 * Linear damping: a force against a body's velocity and a moment against its angular velocity, in body axes.
 */
export type ViscousDamping = {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * The body.
   */
  body: string;
  /**
   * Reference against which the velocity is measured.
   */
  relative_to?: "water" | "earth";
  /**
   * The point where the force acts and whose velocity is used, in the body's drawing frame, m; without it, the
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
   * A full matrix, added to the two above: rows of force x, y, z (N) and moment x, y, z (N m), columns of velocity
   * x, y, z (m/s) and roll, pitch, yaw rate (rad/s). The matrix must not add energy to any motion.
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
 * The water on a hull, by potential theory at zero forward speed: buoyancy, added mass, radiated and incident waves.
 * Weight is not included: `gravity` acts on every body.
 */
export type Hydrodynamics = {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * The body that is the hull; its joint is floating.
   */
  body: string;
  /**
   * File of the hydrodynamic database, relative to the scenario's file.
   */
  database: string;
  /**
   * Name of the hull in a database of several hulls that feel each other; if it is left out, the name of the body. Every hull
   * of such a database takes part, each once.
   */
  hull?: string | null;
  /**
   * The database's origin in the body's drawing frame, m; the axes are the body's. The origin lies on the waterplane
   * at the database's draught.
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
   * Whether the added mass at infinite frequency acts.
   */
  added_mass?: boolean;
  /**
   * Whether the waves that the hull radiates act on it.
   */
  radiation?: boolean;
  /**
   * Whether the sea's waves act on it.
   */
  excitation?: boolean;
  /**
   * Whether the pressure of the incident waves acts on the part of the mesh below their surface, instead of the
   * linear Froude-Krylov force: for large motions and high waves. The linear excitation is then diffraction only.
   * Needs `hydrostatics: mesh`.
   */
  wave_pressure?: boolean;
  /**
   * Whether the mean and slowly varying drift forces of the waves act on it, by Newman's approximation: surge and
   * sway force, yaw moment. The database's coefficients are valid for the loading condition for which they were
   * computed. Not together with `wave_pressure`.
   */
  wave_drift?: boolean;
  /**
   * Whether the drift forces change with the velocity of the hull through the water, by Aranha's formula for deep
   * water: it adds wave-drift damping of slow surge and sway, and changes the drift in a current. Needs
   * `wave_drift`.
   */
  wave_drift_damping?: boolean;
  /**
   * Cut-off of a sixth-order low-pass filter, rad/s. First-order wave loads are computed at the filtered position
   * and heading. Choose it well below the wave frequencies and above the frequencies of the ship's slow drift, which
   * the filter follows without lag.
   */
  slow_motion_cutoff_rad_s?: number;
  /**
   * The same as `slow_motion_cutoff_rad_s`, in the unit of this name.
   */
  slow_motion_cutoff_deg_s?: number;
};
/**
 * A reversible pump whose pressure falls linearly with the flow that it drives. Its largest power is a quarter of the
 * product of its limits.
 */
export type UTankPump = {
  [k: string]: unknown;
} & {
  /**
   * Pressure at zero flow, Pa.
   */
  pressure_limit_Pa?: number;
  /**
   * The same as `pressure_limit_Pa`, in the unit of this name.
   */
  pressure_limit_GPa?: number;
  /**
   * The same as `pressure_limit_Pa`, in the unit of this name.
   */
  pressure_limit_bar?: number;
  /**
   * Flow at zero pressure, m^3/s.
   */
  flow_limit_m3_s: number;
};
/**
 * A pump that follows the commanded pressure of the air with a first-order lag, as far as its flow allows.
 */
export type AirPump = {
  [k: string]: unknown;
} & {
  /**
   * Largest gauge pressure, positive and negative, Pa: below 101325.
   */
  pressure_limit_Pa?: number;
  /**
   * The same as `pressure_limit_Pa`, in the unit of this name.
   */
  pressure_limit_GPa?: number;
  /**
   * The same as `pressure_limit_Pa`, in the unit of this name.
   */
  pressure_limit_bar?: number;
  /**
   * Largest flow, either way, of air at the pressure of the atmosphere, m^3/s.
   */
  flow_limit_m3_s: number;
  /**
   * Time constant of the pressure's lag behind the command, s.
   */
  response_time_s?: number;
};
/**
 * Its added mass.
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
   * V_R: reference volume of the coefficients, m^3; without it, the volume of the solid.
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
   * Open area over total area of the plates, from 0 to 0.5: it reduces the coefficients.
   */
  perforation?: number;
  /**
   * Growth of the added mass with immersion; without it, in proportion to the share of the volume under water.
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
   * A_p: reference areas of the coefficients across x, y and z, m^2; without them, the solid's projected areas.
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
 * A weightless line between a point on a body and a point on another body or in the world. It pulls like a spring if
 * it is longer than its unstretched length, and never pushes.
 */
export type SpringLine = {
  [k: string]: unknown;
} & {
  /**
   * Whether the element acts.
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
   * Damping along the line, s/m: a in T = EA/L0 s (1 + a s') at the stretch s; T is never negative.
   */
  dissipation_s_per_m?: number;
};
/**
 * A mooring line from a fairlead to an anchor: quasi-static, an elastic catenary at every moment. It has no inertia,
 * no drag and no seabed friction.
 */
export type CatenaryLine = {
  [k: string]: unknown;
} & {
  /**
   * Whether the element acts.
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
   * Weight in water per unstretched length, N/m.
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
   * Whether the line can lie on a flat seabed at the anchor's depth; if not, the line hangs freely.
   */
  seabed?: boolean;
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
 * A section of a line, with the same properties along it.
 */
export type DynamicLineSection = {
  [k: string]: unknown;
} & {
  /**
   * Length without tension, m.
   */
  unstretched_length_m: number;
  /**
   * Number of its elements, each with two nodes: the error falls with the fourth power of the number; with the second where
   * drag or bending curves the line.
   */
  elements: number;
  /**
   * Mass, kg/m.
   */
  mass_kg_per_m: number;
  /**
   * Diameter of the circular section that displaces the same volume of water, m. That of a chain is 1.8 times the
   * diameter of its bar without studs.
   */
  diameter_m: number;
  /**
   * EA: tension per strain, N.
   */
  axial_stiffness_N?: number;
  /**
   * The same as `axial_stiffness_N`, in the unit of this name.
   */
  axial_stiffness_kN?: number;
  /**
   * tau: axial damping over stiffness, s. The tension is EA (e + tau e') at the strain e: at the period T the damping is
   * pi tau / T of the critical one. Without damping, axial waves that are shorter than the step ring.
   */
  damping_time_s?: number;
  /**
   * EI: bending moment per curvature, N m^2; none for a section that is paid out. A section with it also pushes, one without
   * becomes slack.
   */
  bending_stiffness_N_m2?: number;
  /**
   * Added mass over the mass of the displaced water, across the line.
   */
  added_mass_across?: number;
  /**
   * Added mass over the mass of the displaced water, along the line.
   */
  added_mass_along?: number;
  /**
   * Drag coefficient of the flow across the line, with the area of diameter times length: 1.2 for a wire, 2.4 for a chain
   * over its bar diameter, which is 1.3 over the diameter of the displaced water (DNV-OS-E301).
   */
  drag_across?: number;
  /**
   * Drag coefficient of the flow along the line, with the area of pi times diameter times length.
   */
  drag_along?: number;
  /**
   * A clump weight or a buoy at its end towards the second end of the line; in the last section only with a free end.
   */
  clump_weight?: LineClumpWeight | null;
};
/**
 * A clump weight or a buoy on a line: a point with mass, buoyancy, added mass and drag, which turns freely.
 */
export type LineClumpWeight = {
  [k: string]: unknown;
} & {
  /**
   * Mass, kg.
   */
  mass_kg?: number;
  /**
   * The same as `mass_kg`, in the unit of this name.
   */
  mass_t?: number;
  /**
   * Displaced volume, m^3. At the surface the wet share is that of a body as high as a sphere of this volume.
   */
  volume_m3?: number;
  /**
   * Drag coefficient times area, m^2, in every direction.
   */
  drag_area_m2?: number;
  /**
   * Added mass over the mass of the displaced water; that of a sphere is 0.5.
   */
  added_mass?: number;
};
/**
 * The seabed under a line.
 */
export type LineSeabed = {
  /**
   * Its depth below the still waterline at the origin of the world, m; without it, that of the sea.
   */
  depth_m?: number | null;
  /**
   * Its slope, rad: up to 60 degrees. A run begins with the line at rest without friction, also on a slope.
   */
  slope_rad?: number;
  /**
   * The same as `slope_rad`, in the unit of this name.
   */
  slope_deg?: number;
  /**
   * Horizontal direction in which it falls, rad, from x towards y.
   */
  slope_direction_rad?: number;
  /**
   * The same as `slope_direction_rad`, in the unit of this name.
   */
  slope_direction_deg?: number;
  /**
   * Coefficient of Coulomb friction, along and across the line.
   */
  friction: number;
  /**
   * Pressure per depth of penetration, N/m^3: the force per length is this times the diameter times the depth.
   */
  stiffness_N_per_m3?: number;
  /**
   * Damping over stiffness, s: a line that falls on it at a speed v is braked from a height of this time times v on.
   */
  damping_time_s?: number;
};
/**
 * A rope without inertia that runs over sheaves: a hoist or a sling. It pulls when its path is longer
 * than the rope, else it is slack. Without a stiffness it is inextensible: it comes taut without a rebound, and its
 * peak tension at that moment must not be used for design.
 */
export type Rope = {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * The points, sheaves and drum of its path, from the first end to the last. A path begins at a point or a drum and
   * ends at a point.
   */
  path: RopeStation[];
  /**
   * Unstretched length of the rope on its path at the start, m; without it, the rope is just taut at the start.
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
   * Stiffness in series with the rope, N/m, such as that of the crane's boom and foundation; without it, they are
   * rigid.
   */
  series_stiffness_N_per_m?: number | null;
  /**
   * The same as `series_stiffness_N_per_m`, in the unit of this name.
   */
  series_stiffness_kN_per_m?: number | null;
  /**
   * tau: damping over stiffness, s. At the rate e' of its stretch the rope pulls with k tau e' in addition to k e.
   * For wire ropes it is 0.01 to 0.02 s.
   */
  damping_time_s?: number;
  /**
   * Mass of the rope, kg/m. The mass acts as weight only, without inertia, and the legs stay straight; without it,
   * the rope has no weight.
   */
  mass_kg_per_m?: number | null;
  /**
   * Diameter of the circular section that displaces the same volume of water as the rope, below the still waterline,
   * m; without it, the rope has no buoyancy.
   */
  diameter_m?: number | null;
  /**
   * Tension at which the rope parts, N; without it, the rope never parts.
   */
  breaking_load_N?: number | null;
  /**
   * The same as `breaking_load_N`, in the unit of this name.
   */
  breaking_load_kN?: number | null;
  /**
   * The bodies that hang on it, all of them: hook block, slings' bodies, load. The dynamic amplification factor is the
   * rope's tension over its tension with these bodies at rest in air; it is 1 while they hang at rest.
   */
  carries?: CarriedByRope[];
  /**
   * The crane's load chart for this rope; without it, the load is not checked.
   */
  load_chart?: LoadChart | null;
  /**
   * Whether it can be released, by an input in [0, 1] with the rope's name. At 0.5 the load is released. Below 0.5
   * the rope is hooked on again as soon as its path is shorter than the rope.
   */
  can_be_released?: boolean;
  /**
   * Whether it begins released: its input then begins at 1.
   */
  begins_released?: boolean;
};
/**
 * The load chart of a crane: rated loads over the radius, the distance from the slewing axis to the point where the
 * rope leaves the crane. The results have `load_radius` (m), `rated_load` and `hook_load` (kg) and `load_utilisation`,
 * hook load over rated load; a run warns when the utilisation exceeds 1 or the radius is outside the chart.
 */
export type LoadChart = {
  [k: string]: unknown;
} & {
  /**
   * The revolute joint about which the crane slews.
   */
  joint: string;
  /**
   * Radii that increase, m: two or more.
   */
  radii_m: number[];
  /**
   * Rated load at each radius, kg, including the lifting gear between rope and load. Linear between radii; constant
   * below the first radius and above the last.
   */
  rated_loads_kg?: number[];
  /**
   * The same as `rated_loads_kg`, in the unit of this name.
   */
  rated_loads_t?: number[];
};
/**
 * A line with a constant-tension winch at its first end: a tugger line or a tag line.
 */
export type TuggerLine = {
  [k: string]: unknown;
} & {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * The points and sheaves of its path, from the winch to the load: it begins and ends at a point.
   */
  path: RopeStation[];
  /**
   * Tension at the load while the length is constant, N.
   */
  tension_N?: number;
  /**
   * The same as `tension_N`, in the unit of this name.
   */
  tension_kN?: number;
  /**
   * Damping that reduces swing, N s/m: increase of the tension per rate of paying out, and decrease per rate of
   * hauling in.
   */
  damping_N_s_per_m?: number;
  /**
   * The same as `damping_N_s_per_m`, in the unit of this name.
   */
  damping_kN_s_per_m?: number;
  /**
   * Largest tension at the load, N: at least `tension_N`. Without it, there is no upper limit. The tension is never
   * negative.
   */
  largest_tension_N?: number | null;
  /**
   * The same as `largest_tension_N`, in the unit of this name.
   */
  largest_tension_kN?: number | null;
};
/**
 * Contact of a load with a surface: a normal force pushes the load out, and friction holds it.
 */
export type Contact = {
  [k: string]: unknown;
} & {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  load: ContactLoad;
  surface: ContactSurface;
  /**
   * Stiffness of each contact point, N/m: a box that stands on four corners has four times this stiffness.
   */
  stiffness_N_per_m?: number;
  /**
   * The same as `stiffness_N_per_m`, in the unit of this name.
   */
  stiffness_kN_per_m?: number;
  /**
   * Coefficient of restitution, from 0.1 to 1: rebound speed over impact speed, at `restitution_speed_m_s`. It is
   * higher for slower impacts.
   */
  restitution?: number;
  /**
   * The impact speed at which `restitution` holds, m/s.
   */
  restitution_speed_m_s?: number;
  /**
   * Coulomb's coefficient of friction; 0 for a smooth surface.
   */
  friction_coefficient: number;
  /**
   * Tangential stiffness of each contact point while friction holds it, N/m; without it, `stiffness_N_per_m`.
   */
  friction_stiffness_N_per_m?: number | null;
  /**
   * The same as `friction_stiffness_N_per_m`, in the unit of this name.
   */
  friction_stiffness_kN_per_m?: number | null;
  /**
   * Largest penetration, m: a deeper penetration is an error at the start and a warning during the run.
   */
  penetration_tolerance_m?: number;
};
/**
 * The load.
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
   * Orientation of the shape's axes in the body's: roll, pitch, yaw, rad.
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
   * The load.
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
      }
    | {
        capsule: CapsuleShape;
      }
    | {
        cone: ConeShape;
      }
    | {
        ring: RingShape;
      }
    | {
        convex: ConvexShape;
      };
};
/**
 * A circular cone: its tip is at the shape's position and points along z.
 */
export type ConeShape = {
  [k: string]: unknown;
} & {
  /**
   * Angle between the axis and the side, below 90 degrees, rad.
   */
  half_angle_rad?: number;
  /**
   * The same as `half_angle_rad`, in the unit of this name.
   */
  half_angle_deg?: number;
  /**
   * Distance of the base from the tip, m.
   */
  length_m: number;
};
/**
 * The surface that the load touches: a deck, a quay, the seabed, a bumper.
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
   * Orientation of the shape's axes in the body's: roll, pitch, yaw, rad.
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
   * The shape of the surface.
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
      }
    | {
        cylinder: CylinderShape;
      }
    | {
        capsule: CapsuleShape;
      }
    | {
        cone: ConeShape;
      }
    | {
        ring: RingShape;
      }
    | {
        convex: ConvexShape;
      };
};
/**
 * The coefficients.
 */
export type FlowCoefficients = {
  [k: string]: unknown;
} & {
  /**
   * Directions towards which the fluid flows, from the body's x axis, counter-clockwise, rad, increasing: 0 is flow
   * from astern, pi from ahead, as in OCIMF.
   */
  directions_rad?: number[];
  /**
   * The same as `directions_rad`, in the unit of this name.
   */
  directions_deg?: number[];
  /**
   * Whether port and starboard are alike: the directions then go from 0 to pi and are mirrored.
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
   * Directions towards which the fluid flows, from the body's x axis, counter-clockwise, rad, increasing: 0 is flow
   * from astern, pi from ahead, as in OCIMF.
   */
  directions_rad?: number[];
  /**
   * The same as `directions_rad`, in the unit of this name.
   */
  directions_deg?: number[];
  /**
   * Whether port and starboard are alike: the directions then go from 0 to pi and are mirrored.
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
 * The position and heading to hold.
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
   * Heading from the world's x axis, counter-clockwise, rad.
   */
  heading_rad?: number;
  /**
   * The same as `heading_rad`, in the unit of this name.
   */
  heading_deg?: number;
};
/**
 * Tuning of surge, along the ship.
 */
export type TranslationTuning = {
  [k: string]: unknown;
} & {
  /**
   * Mass of the ship plus its low-frequency added mass, kg.
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
 * Tuning of sway, athwartships.
 */
export type TranslationTuning1 = {
  [k: string]: unknown;
} & {
  /**
   * Mass of the ship plus its low-frequency added mass, kg.
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
 * Tuning of yaw, about the vertical.
 */
export type RotationTuning = {
  [k: string]: unknown;
} & {
  /**
   * Moment of inertia about the vertical, added moment of inertia included, kg m^2.
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
   * Whether the thruster runs.
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
   * Time constant with which the thrust follows its command, s.
   */
  time_constant_s: number;
  /**
   * Weight in the thrust allocation: a thruster with a larger weight is used less.
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
   * Whether the thruster runs.
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
   * Time constant with which the thrust follows its command, s.
   */
  time_constant_s: number;
  /**
   * Weight in the thrust allocation: a thruster with a larger weight is used less.
   */
  weight?: number;
};
/**
 * A propeller that turns about the vertical. Its thrust has two components; the magnitude of the thrust is limited.
 */
export type AzimuthThruster = {
  [k: string]: unknown;
} & {
  /**
   * Whether the thruster runs.
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
   * Time constant with which both components of the thrust follow their commands, s.
   */
  time_constant_s: number;
  /**
   * Weight in the thrust allocation: a thruster with a larger weight is used less.
   */
  weight?: number;
};
/**
 * A position and a heading.
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
   * Heading from the world's x axis, counter-clockwise, rad.
   */
  heading_rad?: number;
  /**
   * The same as `heading_rad`, in the unit of this name.
   */
  heading_deg?: number;
};
/**
 * Forces between two bodies, mostly in the joint that connects them.
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
   * Whether the element acts.
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
   * How the torque varies over time.
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
   * Whether the element acts.
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
   * How the force varies over time.
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
   * Whether the element acts.
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
   * Whether the element acts.
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
 * A drive that turns an axis to follow a set-point within limits, such as a winch or a slewing gear.
 */
export type ControlledDrive = {
  [k: string]: unknown;
} & {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * The revolute joint, or `joint.axis` for an axis that another joint turns about.
   */
  joint: string;
  /**
   * The set-point that it follows. An input with the drive's name is added to it.
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
   * Largest power that it delivers, W. It does not limit braking: only the torque limit does.
   */
  power_limit_W?: number | null;
  /**
   * The same as `power_limit_W`, in the unit of this name.
   */
  power_limit_kW?: number | null;
  /**
   * Torque per angle error against its reference, N m/rad.
   */
  stiffness_N_m_per_rad?: number;
  /**
   * The same as `stiffness_N_m_per_rad`, in the unit of this name.
   */
  stiffness_kN_m_per_rad?: number;
  /**
   * Torque per rate error against its reference, N m s/rad.
   */
  damping_N_m_s_per_rad?: number;
  /**
   * The same as `damping_N_m_s_per_rad`, in the unit of this name.
   */
  damping_kN_m_s_per_rad?: number;
  /**
   * Time in which its reference reaches a new rate if no limit acts, s. A jerk limit makes this time longer.
   */
  response_time_s?: number;
};
/**
 * A torque set-point.
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
 * A rate set-point.
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
 * An angle set-point.
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
 * A drive that slides an axis to follow a set-point within limits.
 */
export type LinearControlledDrive = {
  [k: string]: unknown;
} & {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * The prismatic joint, or `joint.axis` for an axis that another joint slides along.
   */
  joint: string;
  /**
   * The set-point that it follows. An input with the drive's name is added to it.
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
   * Largest power that it delivers, W. It does not limit braking: only the force limit does.
   */
  power_limit_W?: number | null;
  /**
   * The same as `power_limit_W`, in the unit of this name.
   */
  power_limit_kW?: number | null;
  /**
   * Force per extension error against its reference, N/m.
   */
  stiffness_N_per_m?: number;
  /**
   * The same as `stiffness_N_per_m`, in the unit of this name.
   */
  stiffness_kN_per_m?: number;
  /**
   * Force per speed error against its reference, N s/m.
   */
  damping_N_s_per_m?: number;
  /**
   * The same as `damping_N_s_per_m`, in the unit of this name.
   */
  damping_kN_s_per_m?: number;
  /**
   * Time in which its reference reaches a new speed if no limit acts, s. A jerk limit makes this time longer.
   */
  response_time_s?: number;
};
/**
 * A force set-point.
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
   * Whether the element acts.
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
   * Smoothing rate over which the torque changes sign, rad/s. A held joint creeps more slowly than this rate.
   */
  smoothing_rad_s?: number;
  /**
   * The same as `smoothing_rad_s`, in the unit of this name.
   */
  smoothing_deg_s?: number;
  /**
   * Set, released, or moved by a lever.
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
   * Whether the element acts.
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
   * Smoothing speed over which the force changes sign, m/s. A held joint creeps more slowly than this speed.
   */
  smoothing_m_s?: number;
  /**
   * Set, released, or moved by a lever.
   */
  state?: "set" | "released" | "lever";
};
/**
 * A hydraulic cylinder between two pins: a force `stiffness (target length - length) - damping rate` along the line
 * between them, within the push and pull limits. The target length changes no faster than the speed limit.
 */
export type Cylinder = {
  [k: string]: unknown;
} & {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  first: Pin4;
  second: Pin5;
  /**
   * Length between the pins when fully retracted, m, limited by a stop.
   */
  shortest_m: number;
  /**
   * Length between the pins when fully extended, m, limited by a stop.
   */
  longest_m: number;
  /**
   * The target length.
   */
  target?:
    | "hold"
    | {
        length: TargetLength;
      }
    | "lever";
  /**
   * Largest rate of the target length, m/s.
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
   * Stiffness of the stops at both ends of the stroke, N/m.
   */
  stop_stiffness_N_per_m?: number;
  /**
   * The same as `stop_stiffness_N_per_m`, in the unit of this name.
   */
  stop_stiffness_kN_per_m?: number;
  /**
   * Dissipation of the stops, s/m: at a speed u into a stop, the stop's force is its spring force times (1 +
   * dissipation u).
   */
  stop_dissipation_s_per_m?: number;
};
/**
 * Sensors. Clearances, air gaps and gangways are measured in every row of the results, the others at their own interval.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export type Sensor =
  | {
      motion_reference_unit: MotionReferenceUnit;
    }
  | {
      inertial_unit: InertialUnit;
    }
  | {
      swing_estimator: SwingEstimator;
    }
  | {
      encoder: Encoder;
    }
  | {
      linear_encoder: LinearEncoder;
    }
  | {
      load_cell: LoadCell;
    }
  | {
      satellite_receiver: SatelliteReceiver;
    }
  | {
      clearance: Clearance;
    }
  | {
      air_gap: AirGap;
    }
  | {
      gangway: Gangway;
    };
/**
 * Errors of a measured angle.
 */
export type AngleErrors = {
  /**
   * Standard deviation of its white noise in a sample, rad: the noise density, rad/sqrt(Hz), over the square root of
   * twice the period.
   */
  noise_rad?: number;
  /**
   * The same as `noise_rad`, in the unit of this name.
   */
  noise_deg?: number;
  /**
   * Constant error, rad.
   */
  bias_rad?: number;
  /**
   * The same as `bias_rad`, in the unit of this name.
   */
  bias_deg?: number;
  /**
   * Resolution, rad; 0 for none. With a resolution the derivative of the measured value is 0.
   */
  resolution_rad?: number;
  /**
   * The same as `resolution_rad`, in the unit of this name.
   */
  resolution_deg?: number;
};
/**
 * Errors of a measured angular velocity.
 */
export type RateErrors = {
  /**
   * Standard deviation of its white noise in a sample, rad/s: the noise density, rad/s/sqrt(Hz), over the square
   * root of twice the period.
   */
  noise_rad_s?: number;
  /**
   * The same as `noise_rad_s`, in the unit of this name.
   */
  noise_deg_s?: number;
  /**
   * Constant error, rad/s.
   */
  bias_rad_s?: number;
  /**
   * The same as `bias_rad_s`, in the unit of this name.
   */
  bias_deg_s?: number;
  /**
   * Resolution, rad/s; 0 for none. With a resolution the derivative of the measured value is 0.
   */
  resolution_rad_s?: number;
  /**
   * The same as `resolution_rad_s`, in the unit of this name.
   */
  resolution_deg_s?: number;
};
/**
 * Assumptions of the filter.
 */
export type InertialFilter = {
  /**
   * Standard deviation of the noise of an accelerometer in a sample, m/s^2.
   */
  acceleration_noise_m_s2?: number;
  /**
   * Standard deviation of the noise of a gyroscope in a sample, rad/s.
   */
  rate_noise_rad_s?: number;
  /**
   * The same as `rate_noise_rad_s`, in the unit of this name.
   */
  rate_noise_deg_s?: number;
  /**
   * Standard deviation of the noise of the heading in a sample, rad.
   */
  heading_noise_rad?: number;
  /**
   * The same as `heading_noise_rad`, in the unit of this name.
   */
  heading_noise_deg?: number;
  /**
   * Standard deviation of the noise of the receiver's positions, m.
   */
  position_noise_m?: number;
  /**
   * Standard deviation of the motion of the unit in waves, m: a smaller value gives the mean position more weight
   * relative to the accelerometers.
   */
  wave_motion_m?: number;
  /**
   * Peak period of the waves, s: an error by a factor of two has little effect.
   */
  wave_period_s?: number;
};
/**
 * Assumptions of the filter.
 */
export type SwingFilter = {
  /**
   * Standard deviation of the noise of a gyroscope in a sample, rad/s.
   */
  rate_noise_rad_s?: number;
  /**
   * The same as `rate_noise_rad_s`, in the unit of this name.
   */
  rate_noise_deg_s?: number;
  /**
   * Standard deviation of the swing, rad: a smaller value gives the vertical more weight relative to the gyroscopes.
   */
  swing_rad?: number;
  /**
   * The same as `swing_rad`, in the unit of this name.
   */
  swing_deg?: number;
  /**
   * Peak period of the swing, s: an error by a factor of two has little effect.
   */
  swing_period_s?: number;
};
/**
 * Errors of a measured force.
 */
export type ForceErrors = {
  /**
   * Standard deviation of its white noise in a sample, N: the noise density, N/sqrt(Hz), over the square root of
   * twice the period.
   */
  noise_N?: number;
  /**
   * The same as `noise_N`, in the unit of this name.
   */
  noise_kN?: number;
  /**
   * Constant error, N.
   */
  bias_N?: number;
  /**
   * The same as `bias_N`, in the unit of this name.
   */
  bias_kN?: number;
  /**
   * Resolution, N; 0 for none. With a resolution the derivative of the measured value is 0.
   */
  resolution_N?: number;
  /**
   * The same as `resolution_N`, in the unit of this name.
   */
  resolution_kN?: number;
};
/**
 * The point or solid.
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
   * The point, a point of the plane, or the centre of the solid, in the body's drawing frame, m; measured from the
   * named point if one is given.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * Orientation of the solid's axes in the body's: roll, pitch, yaw, rad.
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
   * The solid; without it, the distance is to the point.
   */
  shape?: ClearanceShape | null;
};
/**
 * A solid whose clearance is measured.
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
    }
  | {
      capsule: CapsuleShape;
    }
  | {
      cone: ConeShape;
    }
  | {
      convex: ConvexShape;
    };
/**
 * The point or solid from which the clearance is measured.
 */
export type ClearanceFrom1 = {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * The name of one of the body's `points`.
   */
  point?: string | null;
  /**
   * The point, a point of the plane, or the centre of the solid, in the body's drawing frame, m; measured from the
   * named point if one is given.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * Orientation of the solid's axes in the body's: roll, pitch, yaw, rad.
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
   * The solid; without it, the distance is to the point.
   */
  shape?: ClearanceShape | null;
};
/**
 * A telescopic gangway from its pedestal on one body to its landing point on another: stroke, luff and slew in the results, and
 * a warning when the run leaves its operating range. It exerts no force: its own weight and actuators are left out.
 */
export type Gangway = {
  [k: string]: unknown;
} & {
  /**
   * Whether the gangway is measured.
   */
  enabled?: boolean;
  pedestal: Pin6;
  landing: Pin7;
  /**
   * Direction of the gangway at slew 0 in the axes of the pedestal's body: angle from its x axis to its y axis, rad.
   */
  heading_rad?: number;
  /**
   * The same as `heading_rad`, in the unit of this name.
   */
  heading_deg?: number;
  /**
   * Length from the pedestal to the tip at stroke 0, m.
   */
  length_m: number;
  /**
   * Smallest and largest stroke of the telescope, m; negative when it is shorter than `length_m`.
   *
   * @minItems 2
   * @maxItems 2
   */
  stroke_limits_m: [number, number];
  /**
   * Smallest and largest luff angle, up from the plane of the pedestal's x and y axes, rad.
   *
   * @minItems 2
   * @maxItems 2
   */
  luff_limits_rad?: [number, number];
  /**
   * The same as `luff_limits_rad`, in the unit of this name.
   *
   * @minItems 2
   * @maxItems 2
   */
  luff_limits_deg?: [number, number];
  /**
   * Smallest and largest slew angle from `heading_rad`, counter-clockwise, rad.
   *
   * @minItems 2
   * @maxItems 2
   */
  slew_limits_rad?: [number, number];
  /**
   * The same as `slew_limits_rad`, in the unit of this name.
   *
   * @minItems 2
   * @maxItems 2
   */
  slew_limits_deg?: [number, number];
};
/**
 * Controller between a command, of a user or of the operation, and an input. Its own command is an input with its
 * name. A controller may stand before another.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export type Controller =
  | {
      input_shaper: InputShaper;
    }
  | {
      drive_function: DriveFunction;
    }
  | {
      state_feedback: StateFeedback;
    }
  | {
      policy: Policy;
    }
  | {
      selector: Selector;
    }
  | {
      heave_compensation: HeaveCompensation;
    }
  | {
      three_axis_compensation: ThreeAxisCompensation;
    }
  | {
      platform_compensation: PlatformCompensation;
    }
  | {
      heave_forecast: HeaveForecast;
    };
/**
 * The condition that ends a step of an operation.
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
    }
  | {
      holds: HoldingCondition;
    }
  | {
      count: CountedCondition;
    }
  | {
      lull: Lull;
    };
/**
 * Viewpoint of the camera.
 */
export type Camera =
  | "free"
  | "load"
  | "cab"
  | "bridge"
  | "top"
  | "section"
  | {
      place: CameraPlace;
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
   * A title of one line.
   */
  title: string;
  /**
   * A description: sources, assumptions, choices.
   */
  description?: string;
  /**
   * The parameters that a user can change, in the order in which views show them.
   */
  parameters?: Parameter[];
  simulation?: SimulationSettings;
  /**
   * Other files that this scenario includes, by name. In a resolved scenario their contents stand among its own
   * bodies, loops, forces, drives and parameters.
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
   * Constraints between bodies in addition to their joints, by name.
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
   * Forces on the bodies from outside, by name.
   */
  forces?: {
    [k: string]: Force;
  };
  /**
   * Drives between the bodies, in their joints, by name.
   */
  drives?: {
    [k: string]: Drive;
  };
  /**
   * Sensors by name.
   */
  sensors?: {
    [k: string]: Sensor;
  };
  /**
   * Controllers by name: each stands before an input and sets it.
   */
  controllers?: {
    [k: string]: Controller;
  };
  /**
   * Connections from a sensor's output to an input, by name.
   */
  wires?: {
    [k: string]: Wire;
  };
  /**
   * The timeline that moves levers and set-points.
   */
  operation?: Operation | null;
  /**
   * The task for whoever moves the levers.
   */
  task?: Task | null;
  /**
   * Limits on columns of the results, by name.
   */
  limits?: {
    [k: string]: Limit;
  };
  /**
   * Camera and plots at first.
   */
  view?: View | null;
}
/**
 * A parameter that a user can change. Command line, Python and the app set the fields in `writes` by its name.
 */
export interface Parameter {
  /**
   * The name by which it is set; it may not be the name of a field at the top of the file.
   */
  name: string;
  /**
   * The label that views show; without it, the name.
   */
  label?: string;
  /**
   * Unit, for display.
   */
  unit?: string;
  /**
   * The default value; without it, the value of the first field in `writes`.
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
   * Whether it can change during a run; if not, it takes effect at the next reset.
   */
  live?: boolean;
  /**
   * The fields that it sets, as dotted paths: `bodies.ship.mass_kg`.
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
   * Whether the run begins at the equilibrium near the given positions, found without waves: a ship at its draught,
   * heel and trim.
   */
  begin_at_equilibrium?: boolean;
  /**
   * A run counts as diverged when a rate exceeds this, rad/s or m/s.
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
   * Error that a step may make in each coordinate, rad or m, and in each rate, rad/s or m/s.
   */
  absolute_tolerance?: number;
  /**
   * Added to it: error relative to the coordinate's motion in the step, and to the rate.
   */
  relative_tolerance?: number;
  /**
   * Largest step that it takes, s.
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
   * Factor by which one step reduces oscillations much faster than the step: from 0, all removed, to 1, no damping.
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
 * A round tube; a solid bar if the wall is half of the diameter.
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
 * The damping ratio of a mode; those of other modes are in proportion to their frequencies.
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
 * A body that moves freely in the world. Its parent is the world.
 */
export interface FloatingJoint {
  /**
   * Name of the joint; without it, the body's name.
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
 * `rise_s`, and 0 from then on. With a `reverse_s`, after the hold: from R to -R in twice `rise_s`, -R for
 * `reverse_s`, and then back to 0. Without a reverse the distance is `R (rise_s + hold_s)`.
 */
export interface RatePulse {
  /**
   * When it begins, s.
   */
  start_s?: number;
  /**
   * Duration of the ramp from 0 to the full rate, s.
   */
  rise_s: number;
  /**
   * Time at the full rate, s.
   */
  hold_s: number;
  /**
   * Time at the full rate in the other direction, s; 0 is a pulse that does not reverse.
   */
  reverse_s?: number;
}
/**
 * Shares of the full strength at given times, linear between them: 0 before the first time, the last share after the
 * last.
 */
export interface HistoryList {
  /**
   * Times in increasing order, s. A time given twice is a jump, which is allowed for a motor but not for a
   * prescribed rate.
   */
  time_s: number[];
  /**
   * The share at each time: 1 is full strength, -1 full strength in the other direction.
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
   * How the speed varies over time.
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
 * A travel by a length, from rest to rest: the speed rises in `ramp_s`, is constant at `length / (duration_s -
 * ramp_s)`, and falls to 0 in `ramp_s`.
 */
export interface LengthTravel {
  /**
   * Length of the travel, positive along the axis, m.
   */
  length_m: number;
  /**
   * When it begins, s.
   */
  start_s?: number;
  /**
   * Duration from rest to rest, both ramps included, s.
   */
  duration_s: number;
  /**
   * Duration of a ramp, s; at most half of the whole duration.
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
 * A joint that closes a loop, written as constraints between the two bodies that it connects. Give only constraints
 * that the other joints do not already impose: a four-bar linkage in the x-z plane needs x and z.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export interface Loop {
  /**
   * Whether the loop holds.
   */
  enabled?: boolean;
  first: Attachment;
  second: Attachment1;
  /**
   * The constraints, in any order; none may follow from the others.
   */
  constraints: Constraint[];
  /**
   * The largest gap at the start, m, and rad for angles. A smaller gap is closed by the smallest mass-weighted
   * motion of the free joints; a larger one is an error.
   */
  start_gap_m?: number;
  /**
   * Lets an input release the loop and engage it again; without it, the loop always holds.
   */
  connection?: Connection | null;
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
 * Lets an input with the loop's name release the loop and engage it again, in [0, 1]: it is released from 0.5 up, and to engage
 * below 0.5. It engages at once or as soon as its ends are within the tolerance, with an impact whose energy becomes heat.
 */
export interface Connection {
  /**
   * Whether it begins released: its input then begins at 1, and its gap at the start is not closed.
   */
  begins_released?: boolean;
  /**
   * Where it engages.
   */
  engages?:
    | {
        within: MisfitTolerance;
      }
    | "where_it_is";
}
/**
 * The water, its waves and its current.
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
   * How the water's motion continues from the still water level, where linear theory ends, to the moving surface.
   */
  stretching?: "none" | "vertical" | "wheeler" | "extrapolated";
  /**
   * Time over which the waves grow from zero at the start, s.
   */
  ramp_s?: number;
  /**
   * Velocity of the current at the surface along the world's x and y, m/s; leave it out for a current by a table.
   *
   * @minItems 2
   * @maxItems 2
   */
  current_m_s?: [number, number];
  /**
   * How the current varies with depth. Current loads by coefficients use it; damping, radiation and drift use the
   * current at the surface.
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
   * Height at which the mean wind is zero by this law, m: 0.0001 to 0.01 at sea.
   */
  roughness_m: number;
}
/**
 * Gusts: variation of the wind speed about its mean, drawn from a spectrum with the run's seed. They act along the
 * mean wind and on the whole ship at once.
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
   * Whether the amplitudes are random or those of the spectrum.
   */
  amplitudes?: "deterministic" | "random";
  /**
   * Lowest frequency, Hz: slower gusts are left out. 1/3600 unless given, for a mean over one hour.
   */
  lowest_Hz?: number;
  /**
   * Highest frequency, Hz: faster gusts, which are smaller than a ship, are left out.
   */
  highest_Hz?: number;
  /**
   * Time over which the gusts grow from zero at the start, s.
   */
  ramp_s?: number;
}
/**
 * S = sigma^2 / f_p / (1 + 1.5 f / f_p)^(5/3), f_p = c U / z, sigma by API RP 2A at the height z.
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
   * I: standard deviation of the speed over the mean speed.
   */
  turbulence_intensity: number;
  /**
   * L, m. In IEC 61400-1 it is 5.67 times the height, and 340 m above 60 m.
   */
  length_scale_m: number;
}
/**
 * Weight of every body, downwards along the world's z axis.
 */
export interface Gravity {
  /**
   * Whether the element acts.
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
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * The body.
   */
  body: string;
  /**
   * Reference against which the velocity is measured.
   */
  relative_to?: "water" | "earth";
  /**
   * The point where the force acts and whose velocity is used, in the body's drawing frame, m.
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
 * The free surface of a liquid in a box whose sides are along the body's axes. The body's `mass_kg`,
 * `centre_of_mass_m` and inertia must contain the liquid, as if it were frozen with the body upright. This force adds
 * the effect of the liquid's shift. The surface is taken as always level, so the liquid's natural period must be well
 * below the natural periods of the body in roll and pitch.
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
   * Centre of the box in the body's drawing frame, m. The moment of a free surface does not depend on this position.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
  /**
   * Inner length along the body's x axis, m.
   */
  length_m: number;
  /**
   * Inner breadth along the body's y axis, m.
   */
  breadth_m: number;
  /**
   * Inner height along the body's z axis, m.
   */
  height_m: number;
  /**
   * Share of the volume that is liquid. An empty tank, 0, and a full one, 1, have no free surface.
   */
  filling: number;
  /**
   * Density of the liquid, kg/m^3; without it, the sea's density.
   */
  density_kg_m3?: number | null;
}
/**
 * Two columns of liquid at the sides of a ship and a duct between them, all of rectangular sections. The liquid is a
 * separate body with the tank's name, and its flow is a degree of freedom: the mass of the carrying body must not
 * contain the liquid.
 */
export interface UTank {
  /**
   * Whether the liquid flows; if not, it is frozen, and its mass stays.
   */
  enabled?: boolean;
  /**
   * The body that carries the tank.
   */
  body: string;
  /**
   * Middle of the duct in the body's drawing frame, m. The columns are to port and to starboard of it.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
  /**
   * Distance between the middles of the columns along the body's y axis, m.
   */
  column_distance_m: number;
  /**
   * Inner length of a column along the body's x axis, m.
   */
  column_length_m: number;
  /**
   * Inner breadth of a column along the body's y axis, m: less than `column_distance_m`.
   */
  column_breadth_m: number;
  /**
   * Top of the columns above the middle of the duct, m.
   */
  column_height_m: number;
  /**
   * Level of the liquid at rest above the middle of the duct, m: above the duct's top and below the columns' top.
   */
  level_m: number;
  /**
   * Inner height of the duct, m.
   */
  duct_height_m: number;
  /**
   * Inner length of the duct along the body's x axis, m; without it, that of the columns.
   */
  duct_length_m?: number | null;
  /**
   * Density of the liquid, kg/m^3; without it, the sea's density.
   */
  density_kg_m3?: number | null;
  /**
   * Linear damping over the critical damping of the liquid in a ship at rest.
   */
  damping_ratio?: number;
  /**
   * Pressure loss in bends and valve over the dynamic pressure in the duct, rho u^2 / 2.
   */
  loss_coefficient?: number;
  /**
   * Level in the port column above `level_m` at the start, m; the starboard level is below `level_m` by the same
   * amount.
   */
  initial_rise_m?: number;
  /**
   * A pump in the duct: an input with the tank's name, from -1 to 1, positive towards port.
   */
  pump?: UTankPump | null;
}
/**
 * A tank with vertical walls and an opening to the sea in its bottom. The water in the tank is a separate body with
 * the tank's name, and its level is a degree of freedom: the mass of the carrying body must not contain the water. The
 * hydrodynamic data of the hull are those of the closed hull.
 */
export interface FreeFloodingTank {
  /**
   * Whether the opening is open; if not, the water is frozen at `level_m`, its mass stays, and the pump has no effect.
   */
  enabled?: boolean;
  /**
   * The body that carries the tank.
   */
  body: string;
  /**
   * Middle of the opening in the tank's bottom, in the body's drawing frame, m. The tank extends upwards from this
   * point.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
  /**
   * Inner length of the tank along the body's x axis, m.
   */
  length_m: number;
  /**
   * Inner breadth of the tank along the body's y axis, m.
   */
  breadth_m: number;
  /**
   * Inner height of the tank, m.
   */
  height_m: number;
  /**
   * Level of the water at rest above the opening, m: below `height_m`. It should equal the depth of the opening
   * below the sea surface.
   */
  level_m: number;
  /**
   * Area of the opening, m^2: at most the area of the bottom.
   */
  opening_area_m2: number;
  /**
   * Length of the opening, m: thickness of the bottom, or length of the pipe to the sea. End corrections for the
   * water about both ends are added to it.
   */
  passage_length_m?: number;
  /**
   * Linear damping over the critical damping of the water in a ship at rest.
   */
  damping_ratio?: number;
  /**
   * Pressure loss in the opening over the dynamic pressure rho u^2 / 2 of the flow through it: about 2.6 for a sharp
   * edge.
   */
  loss_coefficient: number;
  /**
   * Level above `level_m` at the start, m.
   */
  initial_rise_m?: number;
  /**
   * A pump that sets the pressure of the air above the water: an input with the tank's name, from -1 to 1, which presses
   * the water out if positive and sucks it in if negative. Without a pump the tank is open to the atmosphere.
   */
  air_pump?: AirPump | null;
}
/**
 * The water on an object that is lowered through the surface and is small compared with the waves: buoyancy, drag,
 * slamming, and added mass that grows with immersion. A long or composed body may have several such forces.
 */
export interface Submerged {
  /**
   * Whether the element acts.
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
   * V: volume of water that the whole object displaces, m^3, if it is less than the solid's volume, for example for
   * a frame.
   */
  displaced_volume_m3?: number | null;
  added_mass?: SubmergedAddedMass;
  /**
   * Slamming by a coefficient; without it, slamming by the growth of the added mass.
   */
  slamming?: SubmergedSlamming | null;
  drag?: SubmergedDrag;
  /**
   * Drag of the wind on the dry part.
   */
  wind?: SubmergedWind | null;
  /**
   * Water inside, which enters and drains through holes.
   */
  entrained_water?: EntrainedWater | null;
}
/**
 * Added mass over immersion: a smooth curve through points. Immersion is the share of the volume under water, given as
 * shares or by depths of the upright object.
 */
export interface SubmergedGrowth {
  /**
   * Shares of the volume, increasing from 0 to 1; give either shares or depths.
   */
  shares?: number[];
  /**
   * Depths of the upright object's bottom below the surface, m, increasing from 0 to the height of the solid.
   */
  depths_m?: number[];
  /**
   * Share of the added mass at each share or depth, the first 0.
   */
  factors: number[];
}
/**
 * Slamming force 1/2 rho C_S A_S w^2 normal to the surface, at the solid's centre, while the surface cuts the solid
 * and the centre sinks relative to the surface with the speed w. It replaces the force of the growing added mass,
 * whose coefficient is 2 / (rho A_S) dA/dh.
 */
export interface SubmergedSlamming {
  /**
   * C_S; by DNV-RP-N103, sec. 4.3.5, at least 3 for smooth circular cylinders and 5 otherwise, unless tests or
   * theory give another value.
   */
  coefficient: number;
  /**
   * A_S: reference area of the coefficient, m^2; without it, the solid's projected area along z.
   */
  area_m2?: number | null;
}
/**
 * Drag of the wind on the dry share of the volume.
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
   * Reference areas of the coefficients across x, y and z, m^2; without them, the solid's projected areas.
   *
   * @minItems 3
   * @maxItems 3
   */
  areas_m2?: [number, number, number] | null;
  /**
   * Height above the still water at which the wind speed is taken, m.
   */
  height_m?: number;
}
/**
 * Water that an object holds inside, in an upright space of constant section about the centre of the solid, with holes
 * in its floor and open at the top. It enters and drains by Torricelli's law. The object carries the weight of the
 * water above the level of the sea.
 */
export interface EntrainedWater {
  /**
   * Volume of water that it holds when full, m^3; not part of the displaced volume.
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
   * C_d: discharge coefficient, the flow through the holes over the product of their area and Torricelli's speed;
   * about 0.6 for sharp edges.
   */
  discharge_coefficient?: number;
  /**
   * Share of the volume that is water at the start; without it, the level of the sea.
   */
  initial_filling?: number | null;
}
/**
 * The trailing edge of a swimming fin: the water leaves the edge with sideways momentum from the fin, which drives the
 * fin forward (Lighthill, 1971). The fin moves forward along the body's x axis and strikes along y; the edge is along
 * z. The fin's added mass is that of a `submerged` force on its body.
 */
export interface TrailingEdge {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * The fin.
   */
  body: string;
  /**
   * Middle of the edge in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
  /**
   * Length of the edge, m.
   */
  span_m: number;
}
/**
 * One end: a fairlead, for example.
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
 * A wire or chain with mass between two points on bodies or in the world: a mooring line, a hoisting wire in deep water.
 * It has axial stiffness and damping, bending stiffness, weight, buoyancy, added mass and drag in waves and current, and can lie
 * on the seabed. A run begins with the line at rest between its ends. It has two ends, or a path over a drum and
 * sheaves, from which its first section is paid out.
 *
 * With `rk4` and `euler` the line is advanced implicitly within each step, so that its axial waves do not limit the step;
 * `dormand_prince` resolves them.
 */
export interface DynamicLine {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * One end: a fairlead, a crane's tip.
   */
  first?: Pin3 | null;
  /**
   * The other end: an anchor in the `world`, or a point of another body.
   */
  second?: Pin3 | null;
  /**
   * Whether the second end is free, instead of `second`. The line begins at rest straight down, or up if it floats, as far as the
   * seabed or the surface, and beyond down its slope, along the current or along x.
   */
  second_free?: boolean;
  /**
   * Where on another line the second end is fastened, instead of `second`: the line is a branch of that one, as a leg of a
   * bridle is. Several lines may be fastened to the same place, and branches to branches.
   */
  second_on?: SectionEnd | null;
  /**
   * Direction in which it leaves the first end, in the axes of that body: the end is clamped, with bending stiffness in the
   * first section. Without it, the line turns freely there.
   *
   * @minItems 3
   * @maxItems 3
   */
  first_direction?: [number, number, number] | null;
  /**
   * Direction in which it arrives at the second end, in the axes of that body: the end is clamped, with bending stiffness in
   * the last section. Without it, the line turns freely there.
   *
   * @minItems 3
   * @maxItems 3
   */
  second_direction?: [number, number, number] | null;
  /**
   * Instead of both ends, the places of a path as of a `rope`, with one fall: the line is its last leg, from the last drum or
   * sheave, taken as a point, to the last point. Up to there it does not stretch and has no mass; the mass of what is paid
   * out is taken from the first place, whose body has the mass of the wire there at the start. The moment of inertia of a drum
   * stays.
   */
  path?: RopeStation[];
  /**
   * Its sections, from the first end. With a path the length of the first one is that at the start.
   */
  sections: DynamicLineSection[];
  /**
   * The plane seabed on which it can lie; without it, the line does not touch the seabed.
   */
  seabed?: LineSeabed | null;
  /**
   * Number of points along it at which the results have its tension, evenly spaced along its unstretched length with both
   * ends: 2 to 200, or 0 for none.
   */
  points_along?: number;
}
/**
 * A point on a body, or in the world.
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
 * The end of a section of another line, towards the second end of that one. Lines that meet there turn freely about it, and its
 * clump weight is that of the section.
 */
export interface SectionEnd {
  /**
   * The other line, one with mass.
   */
  line: string;
  /**
   * The section, counted from 0: not the last one, unless that line ends free.
   */
  section: number;
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
   * Number of parallel falls from the previous place to this one. Together they pull with this number times the
   * tension.
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
   * Radius to the middle of the rope, m.
   */
  radius_m: number;
  /**
   * The sheave's axis in the body's axes, of any length except 0. From the first end to the last, the rope turns
   * about this axis by the right-hand rule, by -90 to 270 degrees.
   *
   * @minItems 3
   * @maxItems 3
   */
  axis: [number, number, number];
  /**
   * Efficiency while the rope is hauled in, towards its first end: the smaller tension at the sheave over the
   * larger.
   */
  efficiency_hoisting?: number;
  /**
   * Efficiency while the rope is paid out: the smaller tension at the sheave over the larger.
   */
  efficiency_lowering?: number;
}
/**
 * A drum that a rope is wound on.
 */
export interface RopeDrum {
  /**
   * The revolute joint about which the drum turns, on the body that carries it.
   */
  joint: string;
  /**
   * Radius to the middle of the rope that is paid out at the start, m.
   */
  radius_m: number;
  /**
   * The layers of rope on the drum; without them the radius is constant.
   */
  layers?: DrumLayers | null;
  /**
   * Sign of the joint's rate that pays out rope. It determines the side on which the rope leaves the drum.
   */
  pays_out?: "with_positive_rate" | "with_negative_rate";
  /**
   * Efficiency while the drum hauls in: tension times radius over the torque.
   */
  efficiency_hoisting?: number;
  /**
   * Efficiency while the drum pays out: the torque that holds the rope over tension times radius.
   */
  efficiency_lowering?: number;
}
/**
 * Layers of rope on a drum: each layer that is paid out reduces the radius by its height.
 */
export interface DrumLayers {
  /**
   * Turns of rope side by side.
   */
  turns_per_layer: number;
  /**
   * Height of a layer, m: the rope's diameter if each turn lies on top of the one below, 0.87 of it if the turns lie
   * in the grooves.
   */
  height_m: number;
  /**
   * Radius to the middle of the rope in the innermost layer, m, at which the radius stops decreasing and an event is
   * recorded.
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
   * Pull of the rope at rest, of all its falls at the load together, over the weight of the body: 1 for a rope that
   * carries the body alone, on any number of falls; 1 / (n sin b) for each of n slings at an angle b to the
   * horizontal; 0.5 for each of two cranes that share a load evenly.
   */
  share?: number;
}
/**
 * Points that touch.
 */
export interface ContactPoints {
  /**
   * Positions from the shape's centre, in its axes, m; at most 64.
   */
  positions_m: [number, number, number][];
}
/**
 * A circular cylinder with round ends.
 */
export interface CapsuleShape {
  /**
   * Radius, m.
   */
  radius_m: number;
  /**
   * Distance between the centres of the two round ends, m.
   */
  length_m: number;
  /**
   * The axis that it lies along.
   */
  axis?: "x" | "y" | "z";
}
/**
 * A ring of round bar about z.
 */
export interface RingShape {
  /**
   * Radius of the circle in the middle of the bar, m.
   */
  radius_m: number;
  /**
   * Radius of the bar, below that of the circle, m.
   */
  bar_radius_m: number;
}
/**
 * The convex hull of points that are not in one plane.
 */
export interface ConvexShape {
  /**
   * Positions from the shape's centre, in its axes, m; 4 to 32.
   */
  positions_m: [number, number, number][];
}
/**
 * A plane.
 */
export interface ContactPlane {
  /**
   * The outward normal, in the surface's axes, of any length except 0.
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
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * The body.
   */
  body: string;
  /**
   * The point where the force acts and whose velocity is used, in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * Height above the still water at which the wind speed is taken, m.
   */
  height_m?: number;
  coefficients: FlowCoefficients;
}
/**
 * The current on a body by coefficients of its relative velocity. The load also damps surge, sway and yaw: add no
 * other damping for the current.
 */
export interface CurrentLoad {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * The body.
   */
  body: string;
  /**
   * The point where the force acts and whose velocity is used, in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * Draught over which a current profile is averaged, m.
   */
  draught_m?: number | null;
  /**
   * Speed of the current profile that is used.
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
 * A controller with thrusters that holds a point of a ship at a position, and the ship on a heading.
 */
export interface DynamicPositioning {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * The ship.
   */
  body: string;
  /**
   * The held point in the body's drawing frame, m. Forces and moments refer to this point.
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
   * The filter that prevents thruster response to wave-frequency motion; without it, the thrusters respond to every
   * wave.
   */
  wave_filter?: WaveFilter | null;
  /**
   * Priority of yaw moment or force when a thruster is at its limit.
   */
  priority?: "heading" | "none";
  /**
   * Anti-windup time constant, s, with which the integrals follow the force and moment of the thrusters while a
   * thruster is at its limit. Without it, sqrt(K_d / K_i) for surge, sway and yaw each.
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
   * Whether integral action balances the mean load on the ship.
   */
  integral?: boolean;
}
/**
 * Notch filters and then a low-pass filter on the proportional and derivative part of the controller; the integrals
 * are not filtered.
 */
export interface WaveFilter {
  /**
   * Periods of the notches, s: the waves' peak period, or several periods around it.
   */
  notch_periods_s?: number[];
  /**
   * Gain of a notch at its own period: damping ratio of its numerator over that of its denominator.
   */
  notch_damping_ratio?: number;
  /**
   * Cut-off period of the second-order low-pass filter, s; without it, there is no low-pass filter.
   */
  cutoff_period_s?: number | null;
  /**
   * Damping ratio of the low pass.
   */
  cutoff_damping_ratio?: number;
}
/**
 * Springs and dampers in surge, sway and yaw that keep a ship near its position, like soft springs in a wave basin.
 * They have no force in heave and no moment in roll and pitch. They act at the centre of mass, in the initial
 * position, of the ship with all that it carries, so that they do not excite roll.
 *
 * Stiffness is `m (2 pi / T)^2`, damping `2 zeta m 2 pi / T` where m is the mass of the ship with all that it carries
 * (for yaw the moment of inertia) plus the added mass at zero frequency.
 */
export interface SoftHold {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * The ship; its joint is floating.
   */
  body: string;
  /**
   * T of surge, sway and yaw, s. At ten times the longest wave period of interest, the springs do not affect the
   * wave-frequency motions.
   *
   * @minItems 3
   * @maxItems 3
   */
  natural_periods_s?: [number, number, number];
  /**
   * zeta of surge, sway and yaw: damping over critical damping.
   *
   * @minItems 3
   * @maxItems 3
   */
  damping_ratios?: [number, number, number];
  /**
   * Position at which the origin of the body's drawing frame is held, and the heading; without it, those at the
   * start.
   */
  target?: StationTarget1 | null;
}
/**
 * Times of a pulse of strength T: from 0 to T in `rise_s`, T for `hold_s`, back to 0 in `rise_s`, and 0 from then on.
 * With a `reverse_s`, after the hold: from T to -T in twice `rise_s`, -T for `reverse_s`, and then back to 0.
 */
export interface Pulse {
  /**
   * When it begins, s.
   */
  start_s?: number;
  /**
   * Duration of the ramp from 0 to full strength, s; 0 is a jump.
   */
  rise_s: number;
  /**
   * Time at full strength, s.
   */
  hold_s: number;
  /**
   * Time at full strength in the other direction, s; 0 is a pulse that does not reverse.
   */
  reverse_s?: number;
}
/**
 * A speed set-point.
 */
export interface SpeedSetPoint {
  /**
   * The speed, m/s.
   */
  speed_m_s?: number;
}
/**
 * An extension set-point.
 */
export interface ExtensionSetPoint {
  /**
   * The extension, m.
   */
  extension_m?: number;
}
/**
 * A point on a body, or in the world.
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
 * A point on a body, or in the world.
 */
export interface Pin5 {
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
 * A target length.
 */
export interface TargetLength {
  /**
   * Length between the pins, m.
   */
  length_m: number;
}
/**
 * Measures the motion of a point of a body. Its outputs, which wires can use, are `measured_roll` and
 * `measured_pitch` (rad), `measured_heave` (m, relative to the start of the run), `measured_heave_rate` (m/s) and
 * `measured_angular_velocity.x`, `.y`, `.z` (rad/s, body axes), constant between two samples; with horizontal motion also
 * `measured_x`, `measured_y` (m, along the world's axes, relative to the start), `measured_x_velocity`,
 * `measured_y_velocity` (m/s) and `measured_yaw` (rad).
 */
export interface MotionReferenceUnit {
  /**
   * Whether the sensor measures.
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
   * Delay of its outputs, in samples: 0 to 1000.
   */
  delay_samples?: number;
  /**
   * Whether it also measures its horizontal motion, with the filter and the errors of heave, and its yaw, with the
   * errors of the angles, like a unit with a gyrocompass.
   */
  horizontal_motion?: boolean;
  /**
   * The filter that removes the drift of heave and heave rate, as in real units; without it, both are unfiltered.
   */
  heave_filter?: HeaveFilter | null;
  /**
   * Errors of roll and pitch each; without them both are exact.
   */
  angle_errors?: AngleErrors | null;
  /**
   * Errors of heave, after its filter.
   */
  heave_errors?: LengthErrors | null;
  /**
   * Errors of the heave rate, after its filter.
   */
  heave_rate_errors?: SpeedErrors | null;
  /**
   * Errors of each component of the angular velocity.
   */
  rate_errors?: RateErrors | null;
  /**
   * Its failures; without them it always works.
   */
  drop_outs?: DropOuts | null;
}
/**
 * A second-order high-pass filter: it removes motions with periods much longer than its cut-off period, and gives
 * shorter ones a phase lead. A satellite receiver restores the removed motion.
 */
export interface HeaveFilter {
  /**
   * Cut-off period, s.
   */
  cutoff_period_s: number;
  /**
   * Damping ratio.
   */
  damping_ratio?: number;
  /**
   * A satellite receiver on the same body, whose positions restore the motion that the filter removes.
   */
  receiver?: string | null;
}
/**
 * Errors of a measured length or height.
 */
export interface LengthErrors {
  /**
   * Standard deviation of its white noise in a sample, m: the noise density, m/sqrt(Hz), over the square root of
   * twice the period.
   */
  noise_m?: number;
  /**
   * Constant error, m.
   */
  bias_m?: number;
  /**
   * Resolution, m; 0 for none. With a resolution the derivative of the measured value is 0.
   */
  resolution_m?: number;
}
/**
 * Errors of a measured speed.
 */
export interface SpeedErrors {
  /**
   * Standard deviation of its white noise in a sample, m/s: the noise density, m/s/sqrt(Hz), over the square root of
   * twice the period.
   */
  noise_m_s?: number;
  /**
   * Constant error, m/s.
   */
  bias_m_s?: number;
  /**
   * Resolution, m/s; 0 for none. With a resolution the derivative of the measured value is 0.
   */
  resolution_m_s?: number;
}
/**
 * Random drop-outs of a sensor, from the run's seed. During a drop-out its outputs keep their last values and its
 * `sensor_status` is 0; the table of events has the beginning and the end of each drop-out.
 */
export interface DropOuts {
  /**
   * Mean time from the end of one drop-out to the next drop-out, s; at least the sensor's period.
   */
  mean_interval_s: number;
  /**
   * Mean duration of a drop-out, s; at least the sensor's period.
   */
  mean_duration_s: number;
}
/**
 * Estimates the motion of a point of a body from accelerometers, gyroscopes and a gyrocompass, by an error-state
 * Kalman filter. Its outputs are those of a motion reference unit with horizontal motion, and
 * `measured_specific_force.x`, `.y`, `.z` (m/s^2, body axes): the acceleration less that of gravity. Without a
 * satellite receiver, it estimates the motion relative to the mean position. The run starts with the estimate to which
 * the filter converges at rest.
 */
export interface InertialUnit {
  /**
   * Whether the sensor measures.
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
   * Delay of its outputs, in samples: 0 to 1000.
   */
  delay_samples?: number;
  /**
   * Errors of each accelerometer; without them all are exact.
   */
  acceleration_errors?: AccelerationErrors | null;
  /**
   * Errors of each gyroscope; without them all are exact.
   */
  rate_errors?: RateErrors | null;
  /**
   * Errors of the gyrocompass; without them it is exact.
   */
  heading_errors?: AngleErrors | null;
  /**
   * Name of a satellite receiver on the same body. With it, the displacement is relative to the start and includes
   * slow motion.
   */
  receiver?: string | null;
  filter?: InertialFilter;
  /**
   * Failures of the connection to the unit; without them it always works.
   */
  drop_outs?: DropOuts | null;
}
/**
 * Errors of a measured acceleration.
 */
export interface AccelerationErrors {
  /**
   * Standard deviation of its white noise in a sample, m/s^2: the noise density, m/s^2/sqrt(Hz), over the square
   * root of twice the period.
   */
  noise_m_s2?: number;
  /**
   * Constant error, m/s^2.
   */
  bias_m_s2?: number;
  /**
   * Resolution, m/s^2; 0 for none. With a resolution the derivative of the measured value is 0.
   */
  resolution_m_s2?: number;
}
/**
 * Estimates the swing of a load or a hook from its gyroscopes, by an error-state Kalman filter with a model of the
 * swing about the vertical: `measured_roll`, `measured_pitch` (rad) and `measured_angular_velocity.x`, `.y`, `.z`
 * (rad/s, body axes). A constant inclination decays in the estimate. The run starts with the estimate to which the
 * filter converges at rest.
 */
export interface SwingEstimator {
  /**
   * Whether the sensor measures.
   */
  enabled?: boolean;
  /**
   * The body with the gyroscopes.
   */
  body: string;
  /**
   * Time between two samples, s.
   */
  period_s: number;
  /**
   * Delay of its outputs, in samples: 0 to 1000.
   */
  delay_samples?: number;
  /**
   * Errors of each gyroscope; without them all are exact.
   */
  rate_errors?: RateErrors | null;
  filter?: SwingFilter;
  /**
   * Failures of the connection to the sensor; without them it always works.
   */
  drop_outs?: DropOuts | null;
}
/**
 * Measures the angle of a joint: `measured_angle`, rad.
 */
export interface Encoder {
  /**
   * Whether the sensor measures.
   */
  enabled?: boolean;
  /**
   * The revolute joint, or `joint.axis` for an axis that another joint turns about.
   */
  joint: string;
  /**
   * Time between two samples, s.
   */
  period_s: number;
  /**
   * Delay of its output, in samples: 0 to 1000.
   */
  delay_samples?: number;
  /**
   * Its errors; without them it is exact.
   */
  errors?: AngleErrors | null;
  /**
   * Its failures; without them it always works.
   */
  drop_outs?: DropOuts | null;
}
/**
 * Measures the extension of a joint: `measured_extension`, m.
 */
export interface LinearEncoder {
  /**
   * Whether the sensor measures.
   */
  enabled?: boolean;
  /**
   * The prismatic joint, or `joint.axis` for an axis that another joint slides along.
   */
  joint: string;
  /**
   * Time between two samples, s.
   */
  period_s: number;
  /**
   * Delay of its output, in samples: 0 to 1000.
   */
  delay_samples?: number;
  /**
   * Its errors; without them it is exact.
   */
  errors?: LengthErrors | null;
  /**
   * Its failures; without them it always works.
   */
  drop_outs?: DropOuts | null;
}
/**
 * Measures the tension of a rope: `measured_tension`, N. It samples at the start of the first step at or after each
 * multiple of its period.
 */
export interface LoadCell {
  /**
   * Whether the sensor measures.
   */
  enabled?: boolean;
  /**
   * The rope.
   */
  rope: string;
  /**
   * The end of the rope.
   */
  end?: "last" | "first";
  /**
   * Time between two samples, s.
   */
  period_s: number;
  /**
   * Delay of its output, in samples: 0 to 1000.
   */
  delay_samples?: number;
  /**
   * Its errors; without them it is exact.
   */
  errors?: ForceErrors | null;
  /**
   * Its failures; without them it always works.
   */
  drop_outs?: DropOuts | null;
}
/**
 * Measures the position of its antenna: `measured_position.x`, `.y`, `.z`, m in the world.
 */
export interface SatelliteReceiver {
  /**
   * Whether the sensor measures.
   */
  enabled?: boolean;
  /**
   * The body.
   */
  body: string;
  /**
   * The antenna, in the body's drawing frame, m.
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
   * Delay of its outputs, in samples: 0 to 1000.
   */
  delay_samples?: number;
  /**
   * Errors along x and y each; without them both are exact.
   */
  horizontal_errors?: LengthErrors | null;
  /**
   * Errors of the height; without them it is exact.
   */
  vertical_errors?: LengthErrors | null;
  /**
   * Its failures; without them it always works.
   */
  drop_outs?: DropOuts | null;
}
/**
 * The distance between two points or solids, as `clearance` (m) in the results. Of a point inside a solid it is the
 * negative distance from the surface; of overlapping solids, the negative of the shortest displacement that parts them. It is
 * only an output: no force keeps the two apart.
 */
export interface Clearance {
  /**
   * Whether the clearance is measured.
   */
  enabled?: boolean;
  first: ClearanceFrom;
  second: ClearanceFrom1;
}
/**
 * The height of a point above the surface of the incident waves at that point, as `air_gap` (m) in the results; above
 * the still water in a sea without waves. Negative under water.
 */
export interface AirGap {
  /**
   * Whether the clearance is measured.
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
   * The point in the body's drawing frame, m; measured from the named point if one is given.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
}
/**
 * A point on a body, or in the world.
 */
export interface Pin6 {
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
 * A point on a body, or in the world.
 */
export interface Pin7 {
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
 * Sets an input to its command convolved with two or three impulses, so that the command excites no residual swing of
 * the stated period and damping.
 */
export interface InputShaper {
  /**
   * Whether the shaper acts; if not, its command passes unchanged.
   */
  enabled?: boolean;
  /**
   * The input that it sets: of a drive, or the command of another controller.
   */
  to: string;
  /**
   * The impulses; with `none`, the command passes unchanged.
   */
  shaper?: "none" | "zv" | "zvd" | "ei";
  /**
   * Period of the swing, between two maxima, s.
   */
  period_s: number;
  /**
   * Damping ratio of the swing, below 1.
   */
  damping_ratio?: number;
  /**
   * For ei: the residual swing at the period, as a share of the swing without a shaper.
   */
  tolerance?: number;
}
/**
 * Sets an input to its command plus a smooth curve through given commands at given times. `kingpost.drive_functions`
 * computes commands that hold a load in place.
 */
export interface DriveFunction {
  /**
   * Whether the function is added; if not, the command passes unchanged.
   */
  enabled?: boolean;
  /**
   * The input that it sets: of a drive, or the command of another controller.
   */
  to: string;
  /**
   * Times of the curve's points in increasing order, s.
   */
  time_s: number[];
  /**
   * The command at each time, in the SI unit of the input.
   */
  command: number[];
  /**
   * Period after which the curve repeats, s: all times are within one period. Without it, the first command holds
   * before the first time, and the last command after the last time.
   */
  period_s?: number | null;
  /**
   * Duration of the ramp at the start of a run, s, over which the curve grows from 0 to full size like waves over
   * the `ramp_s` of the sea; 0: full size at once.
   */
  ramp_s?: number;
}
/**
 * Sets inputs to `c - K e - K_I (integral of e)` within limits, with `e = x - reference`, the commands c of the
 * inputs, the columns x that it reads, and the gains K and K_I.
 */
export interface StateFeedback {
  /**
   * Whether the controller acts; if not, its commands pass unchanged.
   */
  enabled?: boolean;
  /**
   * The columns that it reads.
   */
  reads: FeedbackRead[];
  /**
   * The inputs that it sets. The command of a single input has the controller's name; with several inputs, each
   * command is named `name.input`.
   */
  steers: FeedbackSteer[];
  /**
   * Time between two samples, s: a whole number of steps; without it, one step.
   */
  period_s?: number | null;
}
/**
 * A column that is fed back.
 */
export interface FeedbackRead {
  /**
   * The column of the results, such as `slew.joint_position`, or a state of a drive by its name in the linear
   * analysis, such as `slewing.position`.
   */
  column: string;
  /**
   * Value of the column at which there is no correction, in its SI unit.
   */
  reference?: number;
  /**
   * The input in `steers` whose command is added to the reference; both have the same unit.
   */
  follows?: string | null;
}
/**
 * An input that a feedback sets.
 */
export interface FeedbackSteer {
  /**
   * The input.
   */
  to: string;
  /**
   * Row of K: a gain for each column, in the input's unit over the column's.
   */
  gains: number[];
  /**
   * Row of K_I: a gain for the time integral of each column, in the input's unit over the column's and over s.
   */
  integral_gains?: number[];
  /**
   * Lower limit of the input's value, in its SI unit; without it, the smallest allowed value.
   */
  lower?: number | null;
  /**
   * Upper limit of the input's value, in its SI unit; without it, the largest allowed value.
   */
  upper?: number | null;
}
/**
 * Sets inputs by a multilayer perceptron with tanh: `o = (columns - reference) / scale`, clipped to 10 on either side,
 * `a = tanh(W_n ... tanh(W_1 o + b_1) + b_n)`, and the input is its command plus the value between lower (at a = -1)
 * and upper (at a = 1).
 */
export interface Policy {
  /**
   * Whether the controller acts; if not, its commands pass unchanged.
   */
  enabled?: boolean;
  /**
   * Columns that it reads, in the order of the columns of the first layer's weights.
   */
  reads: PolicyRead[];
  /**
   * The inputs that it sets. The command of a single input has the controller's name; with several inputs, each
   * command is named `name.input`.
   */
  steers: PolicySteer[];
  /**
   * The layers, from the first to the last.
   */
  layers: PolicyLayer[];
  /**
   * Time between two samples, s: a whole number of steps; without it, one step.
   */
  period_s?: number | null;
}
/**
 * An observation of a policy.
 */
export interface PolicyRead {
  /**
   * The column of the results, or a state of a drive by its name in the linear analysis.
   */
  column: string;
  /**
   * Columns of the same unit that are added to it.
   */
  also?: AlsoRead[];
  /**
   * Value of the column at which the observation is 0, in the column's SI unit.
   */
  reference?: number;
  /**
   * Difference from the reference at which the observation is 1, in the column's SI unit.
   */
  scale?: number;
}
/**
 * A column that is added to another.
 */
export interface AlsoRead {
  /**
   * The column.
   */
  column: string;
}
/**
 * An input that a policy sets.
 */
export interface PolicySteer {
  /**
   * The input.
   */
  to: string;
  /**
   * Value of the input at the action -1, in its SI unit; without it, the smallest allowed value.
   */
  lower?: number | null;
  /**
   * Value of the input at the action 1, in its SI unit; without it, the largest allowed value.
   */
  upper?: number | null;
}
/**
 * A layer of a policy: tanh(W x + b).
 */
export interface PolicyLayer {
  /**
   * W: a row for each output, a number for each input.
   */
  weights: number[][];
  /**
   * b: a number for each output.
   */
  biases: number[];
}
/**
 * Passes the commands of one of several branches to inputs. Another controller, or the operation, sets the commands of
 * a branch, `name.branch.input`; the commands of the other branches have no effect.
 */
export interface Selector {
  /**
   * The branch whose commands pass.
   */
  selected: string;
  /**
   * The branches.
   */
  branches: string[];
  /**
   * The inputs that it sets.
   */
  steers: SelectorTarget[];
}
/**
 * An input that a selector sets.
 */
export interface SelectorTarget {
  /**
   * The input.
   */
  to: string;
}
/**
 * Active heave compensation of a rope. Its inputs are a lever with its name, from 0 (off) to 1 (on), and
 * `NAME.lowering_speed` (m/s at the load, positive: down), which is added to its command. Its outputs are
 * `compensation_residual` (m), `compensation_speed` (m/s), `compensation_tip_velocity` (m/s) and
 * `compensation_utilisation`.
 */
export interface HeaveCompensation {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * Whether it is switched on at the start.
   */
  begins_on?: boolean;
  /**
   * The rope. The place before its last end is the crane's tip.
   */
  rope: string;
  /**
   * The controlled drive of the rope's drum, or of a joint that moves sheaves between drum and tip: the slide of a
   * compensation cylinder. Its set-point is a speed, which is added to the operator's speed.
   */
  drive: string;
  /**
   * The motion reference unit or inertial unit that measures the tip's motion; without it, the compensation uses the
   * exact motion without delay.
   */
  sensor?: string | null;
  /**
   * Time between two commands, s; at least simulation.step_s.
   */
  period_s: number;
  /**
   * Feed-forward gain: share of the tip's velocity that is commanded.
   */
  feed_forward?: number;
  /**
   * Commanded speed per height error of the load, 1/s.
   */
  position_gain_per_s?: number;
  /**
   * Prediction over all delays; without it, the measured velocity is commanded.
   */
  prediction?: HeavePrediction | null;
}
/**
 * Prediction of the ship's motion over the delay of the sensor, the time for which a command is held, and the response
 * of the drive. It also inverts the sensor's high-pass filter, for waves of these periods.
 */
export interface HeavePrediction {
  /**
   * Shortest period of the tip's motion, s; at least four times period_s.
   */
  shortest_period_s?: number;
  /**
   * Longest period, s; longer than the shortest.
   */
  longest_period_s?: number;
  /**
   * Standard deviation of the noise in a measured velocity over that of the velocity. A larger value makes the
   * prediction smoother and less exact.
   */
  noise_share?: number;
  /**
   * Prediction time in addition to the delay of its sensor and half of period_s, s.
   */
  extra_delay_s?: number;
  /**
   * Time constant of the drive's response that the prediction inverts, s; without it, the response_time_s of each
   * drive.
   */
  drive_response_s?: number | null;
}
/**
 * Compensation in three axes: slewing and luffing, or any chain of driven joints, hold the crane's tip over a point of
 * the world, and the winch holds the load's height. Its inputs are a lever with its name, from 0 (off) to 1 (on), and
 * the speeds `NAME.x_speed` and `NAME.y_speed` (m/s of the tip, along the world's axes) and `NAME.lowering_speed` (m/s
 * at the load, positive: down), which are added to its commands. Its outputs are `compensation_offset` (m),
 * `compensation_ship_velocity` (m/s) and `compensation_utilisation`. The set-points of its drives do not count.
 */
export interface ThreeAxisCompensation {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * Whether it is switched on at the start.
   */
  begins_on?: boolean;
  /**
   * The rope, which begins at a drum. The place before its last end is the crane's tip.
   */
  rope: string;
  /**
   * The controlled drive of the drum, with a speed as its set-point.
   */
  drive: string;
  /**
   * The controlled drives that move the tip: of slewing, luffing, knuckle, telescope. At least two.
   */
  joints: CompensationDrive[];
  /**
   * The motion reference unit with horizontal motion, or the inertial unit, that measures the tip's motion; without
   * it, the compensation uses the exact motion without delay.
   */
  sensor?: string | null;
  /**
   * Time between two commands, s; at least simulation.step_s.
   */
  period_s: number;
  /**
   * Feed-forward gain: share of the ship's velocity at the tip that is commanded.
   */
  feed_forward?: number;
  /**
   * Commanded speed per position error, 1/s.
   */
  position_gain_per_s?: number;
  /**
   * Speed of the tip, m/s, below which a direction counts as near a singularity: if the joints at full speed move
   * the tip slower than this in a direction, the commands in that direction are reduced.
   */
  damped_below_m_s?: number;
  /**
   * Prediction over all delays; without it, the measured velocity is commanded.
   */
  prediction?: HeavePrediction | null;
}
/**
 * A drive that a compensation commands.
 */
export interface CompensationDrive {
  /**
   * The controlled drive, with a speed as its set-point.
   */
  drive: string;
}
/**
 * A platform below a crane's pedestal that three or more driven joints keep level and at its height. Its lever is an
 * input with its name, from 0 (off) to 1 (on). Its outputs are `platform_offset` (sines of the tilt, and m) and
 * `compensation_utilisation`. The set-points of its drives do not count.
 */
export interface PlatformCompensation {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * Whether it is switched on at the start.
   */
  begins_on?: boolean;
  /**
   * The body that stays level.
   */
  body: string;
  /**
   * The point of the body that stays at its height, in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m?: [number, number, number];
  /**
   * The controlled drives that move it. At least three.
   */
  joints: CompensationDrive[];
  /**
   * The motion reference unit or inertial unit, on the ship, that measures the motion; without it, the compensation
   * uses the exact motion without delay.
   */
  sensor?: string | null;
  /**
   * Time between two commands, s; at least simulation.step_s.
   */
  period_s: number;
  /**
   * Feed-forward gain: share of the ship's motion that is commanded.
   */
  feed_forward?: number;
  /**
   * Commanded speed per error of tilt and height, 1/s.
   */
  position_gain_per_s?: number;
  /**
   * Prediction over all delays; without it, the measured velocities are commanded.
   */
  prediction?: HeavePrediction | null;
}
/**
 * Predicts the heave of a point, such as the crane's tip, for the next seconds, from the past motion that a sensor measures. A
 * step of an operation waits for a lull with it. Its outputs are `predicted_heave`, `predicted_heave_error` and
 * `predicted_heave_bound` (m) and `forecast_ready`. It sets no input.
 */
export interface HeaveForecast {
  /**
   * Whether the element acts.
   */
  enabled?: boolean;
  /**
   * The body of the point.
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
   * The motion reference unit or inertial unit that measures the motion.
   */
  sensor: string;
  /**
   * Time between two samples, s; at least simulation.step_s.
   */
  period_s: number;
  /**
   * How far ahead it predicts, s.
   */
  horizon_s?: number;
  /**
   * Peak period of the heave, s, mostly that of the waves: the filters suit a JONSWAP spectrum with it. Without it, they suit a
   * heave that is spread evenly over its periods, which is foreseen for a shorter time.
   */
  peak_period_s?: number | null;
  /**
   * Shortest period of the heave, s; at least four times period_s. The filters amplify heave of other periods.
   */
  shortest_period_s?: number;
  /**
   * Longest period, s; longer than the shortest.
   */
  longest_period_s?: number;
  /**
   * Standard deviation of the noise in a measured velocity over that of the velocity.
   */
  noise_share?: number;
  /**
   * Standard deviations of its error that the bound adds to the predicted heave.
   */
  margin?: number;
}
/**
 * A connection from a sampled output to an input, which keeps each sample until the next. Both have the same unit.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export interface Wire {
  /**
   * Whether it connects them; if not, the user sets the input.
   */
  enabled?: boolean;
  /**
   * The output, by its column in the results: `mru.measured_heave`.
   */
  from: string;
  /**
   * The input: a drive's lever by the drive's name, or `winch.target_offset`, which a servo adds to its target.
   */
  to: string;
}
/**
 * Named steps, one after another: each step moves levers and set-points, and lasts until its condition holds. A user
 * cannot move the inputs that the operation sets.
 */
export interface Operation {
  /**
   * Whether the operation runs; if not, the user sets the inputs.
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
   * Name of the step, which describes it: "lift off".
   */
  name: string;
  /**
   * The inputs that it moves. An input that is not named keeps its value.
   */
  set?: InputMove[];
  /**
   * The condition that ends the step; without it, the step ends with its last move.
   */
  until?: Condition | null;
  /**
   * Largest duration of the step, s. After it the run ends and reports the condition that does not hold.
   */
  time_out_s?: number | null;
}
/**
 * Moves an input: a lever, a brake, or the offset of a drive's set-point.
 */
export interface InputMove {
  /**
   * Name of the input, mostly the name of its drive.
   */
  input: string;
  /**
   * The new value, in `unit`.
   */
  to: number;
  /**
   * Unit of `to`: the input's SI unit (rad, m, rad/s, m/s, N m, N, 1), or deg, deg/s, kN m, kN instead; without it,
   * the SI unit.
   */
  unit?: string | null;
  /**
   * When the move begins, s after the start of the step.
   */
  at_s?: number;
  /**
   * Duration of the linear move from the input's present value, s; 0 for a jump.
   */
  in_s?: number;
}
/**
 * A range of a column of the results: above a bound, below one, or both. A bound is a number or another column.
 */
export interface ColumnRange {
  /**
   * The column by its name in the table of results: `hook.position.z`, `hoist_rope.rope_tension`.
   */
  column: string;
  /**
   * The value is above this.
   */
  above?: number | null;
  /**
   * The value is below this.
   */
  below?: number | null;
  /**
   * The value is above that of this column, which has the same unit.
   */
  above_column?: string | null;
  /**
   * The value is below that of this column, which has the same unit.
   */
  below_column?: string | null;
  /**
   * Unit of the bounds: the column's SI unit, or deg, deg/s, kN, kN m, t and so on instead; without it, the SI unit.
   */
  unit?: string | null;
}
/**
 * A condition that holds without a break for a time.
 */
export interface HoldingCondition {
  /**
   * The time, s.
   */
  for_s: number;
  /**
   * The condition.
   */
  condition:
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
      }
    | {
        holds: HoldingCondition;
      }
    | {
        count: CountedCondition;
      }
    | {
        lull: Lull;
      };
}
/**
 * A condition that begins to hold a number of times since the start of the step.
 */
export interface CountedCondition {
  /**
   * The number; a condition that holds at the start of the step has begun once.
   */
  times: number;
  /**
   * The condition.
   */
  condition:
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
      }
    | {
        holds: HoldingCondition;
      }
    | {
        count: CountedCondition;
      }
    | {
        lull: Lull;
      };
}
/**
 * A lull: the bound of a forecast of the heave is low. Its error counts: no lull before the forecast is ready.
 */
export interface Lull {
  /**
   * The controller of the kind `heave_forecast`. Its `horizon_s` is the length of the lull.
   */
  forecast: string;
  /**
   * The heave, m: `predicted_heave_bound` is below it.
   */
  below_m: number;
}
/**
 * A task for whoever moves the levers: stages, one after another. It is done when the last stage ends, and failed when a
 * limit of the scenario is exceeded before.
 */
export interface Task {
  /**
   * Whether the task is set.
   */
  enabled?: boolean;
  /**
   * The task in one sentence: "Set the box down on the mark, softer than 0.3 m/s."
   */
  text: string;
  /**
   * The stages.
   */
  stages: TaskStage[];
  /**
   * The mark that views draw at the place to reach.
   */
  mark?: Mark | null;
}
/**
 * A stage of a task.
 */
export interface TaskStage {
  /**
   * Name of the stage, which describes it: "over the quay".
   */
  name: string;
  /**
   * The condition that ends it.
   */
  until:
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
      }
    | {
        holds: HoldingCondition;
      }
    | {
        count: CountedCondition;
      }
    | {
        lull: Lull;
      };
}
/**
 * A circle on a level surface of a body, or of the world.
 */
export interface Mark {
  /**
   * The body, or `world`.
   */
  body: string;
  /**
   * Its centre in the body's drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
  /**
   * Its radius, m.
   */
  radius_m: number;
}
/**
 * A limit on a column of the results. A run reports for each limit whether it held, and the worst value with its time.
 *
 * This interface was referenced by `undefined`'s JSON-Schema definition
 * via the `patternProperty` "^[a-z][a-z0-9_]*$".
 */
export interface Limit {
  /**
   * Whether the limit is checked.
   */
  enabled?: boolean;
  /**
   * The column by its name in the table of results: `hull.roll`, `hoist_rope.rope_tension`.
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
   * The largest absolute value that is allowed.
   */
  within?: number | null;
  /**
   * Unit of the bounds: the column's SI unit, or deg, deg/s, kN, kN m, t and so on instead; without it, the SI unit.
   */
  unit?: string | null;
  /**
   * Time from which the limit applies, s; without it, from the start.
   */
  from_s?: number;
  /**
   * Time until which the limit applies, s; without it, to the end.
   */
  until_s?: number | null;
  /**
   * Names of the steps of the operation in which the limit applies; without them, in all and without an operation.
   */
  steps?: string[];
  /**
   * Percentage of the rows of the results that must be within the bounds, above 0 and at most 100: 95 allows values beyond a
   * bound for 5 % of the time. Without it, all rows.
   */
  percentile?: number | null;
}
/**
 * Camera and plots with which the app and figures open the scenario; a user can change them.
 */
export interface View {
  /**
   * The camera; without it, the view chooses one.
   */
  camera?: Camera | null;
  /**
   * The columns of each plot over time, by their names in the table of results; without them, the view chooses some.
   */
  plots?: string[][];
}
/**
 * Place of a camera relative to the first body, along the axes of the world.
 */
export interface CameraPlace {
  /**
   * Position of the eye, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  eye_m: [number, number, number];
  /**
   * Position that is in the middle of the picture, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  target_m: [number, number, number];
}
