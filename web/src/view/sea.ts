import { BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, Mesh, ShaderMaterial, UniformsLib, UniformsUtils, Vector3 } from "three";
import { OFFSETS } from "../engine/surface";
import type { Surface } from "../engine/surface";
import { FINISH_GLSL, SKY_GLSL, WATER_GLSL } from "./air";
import type { Air } from "./air";
import type { Sight } from "./sight";
import { setDefine } from "./sky";
import { drawnWaves, heightAt, refined, roughness } from "./waves";
import type { DrawnWaves } from "./waves";

/**
 * Distances between which the waves fade to level water, in lengths of the hull: beyond them the lines are too far
 * apart to show waves.
 */
const LEVEL_BETWEEN = [1.4, 3.6] as const;
/** Range over which the roughness of the sea is computed, in lines from the middle. */
const ROUGH_LINES = 20;
/** Ripples: size of the tile in lengths of the hull, slope with waves and on still water, speed in tiles per second. */
const TILE = 0.16;
const RIPPLE_SLOPE = { waves: 0.16, still: 0.05 };
const DRIFT_PER_S = 0.03;
/** Share of the light from below the surface, seen steeply: of the usual sea, and of one above lines whose colours matter. */
const CLARITY = { usual: 0.26, above_lines: 0.8 };
/** Share of the light from below the surface where the eye looks at something that is under it. */
const SIGHT = 0.8;
/** Distance of the haze, in lengths of the hull. */
const VISIBILITY = 45;
/** Largest time step of the ripples per frame, s, so that they do not jump after a pause. */
const LONGEST_FRAME_S = 0.1;

/** Shader code for the share of the light from below: more if the surface is seen steeply, and most around the line of sight. */
const CLEAR_GLSL = /* glsl */ `
  uniform vec3 sightTop, sightBottom;
  uniform float sight_m, clarity;
  // Share of the sight at a place: 1 if the ray beyond it passes near the line from the top to the bottom.
  float sightAt(vec3 place, vec3 towards) {
    if (sight_m <= 0.0) return 0.0;
    vec3 way = sightBottom - sightTop, from = place - sightTop;
    float along = dot(towards, way), square = max(dot(way, way), 1e-6);
    float share = (dot(way, from) - along * dot(towards, from)) / max(square - along * along, 1e-6 * square);
    vec3 nearest = sightTop + clamp(share, 0.0, 1.0) * way - place;
    return 1.0 - smoothstep(0.3 * sight_m, sight_m, length(nearest - max(dot(nearest, towards), 0.0) * towards));
  }
  float clearAt(vec3 place, vec3 towards) {
    return max(clarity * smoothstep(0.05, 0.75, -towards.z), ${SIGHT} * sightAt(place, towards));
  }`;

const VERTEX = /* glsl */ `
  #include <common>
  #include <shadowmap_pars_vertex>
  attribute vec2 slope;
  attribute float foam;
  attribute float share;
  uniform float crestHeight_m;
  varying vec3 place;
  varying vec2 slopes;
  varying vec3 cover;
  #ifdef FLAT
    varying vec3 tint;
    ${SKY_GLSL}
    ${WATER_GLSL}
  #endif
  void main() {
    vec4 worldPosition = modelMatrix * vec4(position, 1.0);
    vec4 mvPosition = viewMatrix * worldPosition;
    vec3 transformedNormal = normalMatrix * normalize(vec3(-slope, 1.0));
    place = worldPosition.xyz;
    slopes = slope;
    cover = vec3(foam, 0.34 * clamp(place.z / crestHeight_m, -1.0, 1.0), share);
    gl_Position = projectionMatrix * mvPosition;
    #include <shadowmap_vertex>
    #ifdef FLAT
      vec3 towards = place - cameraPosition;
      float distance_m = length(towards);
      towards /= distance_m;
      vec3 normal = normalize(vec3(-slope, 1.0));
      if (dot(normal, towards) < 0.0) tint = hazed(waterColour(-towards, normal, cover.y, 0.8 * foam, 1.0), towards, distance_m);
      else tint = undersideColour(towards, normal, distance_m);
    #endif
  }`;

