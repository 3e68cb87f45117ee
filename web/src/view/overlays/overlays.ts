import { Color, Group } from "three";
import type { Run } from "../../app/session";
import type { Moment } from "../../app/recording/recording";
import type { Equations, Hydrostatics } from "../../engine/engine";
import { Place } from "../craft/place";
import type { Vec3 } from "../fit";
import { vec3 } from "../fit";
import type { Fleet } from "../fleet";
import type { Palette } from "../palette";
import { Arrows } from "./arrows";
import type { Arrow } from "./arrows";
import { floatingSignsOf } from "./floating_signs";
import type { FloatingSigns } from "./floating_signs";
import { loadsAt } from "./forces";
import type { Load } from "./forces";
import { Ghost } from "./ghost";
import { jointAxesOf } from "./joint_axes";
import type { JointAxis } from "./joint_axes";
import { ArrowScale } from "./scale";
import { CentreSigns, Letters, Strokes } from "./signs";

export const OVERLAYS = ["forces", "axes", "masses", "buoyancy", "trace", "ghost"] as const;
export type Overlay = (typeof OVERLAYS)[number];

/** Another run in the picture: the poses of its bodies and its colour. */
export interface OtherRun {
  poses: ArrayLike<number>;
  /** Name of one of the theme's colours. */
  colour: string;
}

/** Opacity of the bodies of another run. */
const OTHER_OPACITY = 0.35;
/** Half length of a joint's axis, and length of a buoyancy arrow, relative to the size of the model. */
const AXIS = 0.06;
const UP = 0.16;

/** Overlays over the bodies, which the user switches on. */
export class Overlays extends Group {
  readonly on = new Set<Overlay>();
  /** Scales of the arrows, m in the picture per N and per N m; 0 if no arrow is drawn. */
  metresPer = { force: 0, moment: 0 };
  private readonly parts = { arrows: new Arrows(), axes: new Strokes(), masses: new CentreSigns(), heights: new Strokes(), letters: new Letters(), path: new Strokes(false), ghost: new Ghost(), other: new Ghost(OTHER_OPACITY) };
  private readonly scales = { force: new ArrowScale(), moment: new ArrowScale() };
  private isBlank = false;
  private jointAxes: JointAxis[] = [];
  /** Bodies whose geometry the ghost shares. */
  private ghostOf: unknown = null;
  private otherOf: unknown = null;
  private floating: { at: Hydrostatics; signs: FloatingSigns[] } | null = null;

  constructor(private readonly fleet: Fleet) {
    super();
    this.add(...Object.values(this.parts));
    this.parts.other.visible = false;
  }

  /** Prepares for another run, or for a reset. */
  begin(): void {
    this.jointAxes = [];
    this.floating = null;
    for (const scale of Object.values(this.scales)) scale.reset();
  }

  /** Keeps the scales of the arrows, or lets them change again. */
  hold(isHeld: boolean): void {
    for (const scale of Object.values(this.scales)) scale.isHeld = isHeld;
  }

  /** Takes the matrices from the second engine, computed for the run at these poses. */
  hearEquations(run: Run, equations: Equations, poses: ArrayLike<number>): void {
    this.jointAxes = jointAxesOf(run.model, equations, poses);
  }

  hearHydrostatics(found: Hydrostatics): void {
    this.floating = { at: found, signs: [] };
  }

  /** Shows the overlays of a moment; `path` returns the earlier positions of the load. */
  show(run: Run, moment: Moment, start: ArrayLike<number>, path: () => readonly Vec3[], palette: Palette): void {
    const { parts, on, fleet } = this;
    const { poses } = moment;
    // This runs sixty times a second: it should not allocate needlessly.
    if (on.size === 0 && this.isBlank) return;
    this.isBlank = on.size === 0;
    if (on.has("buoyancy") && this.floating) this.floating.signs = floatingSignsOf(run.model, this.floating.at, poses);
    const signs = on.has("buoyancy") ? (this.floating?.signs ?? []) : [];
    const loads = on.has("forces") ? loadsAt(run, moment) : [];
    parts.arrows.show([...this.arrowsOf(loads, palette), ...signs.map(({ buoyancy }): Arrow => ({ from: buoyancy.at, way: [0, 0, UP * fleet.size], colour: palette.axes.z }))], fleet.size);
    const axes = on.has("axes") ? this.jointAxes.map((axis) => this.strokeOf(axis, poses)) : [];
    parts.axes.show(axes, palette.axes.y);
    parts.masses.show(on.has("masses") ? run.model.bodies.map((_, i) => new Place(poses, i).toWorld([0, 0, 0])) : []);
    parts.heights.show(signs.map(({ line }) => line), palette.axes.x);
    parts.letters.show(signs.flatMap(({ letters }) => letters), palette.label, palette.halo);
    const places = on.has("trace") ? path() : [];
    parts.path.show(places.slice(1).map((place, i) => [places[i], place] as const), palette.load);
    parts.arrows.visible = loads.length + signs.length > 0;
    parts.axes.visible = axes.length > 0;
    parts.masses.visible = on.has("masses");
    parts.heights.visible = signs.length > 0;
    parts.path.visible = places.length > 1;
    this.showGhost(start, palette);
  }

  private showGhost(start: ArrayLike<number>, palette: Palette): void {
    const { ghost } = this.parts;
    ghost.visible = this.on.has("ghost");
    if (!ghost.visible) return;
    ghost.paint(palette.axes.z);
    if (this.ghostOf !== this.fleet.bodies) ghost.show(this.fleet.bodies, start);
    this.ghostOf = this.fleet.bodies;
    ghost.compare(this.fleet.bodies, this.fleet.size);
  }

  /** Shows the bodies of another run; null for none. */
  showOther(run: OtherRun | null): void {
    const { other } = this.parts;
    other.visible = run !== null;
    if (!run) return;
    other.paint(new Color(getComputedStyle(document.documentElement).getPropertyValue(`--${run.colour}`).trim()));
    if (this.otherOf !== this.fleet.bodies) other.show(this.fleet.bodies, run.poses);
    this.otherOf = this.fleet.bodies;
    other.place(run.poses);
    other.compare(this.fleet.bodies, this.fleet.size);
  }

  private arrowsOf(loads: readonly Load[], palette: Palette): Arrow[] {
    const { size } = this.fleet;
    const of = (unit: Load["unit"]) => loads.filter((load) => load.unit === unit);
    this.metresPer = { force: loads.length > 0 ? this.scales.force.of(of("N"), size) : 0, moment: loads.length > 0 ? this.scales.moment.of(of("N m"), size) : 0 };
    return loads.map(({ at, vector, unit }) => {
      const isMoment = unit === "N m";
      const factor = isMoment ? this.metresPer.moment : this.metresPer.force;
      return { from: at, way: vec3((k) => vector[k] * factor), colour: isMoment ? palette.axes.z : palette.axes.x, isMoment };
    });
  }

  private strokeOf({ body, point, direction }: JointAxis, poses: ArrayLike<number>): [Vec3, Vec3] {
    const place = new Place(poses, body);
    const end = (sign: number) => place.toWorld(vec3((k) => point[k] + sign * AXIS * this.fleet.size * direction[k]));
    return [end(-1), end(1)];
  }
}
