import type { Color } from "three";
import type { Vec3 } from "../fit";
import { Pieces, straight } from "./pieces";
import type { Work } from "./work";

/** Smallest ratio of length to depth of a box-shaped boom that is drawn as a lattice. */
const LATTICE_RATIO = 15;
/**
 * Taper of a boom at its foot and head: its length in depths of the boom, and the depths at the ends as shares of the
 * full depth.
 */
const TAPER = { over: 3, foot: 0.3, head: 0.55 };

/** A boom along x about its middle, with its foot at the smaller x. */
export interface BoomShape {
  length: number;
  width: number;
  height: number;
  isRound: boolean;
  /** Whether the foot is hinged to the crane's support, and whether the head carries no further boom. */
  isFirst: boolean;
  isLast: boolean;
}

/**
 * Adds a boom with the dimensions of the model: a lattice if it is slender, plates if it is stout, a tube if its shape
 * is a cylinder.
 */
export function addBoom(work: Work, shape: BoomShape, colour: Color): void {
  if (shape.isRound) addTube(work.body, shape, colour, work.palette.fitting);
  else if (isLattice(shape.length, shape.width, shape.height)) addLattice(work, shape, colour);
  else addPlates(work, shape, colour);
}

export function isLattice(length: number, width: number, height: number): boolean {
  return length / Math.max(width, height) >= LATTICE_RATIO;
}

/** Adds a stout tube with flanges. */
function addTube(pieces: Pieces, { length, width, isFirst, isLast }: BoomShape, colour: Color, dark: Color): void {
  const [radius, half] = [width / 2, length / 2];
  const flange = Math.min(0.24 * radius, 0.06 * length);
  pieces.turned(straight(0.975 * radius, -half + flange, half - flange), "x", [0, 0, 0], colour, 28);
  for (const from of [-half, half - flange]) pieces.turned(straight(radius, from, from + flange), "x", [0, 0, 0], colour, 28);
  // Flanges with bolts at the ends of the whole boom.
  for (const [from, isEnd] of [[-half + flange, isFirst], [half - 1.4 * flange, isLast]] as const) if (isEnd) pieces.turned(straight(0.995 * radius, from, from + 0.2 * flange), "x", [0, 0, 0], dark, 28);
  const count = Math.floor(length / (5 * radius));
  for (let k = 1; k < count; k++) pieces.turned(straight(0.995 * radius, -0.2 * flange, 0.2 * flange), "x", [-half + (k / count) * length, 0, 0], colour, 28);
}

/**
 * Adds a welded box: plates that taper to the foot and the head, stiffeners, and edges of the full depth in between.
 */
function addPlates({ body, palette }: Work, { length, width, height, isFirst, isLast }: BoomShape, colour: Color): void {
  const [half, y, z] = [length / 2, width / 2, height / 2];
  const taper = Math.min(1.4 * height, 0.25 * length);
  const [foot, head] = [isFirst ? 0.55 : 1, isLast ? 0.62 : 1];
  const line: [number, number][] = [[-half, -foot * z], [-half + taper, -z], [half - taper, -z], [half, -head * z], [half, head * z], [half - taper, z], [-half + taper, z], [-half, foot * z]];
  body.profile(line, 0.9 * width, 0, colour);
  const plate = 0.05 * height;
  for (const side of [1, -1]) {
    body.box([length - 2 * taper, width, plate], [0, 0, side * (z - plate / 2)], colour);
  }
  const count = Math.max(2, Math.round((length - 2 * taper) / (1.5 * height)));
  for (let k = 0; k <= count; k++) body.box([0.05 * height, width, 0.96 * height], [-half + taper + (k / count) * (length - 2 * taper), 0, 0], colour);
  const eye = 0.4 * Math.min(foot, head) * height;
  for (const [x, isEnd] of [[-half + 0.5 * eye, isFirst], [half - 0.5 * eye, isLast]] as const) {
    if (isEnd) body.turned(straight(0.5 * eye, -y, y), "y", [x, 0, 0], palette.fitting, 16);
  }
}

/** Adds a lattice: four chords that taper to the foot and the head, with posts and diagonals on all sides. */
function addLattice({ body, fittings, palette }: Work, shape: BoomShape, colour: Color): void {
  const { length, width, height, isFirst, isLast } = shape;
  const half = length / 2;
  const chord = 0.075 * Math.min(width, height);
  const bar = 0.5 * chord;
  const taper = TAPER.over * height;
  const share = (x: number) => {
    if (isFirst && x < -half + taper) return TAPER.foot + ((1 - TAPER.foot) * (x + half)) / taper;
    if (isLast && x > half - taper) return TAPER.head + ((1 - TAPER.head) * (half - x)) / taper;
    return 1;
  };
  const corner = (x: number, sy: number, sz: number): Vec3 => [x, sy * (width / 2 - chord) * (isLast || x < 0 ? Math.max(0.7, share(x)) : 1), sz * (height / 2 - chord) * share(x)];
  const sides = [[1, 1], [1, -1], [-1, -1], [-1, 1]] as const;
  const bends = [-half, ...(isFirst ? [-half + taper] : []), ...(isLast ? [half - taper] : []), half];
  for (const [sy, sz] of sides) bends.slice(1).forEach((x, k) => body.rod(corner(bends[k], sy, sz), corner(x, sy, sz), chord, colour, 8));
  const bays = Math.max(4, Math.round(length / (1.05 * height)));
  const at = (k: number) => -half + (k / bays) * length;
  for (let k = 0; k < bays; k++) {
    sides.forEach(([sy, sz], i) => {
      const [ty, tz] = sides[(i + 1) % 4];
      if (k > 0) body.rod(corner(at(k), sy, sz), corner(at(k), ty, tz), bar, colour, 5);
      const [from, to] = k % 2 === 0 ? [corner(at(k), sy, sz), corner(at(k + 1), ty, tz)] : [corner(at(k), ty, tz), corner(at(k + 1), sy, sz)];
      body.rod(from, to, bar, colour, 5);
    });
  }
  addEnds(body, shape, colour, palette.fitting);
  addWalkway(fittings, shape, chord, palette.fitting);
}

/** Adds plates at the foot and at the head, up to the ends of the model's shape. */
function addEnds(body: Pieces, { length, width, height, isFirst, isLast }: BoomShape, colour: Color, dark: Color): void {
  const half = length / 2;
  const thick = 0.06 * width;
  for (const [end, share, isEnd] of [[-1, TAPER.foot, isFirst], [1, TAPER.head, isLast]] as const) {
    const long = (isEnd ? 0.9 : 0.12) * height;
    const [y, z] = [0.42 * width, (isEnd ? share : 1) * height];
    for (const side of [1, -1]) body.box([long, thick, z], [end * (half - long / 2), side * (y - thick / 2), 0], colour);
    body.box([thick, 2 * y, z], [end * (half - thick / 2), 0, 0], isEnd ? dark : colour);
  }
}

/** Adds a walkway of grating on the upper side. */
function addWalkway(fittings: Pieces, { length, width, height }: BoomShape, chord: number, dark: Color): void {
  fittings.box([0.72 * length, 0.32 * width, 0.02], [-0.03 * length, 0, height / 2 - chord], dark);
}
