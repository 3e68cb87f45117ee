import type { Run } from "../app/session";
import type { Swarm } from "../view/cloud";
import type { Outlook } from "./outlook";
import { loads, placeOf } from "./score";

/** Interval between two points of the cloud, s: more points would hide the picture. */
const EVERY_S = 2;

/** Returns the possible positions of the loads of a run, from soon to late. */
export function swarmOf(outlook: Outlook, { model, columns }: Pick<Run, "model" | "columns">): Swarm {
  const [points, lateness]: [number[], number[]] = [[], []];
  const { length } = outlook;
  const every = Math.max(1, Math.round(EVERY_S / (outlook.timeAt(1) - outlook.start_s)));
  for (const body of loads(model)) {
    const place = placeOf(model, body, columns);
    for (let k = every; k < length; k += every) {
      outlook.futures.forEach((_, i) => {
        const row = outlook.row(i, k);
        if (!place.every((at) => Number.isFinite(row[at]))) return;
        points.push(...place.map((at) => row[at]));
        lateness.push(k / (length - 1));
      });
    }
  }
  return { points, lateness };
}
