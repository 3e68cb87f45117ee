/** What the app knows of the engine: the class that the WASM package exports, and its JSON. */

import type {
  BodyDescription,
  BoxShape,
  Channel,
  CylinderShape,
  Description,
  DrawnLine,
  HullDescription,
  Input,
  LimitDescription,
  LoopDescription,
  MeshDescription,
  ParameterDescription,
  PointDescription,
  SphereShape,
  Warning,
} from "../generated/model";
import type { Equations } from "../generated/equations";
import type { HydrostaticReport } from "../generated/hydrostatics";
import type { SimulationSettings } from "../generated/scenario";
import { faultOfBreakdown } from "./faults";

export type { Channel, DrawnLine, Warning };
export type { Equations };
export type Hydrostatics = HydrostaticReport;
export type InputInfo = Input;
export type HullInfo = HullDescription;
export type LimitInfo = LimitDescription;
export type LoopInfo = LoopDescription;
export type MeshInfo = MeshDescription;
export type PointInfo = PointDescription;

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

/** As `model_json` has it: a shape stands under its kind, as in a scenario file. */
export function readModel(json: string): ModelInfo {
  const described = JSON.parse(json) as Description;
  return { ...described, bodies: described.bodies.map((body) => ({ ...body, shape: readShape(body.shape) })) };
}

function readShape(tagged: BodyDescription["shape"]): Shape | null {
  if (!tagged) return null;
  if (typeof tagged === "string") return { kind: "point" };
  if ("box" in tagged) return { kind: "box", ...tagged.box };
  if ("cylinder" in tagged) return { kind: "cylinder", ...tagged.cylinder };
  if ("sphere" in tagged) return { kind: "sphere", ...tagged.sphere };
  return { kind: "point" };
}

/** The settings of a resolved scenario, none of them left out. */
export type Settings = Required<SimulationSettings>;

export function readSettings(resolvedJson: string): Settings {
  return (JSON.parse(resolvedJson) as { simulation: Settings }).simulation;
}

/** The axis that a joint turns about or slides along, where it has one. */
export interface JointAxis {
  /** The child. */
  body: string;
  /** In the parent's drawing frame. */
  axis: [number, number, number];
  /** The joint from the child's centre of mass, m; zero where the child turns about its own centre. */
  arm_m: [number, number, number];
}

type ResolvedBody = { joint?: Record<string, { axis?: unknown; child_position_m?: unknown }>; centre_of_mass_m?: unknown };

/** Of the joints of a resolved scenario those with one axis. */
export function readJointAxes(resolvedJson: string): JointAxis[] {
  const { bodies = {} } = JSON.parse(resolvedJson) as { bodies?: Record<string, ResolvedBody> };
  return Object.entries(bodies).flatMap(([body, { joint, centre_of_mass_m }]) => {
    const [given] = Object.values(joint ?? {});
    if (!isVector(given?.axis)) return [];
    const [at, centre] = [given.child_position_m, centre_of_mass_m].map((one) => (isVector(one) ? one : [0, 0, 0]));
    const arm_m = at.map((one, k) => one - centre[k]) as JointAxis["arm_m"];
    return [{ body, axis: given.axis, arm_m }];
  });
}

/** Whether the scenario's timeline steers. */
const TIMELINE = "operation.enabled";

/** What is set to switch the timeline of a resolved scenario off: the parameter for it, else the field itself. */
export function readTimelineSwitch(resolvedJson: string): string {
  const { parameters = [] } = JSON.parse(resolvedJson) as { parameters?: { name: string; writes?: string[] }[] };
  return parameters.find(({ writes }) => writes?.includes(TIMELINE))?.name ?? TIMELINE;
}

function isVector(given: unknown): given is [number, number, number] {
  return Array.isArray(given) && given.length === 3;
}

/** What the engine throws, or anything else that went wrong, in one shape. */
export interface Fault {
  kind: string;
  message: string;
  /** What the page adds to it, in its own language. */
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
  /** Per body x y z qw qx qy qz, metres, world frame. */
  poses(): Float64Array;
  /** Elevation of the sea at every crossing of the lines x and y, world, m, along the first x first. */
  surface(x: Float64Array, y: Float64Array): Float64Array;
  /** What there is to draw beside the bodies. */
  lines_json(): string;
  /** The points of those lines, one line's after another's: x y z, metres, world frame. */
  line_points(): Float64Array;
  model_json(): string;
  /** What a person should know of the rows so far. */
  warnings_json(): string;
  /** What happened, in order of time, but for the first so many: time, element and what it was. */
  events_json(first: number): string;
  /** Throws where a hull cannot float. */
  hydrostatics_json(): string;
  /** The matrices of the method now, and the formulas of their blocks. */
  equations_json(): string;
  /** The scenario with defaults, parameters and overrides in place. */
  resolved_json(): string;
  inputs_json(): string;
  set_input(name: string, value: number): void;
  /** What a hand has set so far. */
  lever_moves_json(): string;
  /** Parameters set since the run began, which no replay has. */
  parameters_set_json(): string;
  /** The scenario with what a hand has set as its operation; throws where one of its own is on. */
  replay_json(): string;
  /** Sets a live parameter from the next step on; throws where the run would have to begin anew. */
  set_parameter(name: string, valueJson: string): void;
  snapshot(): Uint8Array;
  /** Continues from a snapshot of a run of the same scenario. */
  restore(snapshot: Uint8Array): void;
  free(): void;
}

export type OpenEngine = (text: string, file: string, overridesJson: string, filesJson: string) => Engine;

export function asFault(thrown: unknown): Fault {
  // The engine's memory cannot be trusted after this.
  if (thrown instanceof WebAssembly.RuntimeError) return faultOfBreakdown(thrown.message);
  if (typeof thrown === "object" && thrown !== null && "message" in thrown) {
    const { message } = thrown;
    if ("kind" in thrown && typeof thrown.kind === "string") {
      const known: Record<string, unknown> = { ...thrown, kind: thrown.kind, message: String(message) };
      const present = Object.entries(known).filter(([, value]) => value !== null && value !== undefined);
      return Object.fromEntries(present) as unknown as Fault;
    }
    return { kind: "internal", message: String(message) };
  }
  return { kind: "internal", message: String(thrown) };
}