const FRAGMENT = /* glsl */ `
  #include <common>
  #include <packing>
  #include <dithering_pars_fragment>
  #include <lights_pars_begin>
  #include <shadowmap_pars_fragment>
  #include <shadowmask_pars_fragment>
  varying vec3 place;
  varying vec2 slopes;
  varying vec3 cover;
  #ifdef FLAT
    varying vec3 tint;
    ${CLEAR_GLSL}
    void main() {
      vec3 towards = normalize(place - cameraPosition);
      gl_FragColor = vec4(tint, towards.z < 0.0 ? 1.0 - clearAt(place, towards) : 1.0);
      ${FINISH_GLSL}
    }
  #else
    uniform vec2 edgeMiddle;
    uniform float edge_m;
    ${CLEAR_GLSL}
    ${SKY_GLSL}
    ${WATER_GLSL}
    // Foam breaks up into streaks and flecks.
    float flecked(float foam, vec2 at) {
      float grain = texture2D(ripples, 1.9 * at / tile_m + 0.5 * drift).x * texture2D(ripples, 0.63 * at.yx / tile_m).y;
      return smoothstep(0.52 - 0.5 * foam, 0.8 - 0.5 * foam, 2.2 * grain) * smoothstep(0.0, 0.4, foam);
    }
    void main() {
      vec3 towards = place - cameraPosition;
      float distance_m = length(towards);
      towards /= distance_m;
      vec2 small = rippleAt(place.xy, distance_m, 1.0 - cover.z);
      vec3 normal = normalize(vec3(-slopes - small, 1.0));
      float light = getShadowMask();
      if (dot(normalize(vec3(-slopes, 1.0)), towards) > 0.0 || !gl_FrontFacing) {
        gl_FragColor = vec4(undersideColour(towards, normal, distance_m), 0.9);
      } else {
        float foam = flecked(cover.x, place.xy);
        vec3 colour = hazed(waterColour(-towards, normal, cover.y, foam, light), towards, distance_m);
        float seenThrough = clearAt(place, towards) * (1.0 - foam);
        float end = 1.0 - smoothstep(0.8 * edge_m, edge_m, length(place.xy - edgeMiddle));
        gl_FragColor = vec4(colour, (1.0 - seenThrough) * end);
      }
      ${FINISH_GLSL}
    }
  #endif`;

/**
 * Surface of the sea around the ship, from the engine's elevations; the shader of the sky draws the level sea beyond.
 */
export class Sea extends Mesh<BufferGeometry, ShaderMaterial> {
  private readonly calm = matchMedia("(prefers-reduced-motion: reduce)");
  private drawn: DrawnWaves | null = null;
  private surface: Surface | null = null;
  private isFine = true;
  private shares: Float32Array<ArrayBuffer> = new Float32Array();
  private last_ms = 0;
  /** Time to which the ripples have drifted, s; null if they drift with the clock. */
  drifted_s: number | null = null;

