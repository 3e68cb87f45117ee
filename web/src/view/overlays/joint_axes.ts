import { Quaternion, Vector3 } from "three";
import type { Equations, ModelInfo } from "../../engine/engine";
import { bodyFinder, motionsOf } from "../../equations/moved";
import type { Vec3 } from "../fit";

/**
 * Axis about which a joint turns or along which it slides: a point and a direction, in the axes of the body that the
 * joint carries.
 */
export interface JointAxis {
  body: number;
  point: Vec3;
  direction: Vec3;
}

/** Returns the axes of the free joints, from the matrix B at these poses. */
export function jointAxesOf(model: ModelInfo, { matrices }: Equations, poses: ArrayLike<number>): JointAxis[] {
  const b = matrices.find(({ name }) => name === "B");
  if (!b) return [];
  const names = model.bodies.map(({ name }) => name);
  const bodyOf = bodyFinder(names, model.joints);
  return model.joints.flatMap(({ kind, body, free_coordinates }) => {
    if (kind === "floating" || kind === "elastic") return [];
    const own = names.indexOf(body);
    return free_coordinates.flatMap((coordinate): JointAxis[] => {
      const column = b.column_labels.indexOf(coordinate);
      const motion = column < 0 ? undefined : motionsOf(b, column, bodyOf).find((one) => one.body === own);
      return motion ? [axisOf(own, motion.linear, motion.angular, poses)] : [];
    });
  });
}

/** Returns the axis of a motion; the axis of a rotation is at w x v / w^2 from the body's centre. */
function axisOf(body: number, linear: Vec3, angular: Vec3, poses: ArrayLike<number>): JointAxis {
  const from = 7 * body;
  const back = new Quaternion(poses[from + 4], poses[from + 5], poses[from + 6], poses[from + 3]).invert();
  const [v, w] = [new Vector3(...linear).applyQuaternion(back), new Vector3(...angular)];
  const turning = w.lengthSq();
  if (turning < 1e-12) return { body, point: [0, 0, 0], direction: v.normalize().toArray() };
  const point = new Vector3().crossVectors(w, v).divideScalar(turning);
  return { body, point: point.toArray(), direction: w.normalize().toArray() };
}
