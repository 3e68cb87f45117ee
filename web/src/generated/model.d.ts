/* Generated from schema/model.schema.json by `npm run types`; do not edit. */

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
 * What the engine says of a scenario and of its results to other languages.
 */
export interface Published {
  model: Description;
  channels: Channel[];
  lines: DrawnLine[];
  inputs: Input[];
  warnings: Warning[];
}
/**
 * A scenario as a view shows it.
 */
export interface Description {
  /**
   * One line.
   */
  title: string;
  /**
   * The text of the scenario.
   */
  description: string;
  /**
   * Length of the run, s.
   */
  duration_s: number;
  /**
   * Time step, s.
   */
  step_s: number;
  /**
   * Interval between recorded rows, s.
   */
  record_every_s: number;
  /**
   * Name of the integrator.
   */
  integrator:
    | "forward_euler"
    | "midpoint_euler"
    | "semi_implicit_euler"
    | "rk4"
    | "dormand_prince"
    | "newmark"
    | "generalized_alpha"
    | "implicit_midpoint";
  /**
   * The parts that it is made of, those in parts too.
   */
  parts: PartDescription[];
  /**
   * The bodies in the order of results.
   */
  bodies: BodyDescription[];
  /**
   * Their joints, in the same order.
   */
  joints: JointDescription[];
  /**
   * The closed loops, in the order of results.
   */
  loops: LoopDescription[];
  /**
   * The forces and the drives.
   */
  elements: ElementDescription[];
  /**
   * Acceleration of gravity, m/s^2; 0 where it is off.
   */
  gravity_m_s2: number;
  /**
   * The sea, where there is one.
   */
  sea: SeaDescription | null;
  /**
   * The hulls in it, in the order of results.
   */
  hulls: HullDescription[];
  /**
   * What columns of the results are to keep.
   */
  limits: LimitDescription[];
  /**
   * The knobs with their values.
   */
  parameters: ParameterDescription[];
  /**
   * Settings that can be set during a run, by their paths in the scenario.
   */
  live_settings: string[];
  /**
   * What a person should know of the model before it runs.
   */
  warnings: string[];
}
/**
 * A part and where it stands.
 */
export interface PartDescription {
  /**
   * Name of its mounting.
   */
  name: string;
  /**
   * A part of the gallery, or a file.
   */
  part: string;
  /**
   * The body that it stands on, or `world`.
   */
  on: string;
  /**
   * In the drawing frame of that body, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
  /**
   * Its axes in that body's: roll, pitch, yaw, rad.
   *
   * @minItems 3
   * @maxItems 3
   */
  orientation_rad: [number, number, number];
}
/**
 * A body to draw.
 */
