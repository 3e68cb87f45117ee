import { DoubleSide, Group, Mesh, MeshBasicMaterial, RingGeometry } from "three";
import type { TaskInfo } from "../engine/engine";
import { Place } from "./craft/place";
import type { Palette } from "./palette";

/** Width of the rim, and radius of the spot at the centre, relative to the radius. */
const RIM = 0.12;
const SPOT = 0.1;
/** Height above the surface, so that the two do not flicker, m. */
const ABOVE_M = 0.02;
/** Least radius of the drawn circle, m, and number of its edges. */
const LEAST_M = 0.05;
const EDGES = 48;

type MarkInfo = NonNullable<TaskInfo["mark"]>;

/** The mark of a task: a circle with a spot, on a level surface of a body or of the world. */
export class Target extends Group {
  private mark: MarkInfo | null = null;
  private readonly material = new MeshBasicMaterial({ side: DoubleSide });

  constructor() {
    super();
    this.visible = false;
  }

  build(mark: MarkInfo | null, { marking }: Palette): void {
    this.mark = mark;
    this.visible = mark !== null;
    this.material.color.copy(marking);
    for (const part of this.children.splice(0)) if (part instanceof Mesh) part.geometry.dispose();
    if (!mark) return;
    const radius = Math.max(mark.radius_m, LEAST_M);
    const parts = [new RingGeometry(radius * (1 - RIM), radius, EDGES), new RingGeometry(0, radius * SPOT, EDGES)];
    this.add(...parts.map((part) => new Mesh(part.translate(0, 0, ABOVE_M), this.material)));
  }

  /** Moves the mark with its body. */
  place(poses: ArrayLike<number>): void {
    if (!this.mark) return;
    const { body, position_m: at } = this.mark;
    if (body === null) return void this.position.set(at[0], at[1], at[2]);
    this.position.set(...new Place(poses, body).toWorld([at[0], at[1], at[2]]));
    this.quaternion.set(poses[7 * body + 4], poses[7 * body + 5], poses[7 * body + 6], poses[7 * body + 3]);
  }
}
