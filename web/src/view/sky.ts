import { BackSide, Color, Mesh, ShaderMaterial, SphereGeometry } from "three";
import { FINISH_GLSL, SKY_GLSL, WATER_GLSL } from "./air";
import type { Air } from "./air";
import type { Palette } from "./palette";

const VERTEX = /* glsl */ `
  varying vec3 direction;
  void main() {
    direction = position;
    gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * position, 1.0);
    gl_Position.z = gl_Position.w;
  }`;

const FRAGMENT = /* glsl */ `
  #include <common>
  #include <dithering_pars_fragment>
  varying vec3 direction;
  uniform bool hasSea, underWater;
  uniform vec3 studioHigh, studioLow, eye;
  ${SKY_GLSL}
  ${WATER_GLSL}
  // The level sea up to the horizon, which needs no mesh.
  vec3 farSea(vec3 towards) {
    float distance_m = max(eye.z, 0.2) / max(-towards.z, 1e-5);
    #ifdef FLAT
    vec3 normal = vec3(0.0, 0.0, 1.0);
    #else
    vec2 place = eye.xy + distance_m * towards.xy;
    vec3 normal = normalize(vec3(-rippleAt(place, distance_m, 1.0), 1.0));
    #endif
    return hazed(waterColour(-towards, normal, 0.0, 0.0, 1.0), towards, distance_m);
  }
  void main() {
    vec3 towards = normalize(direction);
    if (!hasSea) {
      // A soft transition between a floor and a wall that darkens upwards.
      float wall = smoothstep(-0.12, 0.75, towards.z);
      gl_FragColor = vec4(mix(studioLow, studioHigh, max(wall, 0.7 * smoothstep(0.1, -0.9, towards.z))), 1.0);
      #include <colorspace_fragment>
      #include <dithering_fragment>
      return;
    }
    vec3 colour = farSea(towards);
    if (towards.z >= 0.0) colour = skyColour(towards) + sunDisc(towards);
    if (underWater) colour = depths(towards);
    gl_FragColor = vec4(colour, 1.0);
    ${FINISH_GLSL}
  }`;

/** Background: sky and level sea up to the horizon, or a plain room if there is no sea. */
export class Sky extends Mesh<SphereGeometry, ShaderMaterial> {
  private readonly eye = new Float32Array(3);
  private readonly own = {
    hasSea: { value: false },
    studioHigh: { value: new Color() },
    studioLow: { value: new Color() },
  };

  constructor(air: Air) {
    super(
      new SphereGeometry(1, 32, 24).rotateX(Math.PI / 2),
      new ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, side: BackSide, depthWrite: false, dithering: true }),
    );
    this.material.uniforms = { ...air, ...this.own, eye: { value: this.eye } };
    this.frustumCulled = false;
    // The background is drawn after the opaque objects, so that only the remaining pixels are painted.
    this.renderOrder = 1;
    this.onBeforeRender = (_renderer, _scene, { matrixWorld }) => this.lookFrom(...(matrixWorld.elements.slice(12, 15) as [number, number, number]));
  }

  lookFrom(...eye: [x: number, y: number, z: number]): void {
    this.eye.set(eye);
  }

  paint(palette: Palette): void {
    this.own.studioHigh.value.copy(palette.studioHigh);
    this.own.studioLow.value.copy(palette.studioLow);
  }

  get hasSea(): boolean {
    return this.own.hasSea.value;
  }

  set hasSea(hasSea: boolean) {
    this.own.hasSea.value = hasSea;
  }

  /** Sets the level of detail: with ripples, or with flat colours. */
  detail(ripples: boolean): void {
    setDefine(this.material, "FLAT", !ripples);
  }
}

/** Adds a definition to a shader, or removes it. */
export function setDefine(material: ShaderMaterial, name: string, defined: boolean): void {
  if (name in material.defines === defined) return;
  if (defined) material.defines[name] = "";
  else delete material.defines[name];
  material.needsUpdate = true;
}
