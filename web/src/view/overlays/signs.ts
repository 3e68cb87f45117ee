import { BufferAttribute, BufferGeometry, CanvasTexture, Group, LineBasicMaterial, LineSegments, Points, PointsMaterial, Sprite, SpriteMaterial, SRGBColorSpace } from "three";
import type { Color } from "three";
import type { Vec3 } from "../fit";

/** Size of the symbol of a centre of mass, pixels. */
const SIGN_PX = 20;
/** Height of a letter, as a share of the height of the picture. */
const LETTER = 0.05;

/**
 * Points that are marked with the symbol of a centre of mass: a circle with black and white quarters. One draw call.
 */
export class CentreSigns extends Points<BufferGeometry, PointsMaterial> {
  constructor() {
    super(new BufferGeometry(), new PointsMaterial({ size: SIGN_PX * Math.min(2, globalThis.devicePixelRatio ?? 1), sizeAttenuation: false, transparent: true, depthTest: false, map: quartered() }));
    this.frustumCulled = false;
    this.renderOrder = 13;
  }

  show(places: readonly Vec3[]): void {
    if (places.length === 0) return;
    this.geometry.dispose();
    this.geometry = geometryOf(places);
  }
}

/** Straight lines between pairs of points, drawn over everything. One draw call. */
export class Strokes extends LineSegments<BufferGeometry, LineBasicMaterial> {
  constructor(isOver = true) {
    super(new BufferGeometry(), new LineBasicMaterial({ depthTest: !isOver, transparent: true }));
    this.frustumCulled = false;
    this.renderOrder = 12;
  }

  show(strokes: readonly (readonly [Vec3, Vec3])[], colour: Color): void {
    if (strokes.length === 0) return;
    this.material.color.copy(colour);
    this.geometry.dispose();
    this.geometry = geometryOf(strokes.flat());
  }
}

/** Letters at points; a text is drawn again only if it has changed. */
export class Letters extends Group {
  private said = "";

  show(letters: readonly { text: string; at: Vec3 }[], ink: string, halo: string): void {
    const say = [...letters.map(({ text }) => text), ink, halo].join();
    if (say !== this.said) this.write(letters.map(({ text }) => text), ink, halo);
    this.said = say;
    letters.forEach(({ at }, i) => this.children[i].position.set(...at));
  }

  private write(texts: readonly string[], ink: string, halo: string): void {
    for (const one of this.children) {
      if (!(one instanceof Sprite)) continue;
      one.material.map?.dispose();
      one.material.dispose();
    }
    this.clear();
    for (const [i, text] of texts.entries()) {
      const sprite = new Sprite(new SpriteMaterial({ map: written(text, ink, halo), depthTest: false, sizeAttenuation: false }));
      // Letters are alternately to the right and to the left, because some points are close together.
      sprite.center.set(i % 2 === 0 ? -0.1 : 1.1, 0.5);
      sprite.scale.setScalar(LETTER);
      sprite.renderOrder = 14;
      this.add(sprite);
    }
  }
}

function geometryOf(places: readonly Vec3[]): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(places.flat()), 3));
  return geometry;
}

function drawing(paint: (pen: CanvasRenderingContext2D) => void): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  paint(canvas.getContext("2d")!);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

function quartered(): CanvasTexture {
  return drawing((pen) => {
    for (let k = 0; k < 4; k++) {
      pen.fillStyle = k % 2 === 0 ? "#111" : "#fff";
      pen.beginPath();
      pen.moveTo(32, 32);
      pen.arc(32, 32, 27, (k * Math.PI) / 2, ((k + 1) * Math.PI) / 2);
      pen.fill();
    }
    pen.lineWidth = 4;
    pen.strokeStyle = "#111";
    pen.beginPath();
    pen.arc(32, 32, 28, 0, 2 * Math.PI);
    pen.stroke();
  });
}

function written(text: string, ink: string, halo: string): CanvasTexture {
  return drawing((pen) => {
    pen.font = "bold 44px system-ui, sans-serif";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.lineJoin = "round";
    pen.lineWidth = 9;
    pen.strokeStyle = halo;
    pen.strokeText(text, 32, 34);
    pen.fillStyle = ink;
    pen.fillText(text, 32, 34);
  });
}
