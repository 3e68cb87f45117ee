/** What the app knows of the engine: the class that the WASM package exports, and its JSON. */

import type { BoxShape, CylinderShape, Shape as TaggedShape, SimulationSettings, SphereShape } from "../generated/scenario";

export type Value = boolean | number | string;
export type Values = Record<string, Value>;

export type Shape =
  | ({ kind: "box" } & BoxShape)
  | ({ kind: "cylinder" } & Required<CylinderShape>)
  | ({ kind: "sphere" } & SphereShape)
  | { kind: "point" };

export interface BodyInfo {
  name: string;
  parent: string;
  shape: Shape | null;
  colour: string | null;
  mass_kg: number;
}

export interface ParameterInfo {
  name: string;
  label: string;
  unit: string | null;
  kind: "boolean" | "number" | "choice";
  value: Value;
  range: [number, number] | null;
  choices: string[] | null;
  live: boolean;
}

export interface JointInfo {
  name: string;
  /** The child. */
  body: string;
  kind: "floating" | "revolute" | "prismatic" | "cylindrical" | "universal" | "planar" | "spherical" | "elastic" | "fixed";
}

/** A point on a body, seen from its centre of mass in body axes; or on the world. */
export interface PointInfo {
  body: string;
  position_m: [number, number, number];
}

export interface LoopInfo {
  name: string;
  first: PointInfo;
  second: PointInfo;
  constraints: string[];
}

/** A hydraulic cylinder: the barrel is pinned to the first body, the rod to the second. */
export interface CylinderInfo {
  name: string;
  first: PointInfo;
  second: PointInfo;
  shortest_m: number;
  longest_m: number;
}

/** The sea; its depth is null where it is infinite. */
export interface SeaInfo {
  density_kg_m3: number;
  depth_m: number | null;
  /** 0 for water that is level. */
  wave_components: number;
}

/** A hull in the water. Its vertices and its origin are seen from its body's centre of mass, body axes. */
export interface HullInfo {
  name: string;
  body: string;
  /** The origin of its data, on their water plane. */
  origin_m: [number, number, number];
  draught_m: number;
  length_m: number;
  beam_m: number;
  mesh: MeshInfo | null;
}

export interface MeshInfo {
  vertices_m: [number, number, number][];
  triangles: [number, number, number][];
}

export interface ModelInfo {
  title: string;
  description: string;
  duration_s: number;
  step_s: number;
  record_every_s: number;
  integrator: string;
  bodies: BodyInfo[];
  /** In the order of the bodies. */
  joints: JointInfo[];
  loops: LoopInfo[];
  cylinders: CylinderInfo[];
  sea: SeaInfo | null;
  /** In the order of results. */
  hulls: HullInfo[];
  parameters: ParameterInfo[];
}

/** As `model_json` has it: a shape stands under its kind, as in a scenario file. */
type Described = Omit<ModelInfo, "bodies"> & {
  bodies: (Omit<BodyInfo, "shape"> & { shape: TaggedShape | null })[];
};

export function readModel(json: string): ModelInfo {
  const described = JSON.parse(json) as Described;
  return { ...described, bodies: described.bodies.map((body) => ({ ...body, shape: readShape(body.shape) })) };
}

function readShape(tagged: TaggedShape | null): Shape | null {
  if (!tagged) return null;
  if ("box" in tagged) return { kind: "box", ...tagged.box };
  if ("cylinder" in tagged) return { kind: "cylinder", axis: "z", ...tagged.cylinder };
  if ("sphere" in tagged) return { kind: "sphere", ...tagged.sphere };
  return { kind: "point" };
}

/** How a hull floats at rest in still water, its crane as it stands. Pairs are across the ship and along it. */
export interface HullAtRest {
  /** Name of the force, as of {@link HullInfo}. */
  force: string;
  /** With hanging loads where they hang from, less what slack tanks take off, m. */
  metacentric_height_m: [number, number];
}

export interface Hydrostatics {
  hulls: HullAtRest[];
  /** What a person should know of them. */
  warnings: string[];
}

/** The settings of a resolved scenario, none of them left out. */
export type Settings = Required<SimulationSettings>;

export function readSettings(resolvedJson: string): Settings {
  return (JSON.parse(resolvedJson) as { simulation: Settings }).simulation;
}

/** A named result; its values stand at `offset .. offset + len` of a row. */
export interface Channel {
  variable: string;
  long_name: string;
  unit: string;
  frame: string;
  dims: string[];
  labels: string[][];
  offset: number;
  len: number;
}

/** A lever: a number that may be set at any time and is held between steps. */
export interface InputInfo {
  name: string;
  unit: string;
  lower: number;
  upper: number;
  value: number;
}

/** What the engine throws, or anything else that went wrong, in one shape. */
export interface Fault {
  kind: string;
  message: string;
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
  model_json(): string;
  /** Throws where a hull cannot float. */
  hydrostatics_json(): string;
  /** The scenario with defaults, parameters and overrides in place. */
  resolved_json(): string;
  inputs_json(): string;
  set_input(name: string, value: number): void;
  free(): void;
}

export type OpenEngine = (text: string, file: string, overridesJson: string, filesJson: string) => Engine;

export function asFault(thrown: unknown): Fault {
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
