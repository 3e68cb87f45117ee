import { vec3 } from "../view/fit";
import { blocksOf, stretchesOf } from "./blocks";
import type { Block, NamedMatrix } from "./blocks";

/** The body of a matrix label: the one that it names, or the one that its joint carries; -1 for none. */
export function bodyFinder(bodies: readonly string[], joints: readonly { name: string; body: string; free_coordinates: string[] }[]): (label: string) => number {
  const known = new Map(bodies.map((name, at) => [name, at]));
  for (const { name, body, free_coordinates } of joints) {
    for (const label of [name, ...free_coordinates]) if (!known.has(label)) known.set(label, known.get(body) ?? -1);
  }
  return (label) => known.get(label) ?? known.get(label.slice(0, Math.max(0, label.lastIndexOf(".")))) ?? -1;
}

/** How a body moves with one coordinate, or how fast it moves: along and about its centre of mass. */
export interface BodyMotion {
  body: number;
  /** World axes. */
  linear: [number, number, number];
  /** Body axes. */
  angular: [number, number, number];
}

/** The effect of a column of B: each body's motion at unit rate of that coordinate; bodies at rest are left out. */
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
