import { BufferAttribute, BufferGeometry, Color, Group, Mesh, MeshStandardMaterial } from "three";
import { toCreasedNormals } from "three/addons/utils/BufferGeometryUtils.js";
import type { HullInfo, MeshInfo } from "../engine/engine";
import type { Box, Vec3 } from "./fit";
import { cross, unit, vec3 } from "./fit";
import { bowArrowOf } from "./hull";
import type { Palette } from "./palette";

/** Largest angle between two faces that are shaded as one smooth surface, rad. */
const CREASE = 0.5;
/** Smallest upward component of the normal of faces that are painted as deck. */
const LEVEL = 0.9;

/** Returns the hull mesh of a hydrodynamic database, painted below and above its water line. */
export function meshHullOf({ mesh, origin_m }: HullInfo & { mesh: MeshInfo }, palette: Palette): Group {
  const positions: number[] = [];
  const colours: number[] = [];
  const { low, high } = boxOfMesh(mesh);
  const faces = mesh.triangles.map((triangle) => triangle.map((i): Vec3 => mesh.vertices_m[i]));
  const atTop = (corner: Vec3) => corner[2] > high[2] - 1e-3 * (high[2] - low[2]);
  // A sphere has no deck.
  const hasDeck = faces.some((corners) => corners.every(atTop));
  for (const corners of faces) {
    const isAbove = corners.reduce((sum, corner) => sum + corner[2], 0) > 3 * origin_m[2];
    const isDeck = hasDeck && isAbove && normalOf(corners)[2] > LEVEL;
    const { r, g, b } = isDeck ? palette.deck : isAbove ? palette.hull : palette.bottom;
    for (const corner of corners) {
      positions.push(...corner);
      colours.push(r, g, b);
    }
  }
  const group = new Group().add(painted(positions, colours));
  if (hasDeck) {
    const arrow = bowArrowOf(high[0] - low[0], high[1] - low[1], palette);
    arrow.position.set((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, high[2] + 0.02);
    group.add(arrow);
  }
  return group;
}

/** Returns the box around a mesh, body axes. */
export function boxOfMesh({ vertices_m }: MeshInfo): Box {
  const end = (of: (...values: number[]) => number) =>
    vec3((k) => vertices_m.reduce((so, vertex) => of(so, vertex[k]), vertices_m[0][k]));
  return { low: end(Math.min), high: end(Math.max) };
}

function painted(positions: number[], colours: number[]): Mesh {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(positions), 3));
  geometry.setAttribute("color", new BufferAttribute(Float32Array.from(colours), 3));
  const material = new MeshStandardMaterial({ color: new Color(0xffffff), vertexColors: true, roughness: 0.62, metalness: 0.05 });
  const mesh = new Mesh(toCreasedNormals(geometry, CREASE), material);
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

function normalOf([a, b, c]: Vec3[]): Vec3 {
  const from = (p: Vec3): Vec3 => [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
  return unit(cross(from(b), from(c)));
}
