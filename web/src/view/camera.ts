import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { cornersOf, fitDistance, frame, unit } from "./fit";
import type { Vec3 } from "./fit";

/** From the starboard quarter and above: the crane near, the bow away. */
const FIRST_VIEW: Vec3 = [-0.62, -1, 0.62];
const UP: Vec3 = [0, 0, 1];
/** Room around what is fitted. */
const MARGIN = 1.2;
const KEY_TURN = Math.PI / 36;
const KEY_ZOOM = 0.9;

/** The eye: orbits the ship by mouse, touch and keys, and keeps it in the picture until taken over. */
export class Eye {
  readonly camera = new PerspectiveCamera(32, 1, 0.5, 3000);
  private readonly orbit: OrbitControls;
  private readonly isCalm = matchMedia("(prefers-reduced-motion: reduce)");
  private halves: Vec3[] = [];
  private poses: ArrayLike<number> = [];
  private root: Vec3 = [0, 0, 0];
  private isTaken = false;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly moved: () => void,
  ) {
    this.camera.up.set(...UP);
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.enableDamping = !this.isCalm.matches;
    this.orbit.dampingFactor = 0.12;
    this.orbit.maxPolarAngle = 0.94 * Math.PI;
    this.orbit.addEventListener("change", moved);
    this.orbit.addEventListener("start", () => (this.isTaken = true));
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  /** What to keep in the picture. */
  watch(halves: Vec3[], poses: ArrayLike<number>): void {
    this.halves = halves;
    this.poses = poses;
    this.root = rootOf(poses);
    this.orbit.minDistance = 0.2 * this.size();
    this.orbit.maxDistance = 40 * this.size();
  }

  /** Follows the ship's centre, and steps back where something leaves the picture. */
  follow(poses: ArrayLike<number>): void {
    this.poses = poses;
    const root = rootOf(poses);
    const shift = new Vector3(root[0] - this.root[0], root[1] - this.root[1], root[2] - this.root[2]);
    this.root = root;
    this.camera.position.add(shift);
    this.orbit.target.add(shift);
    if (!this.isTaken) this.stepBack(this.isCalm.matches ? 1 : 0.12);
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (!this.isTaken) this.fit();
  }

  fit(): void {
    this.isTaken = false;
    const points = cornersOf(this.poses, this.halves);
    if (points.length === 0) return;
    this.stopSwinging();
    const back = unit(FIRST_VIEW);
    const { target, distance } = frame(points, back, UP, this.lens());
    this.orbit.target.set(...target);
    this.camera.position.set(...target).addScaledVector(new Vector3(...back), MARGIN * distance);
    this.orbit.update();
    this.moved();
  }

  update(): void {
    this.orbit.update();
  }

  get target(): Vector3 {
    return this.orbit.target;
  }

  /** Vertical field of view, rad. */
  get fov(): number {
    return (this.camera.fov * Math.PI) / 180;
  }

  /** The longest diagonal of a body, m. */
  size(): number {
    return Math.max(1, ...this.halves.map((half) => 2 * Math.hypot(...half)));
  }

  private lens() {
    return { fov: this.fov, aspect: this.camera.aspect };
  }

  /** Without damping an update drops what is left of a drag. */
  private stopSwinging(): void {
    const { enableDamping } = this.orbit;
    this.orbit.enableDamping = false;
    this.orbit.update();
    this.orbit.enableDamping = enableDamping;
  }

  private stepBack(share: number): void {
    const offset = this.camera.position.clone().sub(this.orbit.target);
    const back = unit([offset.x, offset.y, offset.z]);
    const target: Vec3 = [this.orbit.target.x, this.orbit.target.y, this.orbit.target.z];
    const needed = 1.04 * fitDistance(cornersOf(this.poses, this.halves), target, back, UP, this.lens());
    const missing = needed - offset.length();
    if (missing > 0 && Number.isFinite(missing)) offset.setLength(offset.length() + share * missing);
    this.camera.position.copy(this.orbit.target).add(offset);
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
    else if (event.key === "Home") this.fit();
    else return;
    event.preventDefault();
  }

  private turn(around: number, down: number): void {
    this.isTaken = true;
    const offset = this.camera.position.clone().sub(this.orbit.target);
    const distance = offset.length();
    const azimuth = Math.atan2(offset.y, offset.x) + around;
    const polar = Math.min(0.94 * Math.PI, Math.max(0.02, Math.acos(offset.z / distance) + down));
    offset.set(Math.sin(polar) * Math.cos(azimuth), Math.sin(polar) * Math.sin(azimuth), Math.cos(polar));
    this.camera.position.copy(this.orbit.target).addScaledVector(offset, distance);
    this.orbit.update();
    this.moved();
  }

  private zoom(factor: number): void {
    this.isTaken = true;
    const offset = this.camera.position.clone().sub(this.orbit.target).multiplyScalar(factor);
    this.camera.position.copy(this.orbit.target).add(offset);
    this.orbit.update();
    this.moved();
  }
}

function rootOf(poses: ArrayLike<number>): Vec3 {
  return [poses[0] ?? 0, poses[1] ?? 0, poses[2] ?? 0];
}
