import type { Surface } from "../engine/surface";

/**
 * Slopes at which foam begins, and at which it covers the water; the steepest stable wave has about 0.4 on its flanks.
 */
const FOAM_BETWEEN = [0.13, 0.3] as const;

/** Surface of the sea on a grid of lines, ready to be drawn: row by row along the first x. */
export interface DrawnWaves {
  x_m: Float64Array;
  y_m: Float64Array;
  height_m: Float32Array;
  /** Slopes along x and along y, for each crossing. */
  slope: Float32Array;
  /** Foam at each crossing, from 0 to 1. */
  foam: Float32Array;
}

/** Returns the engine's surface with one interpolated line between each two lines. */
export function refined(surface: Surface): Surface {
  const { x_m, y_m, elevation_m } = surface;
  const [nx, ny] = [x_m.length, y_m.length];
  const [fx, fy] = [between(x_m), between(y_m)];
  const wide = new Float32Array(nx * fy.length);
  for (let i = 0; i < nx; i++) fill(y_m, (j) => elevation_m[i * ny + j], (j, value) => (wide[i * fy.length + j] = value));
  const out = new Float32Array(fx.length * fy.length);
  for (let j = 0; j < fy.length; j++) fill(x_m, (i) => wide[i * fy.length + j], (i, value) => (out[i * fy.length + j] = value));
  return { x_m: fx, y_m: fy, elevation_m: out };
}

/**
 * Returns the surface to draw with a `share` of each elevation: slopes by differences, and foam where the water is
 * steep near a crest.
 */
export function drawnWaves({ x_m, y_m, elevation_m }: Surface, share: (i: number, j: number) => number): DrawnWaves {
  const [nx, ny] = [x_m.length, y_m.length];
  const height_m = new Float32Array(nx * ny);
  for (let i = 0; i < nx; i++) for (let j = 0; j < ny; j++) height_m[i * ny + j] = share(i, j) * elevation_m[i * ny + j];
  const slope = new Float32Array(2 * nx * ny);
  const foam = new Float32Array(nx * ny);
  for (let i = 0; i < nx; i++) {
    const [west, east] = [Math.max(i - 1, 0), Math.min(i + 1, nx - 1)];
    for (let j = 0; j < ny; j++) {
      const [south, north] = [Math.max(j - 1, 0), Math.min(j + 1, ny - 1)];
      const at = i * ny + j;
      slope[2 * at] = (height_m[east * ny + j] - height_m[west * ny + j]) / (x_m[east] - x_m[west]);
      slope[2 * at + 1] = (height_m[i * ny + north] - height_m[i * ny + south]) / (y_m[north] - y_m[south]);
      const neighbours = height_m[east * ny + j] + height_m[west * ny + j] + height_m[i * ny + north] + height_m[i * ny + south];
      foam[at] = foamOf(Math.hypot(slope[2 * at], slope[2 * at + 1]), height_m[at] - neighbours / 4);
    }
  }
  return { x_m, y_m, height_m, slope, foam };
}

/**
 * Returns the share of foam on the water: a wave is white where it is steep, except in a trough. `above_m` is the
 * height above the surroundings.
 */
export function foamOf(slope: number, above_m: number): number {
  if (above_m < 0) return 0;
  const t = Math.min(1, Math.max(0, (slope - FOAM_BETWEEN[0]) / (FOAM_BETWEEN[1] - FOAM_BETWEEN[0])));
  return t * t * (3 - 2 * t);
}

/** Returns the height of the drawn surface at a position, m; 0 outside the grid. */
export function heightAt({ x_m, y_m, height_m }: DrawnWaves, x: number, y: number): number {
  const [i, u] = cellOf(x_m, x);
  const [j, v] = cellOf(y_m, y);
  if (i < 0 || j < 0) return 0;
  const at = i * y_m.length + j;
  const next = at + y_m.length;
  return (1 - u) * ((1 - v) * height_m[at] + v * height_m[at + 1]) + u * ((1 - v) * height_m[next] + v * height_m[next + 1]);
}

/** Returns the root mean square of the slope within a number of lines from the middle line. */
export function roughness({ slope, x_m, y_m }: DrawnWaves, lines: number): number {
  const [middleX, middleY] = [(x_m.length - 1) / 2, (y_m.length - 1) / 2];
  let sum = 0;
  let count = 0;
  for (let i = Math.ceil(middleX - lines); i <= middleX + lines; i++) {
    for (let j = Math.ceil(middleY - lines); j <= middleY + lines; j++) {
      const at = 2 * (i * y_m.length + j);
      sum += slope[at] ** 2 + slope[at + 1] ** 2;
      count += 1;
    }
  }
  return Math.sqrt(sum / count);
}

function cellOf(lines: Float64Array, at: number): [cell: number, share: number] {
  if (!(at >= lines[0] && at <= lines[lines.length - 1])) return [-1, 0];
  let cell = 0;
  while (cell < lines.length - 2 && lines[cell + 1] <= at) cell += 1;
  return [cell, (at - lines[cell]) / (lines[cell + 1] - lines[cell])];
}

function between(lines: Float64Array): Float64Array {
  return Float64Array.from({ length: 2 * lines.length - 1 }, (_, k) => (k % 2 ? (lines[(k - 1) / 2] + lines[(k + 1) / 2]) / 2 : lines[k / 2]));
}

/** Computes values on the lines and halfway between them, by a cubic with slopes from differences. */
function fill(lines: Float64Array, value: (k: number) => number, put: (k: number, value: number) => void): void {
  const last = lines.length - 1;
  const slopeAt = (k: number) => {
    const [before, after] = [Math.max(k - 1, 0), Math.min(k + 1, last)];
    return (value(after) - value(before)) / (lines[after] - lines[before]);
  };
  let slope = slopeAt(0);
  for (let k = 0; k < last; k++) {
    const next = slopeAt(k + 1);
    put(2 * k, value(k));
    put(2 * k + 1, (value(k) + value(k + 1)) / 2 + ((lines[k + 1] - lines[k]) * (slope - next)) / 8);
    slope = next;
  }
  put(2 * last, value(last));
}
