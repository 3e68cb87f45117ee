import { ExtrudeGeometry, Group, Mesh, MeshStandardMaterial, Shape, ShapeGeometry, SphereGeometry } from "three";
import type { Color } from "three";
import type { Palette } from "./palette";

interface Box {
  length_m: number;
  width_m: number;
  height_m: number;
}

/** Heights of the strakes above the keel, as shares of the hull's height. */
const STRAKES = [
  { from: 0, to: 0.38, colour: "bottom" },
  { from: 0.38, to: 0.42, colour: "stripe" },
  { from: 0.42, to: 0.9, colour: "hull" },
  { from: 0.9, to: 1, colour: "stripe" },
] as const;

/** Returns a floating box: a painted hull with its deck, an arrow to the bow and side lights. */
export function hullOf(box: Box, palette: Palette): Group {
  const group = new Group();
  const bevel = 0.03 * Math.min(box.length_m, box.width_m, box.height_m);
  for (const strake of STRAKES) group.add(strakeOf(box, strake, bevel, palette[strake.colour]));
  group.add(deckOf(box, bevel, palette), ...markingsOf(box, palette), ...lightsOf(box));
  return group;
}

/** Returns the outline in plan, with rounded corners. */
function planOf(length: number, width: number, radius: number): Shape {
  const [x, y] = [length / 2, width / 2];
  const shape = new Shape();
  shape.moveTo(-x + radius, -y);
  shape.lineTo(x - radius, -y);
  shape.quadraticCurveTo(x, -y, x, -y + radius);
  shape.lineTo(x, y - radius);
  shape.quadraticCurveTo(x, y, x - radius, y);
  shape.lineTo(-x + radius, y);
  shape.quadraticCurveTo(-x, y, -x, y - radius);
  shape.lineTo(-x, -y + radius);
  shape.quadraticCurveTo(-x, -y, -x + radius, -y);
  return shape;
}

function strakeOf(box: Box, strake: { from: number; to: number }, bevel: number, colour: Color): Mesh {
  const [low, high] = [(strake.from - 0.5) * box.height_m, (strake.to - 0.5) * box.height_m];
  const atEnd = strake.from === 0 || strake.to === 1;
  const edge = atEnd ? bevel : 0;
  const geometry = new ExtrudeGeometry(planOf(box.length_m - 2 * edge, box.width_m - 2 * edge, 3 * bevel), {
    depth: high - low - (atEnd ? 2 * edge : 0),
    bevelEnabled: atEnd,
    bevelThickness: edge,
    bevelSize: edge,
    bevelSegments: 3,
    curveSegments: 6,
  });
  geometry.translate(0, 0, low + edge);
  const mesh = new Mesh(geometry, new MeshStandardMaterial({ color: colour, roughness: 0.62, metalness: 0.05 }));
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

function deckOf(box: Box, bevel: number, palette: Palette): Mesh {
  const plan = planOf(box.length_m - 6 * bevel, box.width_m - 6 * bevel, 2 * bevel);
  const deck = flat(plan, palette.deck, box.height_m / 2 + 0.01);
  deck.receiveShadow = true;
  return deck;
}

/** Returns an arrow along the deck and two frame lines, which show the bow from any side. */
function markingsOf(box: Box, palette: Palette): Mesh[] {
  const [l, w, z] = [box.length_m, box.width_m, box.height_m / 2 + 0.02];
  const line = (x: number) => {
    const shape = new Shape();
    const half = 0.003 * l;
    shape.moveTo(x - half, -0.42 * w);
    shape.lineTo(x + half, -0.42 * w);
    shape.lineTo(x + half, 0.42 * w);
    shape.lineTo(x - half, 0.42 * w);
    shape.closePath();
    return flat(shape, palette.marking, z);
  };
  const arrow = bowArrowOf(l, w, palette);
  arrow.position.z = z;
  return [arrow, line(0), line(-0.25 * l)];
}

/** Returns an arrow along a deck of this length and width, about its centre. */
export function bowArrowOf(l: number, w: number, palette: Palette): Mesh {
  const arrow = new Shape();
  const [tip, root, wing, stem] = [0.43 * l, 0.27 * l, 0.27 * w, 0.07 * w];
  arrow.moveTo(tip, 0);
  arrow.lineTo(root, wing);
  arrow.lineTo(root, stem);
  arrow.lineTo(0.08 * l, stem);
  arrow.lineTo(0.08 * l, -stem);
  arrow.lineTo(root, -stem);
  arrow.lineTo(root, -wing);
  arrow.closePath();
  return flat(arrow, palette.marking, 0);
}

/** Returns the side lights at the bow: red to port, green to starboard. */
function lightsOf(box: Box): Mesh[] {
  const radius = 0.06 * box.height_m;
  const light = (side: number, colour: number) => {
    const material = new MeshStandardMaterial({ color: colour, emissive: colour, emissiveIntensity: 0.5, roughness: 0.4 });
    const mesh = new Mesh(new SphereGeometry(radius, 20, 14), material);
    mesh.position.set(0.47 * box.length_m, side * 0.45 * box.width_m, box.height_m / 2 + 0.6 * radius);
    mesh.castShadow = true;
    return mesh;
  };
  return [light(1, 0xd93a35), light(-1, 0x1f9d55)];
}

function flat(shape: Shape, colour: Color, z: number): Mesh {
  const geometry = new ShapeGeometry(shape, 6);
  geometry.translate(0, 0, z);
  const mesh = new Mesh(geometry, new MeshStandardMaterial({ color: colour, roughness: 0.9 }));
  mesh.receiveShadow = true;
  return mesh;
}
