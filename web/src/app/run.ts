import type { Change } from "../engine/changes";
import { Columns } from "../engine/columns";
import type { Channel, DrawnLine, Fault, InputInfo, JointAxis, ModelInfo } from "../engine/engine";
import type { Frame, Opened } from "../engine/messages";
import { Accuracy } from "./accuracy";
import type { Moment, Recording } from "./recording/recording";

/**
 * empty: nothing could be opened; idle: at the start; stepping: in the middle of a long Step; stopped: the run cannot go on.
 */
export type Status = "loading" | "empty" | "idle" | "stepping" | "running" | "paused" | "stopped";

/** An opened scenario: its model and channels, and data derived from them. */
export interface Run {
  model: ModelInfo;
  lines: DrawnLine[];
  channels: Channel[];
  columns: Columns;
  /** Inputs that can be set by hand: levers and set-points. */
  inputs: InputInfo[];
  jointAxes: JointAxis[];
  /** The parameter or field that switches the scenario's timeline off. */
  timelineSwitch: string;
  /** Digest of the scenario's text and of all its files. */
  digest: string;
  accuracy: Accuracy;
}

/** A scenario to hand to the engine. */
export interface Source {
  text: string;
  file: string;
  /** Texts of the files that were opened with the scenario, by name; left out for a scenario of the gallery. */
  opened?: Record<string, string>;
  /** Address of the folder with the files that the scenario names; left out for the gallery's folder. */
  folder?: string;
  /** Name of the scenario in the gallery; left out for other scenarios. */
  gallery?: string;
  /** Changes that a link holds; the run makes them again. */
  changes?: readonly Change[];
}

export interface Listener {
  /** A scenario was opened or reset. */
  opened?(run: Run, frame: Frame, isAnother: boolean): void;
  advanced?(run: Run, frame: Frame): void;
  /** Another moment is shown: a newer one, or one that the user chose. */
  moved?(run: Run, moment: Moment): void;
  /** An input of the run has changed. */
  inputsChanged?(run: Run): void;
  /**
   * Records are about to leave the recording: those after `from_s`, from which the run continues, or all of them, with
   * null, at a reset or when another scenario opens.
   */
  leaves?(run: Run, recording: Recording, from_s: number | null): void;
  /** The run continues from an earlier moment: its recording has nothing later. */
  branched?(run: Run): void;
  /** A parameter or an input was set by hand: forecasts made before are no longer valid. */
  steered?(): void;
  /** The run has repeated changes of a link. */
  followed?(run: Run): void;
  statusChanged?(status: Status): void;
  valuesChanged?(): void;
  faulted?(fault: Fault | null): void;
}

export function runOf({ model, lines, channels, inputs, joint_axes, timeline_switch, digest }: Opened): Run {
  const columns = new Columns(channels);
  return { model, lines, channels, columns, inputs, jointAxes: joint_axes, timelineSwitch: timeline_switch, digest, accuracy: new Accuracy(columns) };
}
