import type { WebGLRenderer } from "three";

/** Level of detail of the scene. */
export interface Tier {
  /** Largest number of pixels of the picture per pixel of the page. */
  pixelRatio: number;
  /** Number of texels along an edge of the shadow map. */
  shadowSize: number;
  /** Whether the sea has ripples and interpolated grid lines, and the sky lights the scene; otherwise flat shading. */
  ripples: boolean;
}

/** Levels of detail, from the best to the level for a computer without a graphics card. */
export const TIERS: readonly Tier[] = [
  { pixelRatio: 2, shadowSize: 4096, ripples: true },
  { pixelRatio: 1.5, shadowSize: 4096, ripples: true },
  { pixelRatio: 1, shadowSize: 4096, ripples: true },
  { pixelRatio: 1, shadowSize: 2048, ripples: true },
  { pixelRatio: 1, shadowSize: 1024, ripples: true },
  { pixelRatio: 1, shadowSize: 1024, ripples: false },
];
export const LOWEST = TIERS.length - 1;

/** Number of frames over which the time per frame is averaged. */
const WINDOW = 30;
/** Target time per frame, ms. */
const AIM_MS = 1000 / 60;
/**
 * Multiples of the target time: a mean above the first is too slow; below the second, a better level may be possible.
 */
const SLOW = 1.35;
const ROOMY = 1.12;
/** Number of fast means before a better level is tried, and its upper bound. */
const PATIENCE = 6;
const LONGEST_PATIENCE = 192;

/** Names of software renderers. */
const SOFTWARE = /swiftshader|llvmpipe|software|basic render/i;

/**
 * Chooses a level of detail by the times between frames: a lower one soon, a better one after a while, and later each
 * time that it was too slow.
 */
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

  /** Takes the time between two consecutive frames; returns whether the level has changed. */
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

/** Sets the level of detail of a renderer from the times between consecutive frames. */
export class Drawing {
  private last_ms = 0;
  /** Whether the best level is used, whatever the machine: saved pictures are equal on every machine. */
  isSaved = false;

  constructor(
    private readonly quality: Quality,
    /** Whether the level is fixed. */
    private readonly isHeld: boolean,
  ) {}

  /**
   * Starts at a level that the machine can probably draw: the lowest, and fixed, without a graphics card; a lower one
   * on a phone.
   */
  static of(renderer: WebGLRenderer): Drawing {
    const gl = renderer.getContext();
    const names = gl.getExtension("WEBGL_debug_renderer_info");
    const name = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    // `#quality=best` after the address fixes the best level, for saved pictures.
    if (new URLSearchParams(location.hash.slice(1)).get("quality") === "best") return new Drawing(new Quality(), true);
    if (SOFTWARE.test(name)) return new Drawing(new Quality(LOWEST), true);
    return new Drawing(new Quality(matchMedia("(pointer: coarse)").matches ? 1 : 0), false);
  }

  get tier(): Tier {
    return this.isSaved ? TIERS[0] : this.quality.tier;
  }

  /** Takes the time of a drawn picture; returns whether the level has changed. */
  drew(now_ms: number): boolean {
    const [last_ms, isHeld] = [this.last_ms, this.isHeld];
    this.last_ms = now_ms;
    return !isHeld && last_ms > 0 && this.quality.drew(now_ms - last_ms);
  }

  /** Takes note that no picture was needed: the interval to the next picture does not count. */
  rest(): void {
    this.last_ms = 0;
  }
}
