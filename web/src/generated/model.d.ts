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
 * Types of a scenario and of its results that the engine publishes to other languages.
 */
export interface Published {
  model: Description;
  channels: Channel[];
  lines: DrawnLine[];
  inputs: Input[];
  warnings: Warning[];
}
/**
 * The description of a scenario for a view.
 */
export interface Description {
  /**
   * Title of one line.
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
   * The parts that it includes, also those within parts.
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
   * The loops that an input releases and engages.
   */
  connections: ConnectionDescription[];
  /**
   * The steps of the operation; none without one.
   */
  steps: StepDescription[];
  /**
   * The task for whoever moves the levers, if there is one.
   */
  task: TaskDescription | null;
  /**
   * The forces and the drives.
   */
  elements: ElementDescription[];
  /**
   * Acceleration of gravity, m/s^2; 0 if it is disabled.
   */
  gravity_m_s2: number;
  /**
   * The sea, if there is one.
   */
  sea: SeaDescription | null;
  /**
   * The wind, if there is any.
   */
  wind: WindDescription | null;
  /**
   * The hulls in it, in the order of results.
   */
  hulls: HullDescription[];
  /**
   * The tanks with liquids that move.
   */
  tanks: DrawnTank[];
  /**
   * The objects that are lowered through its surface, in the order of results.
   */
  objects_in_water: ObjectInWater[];
  /**
   * The limits on columns of the results.
   */
  limits: LimitDescription[];
  view: ViewDescription;
  /**
   * The parameters with their values.
   */
  parameters: ParameterDescription[];
  /**
   * Settings that can be set during a run, by their paths in the scenario.
   */
  live_settings: string[];
  /**
   * Warnings about the model before it runs.
   */
  warnings: string[];
}
/**
 * A part and where it is mounted.
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
   * Body on which the part is mounted, or `world`.
   */
  on: string;
  /**
   * Position in the drawing frame of that body, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
  /**
   * Orientation of the part's axes relative to the axes of that body: roll, pitch, yaw, rad.
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
   * Whether it is a ship or floats like one: its joint to the world is floating or moved by waves.
   */
  floats: boolean;
  /**
   * Whether a `submerged` force acts on it.
   */
  is_submerged: boolean;
  /**
   * Mass, kg.
   */
  mass_kg: number;
  /**
   * Inertia about its centre of mass, body axes, kg m^2, without added mass.
   *
   * @minItems 3
   * @maxItems 3
   */
  inertia_kg_m2: [[number, number, number], [number, number, number], [number, number, number]];
  /**
   * The shape in the scenario; absent if only an inertia is given.
   */
  shape: Shape | null;
  /**
   * Colour, as `#rrggbb`.
   */
  colour: string | null;
  /**
   * Where it is at the start, if its joint is floating and its drawing frame does not begin at its centre of mass.
   */
  at_start: PlaceAtStart | null;
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
 * The place of a floating body at the start of a run, in the world.
 */
export interface PlaceAtStart {
  /**
   * Position of the centre of mass, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  centre_of_mass_m: [number, number, number];
  /**
   * Position of the origin of the drawing frame, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  drawing_frame_m: [number, number, number];
}
/**
 * A joint, with its coordinates.
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
   * Unit vector of the axis about which it turns, axes of the child body; absent if it has no such axis, or several.
   *
   * @minItems 3
   * @maxItems 3
   */
  axis: [number, number, number] | null;
  /**
   * Names of its coordinates that move freely.
   */
  free_coordinates: string[];
  /**
   * The given data of its prescribed motion.
   */
  prescribed: Fact[];
}
/**
 * A given value, ready to print.
 */
export interface Fact {
  /**
   * Its kind, in words.
   */
  label: string;
  /**
   * Its value.
   */
  value: string;
  /**
   * SI unit; empty if it has none.
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
   * Its constraints, as named in the scenario.
   */
  constraints: string[];
}
/**
 * The attachment to the first body.
 */
