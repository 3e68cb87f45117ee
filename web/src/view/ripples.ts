import { DataTexture, LinearFilter, LinearMipmapLinearFilter, RepeatWrapping, RGBAFormat } from "three";

/** Number of texels along an edge of a tile. */
const SIZE = 256;
/**
 * Waves in a tile: numbers of waves along x and along y, share of the slope, and phase. The numbers are whole, so that
 * tiles join.
 */
const WAVES = waves(28);

/**
 * Returns the slopes of the ripples along x and y at a position in the tile, from -1 to 1; the position goes from 0 to
 * 1.
 */
export function rippleSlope(x: number, y: number): [number, number] {
  const slope: [number, number] = [0, 0];
  for (const { along, across, share, phase } of WAVES) {
    const rise = share * Math.cos(2 * Math.PI * (along * x + across * y) + phase);
    const number = Math.hypot(along, across);
    slope[0] += (rise * along) / number;
    slope[1] += (rise * across) / number;
  }
  return slope;
}

/** Returns a tile of decorative ripples: the slopes as red and green. */
export function ripplesOf(): DataTexture {
  const texels = new Uint8Array(4 * SIZE * SIZE);
  for (let j = 0; j < SIZE; j++) {
    for (let i = 0; i < SIZE; i++) {
      const [x, y] = rippleSlope(i / SIZE, j / SIZE);
      texels.set([byteOf(x), byteOf(y), 128, 255], 4 * (j * SIZE + i));
    }
  }
  const texture = new DataTexture(texels, SIZE, SIZE, RGBAFormat);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = 8;
  texture.needsUpdate = true;
  return texture;
}

function byteOf(slope: number): number {
  return Math.round(255 * Math.min(1, Math.max(0, 0.5 + 0.5 * slope)));
}

/** Returns waves around one main direction, the shorter ones less steep; they are equal at every start. */
function waves(count: number): { along: number; across: number; share: number; phase: number }[] {
  const random = randomFrom(7);
  const drawn = Array.from({ length: count }, (_, i) => {
    const number = 2 + 20 * (i / count) ** 1.3;
    const heading = 1.9 * (random() - 0.5) * Math.PI;
    return { along: Math.round(number * Math.cos(heading)), across: Math.round(number * Math.sin(heading)), phase: 2 * Math.PI * random() };
  }).filter(({ along, across }) => along !== 0 || across !== 0);
  return drawn.map((wave) => ({ ...wave, share: 1.5 / drawn.length ** 0.5 / Math.hypot(wave.along, wave.across) ** 0.35 }));
}

/** Returns a generator of numbers from 0 to 1, a linear congruential generator. */
function randomFrom(seed: number): () => number {
  let state = seed;
  return () => (state = (1103515245 * state + 12345) % 2147483648) / 2147483648;
}
