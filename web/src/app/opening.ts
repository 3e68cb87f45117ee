import type { Asked } from "./address";

/** What the bare address opens: the paper's page, with the load on and motors that stop by themselves. */
export const OPENING: Asked = { scenario: "paper", values: { motor_1: true, load: true, torque_history: "pulse" } };
