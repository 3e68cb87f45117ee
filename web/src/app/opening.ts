import type { Asked } from "./address";

/** Default scenario: the paper's ship with its load, and motors that stop by themselves. */
export const OPENING: Asked = { scenario: "paper", values: { motor_1: true, load: true, torque_history: "pulse" } };

/**
 * Returns the default request for a gallery scenario. The paper's ship gets motors that stop by themselves, because she
 * capsizes in the paper's own run; other scenarios keep the values of their files.
 */
export function openingOf(scenario: string): Asked {
  return scenario === OPENING.scenario ? OPENING : { scenario, values: {} };
}
