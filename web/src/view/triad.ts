import {
  CanvasTexture,
  ConeGeometry,
  CylinderGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
} from "three";
import type { Color } from "three";
import type { Palette } from "./palette";

/** The paper numbers its axes 1 athwartship, 2 up and 3 along the ship: these are y, z and x here. */
const AXES = [
  { axis: "x", number: 3 },
  { axis: "y", number: 1 },
  { axis: "z", number: 2 },
] as const;

/**
 * Returns the frame (e1 e2 e3) of a body, drawn over everything. `mark` is its superscript, as in Fig. 3; `scale` is
 * the size of the labels, from `labelScale`.
 */
export function triadOf(length: number, mark: string, scale: number, palette: Palette, opacity = 1): Group {
  const group = new Group();
  for (const { axis, number } of AXES) {
    const colour = palette.axes[axis];
    const arrow = arrowOf(length, colour, opacity);
    if (axis === "x") arrow.rotation.z = -Math.PI / 2;
    if (axis === "z") arrow.rotation.x = Math.PI / 2;
    const label = labelOf(String(number), mark, scale, colour, palette);
    label.position[axis] = 1.17 * length;
    group.add(arrow, label);
  }
  return group;
}

/** Returns an arrow along y from the origin. */
function arrowOf(length: number, colour: Color, opacity: number): Group {
  const material = new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true, opacity });
  const stem = new Mesh(new CylinderGeometry(0.016 * length, 0.016 * length, 0.85 * length, 10), material);
  stem.position.y = 0.425 * length;
  const head = new Mesh(new ConeGeometry(0.06 * length, 0.18 * length, 16), material);
  head.position.y = 0.91 * length;
  stem.renderOrder = head.renderOrder = 10;
  return new Group().add(stem, head);
}

/** Returns the scale of a label that has a height in pixels, in a picture of a given height. */
export function labelScale(pixels: number, height: number, fov: number): number {
  return (2 * Math.tan(fov / 2) * pixels) / height;
}

/** Returns a label: the letter e with its number below and its frame above, of a constant size on the screen. */
function labelOf(number: string, mark: string, scale: number, colour: Color, palette: Palette): Sprite {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 128;
  const pen = canvas.getContext("2d")!;
  pen.lineJoin = "round";
  pen.lineWidth = 10;
  pen.strokeStyle = palette.halo;
  pen.fillStyle = `#${colour.getHexString()}`;
  const write = (text: string, font: string, x: number, y: number) => {
    pen.font = font;
    pen.strokeText(text, x, y);
    pen.fillText(text, x, y);
  };
  write("e", "italic bold 64px Georgia, 'Times New Roman', serif", 28, 82);
  write(number, "bold 32px Georgia, 'Times New Roman', serif", 60, 98);
  write(mark, "bold 30px Georgia, 'Times New Roman', serif", 60, 52);
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({ map, depthTest: false, sizeAttenuation: false }));
  sprite.scale.setScalar(scale);
  sprite.renderOrder = 11;
  return sprite;
}
