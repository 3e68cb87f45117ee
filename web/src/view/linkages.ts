import { CylinderGeometry, Group, SphereGeometry, Vector3 } from "three";
import type { Color, Mesh, Object3D } from "three";
import type { ModelInfo, PointInfo } from "../engine/engine";
import { painted } from "./lines";
import type { Palette } from "./palette";

/** Radius of a loop's pin, relative to the thickness of the more slender of its two bodies. */
const PIN = 0.6;

/** Axis of cylinders in the library. */
const ALONG = new Vector3(0, 1, 0);

/** Connections of closed loops: pins, and rods for a constant distance. */
export class Linkages {
  private readonly lines: Line[] = [];
  private readonly names: string[];

  /**
   * Adds the connections to the objects of the bodies and to the world; `thickness` is the thickness of each body, m.
   */
  constructor(
    model: ModelInfo,
    private readonly bodies: readonly Group[],
    private readonly thickness: readonly number[],
    private readonly world: Group,
    palette: Palette,
  ) {
    this.names = model.bodies.map((body) => body.name);
    for (const loop of [...model.loops, ...model.connections]) {
      const radius = PIN * Math.min(this.thicknessAt(loop.first), this.thicknessAt(loop.second));
      const ends = [loop.first, loop.second].map((point) => this.pin(point, radius, palette.pin));
      if (loop.constraints.includes("distance")) this.join(ends, spanning(0.3 * radius, palette.pin));
    }
  }

  /** Moves rods between two bodies to the present positions of their pins. */
  place(): void {
    for (const line of this.lines) line.place();
  }

  private join(ends: Object3D[], rod: Mesh): void {
    const line = new Line(ends[0], ends[1], rod);
    this.world.add(line.group);
    this.lines.push(line);
  }

  /** Returns a ball at a point of a body, which moves with the object of the body. */
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

/** Returns a round rod of length 1 from the origin. */
function spanning(radius: number, colour: Color): Mesh {
  const geometry = new CylinderGeometry(radius, radius, 1, 24);
  geometry.translate(0, 0.5, 0);
  return painted(geometry, colour);
}

/** A rod from one object to another. */
class Line {
  readonly group = new Group();
  private readonly start = new Vector3();
  private readonly way = new Vector3();

  constructor(
    private readonly first: Object3D,
    private readonly second: Object3D,
    private readonly rod: Mesh,
  ) {
    this.group.add(rod);
  }

  place(): void {
    this.first.getWorldPosition(this.start);
    this.second.getWorldPosition(this.way).sub(this.start);
    const length = this.way.length();
    this.group.position.copy(this.start);
    if (length > 0) this.group.quaternion.setFromUnitVectors(ALONG, this.way.divideScalar(length));
    this.rod.scale.y = Math.max(length, Number.EPSILON);
  }
}
