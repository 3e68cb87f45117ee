import type { Values } from "../engine/engine";

/** What the page opens with: the paper's page, with the load on and motors that stop by themselves. */
export const OPENING_SCENARIO = "paper";

const OPENINGS: Record<string, Values> = {
  paper: { motor_1: true, load: true, torque_history: "pulse" },
};

export function openingOverrides(scenario: string): Values {
  return { ...OPENINGS[scenario] };
}
