import type { Recording } from "../app/recording/recording";
import type { Hydrostatics, InputInfo, ModelInfo } from "../engine/engine";

/** The engine's facts of an element that can release its load, and the event of the release. */
const CAN_BE = { label: "can be released", value: "true" };
const IS = "is released";

/** The kind of an input that the scenario's timeline sets. */
const TIMELINE = "operation";

/** The input that releases a load: it has the name of the element that holds the load, and a hand or a timeline sets it. Null if there is
 * none. */
export function releaseOf({ elements }: Pick<ModelInfo, "elements">, inputs: readonly InputInfo[]): InputInfo | null {
  const can = (name: string) => elements.some((one) => one.name === name && one.enabled && one.facts.some(({ label, value }) => label === CAN_BE.label && value === CAN_BE.value));
  return inputs.find((one) => (one.signal === null || isByTimeline(one)) && can(one.name)) ?? null;
}

export function isByTimeline({ signal }: InputInfo): boolean {
  return signal === TIMELINE;
}

/** Time of the release, s; null if there was none until then. */
export function releasedAt(recording: Recording, name: string, until_s: number): number | null {
  return recording.events.find((one) => one.name === name && one.text === IS && one.time_s <= until_s)?.time_s ?? null;
}

/** The load on it, with all bodies joined to the load; empty if there is no load. */
export function lostWith({ hulls }: Hydrostatics, name: string, bodies: ModelInfo["bodies"]): string[] {
  const hanging = hulls.flatMap((hull) => hull.hanging).filter(({ joint }) => joint === name).map(({ body }) => body);
  const lost = new Set(hanging);
  // A body comes after the body that it is joined to.
  for (const { name: body, parent } of bodies) if (lost.has(parent)) lost.add(body);
  return [...lost];
}
