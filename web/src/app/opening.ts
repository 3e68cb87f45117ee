import type { Asked } from "./address";

/** The default scenario: the paper's ship, with the load on and motors that stop by themselves. */
export const OPENING: Asked = { scenario: "paper", values: { motor_1: true, load: true, torque_history: "pulse" } };
