import { ACESFilmicToneMapping, FogExp2, PCFShadowMap, Scene, Vector3, WebGLRenderer } from "three";
import type { Color } from "three";
import { onPalette } from "../app/palette";
import type { Moment } from "../app/recording/recording";
import type { Run } from "../app/session";
import { inTheSea, shipsInTheSea } from "../engine/surface";
import type { Surface } from "../engine/surface";
import { airOf } from "./air";
import { Cloud } from "./cloud";
import type { Swarm } from "./cloud";
import { Eye } from "./camera";
import { coversOf } from "./covers";
import { Daylight } from "./daylight";
import type { Highlight } from "../equations/highlight";
import type { Vec3 } from "./fit";
import { Fleet } from "./fleet";
import type { Pose, Shown } from "./fleet";
import { Ground } from "./ground";
import { Marks } from "./highlight";
import { Overlays } from "./overlays/overlays";
import type { OtherRun } from "./overlays/overlays";
import { readPalette } from "./palette";
import type { Palette } from "./palette";
import { Drawing } from "./quality";
import { Sea } from "./sea";
import { largestOf, TooLargeError } from "./size";
import type { Size } from "./size";
import { Seabed } from "./seabed";
import type { LevelSeabed } from "./seabed";
import { Section } from "./section";
import { reachesDown, sightOf } from "./sight";
import { withFrame } from "./solids";
import { gridSpacing } from "./spacing";
import type { Reading } from "./tanks";
import type { Tints } from "./tension";
import { Target } from "./target";
import { labelScale, triadOf } from "./triad";
import { CAMERAS, textOfPlace, viewpointOf } from "./viewpoint";
import type { CameraName, Place } from "./viewpoint";

export type { CameraName };

/** Largest height of a label of a body frame, pixels. */
const LABEL_PX = 58;

/** Length of a body frame, relative to the longest diagonal of a body. */
const FRAME_LENGTH = 0.14;

/** Density of the fog under water, times the longest diagonal of a body or a share of the distance to the target. */
const FOG = 0.22;
const SEEN = 0.6;

/** Radius of the seabed that is drawn at the depth of the sea, in depths or sizes of the model, whichever is more. */
const SEABED = 3;

/** Directions of the views; the view from above is slightly tilted to starboard, so that the bow is to the right. */
const FROM: Partial<Record<CameraName, Vec3>> = { top: [0, -0.002, 1], section: [0, -1, 0.1] };

/** The 3D picture: world z up, the object of each body at the pose that the engine gives. It is drawn on demand. */
export class View {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly eye: Eye;
  private readonly ground = new Ground();
  private readonly air = airOf();
  private readonly sea = new Sea(this.air);
  private readonly daylight: Daylight;
  private readonly drawing: Drawing;
  private readonly fleet = new Fleet();
  private readonly section = new Section();
  private readonly seabed = new Seabed();
  private readonly target = new Target();
  readonly overlays = new Overlays(this.fleet);
  private palette: Palette = readPalette();
  private run: Shown | null = null;
  /** Poses at the start of the run. */
  private start: Pose = { poses: [], line_points: [] };
  private frame: Pose = { poses: [], line_points: [] };
  private tints: readonly Tints[] = [];
  private isPlain = false;
  mayDive = false;
  /** Whether a ship floats in the sea: the eye stays above the water unless the user lets it dive. */
  private isAfloat = false;
  camera: CameraName = "free";
  private tell: (camera: CameraName) => void = () => {};
  private readonly marks = new Marks();
  private readonly cloud = new Cloud();
  private highlighted: Highlight | null = null;
  private framesShown = false;
  private stale = true;
  /** Size of the pictures that are saved, pixels; null on the page. */
  private held: Size | null = null;

