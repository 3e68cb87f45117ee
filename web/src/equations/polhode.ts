import type { Run, Session } from "../app/session";
import { texts } from "../texts";
import { make, setText } from "../ui/dom";
import { vec3 } from "../view/fit";
import { circlesOf, energyEllipsoid, inertiaOf, momentumOf, momentumSphere, rigidsOf, sizeOf } from "./momentum";
import type { Rigid, Vector } from "./momentum";

/** Length of the drawn path, s. */
const PATH_S = 120;
/** Size of the picture in CSS pixels; it is drawn with twice as many. */
const SIZE_PX = 300;
/** Share of the picture that the larger of the two surfaces fills. */
const FILLS = 0.9;
/** Rotation of the view by one press of a key, and by a drag of one pixel, rad. */
const KEY_TURN = Math.PI / 18;
const DRAG_TURN = 0.01;

/**
 * Angular momentum of a body, with all bodies fixed to it, about their centre of mass and in body axes. It is drawn
 * with the momentum sphere and the energy ellipsoid, on which the polhode of a free body lies.
 */
export class Polhode {
  readonly element: HTMLElement;
  private readonly choice = make("select", { "aria-label": texts.equations.polhode_body, "data-testid": "polhode-body" });
  private readonly canvas = make("canvas", { width: 2 * SIZE_PX, height: 2 * SIZE_PX, class: "polhode", tabindex: 0, role: "img" });
  private readonly words = make("p", { class: "muted" });
  private readonly details: HTMLDetailsElement;
  /** Angles of the view: about the vertical, and elevation, rad. */
  private view: [number, number] = [0.7, 0.5];
  private run: Run | null = null;
  private rigids: Rigid[] = [];

  constructor(private readonly session: Session) {
    const { polhode, polhode_help } = texts.equations;
    this.details = make("details", { class: "fold" }, make("summary", {}, polhode), make("div", { class: "fold-body" }, this.choice, this.canvas, this.words, make("p", { class: "muted" }, polhode_help)));
    this.element = this.details;
    this.choice.addEventListener("change", () => this.show());
    this.details.addEventListener("toggle", () => this.show());
    this.canvas.addEventListener("pointermove", ({ buttons, movementX, movementY }) => buttons && this.turn(DRAG_TURN * movementX, DRAG_TURN * movementY));
    this.canvas.addEventListener("keydown", (event) => this.key(event));
  }

  begin(run: Run): void {
    this.run = run;
    this.rigids = rigidsOf(run.model);
    const nameOf = (rigid: Rigid) => rigid.map((body) => run.model.bodies[body].name).join(" + ");
    this.choice.replaceChildren(...this.rigids.map((rigid, k) => make("option", { value: k }, nameOf(rigid))));
    this.show();
  }

  show(): void {
    const { run } = this;
    const { recording, time_s, moment } = this.session.shown;
    if (!run || !recording || !moment || !this.details.open) return;
    const rigid = this.rigids[Number(this.choice.value)];
    const { bodies } = run.model;
    const inertia = inertiaOf(rigid, bodies, moment.poses);
    const places = ["x", "y", "z"].map((axis) => run.columns.at(`${bodies[rigid[0]].name}.angular_velocity.${axis}`));
    const momentumIn = (row: ArrayLike<number>) => momentumOf(inertia, vec3((k) => row[places[k]]));
    const { items } = recording.rows;
    const from = Math.max(0, recording.rows.indexAt(time_s - PATH_S));
    const path = items.slice(from, recording.rows.indexAt(time_s) + 1).map(({ row }) => momentumIn(row));
    const now = momentumIn(moment.row);
    const omega = vec3((k) => moment.row[places[k]]);
    const energy_J = (omega[0] * now[0] + omega[1] * now[1] + omega[2] * now[2]) / 2;
    this.draw(path, now, energy_J, inertia);
    const text = texts.equations.polhode_now(sizeOf(now).toPrecision(3), energy_J.toPrecision(3));
    setText(this.words, text);
    this.canvas.setAttribute("aria-label", text);
  }

  private draw(path: readonly Vector[], now: Vector, energy_J: number, inertia: number[][]): void {
    const pen = this.canvas.getContext("2d")!;
    const surfaces = [momentumSphere(sizeOf(now)), energyEllipsoid(inertia, energy_J)];
    const reach = Math.max(...surfaces.map((surface) => Math.max(surface([1, 0, 0])[0], surface([0, 1, 0])[1], surface([0, 0, 1])[2])));
    const scale = (FILLS * SIZE_PX) / (reach || 1);
    const style = getComputedStyle(this.canvas);
    const colour = (name: string) => style.getPropertyValue(name);
    pen.setTransform(1, 0, 0, 1, SIZE_PX, SIZE_PX);
    pen.clearRect(-SIZE_PX, -SIZE_PX, 2 * SIZE_PX, 2 * SIZE_PX);
    surfaces.forEach((surface, k) => {
      pen.strokeStyle = colour(k === 0 ? "--yaw" : "--roll");
      for (const circle of circlesOf(surface)) this.trace(pen, circle, scale, 1.4);
    });
    pen.strokeStyle = colour("--ink");
    this.trace(pen, path, scale, 5);
    const [x, y] = this.seen(now);
    pen.fillStyle = colour("--accent");
    pen.globalAlpha = 1;
    pen.beginPath();
    pen.arc(scale * x, -scale * y, 9, 0, 2 * Math.PI);
    pen.fill();
  }

  /** The hidden parts are fainter. */
  private trace(pen: CanvasRenderingContext2D, points: readonly Vector[], scale: number, width: number): void {
    pen.lineWidth = width;
    const seen = points.map((point) => this.seen(point));
    for (let k = 1; k < seen.length; k++) {
      const [[x, y], [u, v, depth]] = [seen[k - 1], seen[k]];
      pen.globalAlpha = depth > 0 ? 0.9 : 0.25;
      pen.beginPath();
      pen.moveTo(scale * x, -scale * y);
      pen.lineTo(scale * u, -scale * v);
      pen.stroke();
    }
  }

  /** Components of a vector in the view: to the right, up, and towards the eye. */
  private seen([x, y, z]: Vector): Vector {
    const [around, above] = this.view;
    const [c, s] = [Math.cos(around), Math.sin(around)];
    const [right, away] = [c * x - s * y, s * x + c * y];
    const [cosine, sine] = [Math.cos(above), Math.sin(above)];
    return [right, cosine * z + sine * away, sine * z - cosine * away];
  }

  private turn(around: number, above: number): void {
    const [before, height] = this.view;
    this.view = [before + around, Math.max(-Math.PI / 2, Math.min(Math.PI / 2, height + above))];
    this.show();
  }

  private key(event: KeyboardEvent): void {
    const turns: Record<string, Vector> = { ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 1, 0], ArrowDown: [0, -1, 0] };
    const turn = turns[event.key];
    if (!turn) return;
    event.preventDefault();
    this.turn(KEY_TURN * turn[0], KEY_TURN * turn[1]);
  }
}
