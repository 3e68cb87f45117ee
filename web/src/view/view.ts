import { ACESFilmicToneMapping, FogExp2, Group, Mesh, PCFShadowMap, Scene, Sprite, WebGLRenderer } from "three";
import type { Color, Material, Object3D } from "three";
import { onPalette } from "../app/palette";
import type { Run } from "../app/session";
import type { Frame } from "../engine/messages";
import type { Surface } from "../engine/surface";
import { airOf } from "./air";
import { Eye } from "./camera";
import { craftOf } from "./craft/craft";
import { Daylight } from "./daylight";
import type { Highlight } from "../equations/highlight";
import type { Area, Box } from "./fit";
import { Ground } from "./ground";
import { Marks } from "./highlight";
import { Linkages } from "./linkages";
import { DrawnLines } from "./lines";
import { readPalette } from "./palette";
import type { Palette } from "./palette";
import { Drawing } from "./quality";
import { Sea } from "./sea";
import { boxOf, edgesOf, shapedHullOf, solidOf, withFrame } from "./solids";
import { gridSpacing } from "./spacing";
import { labelScale, triadOf } from "./triad";

/** Height of a label of a body frame, pixels, at most. */
const LABEL_PX = 58;

/** Length of a body frame, as a part of the longest diagonal of a body. */
const FRAME_LENGTH = 0.14;

/** How dense the water is to look through, over the longest diagonal of a body. */
const FOG = 0.22;

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
  private readonly air = airOf();
  private readonly sea = new Sea(this.air);
  private readonly daylight: Daylight;
  private readonly drawing: Drawing;
  private readonly world = new Group();
  private bodies: Group[] = [];
  private linkages: Linkages | null = null;
  private palette: Palette = readPalette();
  private lines: DrawnLines | null = null;
  private run: Shown | null = null;
  /** How everything stood when the run began: what is on what is taken from it. */
  private start: Pose = { poses: [], line_points: [] };
  /** Whether the model's own solids are drawn. */
  private plain = false;
  private frame: Pose = { poses: [], line_points: [] };
  private boxes: Box[] = [];
  private readonly marks = new Marks();
  private highlighted: Highlight | null = null;
  private framesShown = false;
  private stale = true;

  /** Throws where the browser has no WebGL. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.toneMapping = ACESFilmicToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.autoUpdate = false;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.eye = new Eye(canvas, () => (this.stale = true), () => coversOf(canvas));
    this.daylight = new Daylight(this.renderer, this.air);
    this.drawing = Drawing.of(this.renderer);
    this.scene.add(this.ground, this.sea, this.daylight, this.world, this.marks.group);
    this.light();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement!);
    onPalette(() => this.repaint());
  }

  /** Builds the bodies; `refit` when it is another model and not the same one reset. */
  build(run: Shown, frame: Pose, refit: boolean): void {
    const { model } = run;
    if (run !== this.run) this.start = frame;
    this.run = run;
    this.frame = frame;
    this.clear();
    const hulls = model.bodies.map(({ name }) => shapedHullOf(model, name));
    const craft = this.plain ? null : craftOf(run, this.start, this.palette);
    this.bodies = model.bodies.map((body, i) => new Group().add(craft ? craft.works[i].object() : solidOf(body, this.palette, body.floats, hulls[i])));
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
    if (this.daylight.surround(!this.ground.visible)) this.detail();
    this.highlight(this.highlighted);
    this.place(frame);
    if (refit) this.eye.fit();
    this.stale = true;
  }

  /** The sea around; null where there is none to draw. */
  showSea(surface: Surface | null): void {
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
    if (!this.stale) return this.drawing.rest();
    this.stale = false;
    this.lookFrom(this.eye.camera.position);
    this.renderer.render(this.scene, this.eye.camera);
    if (this.drawing.drew(performance.now())) this.detail();
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
    const [x, y, z] = [poses[0] ?? 0, poses[1] ?? 0, poses[2] ?? 0];
    this.daylight.follow(x, y, z, this.eye.size());
    this.ground.reachFrom(x, y, this.eye.size());
    this.renderer.shadowMap.needsUpdate = true;
    this.stale = true;
  }

  /** Under water everything that is far takes the water's colour. */
  private lookFrom({ x, y, z }: { x: number; y: number; z: number }): void {
    const water_m = this.sea.heightAt(x, y);
    const isUnder = water_m !== null && z < water_m;
    if (this.air.underWater.value === isUnder) return;
    this.air.underWater.value = isUnder;
    this.scene.fog = isUnder ? new FogExp2(fogColour(this.palette), FOG / this.eye.size()) : null;
  }

  private addFrames(length: number): void {
    const height = this.canvas.clientHeight || 1;
    const scale = labelScale(Math.min(LABEL_PX, 0.14 * height), height, this.eye.fov);
    this.bodies.forEach((body, i) => body.add(triadOf(length, `(${i + 1})`, scale, this.palette)));
    this.world.add(triadOf(1.7 * length, "I", scale, this.palette, 0.6));
  }

  private light(): void {
    this.ground.paint(this.palette);
    this.daylight.paint(this.palette);
    this.scene.fog?.color.copy(fogColour(this.palette));
    this.detail();
  }

  /** Draws in the detail that the machine keeps up with. */
  private detail(): void {
    const { tier } = this.drawing;
    this.sea.detail(tier.ripples);
    this.scene.environment = this.daylight.detail(tier);
    this.scene.environmentIntensity = this.daylight.skyLight;
    this.renderer.setPixelRatio(this.pixelRatio());
    this.renderer.shadowMap.needsUpdate = true;
    this.stale = true;
  }

  /** Makes everything that is drawn anew. */
  repaint(): void {
    this.palette = readPalette();
    this.light();
    if (this.run) this.build(this.run, this.frame, false);
    this.stale = true;
  }

  private pixelRatio(): number {
    return Math.min(this.drawing.tier.pixelRatio, devicePixelRatio);
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement!;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(this.pixelRatio());
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

/** As the depths are painted at the height of the eye. */
function fogColour({ deep, shallow }: Palette): Color {
  return deep.clone().lerp(shallow, 0.4);
}

function dispose(object: Object3D): void {
  if (object instanceof Sprite) object.material.map?.dispose();
  if (object instanceof Mesh || object instanceof Sprite) {
    object.geometry.dispose();
    (object.material as Material).dispose();
  }
}
