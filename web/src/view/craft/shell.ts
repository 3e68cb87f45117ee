import { BufferAttribute, BufferGeometry, Color, Vector3 } from "three";
import { toCreasedNormals } from "three/addons/utils/BufferGeometryUtils.js";
import type { MeshInfo } from "../../engine/engine";
import type { Box, Vec3 } from "../fit";
import { cross, middleOf, unit } from "../fit";
import type { Palette } from "../palette";
import type { Outline } from "./outline";
import { lofted } from "./pieces";
import type { Pieces, Plan } from "./pieces";

/** Largest angle between two faces that are shaded as one round surface, rad. */
const CREASE = 0.5;
/** Smallest upward component of the normal of faces that are painted as deck. */
const LEVEL = 0.9;
/** Largest relative distance of the vertices of a mesh from a sphere, for a mesh that is drawn as a sphere. */
const ROUND = 0.02;
/** Lower and upper edge of the boot-top, relative to the water line, as shares of the hull's height. */
const BOOT_TOP = [-0.015, 0.055] as const;
/** Rake of the stem of a box-shaped ship: setback at the keel, as a share of the hull's height. */
const RAKE = 0.55;

/** Part of the hull's side with one colour. */
interface Strake {
  low: number;
  high: number;
  colour: Color;
}

/** Returns the strakes of a hull: bottom paint, boot-top and topsides. */
function strakesOf({ box, water_m }: Outline, palette: Palette): Strake[] {
  const [low, high] = [box.low[2], box.high[2]];
  const at = (share: number) => Math.min(high, Math.max(low, water_m + share * (high - low)));
  const heights = [low, at(BOOT_TOP[0]), at(BOOT_TOP[1]), high];
  const colours = [palette.bottom, palette.stripe, palette.hull];
  return colours.map((colour, k) => ({ low: heights[k], high: heights[k + 1], colour })).filter((one) => one.high - one.low > 1e-6);
}

/** Adds the hull of a box, with its dimensions: rounded corners, or a raked bow. */
export function addBoxShell(pieces: Pieces, outline: Outline, palette: Palette): void {
  const { box } = outline;
  for (const { low, high, colour } of strakesOf(outline, palette)) {
    const turn = bilgeOf(box);
    const heights = [low, ...[0.3, 1].map((share) => box.low[2] + share * turn).filter((z) => z > low && z < high), high];
    pieces.add(lofted(heights.map((z) => ({ z, plan: outline.isShip ? bowed(outline, z) : rounded(box, z) }))), colour);
  }
  const plan = outline.isShip ? bowed(outline, box.high[2]) : rounded(box, box.high[2]);
  addDeck(pieces, plan, box.high[2], palette);
}

/** Returns the radius of the bilge, m. */
function bilgeOf({ low, high }: Box): number {
  return 0.09 * Math.min(high[1] - low[1], high[2] - low[2]);
}

/** Returns the reduction of the half breadth by the bilge at a height, m. */
function bilgeInset(box: Box, z: number): number {
  const radius = bilgeOf(box);
  const down = Math.max(0, box.low[2] + radius - z);
  return radius - Math.sqrt(Math.max(0, radius ** 2 - down ** 2));
}

function rounded(box: Box, z: number): Plan {
  const inset = bilgeInset(box, z);
  const [x, y] = [(box.high[0] - box.low[0]) / 2 - inset, (box.high[1] - box.low[1]) / 2 - inset];
  const [cx, cy] = [(box.high[0] + box.low[0]) / 2, (box.high[1] + box.low[1]) / 2];
  const radius = 0.06 * (box.high[1] - box.low[1]);
  const corners = [[-1, -1, 180], [1, -1, 270], [1, 1, 0], [-1, 1, 90]] as const;
  return corners.flatMap(([sx, sy, from]) =>
    [0, 30, 60, 90].map((turn) => {
      const angle = ((from + turn) * Math.PI) / 180;
      return [cx + sx * (x - radius) + radius * Math.cos(angle), cy + sy * (y - radius) + radius * Math.sin(angle)] as const;
    }),
  );
}

/** Returns the outline at a height; the lower it is, the farther the stem is set back. */
function bowed({ box, stations }: Outline, z: number): Plan {
  const height = box.high[2] - box.low[2];
  const back = RAKE * (box.high[2] - z);
  const from = box.high[0] - 0.3 * (box.high[0] - box.low[0]);
  const share = (box.high[0] - from - Math.min(back, RAKE * height)) / (box.high[0] - from);
  const inset = bilgeInset(box, z);
  const sides = stations.map(({ x, half }) => ({ x: x > from ? from + share * (x - from) : x, y: Math.max(0.02, half - inset) }));
  return [...sides.map(({ x, y }) => [x, -y] as const), ...sides.reverse().map(({ x, y }) => [x, y] as const)];
}

