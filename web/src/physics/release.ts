import type { Recording } from "../app/recording/recording";
import type { Hydrostatics, InputInfo, ModelInfo } from "../engine/engine";

/** Fact by which the engine marks an element that can release its load, and text of the event of the release. */
const CAN_BE = { label: "can be released", value: "true" };
const IS = "is released";

/** Kind of an input's signal that the scenario's timeline gives. */
const TIMELINE = "operation";

/**
 * Returns the input that releases a load: it has the name of the element that holds the load, and is set by hand or by
 * a timeline. Null if there is none.
 */
export function releaseOf({ elements }: Pick<ModelInfo, "elements">, inputs: readonly InputInfo[]): InputInfo | null {
  const can = (name: string) => elements.some((one) => one.name === name && one.enabled && one.facts.some(({ label, value }) => label === CAN_BE.label && value === CAN_BE.value));
  return inputs.find((one) => (one.signal === null || isByTimeline(one)) && can(one.name)) ?? null;
}

export function isByTimeline({ signal }: InputInfo): boolean {
  return signal === TIMELINE;
}

/** Returns the time of the release, s; null if the load was not released before `until_s`. */
export function releasedAt(recording: Recording, name: string, until_s: number): number | null {
  return recording.events.find((one) => one.name === name && one.text === IS && one.time_s <= until_s)?.time_s ?? null;
}

/** Returns the load that an element holds, with all bodies joined to the load; empty if there is no load. */
export function lostWith({ hulls }: Hydrostatics, name: string, bodies: ModelInfo["bodies"]): string[] {
  const hanging = hulls.flatMap((hull) => hull.hanging).filter(({ joint }) => joint === name).map(({ body }) => body);
  const lost = new Set(hanging);
  // In this list a body stands after the body to which it is joined.
  for (const { name: body, parent } of bodies) if (lost.has(parent)) lost.add(body);
  return [...lost];
}
