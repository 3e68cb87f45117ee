import type { Vec3 } from "./fit";

/** Names of the viewpoints. */
export const CAMERAS = ["free", "load", "cab", "bridge", "top", "section"] as const;
export type CameraName = (typeof CAMERAS)[number];

/** Positions of the eye and of its target relative to the first body, along the axes of the world, m. */
export interface Place {
  eye: Vec3;
  target: Vec3;
}

/** Decimals of a position in a text. */
const DECIMALS = 2;

/** Reads a viewpoint: its name, or the six numbers of a place; null if it is neither. */
export function viewpointOf(text: string): CameraName | Place | null {
  const name = CAMERAS.find((one) => one === text.trim());
  if (name) return name;
  const numbers = text.trim().split(/[\s,]+/).map(Number);
  if (numbers.length !== 6 || !numbers.every(Number.isFinite)) return null;
  const [a, b, c, x, y, z] = numbers;
  return { eye: [a, b, c], target: [x, y, z] };
}

export function textOfPlace({ eye, target }: Place): string {
  return [...eye, ...target].map((value) => Number(value.toFixed(DECIMALS))).join(" ");
}
