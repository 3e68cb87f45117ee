import type { Channel, Fault, InputInfo, ModelInfo, Settings, Values } from "./engine";

export type Request =
  | { kind: "open"; text: string; file: string; overrides: Values }
  | { kind: "advance"; wall_s: number; speed: number }
  | { kind: "step" }
  | { kind: "input"; name: string; value: number };

/** What a stretch of simulation produced. */
export interface Frame {
  /** Rows at the recording times passed, one after another, each as wide as `row`. */
  rows: Float64Array;
  /** The row now, on a recording time or not. */
  row: Float64Array;
  /** Per body x y z qw qx qy qz, world frame. */
  poses: Float64Array;
  /** Why the run cannot go on. */
  fault: Fault | null;
}

export interface Opened {
  model: ModelInfo;
  settings: Settings;
  channels: Channel[];
  inputs: InputInfo[];
  frame: Frame;
}

export interface Replies {
  open: Opened;
  advance: Frame;
  step: Frame;
  input: null;
}

export type Reply = { id: number; value: unknown } | { id: number; fault: Fault };
