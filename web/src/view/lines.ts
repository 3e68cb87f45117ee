import { CylinderGeometry, Group, InstancedMesh, Matrix4, Mesh, MeshStandardMaterial, Quaternion, SphereGeometry, Vector3 } from "three";
import type { BufferGeometry, Color, InterleavedBufferAttribute } from "three";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import type { DrawnLine } from "../engine/engine";
import type { Palette } from "./palette";
import type { Tints } from "./tension";

/** Width of a line that is too thin to be drawn to scale, pixels; it stays visible from a distance. */
const WIDTH_PX = 2.2;

/** Axis of cylinders in the library. */
const ALONG = new Vector3(0, 1, 0);

/** Radius and length of the collar at the end of a cylinder's barrel, relative to the radius of the barrel. */
const COLLAR = { radius: 1.22, length: 1.1 };

/** Width of a line that is coloured along it, pixels: its colours need some width to be told apart. */
const TINTED_WIDTH_PX = 3.2;

/** Colours from a slack line to the largest tension. */
type Ramp = Pick<Palette, "slack" | "taut" | "tautest">;

/** Places a line along its points: x y z of each. */
type Lay = (points: ArrayLike<number>, from: number) => void;

/**
 * Lines of the engine: ropes, tubes and pins, placed along their points. All tubes are one draw call, and all pins
 * another.
 */
export class DrawnLines {
  private readonly drawn: { lay: Lay; points: number; thread?: Line2 }[];
  private readonly tubes: Instances | null;
  private readonly pins: Instances | null;

  /** Adds the lines to the world. */
  constructor(lines: readonly DrawnLine[], world: Group, private readonly palette: Pick<Palette, DrawnLine["style"]> & Ramp) {
    const isTube = ({ points, radius_m }: DrawnLine) => points > 1 && radius_m > 0;
    const collars = lines.filter(({ style }) => style === "barrel").length;
    this.tubes = Instances.of(lines.filter(isTube).length + collars, new CylinderGeometry(1, 1, 1, 20).translate(0, 0.5, 0), world);
    this.pins = Instances.of(lines.filter(({ points }) => points === 1).length, new SphereGeometry(1, 16, 12), world);
    this.drawn = lines.map((line) => {
      const colour = palette[line.style];
      if (line.points === 1) return { lay: this.pins!.ball(line.radius_m, colour), points: 1 };
      if (!isTube(line)) {
        const thread = threadOf(line.points, colour, world);
        return { lay: layOf(thread, line.points), points: line.points, thread };
      }
      return { lay: this.tubes!.tube(line.radius_m, colour, line.style === "barrel"), points: line.points };
    });
  }

  /** Moves the lines to their present points, which follow line by line. */
  place(points: ArrayLike<number>): void {
    let from = 0;
    for (const line of this.drawn) {
      line.lay(points, from);
      from += 3 * line.points;
    }
    for (const instances of [this.tubes, this.pins]) instances?.changed();
  }

  /** Colours lines along their points. */
  tint(tints: readonly Tints[]): void {
    for (const { at, shares } of tints) {
      const { thread } = this.drawn[at];
      if (!thread) continue;
      const colours = Float32Array.from({ length: 3 * shares.length }, () => 0);
      shares.forEach((share, i) => tint(share, this.palette).toArray(colours, 3 * i));
      paint(thread, colours);
    }
  }
}

/** Returns the colour of a share of the largest tension. */
function tint(share: number, { slack, taut, tautest }: Ramp): Color {
  const [from, to] = share < 0.5 ? [slack, taut] : [taut, tautest];
  return from.clone().lerp(to, Math.min(1, share < 0.5 ? 2 * share : 2 * share - 1));
}

/** Solids of one shape with different sizes and colours, as one mesh. */
class Instances {
  private count = 0;

  private constructor(private readonly mesh: InstancedMesh) {}

  /** Returns a set for this number of solids; null if the number is 0. */
  static of(count: number, geometry: BufferGeometry, world: Group): Instances | null {
    if (count === 0) return null;
    const mesh = new InstancedMesh(geometry, new MeshStandardMaterial({ roughness: 0.35, metalness: 0.25 }), count);
    mesh.castShadow = mesh.receiveShadow = true;
    mesh.frustumCulled = false;
    world.add(mesh);
    return new Instances(mesh);
  }

  ball(radius_m: number, colour: Color): Lay {
    const at = this.next(colour);
    return (points, from) => this.put(at, point(points, from), new Quaternion(), new Vector3().setScalar(radius_m));
  }

  /**
   * Returns a function that places a tube from its first point to its second; a barrel has a collar at the end with the
   * rod.
   */
  tube(radius_m: number, colour: Color, isBarrel: boolean): Lay {
    const [at, collar] = [this.next(colour), isBarrel ? this.next(colour) : -1];
    return (points, from) => {
      const [start, end] = [point(points, from), point(points, from + 3)];
      const way = end.clone().sub(start);
      const length = Math.max(way.length(), Number.EPSILON);
      const turn = new Quaternion().setFromUnitVectors(ALONG, way.divideScalar(length));
      this.put(at, start, turn, new Vector3(radius_m, length, radius_m));
      if (collar < 0) return;
      const long = Math.min(COLLAR.length * radius_m, length);
      this.put(collar, end.addScaledVector(way, -long), turn, new Vector3(COLLAR.radius * radius_m, long, COLLAR.radius * radius_m));
    };
  }

  changed(): void {
    this.mesh.instanceMatrix.needsUpdate = true;
  }

  private next(colour: Color): number {
    this.mesh.setColorAt(this.count, colour);
    return this.count++;
  }

  private put(at: number, place: Vector3, turn: Quaternion, scale: Vector3): void {
    this.mesh.setMatrixAt(at, new Matrix4().compose(place, turn, scale));
  }
}

function threadOf(count: number, colour: Color, world: Group): Line2 {
  const geometry = new LineGeometry();
  geometry.setPositions(new Float32Array(3 * count));
  const object = new Line2(geometry, new LineMaterial({ color: colour, linewidth: WIDTH_PX }));
  object.frustumCulled = false;
  world.add(object);
  return object;
}

function layOf({ geometry }: Line2, count: number): Lay {
  const { data } = geometry.getAttribute("instanceStart") as InterleavedBufferAttribute;
  return (points, from) => {
    // Each part of a line stores both of its ends.
    for (let part = 0; part + 1 < count; part++) {
      for (let k = 0; k < 6; k++) data.array[6 * part + k] = points[from + 3 * part + k];
    }
    data.needsUpdate = true;
  };
}

/** Colours a line at its points: red, green and blue of each. */
function paint({ geometry, material }: Line2, colours: Float32Array): void {
  if (!geometry.hasAttribute("instanceColorStart")) {
    geometry.setColors(colours);
    material.vertexColors = true;
    material.color.set(0xffffff);
    material.linewidth = TINTED_WIDTH_PX;
    material.needsUpdate = true;
    return;
  }
  const { data } = geometry.getAttribute("instanceColorStart") as InterleavedBufferAttribute;
  for (let part = 0; 6 * part < data.array.length; part++) {
    for (let k = 0; k < 6; k++) data.array[6 * part + k] = colours[3 * part + k];
  }
  data.needsUpdate = true;
}

function point(points: ArrayLike<number>, from: number): Vector3 {
  return new Vector3(points[from], points[from + 1], points[from + 2]);
}

export function painted(geometry: SphereGeometry | CylinderGeometry, colour: Color): Mesh {
  const mesh = new Mesh(geometry, new MeshStandardMaterial({ color: colour, roughness: 0.35, metalness: 0.25 }));
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}
