import type { Asked } from "./address";

/** The default scenario: the paper's ship, with the load on and motors that stop by themselves. */
export const OPENING: Asked = { scenario: "paper", values: { motor_1: true, load: true, torque_history: "pulse" } };

/** Opening of a gallery scenario: the paper's ship with motors that stop, since its own run her over; others as their files are. */
export function openingOf(scenario: string): Asked {
  return scenario === OPENING.scenario ? OPENING : { scenario, values: {} };
}
