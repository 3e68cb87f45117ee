/* Generated from schema/equations.schema.json by `npm run types`; do not edit. */

/**
 * The method's equations for other languages: the matrices at one state, and the formulas of their blocks.
 */
export interface Equations {
  /**
   * The matrices, in the order of the theory.
   */
  matrices: NamedMatrix[];
  /**
   * The formulas of the matrices that have them, with bodies by number.
   */
  formulas: SymbolicMatrix[];
}
/**
 * A labelled matrix; `data` by rows.
 *
 * A matrix maps a list in the units of its columns to one in the units of its rows, so each entry has its row's unit
 * over its column's: M* (row N m, column rad/s^2) has kg m^2.
 */
export interface NamedMatrix {
  /**
   * Name, as in the paper: `B`, `M_star`, `E_tower/ship`.
   */
  name: string;
  /**
   * One label per row.
   */
  row_labels: string[];
  /**
   * One label per column; a list has a single label.
   */
  column_labels: string[];
  /**
   * One SI unit per row.
   */
  row_units: string[];
  /**
   * One SI unit per column; `1` for a list.
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
   * Name, as in [`NamedMatrix`](super::NamedMatrix): `B`, `M_star`, `E_tower/ship`.
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
   * The meaning of each block row, in LaTeX.
   */
  rows: string[];
  /**
   * The meaning of each block column, in LaTeX.
   */
  columns: string[];
  /**
   * Blocks by row, in LaTeX.
   */
  blocks: string[][];
}