  constructor(private readonly air: Air) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: DoubleSide,
      transparent: true,
      depthWrite: true,
      dithering: true,
      lights: true,
      forceSinglePass: true,
    });
    super(new BufferGeometry(), material);
    material.uniforms = {
      ...UniformsUtils.clone(UniformsLib.lights),
      ...air,
      crestHeight_m: { value: 1 },
      edge_m: { value: 1 },
      edgeMiddle: { value: [0, 0] },
      clarity: { value: CLARITY.usual },
      sightTop: { value: new Vector3() },
      sightBottom: { value: new Vector3() },
      sight_m: { value: 0 },
    };
    this.frustumCulled = false;
    this.receiveShadow = true;
    this.visible = false;
  }

  /** Sets the level of detail: with or without ripples and interpolated lines. */
  detail(ripples: boolean): void {
    setDefine(this.material, "FLAT", !ripples);
    this.blend(ripples);
    if (ripples === this.isFine && this.shares.length > 0) return;
    this.isFine = ripples;
    this.show(this.surface);
  }

  /** Sets whether something shows through the surface: without ripples only where it is clearer than usual. */
  private blend(ripples: boolean): void {
    const { clarity, sight_m } = this.material.uniforms;
    this.material.transparent = ripples || sight_m.value > 0 || clarity.value > CLARITY.usual;
  }

  /** Shows a surface; null hides the sea. */
  show(surface: Surface | null): void {
    this.visible = surface !== null;
    this.surface = surface;
    if (!surface) return;
    const { x_m, y_m, elevation_m } = this.isFine ? refined(surface) : surface;
    this.lay(x_m.length);
    const drawn = drawnWaves({ x_m, y_m, elevation_m }, (i, j) => this.shares[i * x_m.length + j]);
    this.drawn = drawn;
    const { position, slope, foam } = this.geometry.attributes;
    for (let i = 0, at = 0; i < x_m.length; i++) for (let j = 0; j < y_m.length; j++, at++) position.setXYZ(at, x_m[i], y_m[j], drawn.height_m[at]);
    slope.array.set(drawn.slope);
    foam.array.set(drawn.foam);
    for (const one of [position, slope, foam]) one.needsUpdate = true;
    this.suit(drawn);
  }

  /** Makes the water clear enough for lines and tanks below the surface. */
  showBelow(isClear: boolean): void {
    this.material.uniforms.clarity.value = isClear ? CLARITY.above_lines : CLARITY.usual;
    this.blend(this.isFine);
  }

  /** Makes the water clear around the line of sight to something below the surface; null for nothing. */
  look(sight: Sight | null): void {
    const { sightTop, sightBottom, sight_m } = this.material.uniforms;
    sight_m.value = sight?.radius_m ?? 0;
    if (sight) [sightTop.value, sightBottom.value] = [sight.top, sight.bottom].map((place) => new Vector3(...place));
    this.blend(this.isFine);
  }

  /** Whether there is a sea, visible or not. */
  get isShown(): boolean {
    return this.surface !== null;
  }

  /** Returns the height of the water at a position, m; null if there is no water. */
  heightAt(x: number, y: number): number | null {
    return this.isShown && this.drawn ? heightAt(this.drawn, x, y) : null;
  }

  /** Adapts ripples, haze and colours to the size of the ship and the roughness of the sea. */
  private suit(drawn: DrawnWaves): void {
    const { air } = this;
    const { x_m, y_m, height_m } = drawn;
    const half = (x_m[x_m.length - 1] - x_m[0]) / 2;
    const length_m = half / OFFSETS[OFFSETS.length - 1];
    const rough = roughness(drawn, ROUGH_LINES);
    air.tile_m.value = TILE * length_m;
    air.visibility_m.value = VISIBILITY * length_m;
    air.rippleSlope.value = rough > 0 ? RIPPLE_SLOPE.waves : RIPPLE_SLOPE.still;
    air.farSlope.value = 1.2 * rough;
    const { uniforms } = this.material;
    uniforms.edge_m.value = half;
    uniforms.edgeMiddle.value = [x_m[0] + half, y_m[0] + half];
    let highest = 0.01 * length_m;
    for (const height of height_m) if (height > highest) highest = height;
    uniforms.crestHeight_m.value = highest;
    if (this.drifted_s !== null) this.drift(this.drifted_s);
    else if (rough > 0 && !this.calm.matches) this.driftOn();
  }

  private driftOn(): void {
    const now_ms = performance.now();
    const passed_s = Math.min((now_ms - this.last_ms) / 1000, LONGEST_FRAME_S);
    this.last_ms = now_ms;
    this.drift(passed_s, this.air.drift.value);
  }

  /** Sets the ripples to where they are after a time, from a beginning. */
  private drift(passed_s: number, { x, y } = { x: 0, y: 0 }): void {
    this.air.drift.value.set((x + DRIFT_PER_S * passed_s) % 1000, (y + 0.6 * DRIFT_PER_S * passed_s) % 1000);
  }

  /** Allocates the mesh for a new number of lines along each axis. */
  private lay(lines: number): void {
    if (this.shares.length === lines * lines) return;
    this.shares = sharesOf(lines);
    this.geometry.dispose();
    this.geometry = new BufferGeometry();
    const attribute = (size: number) => new BufferAttribute(new Float32Array(lines * lines * size), size).setUsage(DynamicDrawUsage);
    this.geometry.setAttribute("position", attribute(3));
    this.geometry.setAttribute("slope", attribute(2));
    this.geometry.setAttribute("foam", attribute(1));
    this.geometry.setAttribute("share", new BufferAttribute(this.shares, 1));
    this.geometry.setIndex(triangles(lines));
  }
}

/** Returns the share of the wave at each crossing: 1 around the middle, 0 far away, smooth in between. */
function sharesOf(lines: number): Float32Array<ArrayBuffer> {
  const step = (lines - 1) / (OFFSETS.length - 1);
  const offset = (k: number) => {
    const [low, high] = [OFFSETS[Math.floor(k / step)], OFFSETS[Math.ceil(k / step)]];
    return (low + high) / 2;
  };
  const [from, to] = LEVEL_BETWEEN;
  return Float32Array.from({ length: lines * lines }, (_, at) => {
    const distance = Math.hypot(offset(Math.floor(at / lines)), offset(at % lines));
    const t = Math.min(1, Math.max(0, (distance - from) / (to - from)));
    return 1 - t * t * (3 - 2 * t);
  });
}

/** Returns two triangles for each cell, counter-clockwise as seen from above. */
function triangles(lines: number): number[] {
  const indices: number[] = [];
  for (let i = 0; i + 1 < lines; i++) {
    for (let j = 0; j + 1 < lines; j++) {
      const at = i * lines + j;
      indices.push(at, at + lines, at + 1, at + 1, at + lines, at + lines + 1);
    }
  }
  return indices;
}
