import type { Color } from "three";
import type { Box } from "../fit";
import { straight } from "./pieces";
import type { Work } from "./work";

/** Share of the height that the foam takes, from the top. */
const FOAM = 0.42;

/**
 * Adds an underwater vehicle of the size of the model's box: a block of foam on an open frame with skids, a canister,
 * thrusters, and lamps at the front.
 */
export function addVehicle({ body, lit, palette }: Work, { low, high }: Box, colour: Color): void {
  const [x, y, z] = [0, 1, 2].map((k) => high[k] - low[k]);
  const bar = 0.05 * Math.min(x, y, z);
  const dark = colour.clone().multiplyScalar(0.3);
  const [ends, sides, below] = [(x - bar) / 2, (y - bar) / 2, z / 2 - FOAM * z];
  body.box([x, y, FOAM * z], [0, 0, z / 2 - (FOAM * z) / 2], colour);
  for (const side of [-sides, sides]) {
    body.box([x, bar, bar], [0, side, -(z - bar) / 2], dark);
    for (const end of [-ends, 0, ends]) body.box([bar, bar, below + z / 2], [end, side, (below - z / 2) / 2], dark);
  }
  for (const end of [-ends, ends]) body.box([bar, y, bar], [end, 0, -(z - bar) / 2], dark);
  body.turned(straight(0.14 * z, -0.3 * x, 0.3 * x), "x", [0, 0, -0.15 * z], palette.fitting, 24);
  for (const across of [-0.3 * y, 0.3 * y]) {
    body.turned(straight(0.12 * z, -0.08 * x, 0.08 * x), "x", [-0.38 * x, across, -0.2 * z], dark, 24);
    lit.ball([0.44 * x, 0.6 * across, -0.14 * z], 0.05 * z, palette.window);
  }
}