/**
 * Adds a deck plate: too thin to be seen from the side, thick enough that it does not flicker with the hull under it.
 */
function addDeck(pieces: Pieces, plan: Plan, z: number, palette: Palette): void {
  pieces.prism(plan, z - 0.02, z + 0.002, palette.deck);
}

/** Adds the hull mesh of a hydrodynamic database, cut at the edges of its paint. */
export function addMeshShell(pieces: Pieces, mesh: MeshInfo, outline: Outline, palette: Palette): void {
  const ball = ballOf(mesh);
  const faces = mesh.triangles.map((triangle) => triangle.map((i): Vec3 => mesh.vertices_m[i]));
  const strakes = ball ? [{ low: -Infinity, high: outline.water_m, colour: palette.bottom }, { low: outline.water_m, high: Infinity, colour: palette.hull }] : strakesOf(outline, palette);
  const positions: number[] = [];
  const colours: number[] = [];
  const top = outline.box.high[2];
  for (const { low, high, colour } of strakes) {
    for (const face of ball ? finer(faces, ball) : faces) {
      const part = below(below(face, high, 1), low, -1);
      const isDeck = !ball && part.every(([, , z]) => z > top - 1e-3 * (top - outline.box.low[2])) && part.length > 2 && normalOf(part)[2] > LEVEL;
      for (let k = 1; k + 1 < part.length; k++) {
        for (const corner of [part[0], part[k], part[k + 1]]) {
          positions.push(...corner);
          (isDeck ? palette.deck : colour).toArray(colours, colours.length);
        }
      }
    }
  }
  pieces.addPainted(painted(positions, colours, ball));
}

/** Returns the part of a polygon below a height, or above it if `sign` is -1. */
function below(corners: readonly Vec3[], z: number, sign: number): Vec3[] {
  if (!Number.isFinite(z)) return [...corners];
  const depth = (corner: Vec3) => sign * (z - corner[2]);
  return corners.flatMap((corner, k) => {
    const next = corners[(k + 1) % corners.length];
    const [here, there] = [depth(corner), depth(next)];
    const kept = here >= 0 ? [corner] : [];
    if (here * there >= 0) return kept;
    const t = here / (here - there);
    return [...kept, [corner[0] + t * (next[0] - corner[0]), corner[1] + t * (next[1] - corner[1]), z]];
  });
}

function painted(positions: number[], colours: number[], ball: Vec3 | null): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(positions), 3));
  geometry.setAttribute("color", new BufferAttribute(Float32Array.from(colours), 3));
  if (!ball) return toCreasedNormals(geometry, CREASE);
  const normals = new Float32Array(positions.length);
  const normal = new Vector3();
  for (let i = 0; i < normals.length; i += 3) normal.fromArray(positions, i).sub(new Vector3(...ball)).normalize().toArray(normals, i);
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  return geometry;
}

/** Returns the centre of the sphere that a mesh approximates; null for any other mesh. */
function ballOf({ vertices_m }: MeshInfo): Vec3 | null {
  const middle = middleOf(vertices_m);
  const away = vertices_m.map(([x, y, z]) => Math.hypot(x - middle[0], y - middle[1], z - middle[2]));
  const [least, most] = [Math.min(...away), Math.max(...away)];
  return most - least < ROUND * most ? middle : null;
}

/**
 * Divides each face into sixteen, and puts all new corners at the distance from the centre at which the corners of the
 * face are.
 */
function finer(faces: Vec3[][], middle: Vec3): Vec3[][] {
  const between = (a: Vec3, b: Vec3): Vec3 => {
    const from = (p: Vec3) => new Vector3(...p).sub(new Vector3(...middle));
    const [u, v] = [from(a), from(b)];
    const length = (u.length() + v.length()) / 2;
    return u.add(v).setLength(length).add(new Vector3(...middle)).toArray();
  };
  const halved = (all: Vec3[][]) =>
    all.flatMap(([a, b, c]) => {
      const [ab, bc, ca] = [between(a, b), between(b, c), between(c, a)];
      return [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
    });
  return halved(halved(faces));
}

function normalOf([a, b, c]: Vec3[]): Vec3 {
  const from = (p: Vec3): Vec3 => [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
  return unit(cross(from(b), from(c)));
}
