import type { WebGLRenderer } from "three";

/** How much of the scene is drawn. */
export interface Tier {
  /** Pixels of the picture to one of the page, at most. */
  pixelRatio: number;
  /** Texels along an edge of the map of shadows. */
  shadowSize: number;
  /** Ripples on the sea, lines between the engine's, light by the sky: else flat colours. */
  ripples: boolean;
}

/** From the best to the one that a computer without a graphics card draws. */
export const TIERS: readonly Tier[] = [
  { pixelRatio: 2, shadowSize: 4096, ripples: true },
  { pixelRatio: 1.5, shadowSize: 4096, ripples: true },
  { pixelRatio: 1, shadowSize: 4096, ripples: true },
  { pixelRatio: 1, shadowSize: 2048, ripples: true },
  { pixelRatio: 1, shadowSize: 1024, ripples: true },
  { pixelRatio: 1, shadowSize: 1024, ripples: false },
];
export const LOWEST = TIERS.length - 1;

/** Frames that a mean is taken over. */
const WINDOW = 30;
/** The rate to aim for where the display's is not known to be less, ms a frame. */
const AIM_MS = 1000 / 60;
/** Means over so much of what the display takes are too slow; below so much there may be room. */
const SLOW = 1.35;
const ROOMY = 1.12;
/** Means with room before a better picture is tried, and at most. */
const PATIENCE = 6;
const LONGEST_PATIENCE = 192;

/** What draws without a graphics card. */
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

  /** Takes the time between two frames that followed each other; whether the tier is another now. */
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

/** The quality of a renderer's pictures, by the time between those that follow each other. */
export class Drawing {
  private last_ms = 0;

  constructor(
    private readonly quality: Quality,
    /** Whether the tier stays what it is. */
    private readonly isHeld: boolean,
  ) {}

  /** Begins where the machine likely ends: low without a graphics card and there for good, lower on a phone. */
  static of(renderer: WebGLRenderer): Drawing {
    const gl = renderer.getContext();
    const names = gl.getExtension("WEBGL_debug_renderer_info");
    const name = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    // For pictures that are kept: `#quality=best` after the address.
    if (new URLSearchParams(location.hash.slice(1)).get("quality") === "best") return new Drawing(new Quality(), true);
    if (SOFTWARE.test(name)) return new Drawing(new Quality(LOWEST), true);
    return new Drawing(new Quality(matchMedia("(pointer: coarse)").matches ? 1 : 0), false);
  }

  get tier(): Tier {
    return this.quality.tier;
  }

  /** A picture was drawn; whether the tier is another now. */
  drew(now_ms: number): boolean {
    const [last_ms, isHeld] = [this.last_ms, this.isHeld];
    this.last_ms = now_ms;
    return !isHeld && last_ms > 0 && this.quality.drew(now_ms - last_ms);
  }

  /** Nothing had to be drawn: the next picture follows none. */
  rest(): void {
    this.last_ms = 0;
  }
}
