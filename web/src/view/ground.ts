import { DoubleSide, Group, Mesh, PlaneGeometry, ShaderMaterial, ShadowMaterial } from "three";
import type { Palette } from "./palette";

const VERTEX = /* glsl */ `
  varying vec2 place;
  void main() {
    vec4 world = modelMatrix * vec4(position, 1.0);
    place = world.xy;
    gl_Position = projectionMatrix * viewMatrix * world;
  }`;

const FRAGMENT = /* glsl */ `
  varying vec2 place;
  uniform vec3 line, xAxis, yAxis;
  uniform vec2 centre;
  uniform float spacing, reach, strength;
  // Share of a pixel that is covered by lines of 1.5 pixels at the multiples of a spacing.
  float lines(vec2 p, float every) {
    vec2 q = p / every;
    vec2 away = abs(fract(q - 0.5) - 0.5) / fwidth(q);
    return 1.0 - min(min(away.x, away.y) / 0.75, 1.0);
  }
  float axis(float p) {
    return 1.0 - min(abs(p) / fwidth(p) / 1.25, 1.0);
  }
  void main() {
    float fade = 1.0 - smoothstep(0.25 * reach, reach, length(place - centre));
    vec3 colour = line;
    float cover = max(0.55 * lines(place, spacing), lines(place, 4.0 * spacing)) * strength;
    float onX = axis(place.y) * step(0.0, place.x), onY = axis(place.x) * step(0.0, place.y);
    colour = mix(colour, xAxis, onX);
    colour = mix(colour, yAxis, onY);
    cover = max(cover, 0.8 * max(onX, onY));
    gl_FragColor = vec4(colour, max(cover, 0.05) * fade);
    #include <colorspace_fragment>
  }`;

/** The plane z = 0: a grid that fades out, the world's x and y axes, and a faint shadow. */
export class Ground extends Group {
  private readonly grid: ShaderMaterial;
  private readonly shadow: ShadowMaterial;

  constructor() {
    super();
    this.grid = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
      uniforms: {
        line: { value: null },
        xAxis: { value: null },
        yAxis: { value: null },
        centre: { value: [0, 0] },
        spacing: { value: 5 },
        reach: { value: 100 },
        strength: { value: 0.5 },
      },
    });
    this.shadow = new ShadowMaterial({ transparent: true, depthWrite: false });
    const grid = new Mesh(new PlaneGeometry(2000, 2000), this.grid);
    const shadow = new Mesh(new PlaneGeometry(400, 400), this.shadow);
    shadow.receiveShadow = true;
    shadow.position.z = -0.01;
    this.add(grid, shadow);
  }

  paint(palette: Palette): void {
    this.grid.uniforms.line.value = palette.grid;
    this.grid.uniforms.xAxis.value = palette.axes.x;
    this.grid.uniforms.yAxis.value = palette.axes.y;
    this.grid.uniforms.strength.value = palette.isDark ? 0.42 : 0.5;
    this.shadow.opacity = palette.isDark ? 0.3 : 0.13;
  }

  /** Sets the spacing of the grid, m. */
  space(spacing: number): void {
    this.grid.uniforms.spacing.value = spacing;
  }

  /** Makes the grid fade with the distance from a position, within a few sizes of the model. */
  reachFrom(x: number, y: number, size: number): void {
    this.grid.uniforms.centre.value = [x, y];
    this.grid.uniforms.reach.value = 6 * size;
  }
}
