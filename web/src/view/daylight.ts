import { DirectionalLight, Group, HemisphereLight, Mesh, PMREMGenerator, Scene } from "three";
import type { Texture, WebGLRenderer, WebGLRenderTarget } from "three";
import { paintAir, TO_SUN } from "./air";
import type { Air } from "./air";
import type { Palette } from "./palette";
import type { Tier } from "./quality";
import { Sky } from "./sky";

/** Intensities of the lights: of the sky if it is a light source, otherwise of a plain light. */
const LIGHT = {
  day: { sun: 2.3, sky: 0.6, plain: 1.15 },
  night: { sun: 2.1, sky: 2.2, plain: 1.7 },
};
/** Range of the shadows, relative to the size of the objects. */
const REACH = 1.1;
/** Height of the eye that sees the sky as a light, relative to the distance of the haze. */
const EYE = 0.02;

/** The sky, the sun with its shadows, and the ambient light. */
export class Daylight extends Group {
  readonly sky: Sky;
  private readonly sun = new DirectionalLight(0xffffff);
  private readonly plain = new HemisphereLight();
  private surroundings: WebGLRenderTarget | null = null;
  private isDark = false;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly air: Air,
  ) {
    super();
    this.sky = new Sky(air);
    this.sun.castShadow = true;
    this.sun.shadow.bias = -0.0004;
    this.sun.shadow.radius = 2.2;
    this.plain.position.set(0, 0, 1);
    this.add(this.sky, this.sun, this.sun.target, this.plain);
  }

  paint(palette: Palette): void {
    this.isDark = palette.isDark;
    paintAir(this.air, palette);
    this.sky.paint(palette);
    this.plain.groundColor.set(palette.isDark ? 0x46566a : 0x9aa8b5);
  }

  /** Sets the surroundings, a sea or a plain room; returns whether they have changed. */
  surround(hasSea: boolean): boolean {
    if (this.sky.hasSea === hasSea) return false;
    this.sky.hasSea = hasSea;
    return true;
  }

  /** Sets the level of detail; returns the sky as a light, or null for a plain light. */
  detail(tier: Tier): Texture | null {
    this.sky.detail(tier.ripples);
    if (this.sun.shadow.mapSize.x !== tier.shadowSize) {
      this.sun.shadow.mapSize.setScalar(tier.shadowSize);
      this.sun.shadow.map?.dispose();
      this.sun.shadow.map = null;
    }
    const light = this.isDark ? LIGHT.night : LIGHT.day;
    this.sun.intensity = light.sun;
    this.plain.intensity = tier.ripples ? 0 : light.plain;
    this.surroundings?.dispose();
    this.surroundings = tier.ripples ? this.rendered() : null;
    return this.surroundings?.texture ?? null;
  }

  get skyLight(): number {
    return (this.isDark ? LIGHT.night : LIGHT.day).sky;
  }

  /** Moves the sun with the ship, so that the shadow stays sharp while she drifts. */
  follow(x: number, y: number, z: number, size: number): void {
    this.sun.target.position.set(x, y, z);
    this.sun.position.copy(TO_SUN).multiplyScalar(2.4 * size).add(this.sun.target.position);
    const { camera, mapSize } = this.sun.shadow;
    camera.left = camera.bottom = -REACH * size;
    camera.right = camera.top = REACH * size;
    camera.far = 6 * size;
    camera.updateProjectionMatrix();
    this.sun.shadow.normalBias = (2.5 * REACH * size) / mapSize.x;
  }

  /** Renders the sky over level water as a light from all directions, which does not depend on the present picture. */
  private rendered(): WebGLRenderTarget {
    const { air } = this;
    const generator = new PMREMGenerator(this.renderer);
    const room = new Scene();
    const dome = new Mesh(this.sky.geometry, this.sky.material);
    dome.frustumCulled = false;
    const [under, ripples, far] = [air.underWater.value, air.rippleSlope.value, air.farSlope.value];
    air.underWater.value = false;
    air.rippleSlope.value = air.farSlope.value = 0;
    this.sky.lookFrom(0, 0, EYE * air.visibility_m.value);
    const target = generator.fromScene(room.add(dome), 0.02, 0.1, 10, { size: 128 });
    [air.underWater.value, air.rippleSlope.value, air.farSlope.value] = [under, ripples, far];
    generator.dispose();
    return target;
  }
}
