import { Box3, DoubleSide, FrontSide, Group, LineSegments, Material, Mesh, Sprite } from "three";
import type { Object3D, Plane } from "three";
import type { Run } from "../app/session";
import type { Frame } from "../engine/messages";
import { craftOf } from "./craft/craft";
import type { Craft } from "./craft/craft";
import { rolesOf } from "./craft/roles";
import type { Box } from "./fit";
import { insidesOf, seeThrough } from "./insides";
import type { Insides } from "./insides";
import { Linkages } from "./linkages";
import { DrawnLines } from "./lines";
import type { Palette } from "./palette";
import { boxOf, edgesOf, shapedHullOf, solidOf } from "./solids";
import { Stays } from "./stays";
import { Tanks } from "./tanks";
import type { Reading } from "./tanks";
import type { Tints } from "./tension";

/** Data of a run that are needed to draw it. */
export type Shown = Pick<Run, "model" | "lines">;
/** Data of a moment that are needed to draw it. */
export type Pose = { [part in keyof Pick<Frame, "poses" | "line_points">]: ArrayLike<number> };

/** The bodies of a run with their connections, drawn as ships and cranes or as the model's own solids. */
export class Fleet {
  readonly world = new Group();
  bodies: Group[] = [];
  /** Boxes around the solids of the model. */
  boxes: Box[] = [];
  /** Boxes around all drawn parts. */
  drawn: Box[] = [];
  craft: Craft | null = null;
  private linkages: Linkages | null = null;
  private lines: DrawnLines | null = null;
  private stays: Stays | null = null;
  private isPlain = false;
  private tanks: Tanks | null = null;
  private insides: Insides = { glass: new Set(), weights: new Set(), liquids: new Set() };

  /**
   * Builds the bodies and their connections; `start` holds the poses at the start of the run, from which the
   * connections are found.
   */
  build({ model, lines }: Shown, start: Pose, palette: Palette, isPlain: boolean): void {
    this.clear();
    this.isPlain = isPlain;
    const hulls = model.bodies.map(({ name }) => shapedHullOf(model, name));
    this.craft = craftOf({ model, lines }, start, palette);
    this.boxes = model.bodies.map((body, i) => boxOf(body, hulls[i]));
    const roles = rolesOf(model);
    this.bodies = model.bodies.map((body, i) => new Group().add(isPlain ? solidOf(body, palette, roles[i] === "hull", hulls[i]) : this.craft!.works[i].object()));
    this.drawn = this.bodies.map((body, i) => (isPlain ? this.boxes[i] : boxOfObject(body)));
    this.insides = insidesOf(model, roles, this.boxes, start.poses);
    this.showWeights(isPlain);
    if (!isPlain) for (const hull of this.insides.glass) seeThrough(this.bodies[hull]);
    this.tanks = new Tanks(model, this.bodies, palette);
    this.world.add(...this.bodies);
    const thickness = this.boxes.map((box) => Math.min(...edgesOf(box)));
    this.linkages = new Linkages(model, this.bodies, thickness, this.world, palette);
    this.lines = new DrawnLines(lines, this.world, palette);
    this.stays = isPlain || this.craft.stays.length === 0 ? null : new Stays(this.craft.stays, palette);
    if (this.stays) this.world.add(this.stays);
  }

  place({ poses, line_points }: Pose): void {
    this.bodies.forEach((body, i) => {
      const at = 7 * i;
      body.position.set(poses[at], poses[at + 1], poses[at + 2]);
      body.quaternion.set(poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 3]);
    });
    this.linkages?.place();
    this.lines?.place(line_points);
    this.stays?.place(this.bodies);
  }

  /** Colours lines by the tension along them. */
  tint(tints: readonly Tints[]): void {
    this.lines?.tint(tints);
  }

  /** Sets the levels of the liquids in tanks. */
  fill(read: Reading): void {
    this.tanks?.fill(read);
  }

  /** Whether a hull is seen through. */
  get hasGlass(): boolean {
    return this.insides.glass.size > 0;
  }

  /** Shows or hides the weights that are fixed inside hulls; a liquid is drawn in its tank, not as a body. */
  private showWeights(isShown: boolean): void {
    for (const body of this.insides.weights) this.bodies[body].visible = isShown;
    for (const body of this.insides.liquids) this.bodies[body].visible = false;
  }

  /** The longest diagonal of a body's solid, m. */
  get size(): number {
    return Math.max(0.1, ...this.boxes.map((box) => Math.hypot(...edgesOf(box))));
  }

  /** Cuts a body along a plane and shows its inside; a null plane removes the cut. */
  cut(body: number, plane: Plane | null): void {
    this.showWeights(plane !== null || this.isPlain);
    this.bodies[body]?.traverse((object) => {
      if (!(object instanceof Mesh && object.material instanceof Material)) return;
      const { material } = object;
      material.clippingPlanes = plane ? [plane] : null;
      material.side = plane ? DoubleSide : FrontSide;
      material.needsUpdate = true;
    });
  }

  private clear(): void {
    this.world.traverse(dispose);
    this.world.clear();
  }
}

function boxOfObject(object: Object3D): Box {
  const { min, max } = new Box3().setFromObject(object);
  const none = min.x > max.x;
  return { low: none ? [0, 0, 0] : min.toArray(), high: none ? [0, 0, 0] : max.toArray() };
}

export function dispose(object: Object3D): void {
  if (object instanceof Sprite) object.material.map?.dispose();
  if (object instanceof Mesh || object instanceof Sprite || object instanceof LineSegments) {
    object.geometry.dispose();
    object.material.dispose();
  }
}
