import { make } from "../ui/dom";
import type { Chart, Content } from "./chart";

/** Size of a saved chart, pixels of the page; it does not depend on the screen. */
const SIZE = { width: 1100, height: 460 };
/** Pause between two attempts to draw a chart that loads a library, ms. */
const PAUSE_MS = 25;
const MOST_PAUSES = 80;

/** Draws the chart of a plot on a separate canvas; null if it could not be drawn. */
export async function drawnApart(chartIn: (area: HTMLElement) => Chart, content: Content): Promise<HTMLCanvasElement | null> {
  const area = make("div", { class: "plot-sheet", style: `width: ${SIZE.width}px; height: ${SIZE.height}px`, "aria-hidden": "true" });
  document.body.append(area);
  const chart = chartIn(area);
  const pause = () => new Promise((resolve) => setTimeout(resolve, PAUSE_MS));
  for (let i = 0; i < MOST_PAUSES && !chart.canvas(); i++) {
    chart.draw(content);
    await pause();
  }
  const drawn = chart.canvas();
  const copy = drawn && copyOf(drawn);
  chart.destroy();
  area.remove();
  return copy;
}

function copyOf(canvas: HTMLCanvasElement): HTMLCanvasElement {
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  copy.getContext("2d")!.drawImage(canvas, 0, 0);
  return copy;
}

/** Returns the number of pixels of the picture per pixel of the page. */
export function scaleOf(canvas: HTMLCanvasElement): number {
  return canvas.width / SIZE.width;
}
