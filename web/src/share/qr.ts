import { encode } from "uqr";
import { svg } from "../instruments/svg";

/**
 * Largest length of a text whose QR code a phone can read from a screen, characters; the limit of the standard is 2953.
 */
export const LONGEST_QR = 1000;
/** Width of the quiet zone, modules, as the standard requires. */
const QUIET = 4;

/** Returns a QR code as a picture, dark on white in every theme. */
export function qrCode(text: string, label: string): SVGSVGElement {
  const { data, size } = encode(text, { ecc: "L", border: QUIET });
  const modules = data.flatMap((row, y) => row.flatMap((isDark, x) => (isDark ? [`M${x} ${y}h1v1h-1z`] : [])));
  const paper = svg("rect", { width: String(size), height: String(size), fill: "#ffffff" });
  const drawn = svg("path", { d: modules.join(""), fill: "#000000" });
  return svg("svg", { viewBox: `0 0 ${size} ${size}`, role: "img", "aria-label": label, "shape-rendering": "crispEdges" }, paper, drawn);
}
