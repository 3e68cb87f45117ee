import { DirectionalLight, Group, HemisphereLight, Mesh, PCFShadowMap, Scene, Sprite, WebGLRenderer } from "three";
import type { Material, Object3D } from "three";
import { onPalette } from "../app/palette";
import type { Run } from "../app/session";
import type { ModelInfo } from "../engine/engine";
import type { Frame } from "../engine/messages";
import type { Surface } from "../engine/surface";
import { Eye } from "./camera";
import type { Highlight } from "../equations/highlight";
import type { Area, Box } from "./fit";
import { Ground } from "./ground";
import { Marks } from "./highlight";
import { Linkages } from "./linkages";
import { DrawnLines } from "./lines";
import { readPalette } from "./palette";
import type { Palette } from "./palette";
import { Sea } from "./sea";
import { boxOf, edgesOf, solidOf, withFrame } from "./solids";
import type { ShapedHull } from "./solids";
import { gridSpacing } from "./spacing";
import { labelScale, triadOf } from "./triad";

/** Height of a label of a body frame, pixels, at most. */
const LABEL_PX = 58;

/** Length of a body frame, as a part of the longest diagonal of a body. */
const FRAME_LENGTH = 0.14;

/** What of a run is drawn. */
type Shown = Pick<Run, "model" | "lines">;
/** What of a moment is drawn. */
type Pose = { [part in keyof Pick<Frame, "poses" | "line_points">]: ArrayLike<number> };

/** The 3D picture: world z up, a body's object at the pose that the engine gives. Drawn on demand. */
export class View {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly eye: Eye;
  private readonly ground = new Ground();
  private readonly sea = new Sea();
  private readonly sun = new DirectionalLight(0xffffff);
  private readonly sky = new HemisphereLight();
  private readonly world = new Group();
  private bodies: Group[] = [];
  private linkages: Linkages | null = null;
  private palette: Palette = readPalette();
  private lines: DrawnLines | null = null;
  private run: Shown | null = null;
  private frame: Pose = { poses: [], line_points: [] };
  private surface: Surface | null = null;
  private boxes: Box[] = [];
  private readonly marks = new Marks();
  private highlighted: Highlight | null = null;
  private framesShown = false;
  private stale = true;

  /** Throws where the browser has no WebGL. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.eye = new Eye(canvas, () => (this.stale = true), () => coversOf(canvas));
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.bias = -0.0005;
    this.sun.shadow.normalBias = 0.03;
    this.scene.add(this.ground, this.sea, this.sky, this.sun, this.sun.target, this.world, this.marks.group);
    this.light();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement!);
    onPalette(() => this.repaint());
  }

  /** Builds the bodies; `refit` when it is another model and not the same one reset. */
  build(run: Shown, frame: Pose, refit: boolean): void {
    const { model } = run;
    this.run = run;
    this.frame = frame;
    this.clear();
    const hulls = model.bodies.map(({ name }) => shapedHull(model, name));
    this.bodies = model.bodies.map((body, i) => {
      const group = new Group();
      group.add(solidOf(body, this.palette, body.floats, hulls[i]));
      return group;
    });
    this.world.add(...this.bodies);
    const boxes = model.bodies.map((body, i) => boxOf(body, hulls[i]));
    this.boxes = boxes;
    const thickness = boxes.map((box) => Math.min(...edgesOf(box)));
    this.linkages = new Linkages(model, this.bodies, thickness, this.world, this.palette);
    this.lines = new DrawnLines(run.lines, this.world, this.palette);
    const size = Math.max(...boxes.map((box) => Math.hypot(...edgesOf(box))));
    const axes = this.framesShown ? FRAME_LENGTH * size : 0;
    this.eye.watch(boxes.map((box) => withFrame(box, 1.3 * axes)), frame.poses);
    if (axes > 0) this.addFrames(axes);
    this.ground.space(this.spacing());
    this.ground.visible = model.sea === null || model.hulls.length === 0;
    this.highlight(this.highlighted);
    this.place(frame);
    if (refit) this.eye.fit();
    this.stale = true;
  }

  /** The sea around; null where there is none to draw. */
  showSea(surface: Surface | null, isNew: boolean): void {
    if (isNew) this.sea.begin();
    this.surface = surface;
    this.sea.show(surface);
    this.stale = true;
  }

