import { byId } from "../ui/dom";

/** Ratio of height to width of the picture, if the frame leaves the choice. */
const PICTURE = 10 / 16;

/**
 * Reports the height at which everything is visible, whenever it changes: the picture in its own shape, and all that is
 * under it. The height of the frame does not count, so that a frame that follows it comes to rest.
 */
export function reportHeight(tell: (height_px: number) => void): void {
  const under = byId("under");
  let told = 0;
  const look = () => {
    const height_px = Math.ceil(document.documentElement.clientWidth * PICTURE + under.scrollHeight);
    if (height_px === told || height_px <= 0) return;
    told = height_px;
    tell(height_px);
  };
  const observer = new ResizeObserver(look);
  observer.observe(under);
  observer.observe(document.documentElement);
}
