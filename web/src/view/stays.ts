import { CylinderGeometry, InstancedMesh, Matrix4, MeshStandardMaterial, Quaternion, Vector3 } from "three";
import type { Object3D } from "three";
import type { Stay } from "./craft/stays";
import type { Palette } from "./palette";

const ALONG = new Vector3(0, 1, 0);

/** Bars between two bodies that move relative to each other, in one draw call. */
export class Stays extends InstancedMesh {
  constructor(
    private readonly stays: readonly Stay[],
    palette: Palette,
  ) {
    super(new CylinderGeometry(1, 1, 1, 6).translate(0, 0.5, 0), new MeshStandardMaterial({ color: palette.line, roughness: 0.5 }), stays.length);
    this.castShadow = true;
    this.frustumCulled = false;
  }

  /** Moves the bars with the bodies. */
  place(bodies: readonly Object3D[]): void {
    this.stays.forEach(({ from, to, radius }, i) => {
      const [start, end] = [from, to].map(({ body, point }) => new Vector3(...point).applyQuaternion(bodies[body].quaternion).add(bodies[body].position));
      const way = end.sub(start);
      const length = way.length();
      const turn = new Quaternion().setFromUnitVectors(ALONG, way.divideScalar(length || 1));
      this.setMatrixAt(i, new Matrix4().compose(start, turn, new Vector3(radius, length, radius)));
    });
    this.instanceMatrix.needsUpdate = true;
  }
}
