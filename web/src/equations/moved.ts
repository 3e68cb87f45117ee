import { vec3 } from "../view/fit";
import { blocksOf, stretchesOf } from "./blocks";
import type { Block, NamedMatrix } from "./blocks";

/**
 * Returns a function that finds the body of a matrix label: the body that the label names, or the body that the named
 * joint carries; -1 for none.
 */
export function bodyFinder(bodies: readonly string[], joints: readonly { name: string; body: string; free_coordinates: string[] }[]): (label: string) => number {
  const known = new Map(bodies.map((name, at) => [name, at]));
  for (const { name, body, free_coordinates } of joints) {
    for (const label of [name, ...free_coordinates]) if (!known.has(label)) known.set(label, known.get(body) ?? -1);
  }
  return (label) => known.get(label) ?? known.get(label.slice(0, Math.max(0, label.lastIndexOf(".")))) ?? -1;
}

/** Motion of a body with one coordinate, or its velocity: translation of the centre of mass, and rotation. */
export interface BodyMotion {
  body: number;
  /** Translation, in world axes. */
  linear: [number, number, number];
  /** Rotation, in body axes. */
  angular: [number, number, number];
}

/**
 * Returns the effect of a column of B: the motion of each body at unit rate of the column's coordinate, without bodies
 * that do not move.
 */
export function motionsOf(b: NamedMatrix, column: number, bodyOf: (label: string) => number): BodyMotion[] {
  const rows = stretchesOf(b.row_labels, b.row_units, bodyOf);
  const blocks = blocksOf(b, rows, [{ from: column, length: 1, body: -1 }]).flat();
  const bodies = [...new Set(rows.map(({ body }) => body))];
  return bodies.map((body) => motionOf(body, blocks.filter((block) => block.rows.body === body))).filter((motion) => motion !== null);
}

function motionOf(body: number, [linear, angular]: Block[]): BodyMotion | null {
  if (linear.isZero && angular.isZero) return null;
  const vector = ({ values }: Block) => vec3((k) => values[k][0]);
  return { body, linear: vector(linear), angular: vector(angular) };
}