  /** Throws if the browser has no WebGL. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.toneMapping = ACESFilmicToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.autoUpdate = false;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.localClippingEnabled = true;
    this.eye = new Eye(canvas, () => (this.stale = true), () => (this.held ? [] : coversOf(canvas)), () => this.fit());
    this.daylight = new Daylight(this.renderer, this.air);
    this.drawing = Drawing.of(this.renderer);
    this.scene.add(this.ground, this.sea, this.daylight, this.fleet.world, this.seabed, this.target, this.section, this.marks.group, this.overlays, this.cloud);
    this.light();
    const resized = new ResizeObserver(() => this.resize());
    // On a phone the panels are over the picture.
    for (const element of [canvas.parentElement!, ...document.querySelectorAll(".panel, .plots")]) resized.observe(element);
    onPalette(() => this.repaint());
  }

  /** Builds the bodies; `refit` is true for another model, and false for a reset. */
  build(run: Shown, frame: Pose, refit: boolean): void {
    if (run !== this.run) this.start = frame;
    this.run = run;
    this.frame = frame;
    this.fleet.build(run, this.start, this.palette, this.isPlain);
    this.seabed.place(run.lines, frame.line_points, this.levelSeabed(run));
    this.target.build(run.model.task?.mark ?? null, this.palette);
    this.fleet.tint(this.tints);
    const axes = this.framesShown ? FRAME_LENGTH * this.fleet.size : 0;
    this.eye.watch(this.fleet.drawn.map((box) => withFrame(box, 1.3 * axes)), frame.poses, this.start.poses);
    if (axes > 0) this.addFrames(axes);
    this.ground.space(this.spacing());
    this.ground.visible = inTheSea(run.model).length === 0;
    this.isAfloat = shipsInTheSea(run.model).length > 0;
    this.clear();
    if (this.daylight.surround(!this.ground.visible)) this.detail();
    this.highlight(this.highlighted);
    this.place(frame);
    if (refit ? !this.lookBy(run.model.view.camera, true) : !this.cameras().includes(this.camera)) this.look("free");
    else if (this.camera === "section") this.cut(true);
    this.stale = true;
  }

  private levelSeabed({ model }: Shown): LevelSeabed | null {
    const [x, y] = this.frame.poses as number[];
    const depth_m = model.sea?.depth_m ?? null;
    return depth_m === null ? null : { x, y, depth_m, radius_m: SEABED * Math.max(depth_m, this.fleet.size) };
  }

  /** Shows the overlays of a moment. */
  showOverlays(run: Run, moment: Moment, path: () => readonly Vec3[]): void {
    this.overlays.show(run, moment, this.start.poses, path, this.palette);
    this.stale = true;
  }

  /** Shows the bodies of another run; null for none. */
  showOther(run: OtherRun | null): void {
    this.overlays.showOther(run);
    this.stale = true;
  }

  /** The body that hangs on the crane; null if there is none. */
  get load(): number | null {
    return this.fleet.craft?.load ?? null;
  }

  /** Returns the number of pixels per metre at the centre of the view. */
  pixelsPerMetre(): number {
    const { camera, target, fov } = this.eye;
    return this.canvas.clientHeight / (2 * Math.tan(fov / 2) * camera.position.distanceTo(target));
  }

  /** Returns the viewpoints that this model offers. */
  cameras(): CameraName[] {
    const { craft } = this.fleet;
    const offered = { free: true, load: craft?.load != null, cab: craft?.cab != null, bridge: craft?.bridge != null, top: true, section: this.hull() >= 0 };
    return CAMERAS.filter((name) => offered[name]);
  }

  /** Changes the viewpoint. */
  look(from: CameraName): void {
    const { craft } = this.fleet;
    this.camera = from;
    this.tell(from);
    this.cut(from === "section");
    if (from === "load" && craft?.load != null) this.eye.goAlong(craft.load);
    else if (from === "cab" && craft?.cab) this.eye.standAt(craft.cab, craft.load);
    else if (from === "bridge" && craft?.bridge) this.eye.standAt(craft.bridge, null);
    else this.eye.lookFrom(FROM[from]);
    this.stale = true;
  }

  /**
   * Shows a viewpoint by its text, a name or a place; returns false if there is none that the model offers. From a place
   * that is `given` for any picture the eye steps back in a small or narrow one.
   */
  lookBy(text: string, isGiven = false): boolean {
    const asked = viewpointOf(text);
    if (asked === null || (typeof asked === "string" && !this.cameras().includes(asked))) return false;
    if (typeof asked === "string") this.look(asked);
    else this.lookAt(asked, isGiven);
    return true;
  }

  /** Shows the view from a place near the first body. */
  lookAt(place: Place, isGiven = false): void {
    this.look("free");
    if (isGiven) this.eye.give(place);
    else this.eye.place = place;
    this.stale = true;
  }

  /** Returns the viewpoint as a text: its name, or the place to which the user has moved the eye. */
  get viewpoint(): string {
    return this.camera === "free" && this.eye.isTaken ? textOfPlace(this.eye.place) : this.camera;
  }

  /** Calls a listener when the viewpoint changes. */
  onLook(tell: (camera: CameraName) => void): void {
    this.tell = tell;
  }

  /** Returns the index of the first body with a bow and a stern; -1 if there is none. */
  private hull(): number {
    return this.run?.model.bodies.findIndex(({ name, floats, shape }) => floats && (shape?.kind === "box" || this.run!.model.hulls.some(({ body }) => body === name))) ?? -1;
  }

