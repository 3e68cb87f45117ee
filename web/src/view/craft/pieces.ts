import { BoxGeometry, BufferAttribute, BufferGeometry, CylinderGeometry, ExtrudeGeometry, LatheGeometry, Matrix4, Quaternion, Shape, ShapeUtils, SphereGeometry, Vector2, Vector3 } from "three";
import type { Color } from "three";
import { mergeGeometries, toCreasedNormals } from "three/addons/utils/BufferGeometryUtils.js";
import type { Vec3 } from "../fit";

/** A closed line in plan, counter-clockwise, m. */
export type Plan = readonly (readonly [number, number])[];

/** Axis of cylinders in the library. */
const ALONG = new Vector3(0, 1, 0);
/** Largest angle between two faces that are shaded as one round surface, rad. */
const CREASE = 0.5;

/** Painted solids that are merged into one mesh, because draw calls cost more than triangles. */
export class Pieces {
  private readonly parts: BufferGeometry[] = [];

  get isEmpty(): boolean {
    return this.parts.length === 0;
  }

  /** Adds a solid of one colour. */
  add(geometry: BufferGeometry, colour: Color): this {
    const part = geometry.index ? geometry.toNonIndexed() : geometry;
    for (const name of Object.keys(part.attributes)) if (name !== "position" && name !== "normal") part.deleteAttribute(name);
    const { count } = part.attributes.position;
    const colours = new Float32Array(3 * count);
    for (let i = 0; i < count; i++) colour.toArray(colours, 3 * i);
    part.setAttribute("color", new BufferAttribute(colours, 3));
    this.parts.push(part);
    return this;
  }

  /** Adds a solid with its own colours. */
  addPainted(geometry: BufferGeometry): this {
    this.parts.push(geometry);
    return this;
  }

  box([x, y, z]: Vec3, middle: Vec3, colour: Color): this {
    return this.add(new BoxGeometry(x, y, z).translate(...middle), colour);
  }

  /** Adds a round bar between two points, tapered if a second radius is given. */
  rod(from: Vec3, to: Vec3, radius: number, colour: Color, sides = 8, endRadius = radius): this {
    const [start, way] = [new Vector3(...from), new Vector3(...to).sub(new Vector3(...from))];
    const length = way.length();
    if (length < 1e-9) return this;
    const geometry = new CylinderGeometry(endRadius, radius, length, sides).translate(0, length / 2, 0);
    const turn = new Quaternion().setFromUnitVectors(ALONG, way.divideScalar(length));
    return this.add(geometry.applyMatrix4(new Matrix4().compose(start, turn, new Vector3(1, 1, 1))), colour);
  }

  ball(middle: Vec3, radius: number, colour: Color, sides = 12): this {
    return this.add(new SphereGeometry(radius, sides, sides / 2 + 2).translate(...middle), colour);
  }

  /** Adds a vertical prism over a plan. */
  prism(plan: Plan, low: number, high: number, colour: Color): this {
    if (plan.length === 4) return this.add(blockOf(plan, low, high), colour);
    const geometry = new ExtrudeGeometry(shapeOf(plan), { depth: high - low, bevelEnabled: false }).translate(0, 0, low);
    return this.add(toCreasedNormals(geometry, CREASE), colour);
  }

  /** Adds a prism along y over a closed line of x and z; `width` is its length along y. */
  profile(line: Plan, width: number, y: number, colour: Color): this {
    const geometry = new ExtrudeGeometry(shapeOf(line), { depth: width, bevelEnabled: false });
    return this.add(geometry.rotateX(Math.PI / 2).translate(0, y + width / 2, 0), colour);
  }

  /** Adds a body of revolution about an axis through `middle`; the line gives radius and height, from below. */
  turned(line: readonly (readonly [number, number])[], axis: "x" | "y" | "z", middle: Vec3, colour: Color, sides = 28): this {
    const geometry = new LatheGeometry(line.map(([radius, height]) => new Vector2(radius, height)), sides);
    if (axis === "x") geometry.rotateZ(-Math.PI / 2);
    if (axis === "z") geometry.rotateX(Math.PI / 2);
    return this.add(toCreasedNormals(geometry.toNonIndexed(), CREASE).translate(...middle), colour);
  }

  /** Moves all solids. */
  move(by: Matrix4): this {
    for (const part of this.parts) part.applyMatrix4(by);
    return this;
  }

  /** Takes over all solids of another set. */
  take(other: Pieces): this {
    this.parts.push(...other.parts);
    return this;
  }

  /** Returns all solids as one geometry; null if there are none. */
  geometry(): BufferGeometry | null {
    return this.isEmpty ? null : mergeGeometries(this.parts);
  }
}

/** Returns a prism over a quadrangle with few triangles, because there are many windows. */
function blockOf(plan: Plan, low: number, high: number): BufferGeometry {
  const area = plan.reduce((sum, [x, y], i) => sum + x * plan[(i + 1) % 4][1] - plan[(i + 1) % 4][0] * y, 0);
  const [a, b, c, d] = area > 0 ? plan : [...plan].reverse();
  const at = (place: readonly [number, number], z: number) => [place[0], place[1], z];
  const quad = (p: number[], q: number[], r: number[], s: number[]) => [...p, ...q, ...r, ...p, ...r, ...s];
  const walls = [[a, b], [b, c], [c, d], [d, a]].flatMap(([from, to]) => quad(at(from, low), at(to, low), at(to, high), at(from, high)));
  const ends = [...quad(at(a, high), at(b, high), at(c, high), at(d, high)), ...quad(at(d, low), at(c, low), at(b, low), at(a, low))];
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from([...walls, ...ends]), 3));
  geometry.computeVertexNormals();
  return geometry;
}

function shapeOf(plan: Plan): Shape {
  return new Shape(plan.map(([x, y]) => new Vector2(x, y)));
}

/**
 * Returns the profile of a round bar of constant radius, for a body of revolution: half of its longitudinal section.
 */
export function straight(radius: number, from: number, to: number): [number, number][] {
  return [[0, from], [radius, from], [radius, to], [0, to]];
}

/**
 * Returns a solid through plans at ascending heights, closed below and above; all plans have the same number of points.
 */
export function lofted(levels: readonly { z: number; plan: Plan }[]): BufferGeometry {
  const positions: number[] = [];
  const [first, last] = [levels[0], levels[levels.length - 1]];
  for (let k = 0; k + 1 < levels.length; k++) {
    const [low, high] = [levels[k], levels[k + 1]];
    for (let i = 0; i < low.plan.length; i++) {
      const j = (i + 1) % low.plan.length;
      const [a, b] = [[...low.plan[i], low.z], [...low.plan[j], low.z]];
      const [c, d] = [[...high.plan[j], high.z], [...high.plan[i], high.z]];
      positions.push(...a, ...b, ...c, ...a, ...c, ...d);
    }
  }
  const triangles = (plan: Plan) => ShapeUtils.triangulateShape(plan.map(([x, y]) => new Vector2(x, y)), []);
  for (const [a, b, c] of triangles(last.plan)) for (const i of [a, b, c]) positions.push(...last.plan[i], last.z);
  for (const [a, b, c] of triangles(first.plan)) for (const i of [c, b, a]) positions.push(...first.plan[i], first.z);
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(positions), 3));
  return toCreasedNormals(geometry, CREASE);
}
