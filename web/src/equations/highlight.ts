import type { Equations } from "../engine/engine";
import { stretchesOf } from "./blocks";
import type { Block, NamedMatrix } from "./blocks";
import { motionsOf } from "./moved";
import type { BodyMotion } from "./moved";

/** Effect of a block, drawn on the ship: the bodies that it concerns, and their motion. */
export interface Highlight {
  bodies: number[];
  motions: BodyMotion[];
}

/**
 * Returns the effect of a block. For B and its derivative: the motion of the body at unit rate of the block's
 * coordinate. For M, D and lists of bodies: the body. For M*, N* and F*: all bodies that both coordinates of the block
 * move.
 */
export function highlightOf({ matrices }: Equations, matrix: NamedMatrix, block: Block, bodyOf: (label: string) => number): Highlight {
  const b = matrices.find(({ name }) => name === "B");
  if (!b) return { bodies: [block.rows.body], motions: [] };
  const columnsOfB = (labels: readonly string[], { from, length }: Block["rows"]) => labels.slice(from, from + length).map((label) => b.column_labels.indexOf(label)).filter((at) => at >= 0);
  const across = columnsOfB(matrix.column_labels, block.columns);
  if (matrix.row_labels.join() === b.row_labels.join()) {
    const own = (motion: BodyMotion) => motion.body === block.rows.body;
    const motions = across.flatMap((column) => motionsOf(b, column, bodyOf).filter(own));
    return { bodies: [block.rows.body, block.columns.body].filter((body, at, all) => body >= 0 && all.indexOf(body) === at), motions: partsOf(motions, block, b, bodyOf) };
  }
  const moved = (columns: number[]) => new Set(columns.flatMap((column) => motionsOf(b, column, bodyOf).map(({ body }) => body)));
  const down = columnsOfB(matrix.row_labels, block.rows);
  const [first, second] = [moved(down), across.length > 0 ? moved(across) : null];
  return { bodies: [...first].filter((body) => !second || second.has(body)), motions: down.flatMap((column) => motionsOf(b, column, bodyOf)) };
}

/** Returns the translation or the rotation of each motion: a block of B contains only one of them. */
function partsOf(motions: BodyMotion[], { rows }: Block, b: NamedMatrix, bodyOf: (label: string) => number): BodyMotion[] {
  const first = stretchesOf(b.row_labels, b.row_units, bodyOf).find(({ body }) => body === rows.body);
  const isPlace = first?.from === rows.from;
  return motions.map((motion) => (isPlace ? { ...motion, angular: [0, 0, 0] } : { ...motion, linear: [0, 0, 0] }));
}
