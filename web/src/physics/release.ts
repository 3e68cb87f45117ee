import type { Recording } from "../app/recording/recording";
import type { Hydrostatics, InputInfo, ModelInfo } from "../engine/engine";

/** What the engine says of an element whose load can be let go, and of the moment in which it is. */
const CAN_BE = { label: "can be released", value: "true" };
const IS = "is released";

/** What an input takes that the scenario's timeline sets. */
const TIMELINE = "operation";

/** The input that lets a load go: it has the name of what holds the load, and a hand sets it or a timeline. Null where there is none. */
export function releaseOf({ elements }: Pick<ModelInfo, "elements">, inputs: readonly InputInfo[]): InputInfo | null {
  const can = (name: string) => elements.some((one) => one.name === name && one.enabled && one.facts.some(({ label, value }) => label === CAN_BE.label && value === CAN_BE.value));
  return inputs.find((one) => (one.signal === null || isByTimeline(one)) && can(one.name)) ?? null;
}

export function isByTimeline({ signal }: InputInfo): boolean {
  return signal === TIMELINE;
}

/** When it was let go, s; null where it was not by then. */
export function releasedAt(recording: Recording, name: string, until_s: number): number | null {
  return recording.events.find((one) => one.name === name && one.text === IS && one.time_s <= until_s)?.time_s ?? null;
}

/** What hangs on it, with all that is joined to that; none where nothing hangs. */
export function lostWith({ hulls }: Hydrostatics, name: string, bodies: ModelInfo["bodies"]): string[] {
  const hanging = hulls.flatMap((hull) => hull.hanging).filter(({ joint }) => joint === name).map(({ body }) => body);
  const lost = new Set(hanging);
  // Bodies stand after the one that they are joined to.
  for (const { name: body, parent } of bodies) if (lost.has(parent)) lost.add(body);
  return [...lost];
}
