import { between, posesBetween, shareOf, surfaceBetween } from "../app/recording/between";
import { resume } from "../app/recording/resume";
import type { Moment, Recording } from "../app/recording/recording";
import type { Session } from "../app/session";
import type { EngineClient } from "../engine/client";
import type { Frame } from "../engine/messages";
import { words } from "./words";

/** Share of a step by which a time may be before a step and still be that of the step. */
const SLACK = 1e-6;

/**
 * Computes the recorded run again and returns its moments at times in order, interpolated between the two nearest steps. A
 * recording has the sea at the times of the pictures that the machine drew; these moments are equal on every machine.
 */
export async function* momentsAt(client: EngineClient, session: Session, times_s: readonly number[]): AsyncGenerator<Moment> {
  const { run, shown, source, values } = session;
  const { recording } = shown;
  if (!run || !recording || !source) return;
  const { step_s } = run.model;
  const stepOf = (time_s: number) => Math.floor(time_s / step_s + SLACK);
  const at = async (step: number): Promise<Moment> => momentOf(recording, await reached(client, recording, step * step_s, step_s));
  const { frame } = await resume(client, recording, source, values.begun, stepOf(times_s[0]) * step_s);
  let [before, after] = [momentOf(recording, frame), momentOf(recording, frame)];
  for (const time_s of times_s) {
    const step = stepOf(time_s);
    if (stepAt(before, step_s) < step) before = stepAt(after, step_s) === step ? after : await at(step);
    if (time_s / step_s - step > SLACK && stepAt(after, step_s) <= step) after = await at(step + 1);
    yield momentBetween(before, after, time_s);
  }
}

const stepAt = ({ time_s }: Moment, step_s: number) => Math.round(time_s / step_s);

async function reached(client: EngineClient, recording: Recording, time_s: number, step_s: number): Promise<Frame> {
  for (;;) {
    const frame = await client.advance(0, Infinity, time_s);
    if (frame && recording.timeOf(frame.row) > time_s - step_s / 2) return frame;
    if (!frame || frame.fault) throw frame?.fault ?? { kind: "setting", message: words.not_reached(time_s) };
  }
}

function momentOf(recording: Recording, { row, poses, line_points, surface }: Frame): Moment {
  return { time_s: recording.timeOf(row), row, poses, line_points, surface };
}

/** Returns the moment at a time with the row of the step before it. */
function momentBetween(before: Moment, after: Moment, time_s: number): Moment {
  const share = shareOf(before, after, time_s);
  if (share < SLACK) return before;
  const [poses, line_points] = [posesBetween(before.poses, after.poses, share), between(before.line_points, after.line_points, share)];
  return { time_s, row: before.row, poses, line_points, surface: surfaceBetween(before, after, time_s) };
}
