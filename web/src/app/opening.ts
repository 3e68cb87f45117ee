import type { Asked } from "./address";

/** Default scenario: the paper's ship with its load, and motors that stop by themselves. */
export const OPENING: Asked = { scenario: "paper", values: { motor_1: true, load: true, torque_history: "pulse" } };

/**
 * Returns what opens a scenario of the gallery: the paper's ship gets motors that stop, because she capsizes in the
 * paper's own run; other scenarios are opened as their files are.
 */
export function openingOf(scenario: string): Asked {
  return scenario === OPENING.scenario ? OPENING : { scenario, values: {} };
}
