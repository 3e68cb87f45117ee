/** Types of the engine: the class that the WASM package exports, and its JSON. */

import type {
  BodyDescription,
  BoxShape,
  Channel,
  CylinderShape,
  Description,
  DrawnLine,
  DrawnSeabed,
  DrawnTank,
  HullDescription,
  Input,
  LimitDescription,
  LoopDescription,
  MeshDescription,
  ParameterDescription,
  PointDescription,
  SphereShape,
  TankRoom,
  TaskDescription,
  Warning,
} from "../generated/model";
import type { Equations } from "../generated/equations";
import type { HydrostaticReport } from "../generated/hydrostatics";
import type { SimulationSettings } from "../generated/scenario";
import { inBrief } from "../app/format";
import { parsed } from "./answers";
import type { Resolved } from "./answers";
import { faultOfBreakdown } from "./faults";

export type { Channel, DrawnLine, DrawnSeabed, Warning };
export type { Equations };
export type Hydrostatics = HydrostaticReport;
export type InputInfo = Input;
export type HullInfo = HullDescription;
export type LimitInfo = LimitDescription;
export type LoopInfo = LoopDescription;
export type MeshInfo = MeshDescription;
export type PointInfo = PointDescription;
export type TankInfo = DrawnTank;
export type RoomInfo = TankRoom;
export type TaskInfo = TaskDescription;

export type Value = boolean | number | string;
export type Values = Record<string, Value>;

export type Shape =
  | ({ kind: "box" } & BoxShape)
  | ({ kind: "cylinder" } & CylinderShape)
  | ({ kind: "sphere" } & SphereShape)
  | { kind: "point" };

export type BodyInfo = Omit<BodyDescription, "shape"> & { shape: Shape | null };

export type ParameterInfo = ParameterDescription;

export type ModelInfo = Omit<Description, "bodies"> & { bodies: BodyInfo[] };

/** Largest length of a title, characters: a file may have any. */
const LONGEST_TITLE = 200;

/**
 * Reads the description of a model from `model_json`, where the name of a shape's kind is the key of its data, as in a
 * scenario file.
 */
export function readModel(json: string): ModelInfo {
  const described = parsed("model_json", json);
  return { ...described, title: inBrief(described.title, LONGEST_TITLE), bodies: described.bodies.map((body) => ({ ...body, shape: readShape(body.shape) })) };
}

function readShape(tagged: BodyDescription["shape"]): Shape | null {
  if (!tagged) return null;
  if (typeof tagged === "string") return { kind: "point" };
  if ("box" in tagged) return { kind: "box", ...tagged.box };
  if ("cylinder" in tagged) return { kind: "cylinder", ...tagged.cylinder };
  if ("sphere" in tagged) return { kind: "sphere", ...tagged.sphere };
  return { kind: "point" };
}

/** Settings of a resolved scenario; none is left out. */
export type Settings = Required<SimulationSettings>;

/** Axis about which a joint turns or along which it slides. */
export interface JointAxis {
  /** Name of the child body. */
  body: string;
  /** Direction of the axis, in the parent's drawing frame. */
  axis: [number, number, number];
  /** Position of the joint relative to the child's centre of mass, m; zero if the child turns about its own centre. */
  arm_m: [number, number, number];
}

/** Returns the axes of all joints of a resolved scenario that have exactly one axis. */
export function readJointAxes({ bodies = {} }: Resolved): JointAxis[] {
  return Object.entries(bodies).flatMap(([body, { joint, centre_of_mass_m }]) => {
    const [given] = Object.values(joint ?? {});
    if (!isVector(given?.axis)) return [];
    const [at, centre] = [given.child_position_m, centre_of_mass_m].map((one) => (isVector(one) ? one : [0, 0, 0]));
    return [{ body, axis: given.axis, arm_m: [at[0] - centre[0], at[1] - centre[1], at[2] - centre[2]] }];
  });
}

/** Path of the field that enables the scenario's timeline. */
const TIMELINE = "operation.enabled";

/**
 * Returns the name that switches the timeline of a resolved scenario off: the name of the parameter for it, otherwise
 * the path of the field.
 */
export function readTimelineSwitch({ parameters = [] }: Resolved): string {
  return parameters.find(({ writes }) => writes?.includes(TIMELINE))?.name ?? TIMELINE;
}

function isVector(given: unknown): given is [number, number, number] {
  return Array.isArray(given) && given.length === 3;
}

/** An error of the engine, or any other error, in one form. */
export interface Fault {
  kind: string;
  message: string;
  /** Remark that the page adds, in the language of the page. */
  note?: string;
  file?: string;
  line?: number;
  column?: number;
  field?: string;
  found?: string;
  allowed?: string;
  time_s?: number;
  body?: string;
}

export interface Engine {
  step(n: number): void;
  time_s(): number;
  step_s(): number;
  channels_json(): string;
  row(): Float64Array;
  /** Poses x y z qw qx qy qz for each body, m, world frame. */
  poses(): Float64Array;
  /**
   * Elevation of the sea at every crossing of the grid lines `x` and `y`, world frame, m, row by row along the first
   * `x`.
   */
  surface(x: Float64Array, y: Float64Array): Float64Array;
  /** Lines that are drawn in addition to the bodies. */
  lines_json(): string;
  /** Points of the lines of `lines_json`, line by line: x y z, m, world frame. */
  line_points(): Float64Array;
  model_json(): string;
  /** Warnings from the rows so far. */
  warnings_json(): string;
  /** Events in order of time, without the first `first` ones: time, element and event. */
  events_json(first: number): string;
  /** Hydrostatics at rest; throws if a hull cannot float. */
  hydrostatics_json(): string;
  /** Matrices of the method at the present state, and the formulas of their blocks. */
  equations_json(): string;
  /** The scenario with its defaults, parameters and overrides applied. */
  resolved_json(): string;
  inputs_json(): string;
  set_input(name: string, value: number): void;
  /** Inputs that were set by hand so far. */
  lever_moves_json(): string;
  /** Parameters that were set since the start of the run; a replay does not contain them. */
  parameters_set_json(): string;
  /** The scenario with the inputs that were set by hand as its operation; throws if its own operation is enabled. */
  replay_json(): string;
  /** Sets a live parameter from the next step on; throws if the parameter needs a new run. */
  set_parameter(name: string, valueJson: string): void;
  snapshot(): Uint8Array;
  /** Continues from a snapshot of a run of the same scenario. */
  restore(snapshot: Uint8Array): void;
  free(): void;
}

export type OpenEngine = (text: string, file: string, overridesJson: string, filesJson: string) => Engine;

export function asFault(thrown: unknown): Fault {
  // After such an error the engine's memory may be corrupt.
  if (thrown instanceof WebAssembly.RuntimeError) return faultOfBreakdown(thrown.message);
  if (typeof thrown === "object" && thrown !== null && "message" in thrown) {
    const { message } = thrown;
    if ("kind" in thrown && typeof thrown.kind === "string") {
      const present = Object.entries(thrown).filter(([, value]) => value !== null && value !== undefined);
      return { ...Object.fromEntries(present), kind: thrown.kind, message: String(message) };
    }
    return { kind: "internal", message: String(message) };
  }
  return { kind: "internal", message: String(thrown) };
}
