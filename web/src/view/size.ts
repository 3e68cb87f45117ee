import type { WebGLRenderer } from "three";

/** Size of a saved picture, pixels. */
export interface Size {
  width: number;
  height: number;
}

/** Thrown for a size that the graphics card cannot draw. */
export class TooLargeError extends Error {
  constructor(
    readonly size: Size,
    /** Largest width and height, pixels. */
    readonly most: number,
  ) {
    super(`${size.width}x${size.height}`);
  }
}

/** Returns the largest width and height that the graphics card draws, pixels. */
export function largestOf(renderer: WebGLRenderer): number {
  const gl = renderer.getContext();
  const [width, height]: Int32Array = gl.getParameter(gl.MAX_VIEWPORT_DIMS);
  return Math.min(width, height, gl.getParameter(gl.MAX_RENDERBUFFER_SIZE));
}
