import type { Area } from "./fit";

/** Returns the areas of the page's controls and panels that cover the picture, pixels. */
export function coversOf(canvas: HTMLCanvasElement): Area[] {
  const picture = canvas.getBoundingClientRect();
  const parts = [...document.querySelectorAll(".floating, .cockpit, .task, .stick, .scene-tools, .scene-note, .frames-legend, .tension-legend, .readouts, .panel, .plots, .figure-bar")];
  return parts
    .map((part) => part.getBoundingClientRect())
    .map(({ left, top, right, bottom }) => ({ left: left - picture.left, top: top - picture.top, right: right - picture.left, bottom: bottom - picture.top }))
    .filter(({ left, top, right, bottom }) => right > left && left < picture.width && right > 0 && top < picture.height && bottom > 0);
}