export interface PointDescription {
  /**
   * The body that carries it, or its segment if it is flexible, or `world`.
   */
  body: string;
  /**
   * Position from the body's centre of mass in body axes, or from the world's origin, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
}
/**
 * The attachment to the second body.
 */
export interface PointDescription1 {
  /**
   * The body that carries it, or its segment if it is flexible, or `world`.
   */
  body: string;
  /**
   * Position from the body's centre of mass in body axes, or from the world's origin, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
}
/**
 * A loop that an input releases and engages.
 */
export interface ConnectionDescription {
  /**
   * Name.
   */
  name: string;
  first: PointDescription2;
  second: PointDescription3;
  /**
   * Its constraints, as named in the scenario.
   */
  constraints: string[];
  /**
   * Whether it begins released.
   */
  begins_released: boolean;
}
/**
 * The attachment to the first body.
 */
export interface PointDescription2 {
  /**
   * The body that carries it, or its segment if it is flexible, or `world`.
   */
  body: string;
  /**
   * Position from the body's centre of mass in body axes, or from the world's origin, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
}
/**
 * The attachment to the second body.
 */
export interface PointDescription3 {
  /**
   * The body that carries it, or its segment if it is flexible, or `world`.
   */
  body: string;
  /**
   * Position from the body's centre of mass in body axes, or from the world's origin, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_m: [number, number, number];
}
/**
 * A step of the operation.
 */
export interface StepDescription {
  /**
   * Its name.
   */
  name: string;
  /**
   * Its moves.
   */
  moves: MoveDescription[];
  /**
   * The condition that ends it, as text.
   */
  until: string;
  /**
   * Largest duration, s; absent if there is none.
   */
  time_out_s: number | null;
}
/**
 * The move of an input.
 */
export interface MoveDescription {
  /**
   * Name of the input, mostly the name of its drive.
   */
  input: string;
  /**
   * The new value.
   */
  to: number;
  /**
   * Unit of the value.
   */
  unit: string;
  /**
   * When it begins, s after the start of the step.
   */
  at_s: number;
  /**
   * Its duration, s; 0 for a jump.
   */
  in_s: number;
}
/**
 * The task for whoever moves the levers.
 */
export interface TaskDescription {
  /**
   * The task in one sentence.
   */
  text: string;
  /**
   * Its stages.
   */
  stages: StageDescription[];
  /**
   * The mark at the place to reach; absent if there is none.
   */
  mark: MarkDescription | null;
}
/**
 * A stage of the task.
 */
export interface StageDescription {
  /**
   * Its name.
   */
  name: string;
  /**
   * The condition that ends it, as text.
   */
  until: string;
}
/**
 * A circle on a level surface.
 */
export interface MarkDescription {
  /**
   * Index of its body; absent for the world.
   */
  body: number | null;
  /**
   * Its centre relative to the body's centre of mass, along the body's axes, or in the world, m.
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
 * A force, a drive, a sensor or a controller.
 */
export interface ElementDescription {
  /**
   * Name.
   */
  name: string;
  /**
   * Its section in the scenario: `forces`, `drives`, `sensors` or `controllers`.
   */
  group: string;
  /**
   * Its kind, in words.
   */
  kind: string;
  /**
   * Whether it is enabled.
   */
  enabled: boolean;
  /**
   * Its given data.
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
   * Depth of the still water, m; absent if it is infinite.
   */
  depth_m: number | null;
  /**
   * Velocity of the current at the surface, world x and y, m/s.
   *
   * @minItems 2
   * @maxItems 2
   */
  current_m_s: [number, number];
  /**
   * Number of regular waves in the sea; 0 for calm water.
   */
  wave_components: number;
  /**
   * Wave systems whose spectra are cut off.
   */
  cut_spectra: CutSpectrum[];
}
/**
 * A wave spectrum that is partly cut off.
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
 * The wind to draw.
 */
export interface WindDescription {
  /**
   * Mean velocity at the reference height, world x and y, m/s.
   *
   * @minItems 2
   * @maxItems 2
   */
  velocity_m_s: [number, number];
  /**
   * Reference height above the still water, m.
   */
  height_m: number;
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
   * The hull's origin, on the waterplane of its data, from the body's centre of mass, body axes, m.
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
   * Whether its buoyancy is linear, for small motions about the draught of its data.
   */
  is_linear: boolean;
  /**
   * Its mesh, if the data have one.
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
 * A tank in a body, with the liquid in it.
 */
export interface DrawnTank {
  /**
   * Name of its element, and of the liquid's body.
   */
  name: string;
  /**
   * The body that carries it.
   */
  body: string;
  /**
   * Its rooms, each a box with its edges along the axes of that body.
   */
  rooms: TankRoom[];
}
/**
 * A room of a tank, with a surface of the liquid that stays parallel to its bottom.
 */
export interface TankRoom {
  /**
   * Corner with the smallest coordinates, from the body's centre of mass, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  low_m: [number, number, number];
  /**
   * Corner with the largest coordinates, m.
   *
   * @minItems 3
   * @maxItems 3
   */
  high_m: [number, number, number];
  /**
   * Level of the liquid at rest above the bottom, m.
   */
  level_m: number;
  /**
   * Column of the results with the level; absent if the level is constant.
   */
  level_column: string | null;
  /**
   * Height above the bottom at which this column is 0, m.
   */
  level_zero_m: number;
}
/**
 * An object that is lowered through the surface.
 */
export interface ObjectInWater {
  /**
   * Name of the force.
   */
  name: string;
  /**
   * Its body.
   */
  body: string;
  /**
   * Mass of the body and of all that it carries, kg.
   */
  mass_kg: number;
  /**
   * Density of the water, kg/m^3.
   */
  density_kg_m3: number;
  /**
   * Number of objects on the body.
   */
  objects_on_body: number;
  /**
   * Projected area along the body's z axis, m^2.
   */
  projected_area_m2: number;
  /**
   * C_D A_p along x, y and z of the body, m^2.
   *
   * @minItems 3
   * @maxItems 3
   */
  drag_areas_m2: [number, number, number];
  /**
   * Added mass along x, y and z of the body under water, kg.
   *
   * @minItems 3
   * @maxItems 3
   */
  added_mass_kg: [number, number, number];
  /**
   * Whether the slamming coefficient is given; otherwise it follows from the growth of the added mass.
   */
  slamming_is_given: boolean;
  /**
   * Whether the solid is a circular cylinder.
   */
  is_cylinder: boolean;
  /**
   * Immersions of the upright object: its bottom at the surface, half its height under water, all of it.
   */
  immersions: ImmersionDescription[];
}
/**
 * An upright object at one immersion.
 */
export interface ImmersionDescription {
  /**
   * h: depth of the lowest point, m.
   */
  depth_m: number;
  /**
   * Depth of the centre of the part under water, m.
   */
  centre_depth_m: number;
  /**
   * Displaced volume, m^3.
   */
  displaced_volume_m3: number;
  /**
   * Derivative of the displaced volume with respect to the depth, m^2: the waterplane area.
   */
  waterplane_area_m2: number;
  /**
   * Added mass along z, kg.
   */
  added_mass_kg: number;
  /**
   * C_D A_p along z of the part under water, m^2.
   */
  drag_area_m2: number;
  /**
   * C_S A_S, m^2. If it follows from the growth of the added mass, 2 / rho dA/dh, it is the largest value
   * from this immersion to the next one.
   */
  slamming_area_m2: number;
}
/**
 * A limit against which the results of a run are checked.
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
   * Value of this unit in the column's SI unit.
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
   * Time from which it applies, s.
   */
  from_s: number;
  /**
   * Time until which it applies, s; absent if it does to the end.
   */
  until_s: number | null;
  /**
   * Numbers of the steps of the operation in which it applies, from 1; none if it applies in all.
   */
  steps: number[];
  /**
   * Percentage of the rows that must be within the bounds; 100 for all.
   */
  percentile: number;
}
/**
 * Camera and plots at first.
 */
export interface ViewDescription {
  /**
   * Name of the camera, or the six coordinates of the eye and of its target relative to the first body, m; empty if the view
   * chooses it.
   */
  camera: string;
  /**
   * The columns of each plot; none if the view chooses them.
   */
  plots: string[][];
}
/**
 * A parameter of the scenario, with its value.
 */
export interface ParameterDescription {
  /**
   * Name, as used in `--set`.
   */
  name: string;
  /**
   * Label for users.
   */
  label: string;
  /**
   * Unit.
   */
  unit: string;
  /**
   * Kind of control in a view.
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
   * Allowed texts.
   */
  choices: string[] | null;
  /**
   * Whether it can change during a run.
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
   * A short description, for the axis of a plot.
   */
  long_name: string;
  /**
   * Its description.
   */
  description: string;
  /**
   * SI unit of all its columns; absent if they differ.
   */
  unit: string | null;
  /**
   * SI unit of each column.
   */
  units: string[];
  /**
   * Frame of the components.
   */
  frame: "world" | "body" | "joint" | "loop" | "surface" | "slow_frame" | "heading" | "none";
  /**
   * Names of the dimensions, slowest first.
   */
  dims: string[];
  /**
   * Labels along each dimension.
   */
  labels: string[][];
  /**
   * Pattern of the names of its columns, with its labels: `{body}.angular_velocity.{axis}`.
   */
  column: string;
  /**
   * Names of its columns in a flat table: `ship.angular_velocity.x`.
   */
  columns: string[];
  /**
   * Places of its labels along lines, if they are points of lines.
   */
  along: PlacesAlong | null;
  /**
   * Whether it is an output of elements; otherwise it is a variable of the model or the ledger.
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
 * Places along lines of the labels of an output or a channel.
 */
export interface PlacesAlong {
  /**
   * Name of the line of each label.
   */
  lines: string[];
  /**
   * Place of each label on its line, as a share of the unstretched length from its first end.
   */
  shares: number[];
  /**
   * Variable of the results with the unstretched length of each line, m.
   */
  length: string;
}
/**
 * A line that views draw from point to point. Its number of points is constant over a run; a single point is drawn as
 * a ball.
 */
export interface DrawnLine {
  /**
   * Name of its element, or of a line of several in one element.
   */
  name: string;
  /**
   * Its appearance.
   */
  style: "line" | "barrel" | "rod" | "pin";
  /**
   * Radius, m; 0 if it is too thin to be drawn to scale.
   */
  radius_m: number;
  /**
   * Number of its points.
   */
  points: number;
  /**
   * The seabed on which it can lie; absent if there is none.
   */
  seabed: DrawnSeabed | null;
}
/**
 * A plane seabed under a drawn line.
 */
export interface DrawnSeabed {
  /**
   * Height at the origin of the world, world z, m.
   */
  height_m: number;
  /**
   * Gradient of the height along x and y.
   *
   * @minItems 2
   * @maxItems 2
   */
  gradient: [number, number];
}
/**
 * A value that a user or a controller sets, constant over each step.
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
   * The sampled output from which it takes its value, as a flat column (`mru.heave_rate`); `None` if the user sets
   * it.
   */
  signal: string | null;
}
/**
 * A warning of a run.
 */
export interface Warning {
  /**
   * Time of the warning's cause, s.
   */
  time_s: number;
  /**
   * Cause of the warning, in words joined by `_`; all warnings with this cause have the same code.
   */
  code: string;
  /**
   * Name of the joint, closed loop, body or element that it concerns.
   */
  name: string;
  /**
   * The value that exceeds its bound, in `unit`; absent if the warning has no number.
   */
  value: number | null;
  /**
   * The bound of the value, in `unit`.
   */
  bound: number | null;
  /**
   * Unit of `value` and `bound`.
   */
  unit: string;
  /**
   * The text of the warning.
   */
  text: string;
}
