import type { WebGLRenderer } from "three";

/** The level of detail of the scene. */
export interface Tier {
  /** Most pixels of the picture per pixel of the page. */
  pixelRatio: number;
  /** Texels along an edge of the map of shadows. */
  shadowSize: number;
  /** Ripples on the sea, interpolated lines, light from the sky; otherwise flat colours. */
  ripples: boolean;
}

/** From the best to the one for a computer without a graphics card. */
export const TIERS: readonly Tier[] = [
  { pixelRatio: 2, shadowSize: 4096, ripples: true },
  { pixelRatio: 1.5, shadowSize: 4096, ripples: true },
  { pixelRatio: 1, shadowSize: 4096, ripples: true },
  { pixelRatio: 1, shadowSize: 2048, ripples: true },
  { pixelRatio: 1, shadowSize: 1024, ripples: true },
  { pixelRatio: 1, shadowSize: 1024, ripples: false },
];
export const LOWEST = TIERS.length - 1;

/** Number of frames in a mean. */
const WINDOW = 30;
/** Target time per frame, unless the display is slower, ms. */
const AIM_MS = 1000 / 60;
/** A mean above the first multiple of the display's frame time is too slow; below the second a better tier may be possible. */
const SLOW = 1.35;
const ROOMY = 1.12;
/** Number of fast means before a better tier is tried, and its upper bound. */
const PATIENCE = 6;
const LONGEST_PATIENCE = 192;

/** Names of software renderers. */
const SOFTWARE = /swiftshader|llvmpipe|software|basic render/i;

/** Chooses a tier by the times between frames: worse soon, better after a while and later each time that it failed. */
export class Quality {
  private sum_ms = 0;
  private frames = 0;
  private roomy = 0;
  private patience = PATIENCE;
  private wasRaised = false;

  constructor(private at = 0) {}

  get tier(): Tier {
    return TIERS[this.at];
  }

  /** Takes the time between two consecutive frames; returns whether the tier has changed. */
  drew(interval_ms: number): boolean {
    this.sum_ms += interval_ms;
    this.frames += 1;
    if (this.frames < WINDOW) return false;
    const mean_ms = this.sum_ms / this.frames;
    this.sum_ms = this.frames = 0;
    if (mean_ms > SLOW * AIM_MS) return this.lower();
    this.roomy = mean_ms < ROOMY * AIM_MS ? this.roomy + 1 : 0;
    return this.roomy >= this.patience && this.raise();
  }

  private lower(): boolean {
    this.roomy = 0;
    if (this.at === LOWEST) return false;
    if (this.wasRaised) this.patience = Math.min(2 * this.patience, LONGEST_PATIENCE);
    this.wasRaised = false;
    this.at += 1;
    return true;
  }

  private raise(): boolean {
    this.roomy = 0;
    if (this.at === 0) return false;
    this.wasRaised = true;
    this.at -= 1;
    return true;
  }
}

/** Sets the quality of a renderer from the times between consecutive frames. */
export class Drawing {
  private last_ms = 0;

  constructor(
    private readonly quality: Quality,
    /** Whether the tier is fixed. */
    private readonly isHeld: boolean,
  ) {}

  /** Starts at the likely tier of the machine: low and fixed without a graphics card, lower on a phone. */
  static of(renderer: WebGLRenderer): Drawing {
    const gl = renderer.getContext();
    const names = gl.getExtension("WEBGL_debug_renderer_info");
    const name = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    // For saved pictures: `#quality=best` after the address.
    if (new URLSearchParams(location.hash.slice(1)).get("quality") === "best") return new Drawing(new Quality(), true);
    if (SOFTWARE.test(name)) return new Drawing(new Quality(LOWEST), true);
    return new Drawing(new Quality(matchMedia("(pointer: coarse)").matches ? 1 : 0), false);
  }

  get tier(): Tier {
    return this.quality.tier;
  }

  /** A picture was drawn; returns whether the tier has changed. */
  drew(now_ms: number): boolean {
    const [last_ms, isHeld] = [this.last_ms, this.isHeld];
    this.last_ms = now_ms;
    return !isHeld && last_ms > 0 && this.quality.drew(now_ms - last_ms);
  }

  /** No picture was needed: the next one does not follow a previous one. */
  rest(): void {
    this.last_ms = 0;
  }
}
