import { Group, Mesh, MeshBasicMaterial } from "three";
import type { Object3D } from "three";
import type { Palette } from "../palette";

/** Displacement, relative to the size of the model, and rotation above which a body counts as moved. */
const MOVED = { part: 0.01, turn_rad: 0.04 };

/** Copies of the bodies in their poses at the start. */
export class Ghost extends Group {
  private readonly material = new MeshBasicMaterial({ transparent: true, opacity: 0.2, depthWrite: false });

  paint(palette: Palette): void {
    this.material.color.copy(palette.axes.z);
  }

  /** Shows the copies, which share the geometry of the bodies; `poses` are those at the start. */
  show(bodies: readonly Object3D[], poses: ArrayLike<number>): void {
    this.clear();
    bodies.forEach((body, i) => {
      const at = 7 * i;
      const group = new Group();
      body.traverse((part) => {
        if (part instanceof Mesh) group.add(new Mesh(part.geometry, this.material));
      });
      group.position.set(poses[at], poses[at + 1], poses[at + 2]);
      group.quaternion.set(poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 3]);
      this.add(group);
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
