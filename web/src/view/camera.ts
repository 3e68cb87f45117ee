import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Post } from "./craft/craft";
import { backOf, fitDistance, frame, gatheredCorners, reachOf, roomIn, unit, vec3 } from "./fit";
import type { Area, Box, Vec3 } from "./fit";
import { Outlook } from "./outlook";
import type { Place } from "./viewpoint";

/**
 * Default direction from the target to the eye: from the starboard quarter and above, with the crane near and the bow
 * away.
 */
const FIRST_VIEW: Vec3 = [-0.62, -1, 0.62];
const UP: Vec3 = [0, 0, 1];
const FIELD_DEG = 32;
/** Largest polar angle of the eye around its target, from the vertical, rad. */
const LOWEST = 0.94 * Math.PI;
/** Distance to a followed body: `own` in sizes of the body, but at least `model` in sizes of the model. */
const FOLLOWED = { own: 9, model: 0.25 };
/** Smallest height of the eye above the water, relative to the size of the model. */
const ABOVE_WATER = 0.012;
/** Ratio of the eye's distance after a fit to the distance at which the objects just fill the picture. */
const MARGIN = 1.16;
/** Ratio of the eye's distance to the distance that just fills the picture, below which the camera steps back. */
const EDGE = 1.06;
/** Time constant with which the camera steps back, ms. */
const STEP_BACK_MS = 180;
/** Ratio of width to height of the picture for which places are given, in which the whole field of view is free. */
const GIVEN_ASPECT = 1.6;
const KEY_TURN = Math.PI / 36;
const KEY_ZOOM = 0.9;