  private cut(isCut: boolean): void {
    this.fleet.cut(this.hull(), isCut ? this.section.plane : null);
    this.showWater();
    this.place(this.frame);
  }

  /** Shows or hides the water: a section shows only its line. */
  private showWater(): void {
    const isCut = this.camera === "section";
    this.section.visible = isCut && this.sea.isShown;
    this.sea.visible = this.sea.isShown && !isCut;
  }

  /** Sets whether the eye may go under water. */
  dive(may: boolean): void {
    this.mayDive = may;
    this.stale = true;
  }

  /** Draws the model's own solids, or ships and cranes. */
  showPlain(isPlain: boolean): void {
    this.isPlain = isPlain;
    if (this.run) this.build(this.run, this.frame, false);
  }

  /** Shows the surface of the sea; null if there is none to draw. */
  showSea(surface: Surface | null): void {
    this.sea.show(surface);
    this.showWater();
    this.stale = true;
  }

  show(frame: Pose): void {
    this.frame = frame;
    this.eye.follow(frame.poses);
    this.place(frame);
  }

  /** Colours lines by the tension along them. */
  showTensions(tints: readonly Tints[]): void {
    this.tints = tints;
    this.fleet.tint(tints);
    this.clear();
    this.stale = true;
  }

  /** Shows the levels of the liquids in tanks. */
  showLevels(read: Reading): void {
    this.fleet.fill(read);
    this.stale = true;
  }

  /** Makes the sea clear if lines or tanks below its surface are to be seen. */
  private clear(): void {
    this.sea.showBelow(this.tints.length > 0 || this.fleet.hasGlass || reachesDown(this.start.line_points, this.fleet.size));
  }

  showFrames(shown: boolean): void {
    this.framesShown = shown;
    if (this.run) this.build(this.run, this.frame, !this.eye.isTaken);
  }

  /** Highlights bodies and their motion, until something else is highlighted. */
  highlight(what: Highlight | null): void {
    this.highlighted = what;
    this.marks.show(what, this.fleet.bodies, this.fleet.boxes, this.eye.size(), this.palette);
    this.stale = true;
  }

  /** Shows possible future positions; null for none. */
  showCloud(swarm: Swarm | null): void {
    this.cloud.show(swarm, this.eye.size(), this.palette);
    this.stale = true;
  }

  /** The direction in which the eye looks, in plan. */
  get ahead(): readonly [number, number] {
    const { x, y } = this.eye.camera.getWorldDirection(new Vector3());
    return [x, y];
  }

  fit(): void {
    this.look(this.camera);
  }

  /** Returns the spacing of the grid, m. */
  spacing(): number {
    return gridSpacing(this.eye.size());
  }

  /** Draws the picture if something has changed; returns whether it was drawn. */
  draw(): boolean {
    this.eye.update(performance.now());
    this.eye.stayAbove(this.waterUnderEye());
    if (!this.stale) {
      this.drawing.rest();
      return false;
    }
    this.stale = false;
    this.lookFrom(this.eye.camera.position);
    this.renderer.render(this.scene, this.eye.camera);
    if (this.drawing.drew(performance.now())) this.detail();
    return true;
  }

  /** Draws the picture at once, so that it can be copied before the browser clears it. */
  picture(): HTMLCanvasElement {
    this.stale = true;
    this.draw();
    return this.canvas;
  }

  /**
   * Prepares pictures of a fixed size and of the best level of detail, whatever the page, the clock and the machine, until
   * `letGo`. Throws a TooLargeError if the graphics card cannot draw the size.
   */
  hold(size: Size): void {
    const { canvas, eye, renderer } = this;
    const most = largestOf(renderer);
    this.held = size;
    this.drawing.isSaved = true;
    renderer.setPixelRatio(1);
    if (Math.max(size.width, size.height) <= most) renderer.setSize(size.width, size.height, false);
    const { drawingBufferWidth, drawingBufferHeight } = renderer.getContext();
    if (canvas.width !== size.width || drawingBufferWidth !== size.width || drawingBufferHeight !== size.height) {
      this.letGo();
      throw new TooLargeError(size, most);
    }
    eye.hold(size.width, size.height, this.start.poses);
    this.overlays.hold(true);
    this.detail();
    if (this.framesShown && this.run) this.build(this.run, this.frame, false);
  }

