import type { Change } from "../engine/changes";
import { Columns } from "../engine/columns";
import type { Channel, DrawnLine, Fault, InputInfo, JointAxis, ModelInfo } from "../engine/engine";
import type { Frame, Opened } from "../engine/messages";
import { Accuracy } from "./accuracy";
import type { Moment } from "./recording/recording";

/**
 * empty: nothing could be opened; idle: at the start; stepping: on the way of one long Step; stopped: the run
 * cannot go on.
 */
export type Status = "loading" | "empty" | "idle" | "stepping" | "running" | "paused" | "stopped";

/** A scenario opened, with all that follows from its channels. */
export interface Run {
  model: ModelInfo;
  lines: DrawnLine[];
  channels: Channel[];
  columns: Columns;
  /** With the values that they have. */
  inputs: InputInfo[];
  jointAxes: JointAxis[];
  /** What is set to switch the scenario's timeline off. */
  timelineSwitch: string;
  /** Of the scenario's text and of all files that it stands on. */
  digest: string;
  accuracy: Accuracy;
}

/** A scenario as it is handed to the engine. */
export interface Source {
  text: string;
  file: string;
  /** Texts of the files that were opened with it, by their names; left out for a scenario of the gallery. */
  opened?: Record<string, string>;
  /** Its name in the gallery, if it is from there. */
  gallery?: string;
  /** What a link says was set in a run of it, which a run sets again. */
  changes?: readonly Change[];
}

export interface Listener {
  /** A scenario was opened, or the same one reset: everything starts anew. */
  opened?(run: Run, frame: Frame, isAnother: boolean): void;
  advanced?(run: Run, frame: Frame): void;
  /** Another moment is shown: a newer one, or one that was looked up. */
  moved?(run: Run, moment: Moment): void;
  /** An input of the run has another value. */
  inputsChanged?(run: Run): void;
  /** The run goes on from an earlier moment: what came after is no more. */
  branched?(run: Run): void;
  /** Something was set by hand under way: from here the run goes on otherwise. */
  steered?(): void;
  /** The run set levers again by itself, as a link says. */
  followed?(run: Run): void;
  statusChanged?(status: Status): void;
  valuesChanged?(): void;
  faulted?(fault: Fault | null): void;
}

export function runOf({ model, lines, channels, inputs, joint_axes, timeline_switch, digest }: Opened): Run {
  const columns = new Columns(channels);
  return { model, lines, channels, columns, inputs, jointAxes: joint_axes, timelineSwitch: timeline_switch, digest, accuracy: new Accuracy(columns) };
}
