import { ArrowHelper, Box3, Box3Helper, Color, Group, Vector3 } from "three";
import type { Object3D } from "three";
import type { Highlight } from "../equations/highlight";
import type { Box } from "./fit";
import type { Palette } from "./palette";

/** Length of an arrow, relative to the size of the model: of the fastest translation, and of any rotation. */
const ALONG = 0.45;
const ABOUT = 0.3;
/** Length of an arrow's head, relative to the arrow. */
const HEAD = 0.2;

/** Marks of highlighted bodies: a box around each, and arrows of its motion. */
export class Marks {
  readonly group = new Group();
  private arrows: { arrow: ArrowHelper; body: number; isTurning: boolean; direction: Vector3 }[] = [];

  /** Shows a highlight, or none. `boxes` are the boxes of the bodies, and `size` is the size of the model, m. */
  show(highlight: Highlight | null, bodies: readonly Object3D[], boxes: readonly Box[], size: number, palette: Palette): void {
    this.clear();
    if (!highlight) return;
    for (const body of highlight.bodies) this.frame(bodies[body], boxes[body], palette.axes.z);
    const fastest = Math.max(...highlight.motions.map(({ linear }) => Math.hypot(...linear)), Number.MIN_VALUE);
    for (const { body, linear, angular } of highlight.motions) {
      const share = Math.hypot(...linear) / fastest;
      if (share > 0) this.point(body, linear, ALONG * size * share, palette.axes.x, false);
      if (Math.hypot(...angular) > 0) this.point(body, angular, ABOUT * size, palette.axes.y, true);
    }
    this.place(bodies);
  }

  /** Moves the marks with the bodies: rotations are in body axes, translations in world axes. */
  place(bodies: readonly Object3D[]): void {
    for (const { arrow, body, isTurning, direction } of this.arrows) {
      arrow.position.copy(bodies[body].position);
      arrow.setDirection(isTurning ? direction.clone().applyQuaternion(bodies[body].quaternion) : direction);
    }
  }

  private frame(body: Object3D, { low, high }: Box, colour: Color): void {
    const frame = new Box3Helper(new Box3(new Vector3(...low), new Vector3(...high)), colour);
    frame.name = MARK;
    body.add(frame);
  }

  private point(body: number, [x, y, z]: readonly number[], length: number, colour: Color, isTurning: boolean): void {
    const direction = new Vector3(x, y, z).normalize();
    const arrow = new ArrowHelper(direction, new Vector3(), length, colour, HEAD * length, 0.6 * HEAD * length);
    // Arrows are visible through the hull, because most centres of mass lie inside one.
    for (const part of [arrow.line, arrow.cone]) {
      part.renderOrder = 1;
      for (const material of [part.material].flat()) {
        material.depthTest = false;
        material.transparent = true;
      }
    }
    this.group.add(arrow);
    this.arrows.push({ arrow, body, isTurning, direction });
  }

  private clear(): void {
    for (const { arrow } of this.arrows) arrow.dispose();
    this.arrows = [];
    this.group.clear();
    this.frames().forEach((frame) => {
      frame.removeFromParent();
      frame.dispose();
    });
  }

  private frames(): Box3Helper[] {
    const found: Box3Helper[] = [];
    this.group.parent?.traverse((object) => object instanceof Box3Helper && object.name === MARK && found.push(object));
    return found;
  }
}

const MARK = "mark";
