import { Color, Vector2, Vector3 } from "three";
import type { DataTexture } from "three";
import type { Palette } from "./palette";
import { ripplesOf } from "./ripples";

/** Direction to the sun: astern and to starboard, high enough for short shadows. */
export const TO_SUN = new Vector3(-0.72, -0.46, 1.05).normalize();

/** Brightness of sky and water relative to the theme's colours, which tone mapping darkens again. */
const BRIGHTNESS = { day: 1.15, night: 1 };

/** Values that the shaders of sky and sea share, so that sky and sea meet without a visible edge. */
export type Air = ReturnType<typeof airOf>;

export function airOf() {
  const ripples: { value: DataTexture | null } = { value: null };
  return {
    zenith: { value: new Color() },
    haze: { value: new Color() },
    sunColour: { value: new Color() },
    deep: { value: new Color() },
    shallow: { value: new Color() },
    foamColour: { value: new Color() },
    toSun: { value: TO_SUN },
    /** Distance at which haze takes most of the colour, m. */
    visibility_m: { value: 3000 },
    /** Size of a tile of ripples, m. */
    tile_m: { value: 20 },
    /** Slope of the ripples, and of the waves beyond the engine's grid. */
    rippleSlope: { value: 0 },
    farSlope: { value: 0 },
    /** Displacement of the ripples, in tiles. */
    drift: { value: new Vector2() },
    ripples,
    underWater: { value: false },
  };
}

/** Sets the colours of air and water from the theme. */
export function paintAir(air: Air, palette: Palette): void {
  const brightness = palette.isDark ? BRIGHTNESS.night : BRIGHTNESS.day;
  const paint = (uniform: { value: Color }, colour: Color) => uniform.value.copy(colour).multiplyScalar(brightness);
  paint(air.zenith, palette.zenith);
  paint(air.haze, palette.haze);
  paint(air.sunColour, palette.sun);
  paint(air.deep, palette.deep);
  paint(air.shallow, palette.shallow);
  paint(air.foamColour, palette.foam);
  air.ripples.value ??= ripplesOf();
}

/** Shader code for the colour of the sky in a direction; on and below the horizon it is the colour of the horizon. */
export const SKY_GLSL = /* glsl */ `
  uniform vec3 zenith, haze, sunColour, toSun;
  vec3 skyColour(vec3 direction) {
    float up = clamp(direction.z, 0.0, 1.0);
    vec3 colour = mix(haze, zenith, 1.0 - pow(1.0 - up, 3.2));
    float near = max(dot(direction, toSun), 0.0);
    return colour + sunColour * (0.16 * pow(near, 5.0) + 0.5 * pow(near, 90.0));
  }
  vec3 sunDisc(vec3 direction) {
    return sunColour * 9.0 * smoothstep(0.9993, 0.9997, dot(direction, toSun));
  }`;

/** Shader code for the water: its colour, the mirrored sky, the ripples, and the view from below. */
export const WATER_GLSL = /* glsl */ `
  uniform vec3 deep, shallow, foamColour;
  uniform vec2 drift;
  uniform sampler2D ripples;
  uniform float visibility_m, tile_m, rippleSlope, farSlope;

  #ifndef FLAT
  // Slopes of the small waves at a place, and a share of far waves; each layer moves differently.
  vec2 rippleAt(vec2 place, float distance_m, float far) {
    vec2 at = place / tile_m;
    float seen = 1.0 / (1.0 + distance_m / (14.0 * tile_m));
    vec2 slope = texture2D(ripples, at + drift).xy + texture2D(ripples, 2.7 * at.yx - 1.6 * drift).xy - 1.0;
    vec2 swell = texture2D(ripples, 0.11 * at - 0.1 * drift).xy + texture2D(ripples, 0.043 * at.yx + 0.05 * drift).xy - 1.0;
    return rippleSlope * seen * slope + far * farSlope * swell;
  }
  #endif

  vec3 waterColour(vec3 toEye, vec3 normal, float crest, float foam, float light) {
    float facing = clamp(dot(normal, toEye), 0.0, 1.0);
    float mirror = 0.02 + 0.72 * pow(1.0 - facing, 5.0);
    vec3 mirrored = reflect(-toEye, normal);
    mirrored.z = abs(mirrored.z) + 0.04;
    mirrored = normalize(mirrored);
    vec3 body = mix(deep, shallow, clamp(0.25 * facing + crest, 0.0, 1.0)) * mix(0.62, 1.0, light);
    vec3 colour = mix(body, skyColour(mirrored), mirror);
    #ifndef FLAT
    colour += sunColour * light * (0.9 * pow(max(dot(mirrored, toSun), 0.0), 220.0));
    #endif
    return mix(colour, foamColour * mix(0.65, 1.0, light), foam);
  }

  // Mixes a colour with haze over the water: at the horizon only the haze is left, in the colour of the sky there.
  vec3 hazed(vec3 colour, vec3 direction, float distance_m) {
    float clear = exp(-distance_m / visibility_m);
    return mix(skyColour(normalize(vec3(direction.xy, 0.0))), colour, clear);
  }

  // Colour of deep water in a direction: dark below, lighter towards the surface.
  vec3 depths(vec3 direction) {
    vec3 lit = mix(deep, shallow, 0.75);
    return mix(0.35 * deep, lit, smoothstep(-0.9, 1.0, direction.z));
  }

  // Colour of the surface from below: the sky in a round window, and the deep water mirrored around it.
  vec3 undersideColour(vec3 direction, vec3 normal, float distance_m) {
    vec3 beyond = refract(direction, -normal, 1.33);
    vec3 mirrored = depths(reflect(direction, -normal));
    float through = dot(beyond, beyond) > 0.0 ? smoothstep(0.0, 0.45, beyond.z) : 0.0;
    vec3 colour = mix(mirrored + 0.05 * shallow, 0.5 * skyColour(beyond) * (0.35 + shallow) + 0.45 * shallow, through);
    return mix(depths(direction), colour, exp(-2.2 * distance_m / tile_m / 14.0));
  }`;

/** Last lines of each of these shaders. */
export const FINISH_GLSL = /* glsl */ `
    #include <tonemapping_fragment>
    #include <colorspace_fragment>
    #include <dithering_fragment>`;
