import { resume } from "../app/recording/resume";
import type { Moment } from "../app/recording/recording";
import type { Session } from "../app/session";
import type { EngineClient } from "../engine/client";
import type { Frame } from "../engine/messages";
import { words } from "./words";

/**
 * Computes moments of the recorded run again, at the step nearest to each of the times, which are in order. A recording
 * has the sea at the times of the pictures that were drawn; these moments have the same bits on every machine.
 */
export async function* momentsAt(client: EngineClient, session: Session, times_s: readonly number[]): AsyncGenerator<Moment> {
  const { run, shown, source, values } = session;
  const { recording } = shown;
  if (!run || !recording || !source) return;
  const { step_s } = run.model;
  const aimOf = (time_s: number) => Math.round(time_s / step_s) * step_s;
  let { frame } = await resume(client, recording, source, values.begun, aimOf(times_s[0]));
  for (const time_s of times_s) {
    const aim_s = aimOf(time_s);
    while (recording.timeOf(frame.row) < aim_s - step_s / 2) frame = (await client.advance(0, Infinity, aim_s)) ?? stuck(frame, aim_s);
    yield { time_s: recording.timeOf(frame.row), row: frame.row, poses: frame.poses, line_points: frame.line_points, surface: frame.surface };
  }
}

function stuck({ fault }: Frame, time_s: number): never {
  throw fault ?? { kind: "setting", message: words.not_reached(time_s) };
}