  show(frame: Pose): void {
    this.frame = frame;
    this.eye.follow(frame.poses);
    this.place(frame);
  }

  showFrames(shown: boolean): void {
    this.framesShown = shown;
    if (this.run) this.build(this.run, this.frame, !this.eye.isTaken);
  }

  /** Points out bodies and how they move, until something else is pointed out. */
  highlight(what: Highlight | null): void {
    this.highlighted = what;
    this.marks.show(what, this.bodies, this.boxes, this.eye.size(), this.palette);
    this.stale = true;
  }

  fit(): void {
    this.eye.fit();
  }

  /** Distance of the grid's lines, m. */
  spacing(): number {
    return gridSpacing(this.eye.size());
  }

  draw(): void {
    this.eye.update(performance.now());
    if (!this.stale) return;
    this.stale = false;
    this.renderer.render(this.scene, this.eye.camera);
  }

  private place({ poses, line_points }: Pose): void {
    this.bodies.forEach((body, i) => {
      const at = 7 * i;
      body.position.set(poses[at], poses[at + 1], poses[at + 2]);
      body.quaternion.set(poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 3]);
    });
    this.linkages?.place();
    this.marks.place(this.bodies);
    this.lines?.place(line_points);
    this.lightFrom(poses[0] ?? 0, poses[1] ?? 0, poses[2] ?? 0);
    this.stale = true;
  }

  /** The sun goes with the ship, so that the shadow stays sharp wherever it drifts. */
  private lightFrom(x: number, y: number, z: number): void {
    const size = this.eye.size();
    this.sun.target.position.set(x, y, z);
    this.sun.position.set(x - 0.7 * size, y - 0.9 * size, z + 2 * size);
    this.ground.reachFrom(x, y, size);
    const shadow = this.sun.shadow.camera;
    shadow.left = shadow.bottom = -1.1 * size;
    shadow.right = shadow.top = 1.1 * size;
    shadow.far = 6 * size;
    shadow.updateProjectionMatrix();
  }

  private addFrames(length: number): void {
    const height = this.canvas.clientHeight || 1;
    const scale = labelScale(Math.min(LABEL_PX, 0.14 * height), height, this.eye.fov);
    this.bodies.forEach((body, i) => body.add(triadOf(length, `(${i + 1})`, scale, this.palette)));
    this.world.add(triadOf(1.7 * length, "I", scale, this.palette, 0.6));
  }

  private light(): void {
    this.ground.paint(this.palette);
    this.sea.paint(this.palette);
    this.sea.show(this.surface);
    this.sun.intensity = this.palette.isDark ? 2.2 : 2.4;
    this.sky.intensity = this.palette.isDark ? 1.1 : 1.5;
    this.sky.color.set(0xffffff);
    this.sky.groundColor.set(this.palette.isDark ? 0x46566a : 0x9aa8b5);
    this.sky.position.set(0, 0, 1);
  }

  /** Makes everything that is drawn anew. */
  repaint(): void {
    this.palette = readPalette();
    this.light();
    if (this.run) this.build(this.run, this.frame, false);
    this.stale = true;
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement!;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.eye.resize(width, height);
    if (this.framesShown && this.run) this.build(this.run, this.frame, false);
    this.stale = true;
    this.draw();
  }

  private clear(): void {
    this.world.traverse(dispose);
    this.world.clear();
  }
}

/** What of the page stands on the picture, in its pixels. */
function coversOf(canvas: HTMLCanvasElement): Area[] {
  const picture = canvas.getBoundingClientRect();
  const parts = [...document.querySelectorAll(".floating, .scene-tools, .scene-note, .frames-legend, .readouts")];
  return parts
    .map((part) => part.getBoundingClientRect())
    .map(({ left, top, right, bottom }) => ({ left: left - picture.left, top: top - picture.top, right: right - picture.left, bottom: bottom - picture.top }))
    .filter(({ left, top, right, bottom }) => right > left && left < picture.width && right > 0 && top < picture.height && bottom > 0);
}

function shapedHull(model: ModelInfo, body: string): ShapedHull | undefined {
  return model.hulls.find((hull): hull is ShapedHull => hull.body === body && hull.mesh !== null);
}

function dispose(object: Object3D): void {
  if (object instanceof Sprite) object.material.map?.dispose();
  if (object instanceof Mesh || object instanceof Sprite) {
    object.geometry.dispose();
    (object.material as Material).dispose();
  }
}