export interface BodyDescription {
  /**
   * Name.
   */
  name: string;
  /**
   * Parent, or `world`.
   */
  parent: string;
  /**
   * Whether it is a ship or floats as one: nothing but its floating joint, or the motion that waves give it, joins it
   * to the world.
   */
  floats: boolean;
  /**
   * Mass, kg.
   */
  mass_kg: number;
  /**
   * Inertia about its centre of mass, body axes, kg m^2, without the water's share.
   *
   * @minItems 3
   * @maxItems 3
   */
  inertia_kg_m2: [[number, number, number], [number, number, number], [number, number, number]];
  /**
   * As in the scenario; absent where only an inertia is given.
   */
  shape: Shape | null;
  /**
   * As `#rrggbb`.
   */
  colour: string | null;
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
  axis: "x" | "y" | "z";
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
 * A joint to name.
 */
export interface JointDescription {
  /**
   * Name.
   */
  name: string;
  /**
   * The child body.
   */
  body: string;
  /**
   * `floating`, `revolute` and so on, as in the scenario; `elastic` between the segments of a flexible body.
   */
  kind: string;
  /**
   * Names of its coordinates that move freely.
   */
  free_coordinates: string[];
  /**
   * What is given of its prescribed motion.
   */
  prescribed: Fact[];
}
/**
 * Something that is given, ready to print.
 */
export interface Fact {
  /**
   * What it is, in words.
   */
  label: string;
  /**
   * Its value.
   */
  value: string;
  /**
   * SI unit; empty where it has none.
   */
  unit: string;
}
/**
 * A closed loop to draw.
 */
export interface LoopDescription {
  /**
   * Name.
   */
  name: string;
  first: PointDescription;
  second: PointDescription1;
  /**
   * What it constrains, as the scenario names it.
   */
  constraints: string[];
}
/**
 * Where it is tied to the first body.
 */
export interface PointDescription {
  /**
   * The body that carries it, a segment where that is flexible; or `world`.
   */
  body: string;
  /**
   * Seen from the body's centre of mass in body axes, or from the world's origin, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
}
/**
 * Where it is tied to the second.
 */
export interface PointDescription1 {
  /**
   * The body that carries it, a segment where that is flexible; or `world`.
   */
  body: string;
  /**
   * Seen from the body's centre of mass in body axes, or from the world's origin, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
}
/**
 * One of the things that act on the model, or read it.
 */
export interface ElementDescription {
  /**
   * Name.
   */
  name: string;
  /**
   * Where the scenario has it: `forces`, `drives` or `sensors`.
   */
  group: string;
  /**
   * What it is, in words.
   */
  kind: string;
  /**
   * Whether it is on.
   */
  enabled: boolean;
  /**
   * What is given of it.
   */
  facts: Fact[];
}
/**
 * The sea to draw.
 */
export interface SeaDescription {
  /**
   * Density of the water, kg/m^3.
   */
  density_kg_m3: number;
  /**
   * Depth of the still water, m; absent where it is infinite.
   */
  depth_m: number | null;
  /**
   * Number of regular waves that the hulls feel; 0 for water that is level.
   */
  wave_components: number;
  /**
   * Wave systems of whose spectra something is cut off.
   */
  cut_spectra: CutSpectrum[];
}
/**
 * A spectrum of which not all is in the sea.
 */
export interface CutSpectrum {
  /**
   * Name of the wave system.
   */
  name: string;
  /**
   * Significant wave height of the whole spectrum, m.
   */
  significant_height_m: number;
  /**
   * Share of its energy that is cut off.
   */
  energy_cut_off: number;
}
/**
 * A hull in the water, to draw.
 */
export interface HullDescription {
  /**
   * Name of the force.
   */
  name: string;
  /**
   * Its body.
   */
  body: string;
  /**
   * The hull's origin, on the water plane of its data, from the body's centre of mass, body axes, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  origin_m: [number, number, number];
  /**
   * Draught of its data, m.
   */
  draught_m: number;
  /**
   * Length of its water line, m.
   */
  length_m: number;
  /**
   * Beam of its water line, m.
   */
  beam_m: number;
  /**
   * Whether its buoyancy is that of small motions about the draught of its data.
   */
  is_linear: boolean;
  /**
   * Its shape, where the data have it.
   */
  mesh: MeshDescription | null;
}
/**
 * Triangles to draw.
 */
export interface MeshDescription {
  /**
   * From the body's centre of mass, body axes, m.
   */
  vertices_m: [number, number, number][];
  /**
   * Indices of vertices, counter-clockwise seen from the water.
   */
  triangles: [number, number, number][];
}
/**
 * A limit that a run is held against.
 */
export interface LimitDescription {
  /**
   * Its name in the scenario.
   */
  name: string;
  /**
   * The column.
   */
  column: string;
  /**
   * Unit of the bounds.
   */
  unit: string;
  /**
   * How many of the column's SI unit that is.
   */
  unit_si: number;
  /**
   * The smallest value that is allowed.
   */
  at_least: number | null;
  /**
   * The largest value that is allowed.
   */
  at_most: number | null;
  /**
   * From when on it counts, s.
   */
  from_s: number;
}
/**
 * A knob.
 */
export interface ParameterDescription {
  /**
   * Name, as `--set` takes it.
   */
  name: string;
  /**
   * For people.
   */
  label: string;
  /**
   * Unit.
   */
  unit: string;
  /**
   * What kind of control fits.
   */
  kind: "boolean" | "number" | "choice";
  /**
   * The value in this scenario.
   */
  value: boolean | number | string;
  /**
   * Smallest and largest number.
   *
   * @minItems 2
   * @maxItems 2
   */
  range: [number, number] | null;
  /**
   * The texts to choose from.
   */
  choices: string[] | null;
  /**
   * Whether it may change during a run.
   */
  live: boolean;
}
/**
 * One result variable of a model, with its place in a row.
 */
export interface Channel {
  /**
   * Name in a data set.
   */
  variable: string;
  /**
   * What it is, as short as the axis of a plot needs it.
   */
  long_name: string;
  /**
   * What it is.
   */
  description: string;
  /**
   * SI unit of all its columns; absent where they differ.
   */
  unit: string | null;
  /**
   * SI unit of each column.
   */
  units: string[];
  /**
   * Frame of the components.
   */
  frame: "world" | "body" | "joint" | "loop" | "slow_frame" | "heading" | "none";
  /**
   * Names of the dimensions, slowest first.
   */
  dims: string[];
  /**
   * Labels along each dimension.
   */
  labels: string[][];
  /**
   * How a column is named by its labels: `{body}.angular_velocity.{axis}`.
   */
  column: string;
  /**
   * Names of its columns in a flat table: `ship.angular_velocity.x`.
   */
  columns: string[];
  /**
   * Whether elements show it; else it is of the model, or of the ledger.
   */
  of_elements: boolean;
  /**
   * First entry in a row.
   */
  offset: number;
  /**
   * Number of entries.
   */
  len: number;
}
/**
 * A line that a picture draws from point to point. Its number of points stays the same over a run; a single one is a ball.
 */
export interface DrawnLine {
  /**
   * Whose it is.
   */
  name: string;
  /**
   * What it looks like.
   */
  style: "line" | "barrel" | "rod" | "pin";
  /**
   * Radius, m; 0 where it is too thin to be drawn to scale.
   */
  radius_m: number;
  /**
   * Number of its points.
   */
  points: number;
}
/**
 * A value that a hand or a controller sets from outside, held over each step.
 */
export interface Input {
  /**
   * Name in the table of all inputs.
   */
  name: string;
  /**
   * Unit of the value.
   */
  unit: string;
  /**
   * Smallest value.
   */
  lower: number;
  /**
   * Largest value.
   */
  upper: number;
  /**
   * The value at the start.
   */
  value: number;
  /**
   * The sampled output that it takes, as a flat column (`mru.heave_rate`); `None` where a hand sets it.
   */
  signal: string | null;
}
/**
 * What a person should know of a run.
 */
export interface Warning {
  /**
   * When it was so, s.
   */
  time_s: number;
  /**
   * Whose it is: a joint, a closed loop, a body or an element.
   */
  name: string;
  /**
   * What was so.
   */
  text: string;
}
