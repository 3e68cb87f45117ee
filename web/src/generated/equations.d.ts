/* Generated from schema/equations.schema.json by `npm run types`; do not edit. */

/**
 * The method's equations as another language shows them: the matrices at one state, and the formulas of their blocks.
 */
export interface Equations {
  /**
   * In the order of the theory.
   */
  matrices: NamedMatrix[];
  /**
   * Of those that have any, with bodies by their numbers.
   */
  formulas: SymbolicMatrix[];
}
/**
 * A labelled matrix; `data` by rows.
 *
 * A matrix takes a list in the units of its columns to one in the units of its rows, so that each
 * entry is in its row's unit over its column's: M* (row N m, column rad/s^2) has kg m^2.
 */
export interface NamedMatrix {
  /**
   * As in the paper: `B`, `M_star`, `E_tower/ship`.
   */
  name: string;
  /**
   * One label a row.
   */
  row_labels: string[];
  /**
   * One label a column; a list has the single label of what it is.
   */
  column_labels: string[];
  /**
   * One SI unit a row.
   */
  row_units: string[];
  /**
   * One SI unit a column; `1` for a list.
   */
  column_units: string[];
  /**
   * Entries by rows.
   */
  data: number[];
}
/**
 * One matrix by blocks, in LaTeX.
 */
export interface SymbolicMatrix {
  /**
   * As in [`NamedMatrix`](super::NamedMatrix): `B`, `M_star`, `E_tower/ship`.
   */
  name: string;
  /**
   * The symbol on the left-hand side.
   */
  symbol: string;
  /**
   * The paper's equation.
   */
  equation: string;
  /**
   * What each block row stands for, in LaTeX.
   */
  rows: string[];
  /**
   * What each block column stands for, in LaTeX.
   */
  columns: string[];
  /**
   * Blocks by row, in LaTeX.
   */
  blocks: string[][];
}
