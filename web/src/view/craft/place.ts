import { Quaternion, Vector3 } from "three";
import type { BodyInfo } from "../../engine/engine";
import type { Box, Vec3 } from "../fit";
import { vec3 } from "../fit";

/** Pose of a body: transforms points between the body's axes and the world. */
export class Place {
  private readonly at: Vector3;
  private readonly turn: Quaternion;
  private readonly back: Quaternion;

  /** Takes the pose of the body with this index from poses x y z qw qx qy qz. */
  constructor(poses: ArrayLike<number>, body: number) {
    const from = 7 * body;
    const [x, y, z, qw, qx, qy, qz] = [0, 1, 2, 3, 4, 5, 6].map((k) => poses[from + k]);
    this.at = new Vector3(x, y, z);
    this.turn = new Quaternion(qx, qy, qz, qw);
    this.back = this.turn.clone().invert();
  }

  toWorld(point: Vec3): Vec3 {
    return new Vector3(...point).applyQuaternion(this.turn).add(this.at).toArray();
  }

  toBody(point: Vec3): Vec3 {
    return new Vector3(...point).sub(this.at).applyQuaternion(this.back).toArray();
  }
}

/** Returns the point of a body's solid that is nearest to a point, body axes; the point itself if it is inside. */
export function nearestOf({ shape }: BodyInfo, { low, high }: Box, point: Vec3): Vec3 {
  const clamped = vec3((k) => Math.min(high[k], Math.max(low[k], point[k])));
  if (shape?.kind === "sphere") {
    const length = Math.hypot(...point);
    return length <= shape.radius_m ? point : vec3((k) => (point[k] * shape.radius_m) / length);
  }
  if (shape?.kind !== "cylinder") return clamped;
  const axis = "xyz".indexOf(shape.axis);
  const [a, b] = [0, 1, 2].filter((k) => k !== axis);
  const away = Math.hypot(point[a], point[b]);
  const share = away > shape.radius_m ? shape.radius_m / away : 1;
  const found = vec3((k) => clamped[k]);
  [found[a], found[b]] = [point[a] * share, point[b] * share];
  return found;
}

export function distance(a: Vec3, b: Vec3): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** Returns the index of the longest axis of a box: 0, 1 or 2. */
export function longestAxis({ low, high }: Box): number {
  const edges = [0, 1, 2].map((k) => high[k] - low[k]);
  return edges.indexOf(Math.max(...edges));
}
