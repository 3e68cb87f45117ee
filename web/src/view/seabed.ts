import { BufferAttribute, CircleGeometry, Mesh, MeshBasicMaterial, Vector3 } from "three";
import type { DrawnLine, DrawnSeabed } from "../engine/engine";
import type { Palette } from "./palette";

/** Radius of the drawn seabed, relative to the distance of the farthest point of a line over it. */
const REACH = 1.6;
/** Distance of the drawn seabed below the lines on it, relative to the radius, so that it does not hide them. */
const BELOW = 0.002;
const OPACITY = 0.92;
/** Share of the colour of deep water in that of the seabed. */
const IN_WATER = 0.35;
const RINGS = 12;
const SECTORS = 64;
const UP = new Vector3(0, 0, 1);

/** A level seabed at the depth of the sea: around a position, m. */
export interface LevelSeabed {
  x: number;
  y: number;
  depth_m: number;
  radius_m: number;
}

/** Plane seabed under the lines that can lie on it: a disc that fades out. */
export class Seabed extends Mesh<CircleGeometry, MeshBasicMaterial> {
  constructor() {
    super(discOf(), new MeshBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false }));
    // Before the surface of the sea, which writes its depth.
    this.renderOrder = -1;
    this.frustumCulled = false;
    this.visible = false;
  }

  paint({ seabed, deep }: Palette): void {
    this.material.color.copy(seabed).lerp(deep, IN_WATER);
  }

  /**
   * Places the seabed below the present points of the lines that can lie on one; without such a line, around the first
   * body at the depth of the sea. Hides it in a sea without a seabed.
   */
  place(lines: readonly DrawnLine[], points: ArrayLike<number>, level: LevelSeabed | null = null): void {
    const low = [1, 2].map((k) => k * Infinity), high = low.map((most) => -most);
    const beds = lines.flatMap(({ seabed }) => (seabed === null ? [] : [seabed]));
    let from = 0;
    for (const { points: count, seabed } of lines) {
      if (seabed !== null) {
        for (let i = 0; i < count; i++) {
          for (const k of [0, 1]) {
            low[k] = Math.min(low[k], points[from + 3 * i + k]);
            high[k] = Math.max(high[k], points[from + 3 * i + k]);
          }
        }
      }
      from += 3 * count;
    }
    this.visible = beds.length > 0 || level !== null;
    if (beds.length === 0) return level ? this.lay([level.x, level.y], { height_m: -level.depth_m, gradient: [0, 0] }, level.radius_m) : undefined;
    const [x, y] = [0, 1].map((k) => (low[k] + high[k]) / 2);
    const heightOf = ({ height_m, gradient }: DrawnSeabed) => height_m + gradient[0] * x + gradient[1] * y;
    const lowest = beds.reduce((one, other) => (heightOf(other) < heightOf(one) ? other : one));
    this.lay([x, y], { ...lowest, height_m: heightOf(lowest) }, (REACH * Math.hypot(high[0] - low[0], high[1] - low[1])) / 2);
  }

  private lay([x, y]: readonly [number, number], { height_m, gradient }: DrawnSeabed, radius: number): void {
    this.scale.set(radius, radius, 1);
    this.quaternion.setFromUnitVectors(UP, new Vector3(-gradient[0], -gradient[1], 1).normalize());
    this.position.set(x, y, height_m - BELOW * radius);
  }
}

/** Returns a disc of radius 1 whose opacity falls to 0 towards its edge. */
function discOf(): CircleGeometry {
  const disc = new CircleGeometry(1, SECTORS);
  const places: number[] = [];
  const colours: number[] = [];
  const indices: number[] = [];
  for (let ring = 0; ring <= RINGS; ring++) {
    const radius = ring / RINGS;
    for (let sector = 0; sector < SECTORS; sector++) {
      const angle = (2 * Math.PI * sector) / SECTORS;
      places.push(radius * Math.cos(angle), radius * Math.sin(angle), 0);
      colours.push(1, 1, 1, OPACITY * (1 - radius * radius * (3 - 2 * radius)));
      const [at, next] = [ring * SECTORS + sector, ring * SECTORS + ((sector + 1) % SECTORS)];
      if (ring < RINGS) indices.push(at, at + SECTORS, next, next, at + SECTORS, next + SECTORS);
    }
  }
  disc.setAttribute("position", new BufferAttribute(Float32Array.from(places), 3));
  disc.setAttribute("color", new BufferAttribute(Float32Array.from(colours), 4));
  disc.deleteAttribute("uv");
  disc.deleteAttribute("normal");
  disc.setIndex(indices);
  return disc;
}
