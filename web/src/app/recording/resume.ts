import type { Change } from "../../engine/changes";
import type { EngineClient } from "../../engine/client";
import type { Values } from "../../engine/engine";
import type { Restored } from "../../engine/messages";
import { texts } from "../../texts";
import type { Source } from "../run";
import type { Keyframe, Recording } from "./recording";

/**
 * Brings a new engine to a moment of a recording, the newest unless another one is given: opens the scenario with the
 * changes of the run, restores the last keyframe, and repeats the run from there to the same bits. `begun` are the values
 * at the start of the run.
 */
export async function resume(client: EngineClient, recording: Recording, source: Source, begun: Values, time_s = recording.now.time_s): Promise<Restored> {
  const keyframe = recording.keyframeAt(time_s);
  if (!keyframe) throw { kind: "setting", message: texts.faults.no_state };
  await client.open(source.text, source.file, valuesAt(keyframe, recording, begun), source.opened ?? null, changesOf(recording, source), source.folder);
  const { bytes, isChange } = keyframe;
  const restored = await client.resume({ time_s: keyframe.time_s, bytes, isChange });
  let { frame } = restored;
  while (recording.timeOf(frame.row) < time_s && !frame.fault) {
    const next = await client.advance(0, Infinity, time_s);
    if (!next) break;
    frame = next;
  }
  const last = new Map(recording.movesBetween(keyframe.time_s, time_s).map(({ input, value }) => [input, value]));
  return { inputs: restored.inputs.map((input) => ({ ...input, value: last.get(input.name) ?? input.value })), frame };
}

/** Returns the values of the run at a keyframe: the engine accepts a state only with the parameters of that time. */
function valuesAt({ values }: Keyframe, { changes }: Recording, begun: Values): Values {
  const set = changes.flatMap((change) => ("parameter" in change ? [change.parameter] : []));
  return { ...begun, ...Object.fromEntries(set.map((name) => [name, values[name]])) };
}

/** Returns the changes of the run so far, and those of its link that are still due unless the user has steered. */
function changesOf({ changes, now }: Recording, source: Source): Change[] {
  const linked = source.changes ?? [];
  const known = new Set(linked.map(keyOf));
  const isSteered = changes.some((change) => !known.has(keyOf(change)));
  return [...changes, ...(isSteered ? [] : linked.filter(({ time_s }) => time_s > now.time_s))];
}

const keyOf = (change: Change) => JSON.stringify([change.time_s, "input" in change ? change.input : change.parameter, change.value]);
