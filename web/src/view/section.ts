import { BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, Group, Mesh, MeshBasicMaterial, Plane, Vector3 } from "three";
import type { Object3D } from "three";
import type { Box } from "./fit";
import type { Palette } from "./palette";

/** Number of points at which the height of the water is drawn along the cut. */
const PLACES = 65;
/** Thickness of the water line, relative to the length of the hull. */
const LINE = 0.0022;

/** A cut along the centre line of a hull: the clipping plane, and the water in it. */
export class Section extends Group {
  /** Clipping plane; the port side remains visible. */
  readonly plane = new Plane();
  private readonly line = strip(1);
  private readonly water = strip(0.3);

  constructor() {
    super();
    this.visible = false;
    this.add(this.water, this.line);
  }

  paint({ foam, shallow }: Palette): void {
    this.line.material.color.copy(foam);
    this.water.material.color.copy(shallow);
  }

  /** Moves the cut to the present pose of the hull. */
  place(hull: Pick<Object3D, "position" | "quaternion">, box: Box, heightAt: (x: number, y: number) => number | null): void {
    const turned = (x: number, y: number, z: number) => new Vector3(x, y, z).applyQuaternion(hull.quaternion);
    const [forward, port] = [turned(1, 0, 0).setZ(0).normalize(), turned(0, 1, 0)];
    this.plane.setFromNormalAndCoplanarPoint(port, hull.position);
    const length = box.high[0] - box.low[0];
    const depth = hull.position.z + box.low[2] - 0.6 * (box.high[2] - box.low[2]);
    for (let i = 0; i < PLACES; i++) {
      const at = hull.position.clone().addScaledVector(forward, (6 * i) / (PLACES - 1) * length - 3 * length);
      const height = heightAt(at.x, at.y) ?? 0;
      lay(this.line, i, at, height - LINE * length, height + LINE * length);
      lay(this.water, i, at, Math.min(depth, height), height);
    }
    for (const { geometry } of [this.line, this.water]) geometry.attributes.position.needsUpdate = true;
  }
}

type Strip = Mesh<BufferGeometry, MeshBasicMaterial>;

function strip(opacity: number): Strip {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(6 * PLACES), 3).setUsage(DynamicDrawUsage));
  const indices: number[] = [];
  for (let i = 0; i + 1 < PLACES; i++) indices.push(2 * i, 2 * i + 2, 2 * i + 1, 2 * i + 1, 2 * i + 2, 2 * i + 3);
  geometry.setIndex(indices);
  const mesh = new Mesh(geometry, new MeshBasicMaterial({ side: DoubleSide, transparent: true, opacity, depthWrite: false }));
  mesh.frustumCulled = false;
  mesh.renderOrder = 3;
  return mesh;
}

function lay({ geometry }: Strip, i: number, { x, y }: Vector3, low: number, high: number): void {
  const position = geometry.attributes.position;
  position.setXYZ(2 * i, x, y, low);
  position.setXYZ(2 * i + 1, x, y, high);
}
