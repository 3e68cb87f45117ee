import { BufferAttribute, BufferGeometry, Color, DoubleSide, DynamicDrawUsage, Mesh, MeshStandardMaterial } from "three";
import { LINES } from "../engine/surface";
import type { Surface } from "../engine/surface";
import type { Palette } from "./palette";

/** Least height that the colours of trough and crest stand for, m: a ripple looks like one. */
const LEAST_HEIGHT_M = 0.5;
/** Where the water begins to fade, as a part of the half width. */
const FADE_FROM = 0.45;

/** The surface of the sea as the engine gives it, to be seen through; it fades out around the ship. */
export class Sea extends Mesh<BufferGeometry, MeshStandardMaterial> {
  private readonly positions = attribute(3);
  private readonly normals = attribute(3);
  private readonly colours = attribute(4);
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
    for (const elevation of surface.elevation_m) this.height_m = Math.max(this.height_m, Math.abs(elevation));
    for (let i = 0; i < LINES; i++) for (let j = 0; j < LINES; j++) this.put(surface, i, j);
    for (const one of [this.positions, this.normals, this.colours]) one.needsUpdate = true;
  }

  private put({ x_m, y_m, spacing_m, elevation_m }: Surface, i: number, j: number): void {
    const at = i * LINES + j;
    const elevation = elevation_m[at];
    this.positions.setXYZ(at, x_m + i * spacing_m, y_m + j * spacing_m, elevation);
    const slope = (before: number, after: number, lines: number) => (elevation_m[after] - elevation_m[before]) / (lines * spacing_m);
    const [west, east] = [Math.max(i - 1, 0), Math.min(i + 1, LINES - 1)];
    const [south, north] = [Math.max(j - 1, 0), Math.min(j + 1, LINES - 1)];
    const alongX = slope(west * LINES + j, east * LINES + j, east - west);
    const alongY = slope(i * LINES + south, i * LINES + north, north - south);
    const length = Math.hypot(alongX, alongY, 1);
    this.normals.setXYZ(at, -alongX / length, -alongY / length, 1 / length);
    const share = 0.5 + (0.5 * elevation) / this.height_m;
    const mix = (key: "r" | "g" | "b") => this.trough[key] + share * (this.crest[key] - this.trough[key]);
    this.colours.setXYZW(at, mix("r"), mix("g"), mix("b"), cover(i, j));
  }
}

/** How much of the water is there: all around the ship, nothing at the grid's edge. */
function cover(i: number, j: number): number {
  const half = (LINES - 1) / 2;
  const away = Math.hypot(i - half, j - half) / half;
  const t = Math.min(1, Math.max(0, (away - FADE_FROM) / (0.98 - FADE_FROM)));
  return 1 - t * t * (3 - 2 * t);
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
