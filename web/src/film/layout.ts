import type { Size } from "../view/size";

/** A part of a picture, pixels. */
export interface Part {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** Parts of a picture: the ship, the plots beside or below her, and the caption at the foot. */
export interface Layout {
  ship: Part;
  plots: Part[];
  caption: Part;
  /** Number of pixels for one pixel of text at 1280x720. */
  scale: number;
}

/** Largest number of plots in a picture. */
export const MOST_PLOTS = 4;
/** Share of the picture that plots take: of the width beside the ship, of the height below her. */
const PLOTS_SHARE = { beside: 0.36, below: 0.4 };
/** Ratio of width to height from which plots are beside the ship. */
const WIDE = 1.1;
/** Smallest height of a plot, pixels of 1280x720; plots that would be lower are in two columns. */
const LEAST_PLOT = 130;
/** Heights in the caption, pixels of 1280x720. */
export const CAPTION = { margin: 12, title: 26, row: 22 };
const SMALLEST_SCALE = 0.7;

/** Divides a picture; `rows` is the number of rows of the user's text. */
export function layoutOf({ width, height }: Size, plots: number, rows: number): Layout {
  const scale = Math.max(SMALLEST_SCALE, Math.sqrt((width * height) / (1280 * 720)));
  const foot = Math.round(scale * (CAPTION.margin + CAPTION.title + rows * CAPTION.row));
  const body = { left: 0, top: 0, width, height: height - foot };
  const caption = { left: 0, top: body.height, width, height: foot };
  if (plots === 0) return { ship: body, plots: [], caption, scale };
  const isBeside = width >= WIDE * height;
  const beside = Math.round(PLOTS_SHARE.beside * width);
  const below = Math.round(PLOTS_SHARE.below * body.height);
  const ship = isBeside ? { ...body, width: width - beside } : { ...body, height: body.height - below };
  const rest = isBeside ? { ...body, left: ship.width, width: beside } : { ...body, top: ship.height, height: below };
  return { ship, plots: divided(rest, Math.min(plots, MOST_PLOTS), LEAST_PLOT * scale), caption, scale };
}

function divided({ left, top, width, height }: Part, count: number, least: number): Part[] {
  const columns = count > 1 && height / count < least ? 2 : 1;
  const lines = Math.ceil(count / columns);
  const edge = (of: number, k: number, parts: number) => Math.round((of * k) / parts);
  return Array.from({ length: count }, (_, i) => {
    const [line, column] = [Math.floor(i / columns), i % columns];
    const [x, y] = [edge(width, column, columns), edge(height, line, lines)];
    return { left: left + x, top: top + y, width: edge(width, column + 1, columns) - x, height: edge(height, line + 1, lines) - y };
  });
}
