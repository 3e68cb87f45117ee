import { CylinderGeometry, Group, Mesh, MeshStandardMaterial, SphereGeometry, Vector3 } from "three";
import type { Color, Object3D } from "three";
import type { CylinderInfo, ModelInfo, PointInfo } from "../engine/engine";
import type { Palette } from "./palette";

/** The barrel's length, its radius and the rod's, as parts of the length of a cylinder that is drawn in. */
const BARREL = { length: 0.88, radius: 0.036, rod: 0.6 };

/** Radius of a loop's pin, as a part of the thickness of the slimmer body that it ties. */
const PIN = 0.6;

/** Axis along which three's cylinders stand. */
const ALONG = new Vector3(0, 1, 0);

/** What ties bodies together beside their joints: closed loops' pins and rods, hydraulic cylinders. */
export class Linkages {
  private readonly lines: Line[] = [];
  private readonly names: string[];

  /** Hangs what is drawn on the bodies' objects and on the world; `thickness` is the bodies', m. */
  constructor(
    model: ModelInfo,
    private readonly bodies: readonly Group[],
    private readonly thickness: readonly number[],
    private readonly world: Group,
    private readonly palette: Palette,
  ) {
    this.names = model.bodies.map((body) => body.name);
    for (const loop of model.loops) {
      const radius = PIN * Math.min(this.thicknessAt(loop.first), this.thicknessAt(loop.second));
      const ends = [loop.first, loop.second].map((point) => this.pin(point, radius, palette.pin));
      if (loop.constraints.includes("distance")) this.join(ends, [spanning(0, 0.3 * radius, palette.pin)]);
    }
    for (const cylinder of model.cylinders) this.addCylinder(cylinder);
  }

  /** Puts what spans two bodies where their pins are now. */
  place(): void {
    for (const line of this.lines) line.place();
  }

  private addCylinder({ first, second, shortest_m }: CylinderInfo): void {
    const radius = BARREL.radius * shortest_m;
    const ends = [first, second].map((point) => this.pin(point, 1.15 * radius, this.palette.pin));
    const barrel = BARREL.length * shortest_m;
    const tube = { ...spanning(0, radius, this.palette.barrel), reach: () => barrel };
    this.join(ends, [tube, spanning(barrel / 2, BARREL.rod * radius, this.palette.rod)]);
  }

  private join(ends: Object3D[], parts: Part[]): void {
    const line = new Line(ends[0], ends[1], parts);
    this.world.add(line.group);
    this.lines.push(line);
  }

  /** A ball at a point that the engine describes; it moves with the body's object. */
  private pin({ body, position_m }: PointInfo, radius: number, colour: Color): Object3D {
    const ball = painted(new SphereGeometry(radius, 20, 14), colour);
    ball.position.set(...position_m);
    (this.bodies[this.names.indexOf(body)] ?? this.world).add(ball);
    return ball;
  }

  private thicknessAt({ body }: PointInfo): number {
    return this.thickness[this.names.indexOf(body)] ?? Infinity;
  }
}

/** A round part of a line between two pins, from a place on it to where it reaches. */
interface Part {
  mesh: Mesh;
  from: number;
  /** Where it ends, of a line of this length. */
  reach: (length: number) => number;
}

function spanning(from: number, radius: number, colour: Color): Part {
  const geometry = new CylinderGeometry(radius, radius, 1, 24);
  geometry.translate(0, 0.5, 0);
  return { mesh: painted(geometry, colour), from, reach: (length) => length };
}

/** Parts that lie along the line from one object to another. */
class Line {
  readonly group = new Group();
  private readonly start = new Vector3();
  private readonly way = new Vector3();

  constructor(
    private readonly first: Object3D,
    private readonly second: Object3D,
    private readonly parts: readonly Part[],
  ) {
    this.group.add(...parts.map((part) => part.mesh));
  }

  place(): void {
    this.first.getWorldPosition(this.start);
    this.second.getWorldPosition(this.way).sub(this.start);
    const length = this.way.length();
    this.group.position.copy(this.start);
    if (length > 0) this.group.quaternion.setFromUnitVectors(ALONG, this.way.divideScalar(length));
    for (const { mesh, from, reach } of this.parts) {
      mesh.position.y = from;
      mesh.scale.y = Math.max(reach(length) - from, Number.EPSILON);
    }
  }
}

function painted(geometry: SphereGeometry | CylinderGeometry, colour: Color): Mesh {
  const mesh = new Mesh(geometry, new MeshStandardMaterial({ color: colour, roughness: 0.35, metalness: 0.25 }));
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}
