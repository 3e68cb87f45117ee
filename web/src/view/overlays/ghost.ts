import { Group, Mesh, MeshBasicMaterial } from "three";
import type { Color, Object3D } from "three";

/** Displacement, relative to the size of the model, and rotation above which a body counts as moved. */
const MOVED = { part: 0.01, turn_rad: 0.04 };

/** Transparent copies of the bodies in other poses: those at the start, or those of another run. */
export class Ghost extends Group {
  private readonly material: MeshBasicMaterial;

  constructor(opacity = 0.2) {
    super();
    this.material = new MeshBasicMaterial({ transparent: true, opacity, depthWrite: false });
  }

  paint(colour: Color): void {
    this.material.color.copy(colour);
  }

  /** Shows the copies, which share the geometry of the bodies. */
  show(bodies: readonly Object3D[], poses: ArrayLike<number>): void {
    this.clear();
    for (const body of bodies) {
      const group = new Group();
      body.traverse((part) => {
        if (part instanceof Mesh) group.add(new Mesh(part.geometry, this.material));
      });
      this.add(group);
    }
    this.place(poses);
  }

  place(poses: ArrayLike<number>): void {
    this.children.forEach((group, i) => {
      const at = 7 * i;
      group.position.set(poses[at], poses[at + 1], poses[at + 2]);
      group.quaternion.set(poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 3]);
    });
  }

  /** Hides the copies of bodies that have not moved, because they would only blur them. */
  compare(bodies: readonly Object3D[], size: number): void {
    this.children.forEach((ghost, i) => {
      const { position, quaternion } = bodies[i];
      ghost.visible = ghost.position.distanceTo(position) > MOVED.part * size || ghost.quaternion.angleTo(quaternion) > MOVED.turn_rad;
    });
  }
}
