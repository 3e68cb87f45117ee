import { texts } from "../../texts";
import type { EngineClient } from "../../engine/client";
import type { Value, Values } from "../../engine/engine";
import type { Restored } from "../../engine/messages";
import type { Recording } from "./recording";

/**
 * Brings the engine back to a recorded time: restores a keyframe before it, and repeats the run from there with the
 * same lever moves, to the same bits. No parameter was set between the keyframe and that time. `values` are the present
 * parameters of the engine; `set` is called for each parameter that returns to an earlier value.
 */
export async function rewind(
  client: EngineClient,
  recording: Recording,
  time_s: number,
  values: Values,
  set: (name: string, value: Value) => void,
): Promise<Restored> {
  const keyframe = recording.keyframeAt(time_s);
  if (!keyframe) throw { kind: "setting", message: texts.faults.no_state };
  // The engine accepts a state only with the parameters that the run had at that time.
  for (const [name, value] of Object.entries(keyframe.values)) {
    if (values[name] === value) continue;
    await client.parameter(name, value);
    set(name, value);
  }
  const moves = recording.movesBetween(keyframe.time_s, time_s);
  const restored = await client.restore(keyframe.bytes, moves);
  let { frame } = restored;
  while (recording.timeOf(frame.row) < time_s && !frame.fault) frame = await client.step();
  const last = new Map(moves.map(({ input, value }) => [input, value]));
  const inputs = restored.inputs.map((input) => ({ ...input, value: last.get(input.name) ?? input.value }));
  return { inputs, frame };
}
