import { Group, Mesh, MeshBasicMaterial } from "three";
import type { Object3D } from "three";
import type { Palette } from "../palette";

/** The bodies once more, as they stood at the start. */
export class Ghost extends Group {
  private readonly material = new MeshBasicMaterial({ transparent: true, opacity: 0.2, depthWrite: false });

  paint(palette: Palette): void {
    this.material.color.copy(palette.axes.z);
  }

  /** Shares the bodies' geometry; `poses` are those of the start. */
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
}
