import type { HullInfo, MeshInfo } from "../../engine/engine";
import type { Box, Vec3 } from "../fit";
import type { Plan } from "./pieces";

/** Number of stations along a hull at which its breadth is given. */
const STATIONS = 48;
/** Length of the bow of a box-shaped hull, as a share of the hull's length. */
const BOW_SHARE = 0.24;
/** Smallest ratio of length to beam of a box that is drawn as a ship's hull. */
const SHIP_RATIO = 3.5;
/**
 * A hull counts as pointed if its beam at the share `at` of its length from an end is less than the share `below` of
 * its full beam.
 */
const POINTED = { at: 0.03, below: 0.5 };

/** Outline of a hull for the equipment on its deck: body axes, bow at the larger x, m. */
export interface Outline {
  box: Box;
  /** Height of the painted water line, m. */
  water_m: number;
  /** Whether the hull has a bow. */
  isShip: boolean;
  /** Whether the hull has a deck; a sphere has none. */
  hasDeck: boolean;
  /** Returns the half breadth at the deck at a given x. */
  halfAt(x: number): number;
  /** Stations with the half breadth of both sides. */
  stations: readonly { x: number; half: number }[];
}

/** Returns the outline of a hull with a mesh. */
export function outlineOfMesh(mesh: MeshInfo, box: Box, { origin_m }: HullInfo): Outline {
  const z = box.high[2] - 1e-3 * (box.high[2] - box.low[2]);
  const sides = crossings(mesh, z);
  const outline = outlineOf(box, origin_m[2], (x) => halfBreadth(sides, x), null);
  const areOnTop = (triangle: readonly number[]) => triangle.every((i) => mesh.vertices_m[i][2] >= z);
  return { ...outline, hasDeck: mesh.triangles.some(areOnTop) };
}

/** Returns the outline of a box: pointed if it is as slender as a ship. */
export function outlineOfBox(box: Box, water_m: number): Outline {
  const [length, beam] = [box.high[0] - box.low[0], box.high[1] - box.low[1]];
  const isShip = length >= SHIP_RATIO * beam;
  const from = box.high[0] - BOW_SHARE * length;
  const half = (x: number) => (isShip && x > from ? (beam / 2) * bowShare((x - from) / (BOW_SHARE * length)) : beam / 2);
  return outlineOf(box, water_m, half, isShip);
}

/** Returns the share of the full breadth along the bow: 1 at its root, 0 at the stem. */
function bowShare(t: number): number {
  return Math.sqrt(Math.max(0, 1 - t ** 2.2));
}

function outlineOf(box: Box, water_m: number, half: (x: number) => number, known: boolean | null): Outline {
  const [from, length] = [box.low[0], box.high[0] - box.low[0]];
  const stations = Array.from({ length: STATIONS + 1 }, (_, i) => {
    // Stations are closer together towards the bow, where the sides curve.
    const x = from + length * (1 - (1 - i / STATIONS) ** 1.5);
    return { x, half: half(x) };
  });
  const most = Math.max(...stations.map((one) => one.half));
  const isShip = known ?? half(from + (1 - POINTED.at) * length) < POINTED.below * most;
  return { box, water_m, isShip, hasDeck: true, halfAt: half, stations };
}

type Segment = [[number, number], [number, number]];

/** Returns the line segments in which a mesh crosses a height, in plan. */
function crossings({ vertices_m, triangles }: MeshInfo, z: number): Segment[] {
  return triangles.flatMap((triangle): Segment[] => {
    const corners = triangle.map((i): Vec3 => vertices_m[i]);
    const cut = [0, 1, 2].flatMap((k): [number, number][] => {
      const [a, b] = [corners[k], corners[(k + 1) % 3]];
      if (a[2] > z === b[2] > z) return [];
      const t = (z - a[2]) / (b[2] - a[2]);
      return [[a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]];
    });
    return cut.length === 2 ? [[cut[0], cut[1]]] : [];
  });
}

function halfBreadth(sides: readonly Segment[], x: number): number {
  let half = 0;
  for (const [[x1, y1], [x2, y2]] of sides) {
    if ((x1 - x) * (x2 - x) > 0) continue;
    const t = x1 === x2 ? 0 : (x - x1) / (x2 - x1);
    half = Math.max(half, Math.abs(y1 + t * (y2 - y1)), x1 === x2 ? Math.abs(y2) : 0);
  }
  return half;
}

/** Returns the deck between two x, at a distance inside its edge, counter-clockwise. */
export function planBetween({ stations, halfAt }: Outline, from: number, to: number, inset = 0, most = Infinity): Plan {
  const ends = [from, to].map((x) => ({ x, half: halfAt(x) }));
  const between = [ends[0], ...stations.filter(({ x }) => x > from + 1e-6 && x < to - 1e-6), ends[1]];
  const sides = between.map(({ x, half }) => ({ x, y: Math.max(0.02, Math.min(most, half - inset)) }));
  return [...sides.map(({ x, y }) => [x, -y] as const), ...sides.reverse().map(({ x, y }) => [x, y] as const)];
}
