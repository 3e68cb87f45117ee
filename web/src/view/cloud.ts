import { Group, IcosahedronGeometry, InstancedMesh, Matrix4, MeshBasicMaterial } from "three";
import type { Palette } from "./palette";

/** Positions x y z one after another, world, m, and the time of each from 0 to 1. */
export interface Swarm {
  points: ArrayLike<number>;
  lateness: ArrayLike<number>;
}

/** Size of a drawn point, relative to the size of the model. */
const SIZE = 0.0035;
const OPACITY = 0.6;

/** Possible future positions as a cloud of points: early ones in one colour, late ones in another. */
export class Cloud extends Group {
  private drawn: InstancedMesh<IcosahedronGeometry, MeshBasicMaterial> | null = null;

  show(swarm: Swarm | null, size: number, palette: Palette): void {
    this.drop();
    if (!swarm || swarm.lateness.length === 0) return;
    const { points, lateness } = swarm;
    const material = new MeshBasicMaterial({ transparent: true, opacity: OPACITY, depthWrite: false, toneMapped: false });
    const drawn = new InstancedMesh(new IcosahedronGeometry(SIZE * size, 1), material, lateness.length);
    drawn.frustumCulled = false;
    const place = new Matrix4();
    for (let i = 0; i < lateness.length; i++) {
      drawn.setMatrixAt(i, place.makeTranslation(points[3 * i], points[3 * i + 1], points[3 * i + 2]));
      drawn.setColorAt(i, palette.load.clone().lerp(palette.axes.z, lateness[i]));
    }
    this.drawn = drawn;
    this.add(drawn);
  }

  private drop(): void {
    const { drawn } = this;
    if (!drawn) return;
    this.remove(drawn);
    drawn.geometry.dispose();
    drawn.material.dispose();
    drawn.dispose();
    this.drawn = null;
  }
}