  /** Draws a moment in the held size; the pixels depend on the moment alone. Copy the picture at once. */
  still(frame: Pose, surface: Surface | null, time_s: number): HTMLCanvasElement {
    this.sea.drifted_s = time_s;
    this.showSea(surface);
    this.frame = frame;
    this.eye.stand(frame.poses);
    this.place(frame);
    this.eye.stayAbove(this.waterUnderEye());
    this.lookFrom(this.eye.camera.position);
    this.renderer.render(this.scene, this.eye.camera);
    return this.canvas;
  }

  /** Whether the browser has dropped the graphics context, which then draws nothing. */
  get isLost(): boolean {
    return this.renderer.getContext().isContextLost();
  }

  /** Returns to the size of the page. */
  letGo(): void {
    this.held = this.sea.drifted_s = null;
    this.drawing.isSaved = false;
    this.overlays.hold(false);
    this.eye.letGo();
    this.detail();
    this.resize();
  }

  /** Returns the height of the water for the eye, which must stay above it; null if it need not. */
  private waterUnderEye(): ((x: number, y: number) => number | null) | null {
    return this.mayDive || !this.isAfloat || !this.sea.visible ? null : (x, y) => this.sea.heightAt(x, y);
  }

  private place(frame: Pose): void {
    const { poses } = frame;
    this.fleet.place(frame);
    this.target.place(poses);
    this.marks.place(this.fleet.bodies);
    if (this.run) this.sea.look(sightOf(this.run.model, this.fleet.boxes, poses, this.load));
    const hull = this.hull();
    if (this.camera === "section" && hull >= 0) this.section.place(this.fleet.bodies[hull], this.fleet.boxes[hull], (x, y) => this.sea.heightAt(x, y));
    const [x, y, z] = [poses[0] ?? 0, poses[1] ?? 0, poses[2] ?? 0];
    this.daylight.follow(x, y, z, this.eye.size());
    this.ground.reachFrom(x, y, this.eye.size());
    this.renderer.shadowMap.needsUpdate = true;
    this.stale = true;
  }

  /** Sets the fog for a position of the eye: under water, distant objects fade to the colour of the water. */
  private lookFrom({ x, y, z }: { x: number; y: number; z: number }): void {
    const water_m = this.sea.heightAt(x, y);
    const isUnder = water_m !== null && z < water_m;
    this.air.underWater.value = isUnder;
    if (!isUnder) return void (this.scene.fog = null);
    const range_m = Math.max(this.eye.size(), SEEN * this.eye.camera.position.distanceTo(this.eye.target));
    if (!(this.scene.fog instanceof FogExp2)) this.scene.fog = new FogExp2(fogColour(this.palette));
    (this.scene.fog as FogExp2).density = FOG / range_m;
  }

  private addFrames(length: number): void {
    const height = (this.held?.height ?? this.canvas.clientHeight) || 1;
    const scale = labelScale(Math.min(LABEL_PX, 0.14 * height), height, this.eye.fov);
    this.fleet.bodies.forEach((body, i) => body.add(triadOf(length, `(${i + 1})`, scale, this.palette)));
    this.fleet.world.add(triadOf(1.7 * length, "I", scale, this.palette, 0.6));
  }

  private light(): void {
    this.ground.paint(this.palette);
    this.daylight.paint(this.palette);
    this.section.paint(this.palette);
    this.seabed.paint(this.palette);
    this.scene.fog?.color.copy(fogColour(this.palette));
    this.detail();
  }

  /** Applies the level of detail that the machine can draw. */
  private detail(): void {
    const { tier } = this.drawing;
    this.sea.detail(tier.ripples);
    this.scene.environment = this.daylight.detail(tier);
    this.scene.environmentIntensity = this.daylight.skyLight;
    this.renderer.setPixelRatio(this.pixelRatio());
    this.renderer.shadowMap.needsUpdate = true;
    this.stale = true;
  }

  /** Rebuilds all objects, for other colours. */
  repaint(): void {
    this.palette = readPalette();
    this.light();
    if (this.run) this.build(this.run, this.frame, false);
    this.stale = true;
  }

  private pixelRatio(): number {
    if (this.held) return 1;
    return Math.min(this.drawing.tier.pixelRatio, devicePixelRatio);
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement!;
    if (width === 0 || height === 0 || this.held) return;
    this.renderer.setPixelRatio(this.pixelRatio());
    this.renderer.setSize(width, height, false);
    this.eye.resize(width, height);
    if (this.framesShown && this.run) this.build(this.run, this.frame, false);
    this.stale = true;
    this.draw();
  }
}

/** Returns the colour of the water at the depth of the eye. */
function fogColour({ deep, shallow }: Palette): Color {
  return deep.clone().lerp(shallow, 0.4);
}