/** Camera that orbits the ship by mouse, touch and keys, and keeps her in the picture until the user moves it. */
export class Eye {
  readonly camera = new PerspectiveCamera(FIELD_DEG, 1, 0.5, 3000);
  private readonly orbit: OrbitControls;
  private readonly isCalm = matchMedia("(prefers-reduced-motion: reduce)");
  private boxes: Box[] = [];
  private poses: ArrayLike<number> = [];
  private root: Vec3 = [0, 0, 0];
  /** Distance of the farthest corner from the first body at the start of the run, m. */
  private reach = 0;
  /** Index of the body that the camera follows. */
  private followed = 0;
  /** Direction from the target to the eye for a fit. */
  private back = FIRST_VIEW;
  private readonly outlook: Outlook;
  private last_ms = 0;
  private width = 1;
  private height = 1;
  /** Part of the picture that no controls cover. */
  private room: Area = { left: 0, top: 0, right: 1, bottom: 1 };
  /** Place that is given for any picture, until the user turns or zooms the view. */
  private given: Place | null = null;
  /** Whether the user has turned or zoomed the view, which then stays until the next fit. */
  isTaken = false;
  /** Place of the eye in a picture of a fixed size; null on the page. */
  private held: Place | null = null;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly moved: () => void,
    /** Returns the areas of the controls that cover the picture. */
    private readonly covers: () => Area[],
    /** Returns to the first view. */
    private readonly home: () => void,
  ) {
    this.camera.up.set(...UP);
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.enableDamping = !this.isCalm.matches;
    this.orbit.dampingFactor = 0.12;
    this.orbit.maxPolarAngle = LOWEST;
    this.orbit.addEventListener("change", moved);
    this.orbit.addEventListener("start", () => this.take());
    this.outlook = new Outlook(this.camera, canvas, moved);
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  /** Sets the bodies to keep in the picture; `start` holds their poses at the start of the run. */
  watch(boxes: Box[], poses: ArrayLike<number>, start: ArrayLike<number>): void {
    this.boxes = boxes;
    this.reach = reachOf(start, boxes);
    this.poses = poses;
    this.root = this.rootOf(poses);
    this.orbit.minDistance = 0.2 * this.size();
    this.orbit.maxDistance = 40 * this.size();
    this.useLens();
  }

  private useLens(): void {
    if (this.outlook.isTaken) return;
    this.camera.fov = FIELD_DEG;
    this.camera.near = Math.min(0.5, 0.05 * this.size());
    this.camera.updateProjectionMatrix();
  }

  /** Shows everything from one side; the user can turn the view from there. */
  lookFrom(back: Vec3 = FIRST_VIEW): void {
    this.leavePost();
    this.followed = 0;
    this.back = back;
    this.root = this.rootOf(this.poses);
    this.fit();
  }

  /** Moves the camera near a body and follows the body. */
  goAlong(body: number): void {
    this.leavePost();
    this.followed = body;
    this.root = this.rootOf(this.poses);
    this.makeRoom([]);
    const { low, high } = this.boxes[body];
    const own = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    const distance = Math.max(FOLLOWED.own * own, FOLLOWED.model * this.size());
    this.isTaken = true;
    this.orbit.target.set(...this.root);
    this.camera.position.set(...this.root).addScaledVector(new Vector3(...unit(FIRST_VIEW)), distance);
    this.orbit.update();
    this.moved();
  }

  /** Shows the view of a person on a body; `target` is the body to look at. */
  standAt(post: Post, target: number | null): void {
    this.take();
    this.orbit.enabled = false;
    this.outlook.take(post, target);
    this.moved();
  }

  private leavePost(): void {
    this.given = null;
    this.outlook.leave();
    this.orbit.enabled = true;
    this.useLens();
  }

  /** Keeps the eye above the water. `water_m` is null if the eye may go under water, or if there is no water. */
  stayAbove(water_m: ((x: number, y: number) => number | null) | null): void {
    const { position } = this.camera;
    const water = this.outlook.isTaken ? null : (water_m?.(position.x, position.y) ?? null);
    this.orbit.maxPolarAngle = LOWEST;
    if (water === null) return;
    const least = water + ABOVE_WATER * this.size();
    const distance = position.distanceTo(this.orbit.target);
    this.orbit.maxPolarAngle = Math.min(LOWEST, Math.acos(Math.min(1, Math.max(-1, (least - this.orbit.target.z) / distance))));
    if (position.z >= least) return;
    position.z = least;
    this.camera.lookAt(this.orbit.target);
  }

  /** Moves the camera with the followed body. */
  follow(poses: ArrayLike<number>): void {
    this.poses = poses;
    const root = this.rootOf(poses);
    const shift = new Vector3(root[0] - this.root[0], root[1] - this.root[1], root[2] - this.root[2]);
    this.root = root;
    this.camera.position.add(shift);
    this.orbit.target.add(shift);
  }

  /**
   * Prepares pictures of a fixed size: a view that the user has taken stays, any other one fits the ship as she is at
   * `start`. Pictures then depend on their own moment alone.
   */
  hold(width: number, height: number, start: ArrayLike<number>): void {
    this.stopSwinging();
    this.orbit.enableDamping = false;
    this.orbit.maxPolarAngle = LOWEST;
    if (!this.isTaken) this.follow(start);
    this.resize(width, height);
    this.held = this.place;
  }

  /** Shows the held view of a moment. */
  stand(poses: ArrayLike<number>): void {
    this.poses = poses;
    this.root = this.rootOf(poses);
    if (this.outlook.isTaken) return this.outlook.place(poses);
    this.orbit.maxPolarAngle = LOWEST;
    this.put(this.held!);
    if (!this.isTaken) this.stepBack(1);
    this.orbit.update();
  }

  /** Returns to the page, with the view that was held. */
  letGo(): void {
    if (this.held && !this.outlook.isTaken) this.put(this.held);
    this.held = null;
    this.orbit.enableDamping = !this.isCalm.matches;
  }

  private put({ eye, target }: Place): void {
    const root = new Vector3(...this.root);
    this.orbit.target.set(...target).add(root);
    this.camera.position.set(...eye).add(root);
  }

  resize(width: number, height: number): void {
    [this.width, this.height] = [width, height];
    this.camera.aspect = width / height;
    if (this.outlook.isTaken) this.camera.updateProjectionMatrix();
    else if (this.given) this.give(this.given);
    else if (this.isTaken) this.makeRoom(this.corners());
    else this.fit();
  }

  /** Centres the target in the part of the picture that no controls cover and in which the target appears largest. */
  private makeRoom(points: readonly Vec3[]): void {
    const { width, height } = this;
    const nearness = (area: Area) => 1 / frame(points, unit(this.back), UP, this.lensOf(area)).distance;
    this.room = roomIn(width, height, this.covers(), points.length > 0 ? nearness : undefined);
    const { left, top, right, bottom } = this.room;
    this.camera.setViewOffset(width, height, (width - left - right) / 2, (height - top - bottom) / 2, width, height);
  }

  fit(): void {
    if (this.outlook.isTaken) return;
    this.isTaken = false;
    const points = this.corners();
    this.makeRoom(points);
    if (points.length === 0) return;
    this.stopSwinging();
    const back = unit(this.back);
    const { target, distance } = frame(points, back, UP, this.lens());
    this.orbit.target.set(...target);
    this.camera.position.set(...target).addScaledVector(new Vector3(...back), MARGIN * distance);
    this.orbit.update();
    this.moved();
  }

  /** Updates the camera once per frame: continues a drag, and steps back while an object is outside the picture. */
  update(now_ms: number): void {
    const passed_ms = Math.min(now_ms - this.last_ms, 250);
    this.last_ms = now_ms;
    if (this.outlook.isTaken) return this.outlook.place(this.poses);
    if (!this.isTaken && this.boxes.length > 0) this.stepBack(this.isCalm.matches ? 1 : 1 - Math.exp(-passed_ms / STEP_BACK_MS));
    this.orbit.update();
  }

  get target(): Vector3 {
    return this.orbit.target;
  }

  /** Positions of the eye and its target relative to the body that the camera follows. */
  get place(): Place {
    const from = ({ x, y, z }: Vector3): Vec3 => [x - this.root[0], y - this.root[1], z - this.root[2]];
    return { eye: from(this.camera.position), target: from(this.orbit.target) };
  }

  set place({ eye, target }: Place) {
    this.isTaken = true;
    this.stopSwinging();
    this.put({ eye, target });
    this.orbit.update();
    this.moved();
  }

  /** Shows the view from a place that is given for any picture: in a small or narrow one the eye steps back. */
  give(place: Place): void {
    this.makeRoom([]);
    const { eye, target } = place;
    const factor = backOf(this.lens(), { fov: this.fov, aspect: GIVEN_ASPECT });
    this.place = { target, eye: vec3((k) => target[k] + factor * (eye[k] - target[k])) };
    this.given = place;
  }

  /** Leaves the view to the user. */
  private take(): void {
    this.isTaken = true;
    this.given = null;
  }

  /** Vertical field of view, rad. */
  get fov(): number {
    return (this.camera.fov * Math.PI) / 180;
  }

  /** Returns the longest diagonal of a body, m. */
  size(): number {
    return Math.max(0.1, ...this.boxes.map(({ low, high }) => Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2])));
  }

  /** Returns the corners of the bodies to keep in the picture. */
  private corners(): Vec3[] {
    return gatheredCorners(this.poses, this.boxes, this.reach);
  }

  private lens() {
    return this.lensOf(this.room);
  }

  /** Returns the field of view of a part of the picture. */
  private lensOf({ left, top, right, bottom }: Area) {
    const share = (bottom - top) / this.height;
    return { fov: 2 * Math.atan(share * Math.tan(this.fov / 2)), aspect: (right - left) / (bottom - top) };
  }

  /** Stops the motion that continues after a drag: an update without damping drops the rest of it. */
  private stopSwinging(): void {
    const { enableDamping } = this.orbit;
    this.orbit.enableDamping = false;
    this.orbit.update();
    this.orbit.enableDamping = enableDamping;
  }

  /** Moves the camera by a share of the way to a view that contains everything; never moves it nearer. */
  private stepBack(share: number): void {
    const points = this.corners();
    const offset = this.camera.position.clone().sub(this.orbit.target);
    const distance = offset.length();
    const back = unit([offset.x, offset.y, offset.z]);
    const target: Vec3 = [this.orbit.target.x, this.orbit.target.y, this.orbit.target.z];
    if (!(EDGE * fitDistance(points, target, back, UP, this.lens()) > 1.001 * distance)) return;
    const goal = frame(points, back, UP, this.lens());
    this.orbit.target.lerp(new Vector3(...goal.target), share);
    offset.setLength(distance + share * Math.max(0, EDGE * goal.distance - distance));
    this.camera.position.copy(this.orbit.target).add(offset);
  }

  private rootOf(poses: ArrayLike<number>): Vec3 {
    const at = 7 * this.followed;
    return [poses[at] ?? 0, poses[at + 1] ?? 0, poses[at + 2] ?? 0];
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turns: Record<string, [number, number]> = {
      ArrowLeft: [-KEY_TURN, 0],
      ArrowRight: [KEY_TURN, 0],
      ArrowUp: [0, -KEY_TURN],
      ArrowDown: [0, KEY_TURN],
    };
    if (event.key in turns) this.turn(...turns[event.key]);
    else if (event.key === "+" || event.key === "=") this.zoom(KEY_ZOOM);
    else if (event.key === "-") this.zoom(1 / KEY_ZOOM);
    else if (event.key === "Home") this.home();
    else return;
    event.preventDefault();
  }

  private turn(around: number, down: number): void {
    if (this.outlook.isTaken) return this.outlook.turn(around, down);
    this.take();
    const offset = this.camera.position.clone().sub(this.orbit.target);
    const distance = offset.length();
    const azimuth = Math.atan2(offset.y, offset.x) + around;
    const polar = Math.min(this.orbit.maxPolarAngle, Math.max(0.02, Math.acos(offset.z / distance) + down));
    offset.set(Math.sin(polar) * Math.cos(azimuth), Math.sin(polar) * Math.sin(azimuth), Math.cos(polar));
    this.camera.position.copy(this.orbit.target).addScaledVector(offset, distance);
    this.orbit.update();
    this.moved();
  }

  private zoom(factor: number): void {
    if (this.outlook.isTaken) return;
    this.take();
    const offset = this.camera.position.clone().sub(this.orbit.target).multiplyScalar(factor);
    this.camera.position.copy(this.orbit.target).add(offset);
    this.orbit.update();
    this.moved();
  }
}

