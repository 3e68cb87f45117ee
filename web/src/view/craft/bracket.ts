import { Vector3 } from "three";
import type { Vec3 } from "../fit";
import { straight } from "./pieces";
import type { Work } from "./work";

/** Length below which a bracket is a single lug, m. */
const LUG_M = 0.5;

/**
 * Adds a bracket from the nearest point of a body's solid to a point outside the solid; `across` is the direction in
 * which the bracket may spread.
 */
export function addBracket({ fittings, palette }: Work, from: Vec3, to: Vec3, across: Vec3, radius: number): void {
  const way = new Vector3(...to).sub(new Vector3(...from));
  const length = way.length();
  way.normalize();
  const root = new Vector3(...from).addScaledVector(way, -Math.min(0.4, 0.25 * length + radius));
  if (length < LUG_M) {
    fittings.rod(root.toArray(), to, 2 * radius, palette.fitting, 10, 1.15 * radius);
  } else {
    const spread = new Vector3(...across);
    spread.addScaledVector(way, -spread.dot(way)).normalize();
    const apart = Math.max(2.5 * radius, 0.3 * length);
    for (const side of [-1, 1]) fittings.rod(root.clone().addScaledVector(spread, side * apart).toArray(), to, radius, palette.fitting, 8, 0.7 * radius);
    fittings.rod(root.toArray(), to, 0.7 * radius, palette.fitting, 6, 0.6 * radius);
  }
  fittings.ball(to, 1.3 * radius, palette.pin);
}

/** Adds a casing around the foot of a column that stands below the deck and outside the side of the hull. */
export function addSponson({ fittings, palette }: Work, [x, y, foot]: Vec3, radius: number, low: number, deck: number): void {
  const from = Math.max(low, foot - 1.6 * radius);
  fittings.turned([[0, from], [0.7 * radius, from], [1.3 * radius, Math.min(deck, from + 1.2 * radius)], [1.3 * radius, deck], [0, deck]], "z", [x, y, 0], palette.hull, 32);
  addFoundation({ fittings, palette }, [x, y, deck], 1.1 * radius);
}

/** Adds the ring of plates in which a column stands. */
export function addFoundation({ fittings, palette }: Pick<Work, "fittings" | "palette">, [x, y, deck]: Vec3, radius: number): void {
  fittings.turned(straight(1.32 * radius, deck - 0.04 * radius, deck + 0.1 * radius), "z", [x, y, 0], palette.fitting, 32);
  const knees = 8;
  for (let k = 0; k < knees; k++) {
    const angle = (2 * Math.PI * (k + 0.5)) / knees;
    const at = (away: number, z: number): Vec3 => [x + away * Math.cos(angle), y + away * Math.sin(angle), deck + z];
    fittings.rod(at(1.26 * radius, 0.05 * radius), at(1.02 * radius, 0.42 * radius), 0.05 * radius, palette.fitting, 4);
  }
}
