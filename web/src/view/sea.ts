import { BufferAttribute, BufferGeometry, Color, DoubleSide, DynamicDrawUsage, Mesh, MeshStandardMaterial } from "three";
import { LINES, OFFSETS } from "../engine/surface";
import type { Surface } from "../engine/surface";
import type { Palette } from "./palette";

/** Least height that the colours of trough and crest stand for, m: a ripple looks like one. */
const LEAST_HEIGHT_M = 0.5;
/** Between these distances, in lengths of the hull, the waves level out: the lines get too far apart to carry them. */
const LEVEL_BETWEEN = [2, 5];
/** Between these the water fades into the sky. */
const FADE_BETWEEN = [4, 11.5];

/** The surface of the sea as the engine gives it, to be seen through; far from the ship it is level and fades out. */
export class Sea extends Mesh<BufferGeometry, MeshStandardMaterial> {
  private readonly positions = attribute(3);
  private readonly normals = attribute(3);
  private readonly colours = attribute(4);
  private readonly heights = new Float32Array(LINES * LINES);
  /** How much of the wave is drawn at each crossing. */
  private readonly shares = byDistance(LEVEL_BETWEEN);
  private trough = new Color();
  private crest = new Color();
  /** The highest that was seen, m. */
  private height_m = LEAST_HEIGHT_M;

  constructor() {
    const material = new MeshStandardMaterial({ vertexColors: true, transparent: true, side: DoubleSide, roughness: 0.32, forceSinglePass: true });
    super(new BufferGeometry(), material);
    this.geometry.setAttribute("position", this.positions);
    this.geometry.setAttribute("normal", this.normals);
    this.geometry.setAttribute("color", this.colours);
    this.geometry.setIndex(triangles());
    byDistance(FADE_BETWEEN).forEach((cover, at) => this.colours.setW(at, cover));
    this.frustumCulled = false;
    this.receiveShadow = true;
    this.visible = false;
  }

  paint(palette: Palette): void {
    this.trough = palette.trough;
    this.crest = palette.crest;
    this.material.opacity = palette.isDark ? 0.78 : 0.72;
  }

  /** Forgets how high the waves of the run before were. */
  begin(): void {
    this.height_m = LEAST_HEIGHT_M;
  }

  /** Nothing is shown where there is no sea. */
  show(surface: Surface | null): void {
    this.visible = surface !== null;
    if (!surface) return;
    const { heights, shares } = this;
    surface.elevation_m.forEach((elevation, at) => {
      heights[at] = shares[at] * elevation;
      if (Math.abs(heights[at]) > this.height_m) this.height_m = Math.abs(heights[at]);
    });
    for (let i = 0; i < LINES; i++) for (let j = 0; j < LINES; j++) this.put(surface, i, j);
    for (const one of [this.positions, this.normals, this.colours]) one.needsUpdate = true;
  }

  /** Once a crossing and frame: nothing is made here. */
  private put({ x_m, y_m }: Surface, i: number, j: number): void {
    const { heights, trough, crest } = this;
    const at = i * LINES + j;
    this.positions.setXYZ(at, x_m[i], y_m[j], heights[at]);
    const west = i > 0 ? i - 1 : 0;
    const east = i < LINES - 1 ? i + 1 : i;
    const south = j > 0 ? j - 1 : 0;
    const north = j < LINES - 1 ? j + 1 : j;
    const alongX = (heights[east * LINES + j] - heights[west * LINES + j]) / (x_m[east] - x_m[west]);
    const alongY = (heights[i * LINES + north] - heights[i * LINES + south]) / (y_m[north] - y_m[south]);
    const up = 1 / Math.sqrt(alongX * alongX + alongY * alongY + 1);
    this.normals.setXYZ(at, -alongX * up, -alongY * up, up);
    const share = 0.5 + (0.5 * heights[at]) / this.height_m;
    this.colours.setXYZ(
      at,
      trough.r + share * (crest.r - trough.r),
      trough.g + share * (crest.g - trough.g),
      trough.b + share * (crest.b - trough.b),
    );
  }
}

/** For each crossing 1 around the middle, 0 beyond, and smoothly down between these distances. */
function byDistance([from, to]: number[]): Float32Array {
  const shares = new Float32Array(LINES * LINES);
  OFFSETS.forEach((x, i) =>
    OFFSETS.forEach((y, j) => {
      const t = Math.min(1, Math.max(0, (Math.hypot(x, y) - from) / (to - from)));
      shares[i * LINES + j] = 1 - t * t * (3 - 2 * t);
    }),
  );
  return shares;
}

function attribute(size: number): BufferAttribute {
  const made = new BufferAttribute(new Float32Array(LINES * LINES * size), size);
  made.setUsage(DynamicDrawUsage);
  return made;
}

/** Two a cell, counter-clockwise from above. */
function triangles(): number[] {
  const indices: number[] = [];
  for (let i = 0; i + 1 < LINES; i++) {
    for (let j = 0; j + 1 < LINES; j++) {
      const at = i * LINES + j;
      indices.push(at, at + LINES, at + 1, at + 1, at + LINES, at + LINES + 1);
    }
  }
  return indices;
}
