import { Group, Mesh, MeshBasicMaterial, MeshStandardMaterial } from "three";
import type { Matrix4 } from "three";
import type { Box, Vec3 } from "../fit";
import { vec3 } from "../fit";
import type { Palette } from "../palette";
import { Pieces } from "./pieces";

/** Drawing of one body: solids, and parts that shine in the dark. */
export class Work {
  /** Solids with the dimensions of the model. */
  readonly body = new Pieces();
  /** Equipment outside these dimensions. */
  readonly fittings = new Pieces();
  /** Windows and lamps. */
  readonly lit = new Pieces();

  constructor(readonly palette: Palette) {}

  /** Moves all solids. */
  move(by: Matrix4): void {
    for (const part of [this.body, this.fittings, this.lit]) part.move(by);
  }

  /** Returns at most two meshes: an opaque one, and one that shines. */
  object(): Group {
    const group = new Group();
    const solid = new Pieces().take(this.body).take(this.fittings);
    const [geometry, lit] = [solid.geometry(), this.lit.geometry()];
    if (geometry) group.add(shaded(new Mesh(geometry, new MeshStandardMaterial({ vertexColors: true, roughness: 0.58, metalness: 0.06 }))));
    if (lit) group.add(new Mesh(lit, this.litMaterial()));
    return group;
  }

  private litMaterial() {
    if (this.palette.isDark) return new MeshBasicMaterial({ vertexColors: true });
    return new MeshStandardMaterial({ vertexColors: true, roughness: 0.16, metalness: 0.35 });
  }
}

function shaded(mesh: Mesh): Mesh {
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

/** Whether two boxes overlap. */
export function overlap(a: Box, b: Box): boolean {
  return [0, 1, 2].every((k) => a.low[k] < b.high[k] && b.low[k] < a.high[k]);
}

export function boxAround(points: readonly Vec3[]): Box {
  const end = (of: (...values: number[]) => number) => vec3((k) => of(...points.map((point) => point[k])));
  return { low: end(Math.min), high: end(Math.max) };
}
