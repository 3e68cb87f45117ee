import { Quaternion, Vector3 } from "three";
import type { PerspectiveCamera } from "three";
import type { Post } from "./craft/craft";
import { Place } from "./craft/place";

/** Vertical field of view of a person at a window, degrees. */
const FIELD_DEG = 58;
const NEAR_M = 0.1;
/** Rotation of the view by a drag, rad per pixel, and largest rotation up and down, rad. */
const DRAG = 0.004;
const STEEPEST = 1.4;
/** Downward angle of the view if there is no target, rad. */
const DOWN = 0.12;

/** View of a person on a body; it faces a target until the user turns it. */
export class Outlook {
  private post: Post | null = null;
  private target: number | null = null;
  private around = 0;
  private down = DOWN;

  constructor(
    private readonly camera: PerspectiveCamera,
    canvas: HTMLCanvasElement,
    private readonly turned: () => void,
  ) {
    canvas.addEventListener("pointermove", ({ buttons, movementX, movementY }) => {
      if (buttons === 1) this.turn(DRAG * movementX, DRAG * movementY);
    });
  }

  get isTaken(): boolean {
    return this.post !== null;
  }

  /** Moves the view to a viewpoint; `target` is the body to look at. */
  take(post: Post, target: number | null): void {
    this.post = post;
    this.target = target;
    [this.around, this.down] = [0, DOWN];
    this.camera.fov = FIELD_DEG;
    this.camera.near = NEAR_M;
    this.camera.clearViewOffset();
    this.camera.updateProjectionMatrix();
  }

  leave(): void {
    this.post = null;
    this.camera.up.set(0, 0, 1);
  }

  /** Turns the view to the left and down, rad. */
  turn(left: number, down: number): void {
    if (!this.post) return;
    this.around += left;
    this.down = Math.min(STEEPEST, Math.max(-STEEPEST, this.down - down));
    this.target = null;
    this.turned();
  }

  /** Moves the view with its body. */
  place(poses: ArrayLike<number>): void {
    if (!this.post) return;
    const { body, point, looks_rad } = this.post;
    const place = new Place(poses, body);
    if (this.target !== null) {
      const [x, y, z] = place.toBody(new Place(poses, this.target).toWorld([0, 0, 0]));
      const way = [x - point[0], y - point[1], z - point[2]] as const;
      this.around = Math.atan2(way[1], way[0]) - looks_rad;
      this.down = Math.min(STEEPEST, Math.max(-STEEPEST, -Math.atan2(way[2], Math.hypot(way[0], way[1]))));
    }
    const [angle, level] = [looks_rad + this.around, Math.cos(this.down)];
    const ahead = place.toWorld([point[0] + level * Math.cos(angle), point[1] + level * Math.sin(angle), point[2] - Math.sin(this.down)]);
    const from = 7 * body;
    this.camera.up.set(0, 0, 1).applyQuaternion(new Quaternion(poses[from + 4], poses[from + 5], poses[from + 6], poses[from + 3]));
    this.camera.position.set(...place.toWorld(point));
    this.camera.lookAt(new Vector3(...ahead));
  }
}
