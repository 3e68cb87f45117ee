import { Color, LatheGeometry, Mesh, MeshStandardMaterial, SphereGeometry, Vector2 } from "three";
import type { BufferGeometry, Object3D } from "three";
import { RoundedBoxGeometry } from "three/addons/geometries/RoundedBoxGeometry.js";
import type { BodyInfo, HullInfo, MeshInfo, ModelInfo, Shape } from "../engine/engine";
import { boxOfMesh, meshHullOf } from "./afloat";
import type { Box, Vec3 } from "./fit";
import { vec3 } from "./fit";
import { hullOf } from "./hull";
import type { Palette } from "./palette";

/** Density of the ball that shows a point mass, kg/m3: a mass of one tonne has a diameter of 1.2 m. */
const BALL_DENSITY = 1100;

/** A hull with a mesh. */
export type ShapedHull = HullInfo & { mesh: MeshInfo };

/** Returns the solid of a body in its own frame (x forward, y to port, z up); if the body has a hull mesh, the mesh. */
export function solidOf(body: BodyInfo, palette: Palette, isShip: boolean, hull: ShapedHull | undefined): Object3D {
  const { shape } = body;
  if (hull) return meshHullOf(hull, withHull(palette, body.colour));
  if (shape?.kind === "box" && isShip) return hullOf(shape, withHull(palette, body.colour));
  const geometry = shape && geometryOf(shape, body.mass_kg);
  const colour = body.colour ?? (shape?.kind === "point" ? palette.load : palette.plain);
  return painted(geometry ?? ballOf(body.mass_kg), colour);
}

function withHull(palette: Palette, colour: string | null): Palette {
  return colour ? { ...palette, hull: new Color(colour) } : palette;
}

function painted(geometry: BufferGeometry, colour: Color | string): Mesh {
  const material = new MeshStandardMaterial({ roughness: 0.5, metalness: 0.08 });
  material.color.set(colour);
  const mesh = new Mesh(geometry, material);
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

function geometryOf(shape: Shape, mass_kg: number): BufferGeometry {
  switch (shape.kind) {
    case "box": {
      const edge = 0.03 * Math.min(shape.length_m, shape.width_m, shape.height_m);
      return new RoundedBoxGeometry(shape.length_m, shape.width_m, shape.height_m, 2, edge);
    }
    case "cylinder":
      return cylinderOf(shape.radius_m, shape.length_m, shape.axis);
    case "sphere":
      return new SphereGeometry(shape.radius_m, 40, 24);
    case "point":
      return ballOf(mass_kg);
  }
}

/** Returns a cylinder about its centre with slightly bevelled edges. */
function cylinderOf(radius: number, length: number, axis: "x" | "y" | "z"): BufferGeometry {
  const [half, edge] = [length / 2, 0.12 * Math.min(radius, length)];
  const corner = (sign: number) =>
    [0, 0.5, 1].map((part) => {
      const angle = (part * Math.PI) / 2;
      return new Vector2(radius - edge + edge * Math.sin(angle), sign * (half - edge + edge * Math.cos(angle)));
    });
  const profile = [new Vector2(0, -half), ...corner(-1), ...corner(1).reverse(), new Vector2(0, half)];
  const geometry = new LatheGeometry(profile, 40);
  if (axis === "x") geometry.rotateZ(-Math.PI / 2);
  if (axis === "z") geometry.rotateX(Math.PI / 2);
  return geometry;
}

/** Returns the ball of a point mass, whose size follows from its mass. */
function ballOf(mass_kg: number): BufferGeometry {
  return new SphereGeometry(ballRadius(mass_kg), 36, 24);
}

export function ballRadius(mass_kg: number): number {
  return Math.cbrt((3 * mass_kg) / (4 * Math.PI * BALL_DENSITY));
}

/** Returns the hull of a body; undefined if it has no mesh. */
export function shapedHullOf(model: ModelInfo, body: string): ShapedHull | undefined {
  return model.hulls.find((hull): hull is ShapedHull => hull.body === body && hull.mesh !== null);
}

/** Returns the box around a body. */
export function boxOf(body: BodyInfo, hull: ShapedHull | undefined): Box {
  if (hull) return boxOfMesh(hull.mesh);
  const [x, y, z] = halfSizes(body);
  return { low: [-x, -y, -z], high: [x, y, z] };
}

/** Returns the box, enlarged so that it contains a frame of this length at the body's centre. */
export function withFrame({ low, high }: Box, length: number): Box {
  return { low, high: [Math.max(high[0], length), Math.max(high[1], length), Math.max(high[2], length)] };
}

/** Returns the lengths of a box's edges. */
export function edgesOf({ low, high }: Box): Vec3 {
  return [high[0] - low[0], high[1] - low[1], high[2] - low[2]];
}

/** Returns the half sizes of the box around a body, body axes. */
function halfSizes(body: BodyInfo): [number, number, number] {
  const { shape } = body;
  switch (shape?.kind) {
    case "box":
      return [shape.length_m / 2, shape.width_m / 2, shape.height_m / 2];
    case "cylinder":
      return vec3((k) => ("xyz"[k] === shape.axis ? shape.length_m / 2 : shape.radius_m));
    case "sphere":
      return [shape.radius_m, shape.radius_m, shape.radius_m];
    default: {
      const radius = ballRadius(body.mass_kg);
      return [radius, radius, radius];
    }
  }
}
