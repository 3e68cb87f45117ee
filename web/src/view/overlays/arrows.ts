import { ConeGeometry, CylinderGeometry, Group, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, Vector3 } from "three";
import type { BufferGeometry, Color } from "three";
import type { Vec3 } from "../fit";

/** Largest number of arrows at a time. */
const MOST = 96;
/** Length of the head and thickness of an arrow, relative to the size of the model. */
const HEAD = 0.028;
const SHAFT = 0.0035;
const ALONG = new Vector3(0, 1, 0);

/** An arrow in the world frame, m. */
export interface Arrow {
  from: Vec3;
  /** Vector from the foot to the tip. */
  way: Vec3;
  colour: Color;
  /** Whether the arrow is a moment, which has two heads. */
  isMoment?: boolean;
}

/** Arrows that are drawn over everything, in two draw calls. */
export class Arrows extends Group {
  private readonly shafts = instances(new CylinderGeometry(1, 1, 1, 8).translate(0, 0.5, 0));
  private readonly heads = instances(new ConeGeometry(1, 1, 12).translate(0, -0.5, 0));

  constructor() {
    super();
    this.add(this.shafts, this.heads);
  }

  show(arrows: readonly Arrow[], size: number): void {
    let heads = 0;
    let shafts = 0;
    for (const { from, way, colour, isMoment } of arrows) {
      const direction = new Vector3(...way);
      const length = direction.length();
      if (!(length > 0) || shafts === MOST) continue;
      const turn = new Quaternion().setFromUnitVectors(ALONG, direction.clone().divideScalar(length));
      const head = Math.min(HEAD * size, 0.6 * length);
      put(this.shafts, shafts++, new Vector3(...from), turn, new Vector3(SHAFT * size, Math.max(1e-6, length - 0.9 * head), SHAFT * size), colour);
      for (let k = 0; k < (isMoment ? 2 : 1); k++) {
        const tip = new Vector3(...from).addScaledVector(direction, (length - 0.75 * k * head) / length);
        put(this.heads, heads++, tip, turn, new Vector3(0.3 * head, head, 0.3 * head), colour);
      }
    }
    this.shafts.count = shafts;
    this.heads.count = heads;
    for (const mesh of [this.shafts, this.heads]) {
      mesh.instanceMatrix.needsUpdate = true;
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }
}

function instances(geometry: BufferGeometry): InstancedMesh {
  const mesh = new InstancedMesh(geometry, new MeshBasicMaterial({ depthTest: false, transparent: true }), 2 * MOST);
  mesh.count = 0;
  mesh.frustumCulled = false;
  mesh.renderOrder = 12;
  return mesh;
}

function put(mesh: InstancedMesh, at: number, place: Vector3, turn: Quaternion, scale: Vector3, colour: Color): void {
  mesh.setMatrixAt(at, new Matrix4().compose(place, turn, scale));
  mesh.setColorAt(at, colour);
}
