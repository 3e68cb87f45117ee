import { CylinderGeometry, Group, Mesh, MeshStandardMaterial, SphereGeometry, Vector3 } from "three";
import type { Color, InterleavedBufferAttribute, Object3D } from "three";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import type { DrawnLine } from "../engine/engine";
import type { Palette } from "./palette";

/** Width of a line that is too thin to be drawn to scale, pixels: it is seen from afar too. */
const WIDTH_PX = 2.2;

/** Axis along which three's cylinders stand. */
const ALONG = new Vector3(0, 1, 0);

interface Drawn {
  object: Object3D;
  /** Puts it where its points are: x, y, z of each. */
  lay(points: ArrayLike<number>, from: number): void;
  points: number;
}

/** What the engine draws beside the bodies: ropes, tubes and pins, through its points. */
export class DrawnLines {
  private readonly drawn: Drawn[];

  /** Puts what is drawn into the world. */
  constructor(lines: readonly DrawnLine[], world: Group, palette: Pick<Palette, DrawnLine["style"]>) {
    this.drawn = lines.map((line) => ({ ...shapeOf(line, palette[line.style]), points: line.points }));
    if (this.drawn.length > 0) world.add(...this.drawn.map(({ object }) => object));
  }

  /** Lays them through their points now, one line's after another's. */
  place(points: ArrayLike<number>): void {
    let from = 0;
    for (const line of this.drawn) {
      line.lay(points, from);
      from += 3 * line.points;
    }
  }
}

function shapeOf({ points, radius_m }: DrawnLine, colour: Color): Omit<Drawn, "points"> {
  if (points === 1) return ballOf(radius_m, colour);
  return radius_m > 0 ? tubeOf(radius_m, colour) : threadOf(points, colour);
}

function ballOf(radius_m: number, colour: Color): Omit<Drawn, "points"> {
  const object = painted(new SphereGeometry(radius_m, 20, 14), colour);
  return { object, lay: (points, from) => object.position.copy(at(points, from)) };
}

function tubeOf(radius_m: number, colour: Color): Omit<Drawn, "points"> {
  const geometry = new CylinderGeometry(radius_m, radius_m, 1, 24);
  geometry.translate(0, 0.5, 0);
  const object = painted(geometry, colour);
  const lay = (points: ArrayLike<number>, from: number) => {
    const way = at(points, from + 3).sub(at(points, from));
    const length = way.length();
    object.position.copy(at(points, from));
    object.scale.y = Math.max(length, Number.EPSILON);
    if (length > 0) object.quaternion.setFromUnitVectors(ALONG, way.divideScalar(length));
  };
  return { object, lay };
}

function threadOf(count: number, colour: Color): Omit<Drawn, "points"> {
  const geometry = new LineGeometry();
  geometry.setPositions(new Float32Array(3 * count));
  const object = new Line2(geometry, new LineMaterial({ color: colour, linewidth: WIDTH_PX }));
  object.frustumCulled = false;
  const { data } = geometry.getAttribute("instanceStart") as InterleavedBufferAttribute;
  const lay = (points: ArrayLike<number>, from: number) => {
    // Each of its parts has both its ends.
    for (let part = 0; part + 1 < count; part++) {
      for (let k = 0; k < 6; k++) data.array[6 * part + k] = points[from + 3 * part + k];
    }
    data.needsUpdate = true;
  };
  return { object, lay };
}

function at(points: ArrayLike<number>, from: number): Vector3 {
  return new Vector3(points[from], points[from + 1], points[from + 2]);
}

export function painted(geometry: SphereGeometry | CylinderGeometry, colour: Color): Mesh {
  const mesh = new Mesh(geometry, new MeshStandardMaterial({ color: colour, roughness: 0.35, metalness: 0.25 }));
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}
