import { Color, Matrix4, Vector3 } from "three";
import type { BodyInfo, DrawnLine, ModelInfo } from "../../engine/engine";
import type { Vec3 } from "../fit";
import { vec3 } from "../fit";
import type { Palette } from "../palette";
import { boxOf, edgesOf, shapedHullOf } from "../solids";
import { anchorsOf, sheavesOf } from "./anchors";
import type { Anchor, Scene } from "./anchors";
import { addBarge } from "./barge";
import { addBoom, isLattice } from "./boom";
import { addBracket, addFoundation, addSponson } from "./bracket";
import { addColumn, cabOf } from "./column";
import type { ColumnShape } from "./column";
import { addCargo, addDrum, addHook, addQuay, addSheave } from "./gear";
import { addBearings, addGimbal, addWheel, trunnionsOf } from "./gyro";
import { outlineOfBox, outlineOfMesh } from "./outline";
import type { Outline } from "./outline";
import { straight } from "./pieces";
import { distance, longestAxis, nearestOf, Place } from "./place";
import { rolesOf, wheelIn } from "./roles";
import { addBoxShell, addMeshShell } from "./shell";
import { addShip } from "./ship";
import { addStays } from "./stays";
import type { Stay } from "./stays";
import { addVehicle } from "./vehicle";
import { boxAround, Work } from "./work";

/** Viewpoint of a person on a body, in the axes of the body. */
export interface Post {
  body: number;
  point: Vec3;
  /** Direction of view in plan, rad. */
  looks_rad: number;
}

/** The bodies drawn as ships and cranes, and the viewpoints of people on them. */
export interface Craft {
  works: Work[];
  cab: Post | null;
  bridge: Post | null;
  /** Index of the body that hangs on the crane; null if there is none. */
  load: number | null;
  stays: Stay[];
}

/** Height of the water line of a hull without data above the keel, as a share of the height of the hull. */
const WATER = 0.42;
/** Largest distance from a solid at which an attachment needs no bracket, m. */
const NEAR_M = 0.02;

/** Collects the data of a run and of its start from which the bodies are drawn. */
export function sceneOf({ model, lines }: { model: ModelInfo; lines: readonly DrawnLine[] }, { poses, line_points }: Pick<Scene, "poses" | "line_points">): Scene {
  const boxes = model.bodies.map((body) => boxOf(body, shapedHullOf(model, body.name)));
  return { model, lines, boxes, roles: rolesOf(model), poses, line_points };
}

/** Draws the bodies of a run from their shapes and their poses at the start. */
export function craftOf(run: Pick<Scene, "model" | "lines">, start: Pick<Scene, "poses" | "line_points">, palette: Palette): Craft {
  return new Builder(sceneOf(run, start), palette).build();
}

class Builder {
  private readonly works: Work[];
  private readonly outlines: (Outline | null)[];
  private cab: Post | null = null;
  private bridge: Post | null = null;
  private load: number | null = null;
  private readonly stays: Stay[] = [];

  constructor(
    private readonly scene: Scene,
    palette: Palette,
  ) {
    const { model, boxes } = scene;
    this.works = model.bodies.map((body, i) => new Work(scene.roles[i] === "hull" && body.colour ? { ...palette, hull: new Color(body.colour) } : palette));
    this.outlines = model.bodies.map((body, i) => {
      const hull = model.hulls.find((one) => one.body === body.name);
      if (scene.roles[i] !== "hull") return null;
      if (hull?.mesh) return outlineOfMesh(hull.mesh, boxes[i], hull);
      const { low, high } = boxes[i];
      // The still water level is at height 0.
      const water_m = model.sea ? -scene.poses[7 * i + 2] : low[2] + WATER * (high[2] - low[2]);
      return outlineOfBox(boxes[i], hull?.origin_m[2] ?? Math.min(high[2], Math.max(low[2], water_m)));
    });
  }

  build(): Craft {
    this.scene.model.bodies.forEach((body, i) => this.addBody(body, i));
    const anchors = anchorsOf(this.scene);
    for (const anchor of anchors) this.addAnchor(anchor);
    for (const { body, middle, radius, axis } of sheavesOf(this.scene)) {
      const along = axis.map(Math.abs);
      addSheave(this.works[body], middle, "xyz"[along.indexOf(Math.max(...along))] as "x" | "y" | "z", radius);
      this.hold(body, middle, 0.3 * radius);
    }
    this.addHooks(anchors);
    this.scene.model.bodies.forEach((_, i) => this.addHinge(i));
    const pushed = new Set(anchors.filter(({ kind }) => kind === "tube").map(({ body }) => body));
    this.scene.roles.forEach((role, i) => role === "boom" && !pushed.has(i) && this.addStays(i));
    return { works: this.works, cab: this.cab, bridge: this.bridge, load: this.load ?? this.lastCarried(), stays: this.stays };
  }

  private addBody(body: BodyInfo, i: number): void {
    const [work, box, role] = [this.works[i], this.scene.boxes[i], this.scene.roles[i]];
    const { shape } = body;
    const colour = new Color(body.colour ?? (shape?.kind === "point" ? work.palette.load : work.palette.plain));
    if (role === "hull") return this.addHull(i);
    if (role === "column" && shape?.kind === "cylinder") return this.addColumn(i, colour);
    if (role === "boom") return this.addBoom(i, colour);
    if (role === "gimbal") return this.addGimbal(i, colour);
    if (shape?.kind === "cylinder" && role === "wheel") return addWheel(work, shape.radius_m, shape.length_m, shape.axis, colour);
    if (shape?.kind === "cylinder" && role === "drum") return addDrum(work, shape.radius_m, shape.length_m, shape.axis, colour);
    if (shape?.kind === "cylinder") return void work.body.turned(straight(shape.radius_m, -shape.length_m / 2, shape.length_m / 2), shape.axis, [0, 0, 0], colour, 32);
    if (role === "quay") return addQuay(work, box, colour);
    if (shape?.kind === "box" && body.is_submerged && this.carries(body)) return addVehicle(work, box, colour);
    if (shape?.kind === "box" && role === "cargo") return addCargo(work, box, colour);
    if (shape?.kind === "box") return void work.body.box(edgesOf(box), [0, 0, 0], colour);
    work.body.ball([0, 0, 0], box.high[0], colour, 40);
  }

  /** Adds the frame of a wheel, and its bearings on the body that carries it. */
  private addGimbal(i: number, colour: Color): void {
    const { model, boxes, poses } = this.scene;
    const body = model.bodies[i];
    const [wheel, turns] = [wheelIn(model, body)?.shape, model.joints.find((joint) => joint.body === body.name)?.axis];
    const carrier = model.bodies.findIndex(({ name }) => name === body.parent);
    if (wheel?.kind !== "cylinder" || !turns) return;
    addGimbal(this.works[i], boxes[i], wheel.radius_m, turns, colour);
    if (carrier < 0) return;
    const [place, on] = [new Place(poses, i), new Place(poses, carrier)];
    const ends = trunnionsOf(boxes[i], turns).map(([, end]) => on.toBody(place.toWorld(end)));
    const height = edgesOf(boxes[i])[2];
    const deck = boxes[carrier].high[2];
    const foot = ends[0][2] > deck ? deck : ends[0][2] - wheel.radius_m;
    addBearings(this.works[carrier], ends, 0.5 * height, foot);
  }

  /** Whether other bodies are joined to a body that is joined to none. */
  private carries({ name, floats }: BodyInfo): boolean {
    return floats && this.scene.model.bodies.some(({ parent }) => parent === name);
  }

  private addHull(i: number): void {
    const { model, boxes, roles, poses } = this.scene;
    const [work, outline] = [this.works[i], this.outlines[i]!];
    const mesh = model.hulls.find((one) => one.body === model.bodies[i].name)?.mesh;
    if (mesh) addMeshShell(work.body, mesh, outline, work.palette);
    else addBoxShell(work.body, outline, work.palette);
    if (!outline.hasDeck) return;
    const hull = new Place(poses, i);
    const obstacles = model.bodies.flatMap((_, k) => {
      if (k === i || roles[k] === "tank" || roles[k] === "hull" || roles[k] === "quay" || model.tanks.some(({ name }) => name === model.bodies[k].name)) return [];
      const place = new Place(poses, k);
      const { low, high } = boxes[k];
      const corners = [low[0], high[0]].flatMap((x) => [low[1], high[1]].flatMap((y) => [low[2], high[2]].map((z): Vec3 => [x, y, z])));
      return [boxAround(corners.map((corner) => hull.toBody(place.toWorld(corner))))];
    });
    if (!outline.isShip) return addBarge(work, outline, obstacles);
    const bridge = addShip(work, outline, obstacles);
    if (bridge && !this.bridge) this.bridge = { body: i, point: bridge, looks_rad: 0 };
  }

  private addColumn(i: number, colour: Color): void {
    const { model, roles, poses, boxes } = this.scene;
    const { shape, parent } = model.bodies[i];
    if (shape?.kind !== "cylinder") return;
    const boom = roles.findIndex((role, k) => role === "boom" && model.bodies[k].parent === model.bodies[i].name);
    const column: ColumnShape = { radius: shape.radius_m, length: shape.length_m, boom_rad: boom < 0 ? 0 : this.boomCourse(boom, i), hasCab: boom >= 0 };
    addColumn(this.works[i], column, colour);
    if (boom >= 0 && !this.cab) {
      const { middle, looks_rad } = cabOf(column);
      this.cab = { body: i, point: middle, looks_rad };
    }
    const hull = model.bodies.findIndex(({ name }) => name === parent);
    const outline = this.outlines[hull];
    if (!outline) return;
    const foot = new Place(poses, hull).toBody(new Place(poses, i).toWorld([0, 0, boxes[i].low[2]]));
    const deck = outline.box.high[2];
    const isOut = [0, 1, 2, 3, 4, 5, 6, 7].some((k) => {
      const [x, y] = [foot[0] + shape.radius_m * Math.cos((k * Math.PI) / 4), foot[1] + shape.radius_m * Math.sin((k * Math.PI) / 4)];
      return x < outline.box.low[0] || x > outline.box.high[0] || Math.abs(y) > outline.halfAt(x);
    });
    if (isOut && foot[2] < deck) addSponson(this.works[hull], foot, shape.radius_m, outline.box.low[2], deck);
    else addFoundation(this.works[hull], [foot[0], foot[1], Math.max(deck, foot[2])], shape.radius_m);
  }

  private addBoom(i: number, colour: Color): void {
    const { model, roles, boxes } = this.scene;
    const body = model.bodies[i];
    const axis = longestAxis(boxes[i]);
    const edges = edgesOf(boxes[i]);
    const parent = model.bodies.findIndex(({ name }) => name === body.parent);
    const [along, width, height] = [[0, 1, 2], [1, 0, 2], [2, 1, 0]][axis].map((k) => edges[k]);
    const isFirst = roles[parent] !== "boom";
    const isLast = !roles.some((role, k) => role === "boom" && model.bodies[k].parent === body.name);
    const work = new Work(this.works[i].palette);
    addBoom(work, { length: along, width, height, isRound: body.shape?.kind === "cylinder", isFirst, isLast }, colour);
    work.move(this.turnOfBoom(i, parent, axis));
    this.works[i].body.take(work.body);
    this.works[i].fittings.take(work.fittings);
  }

  /** Returns the transform to the body's axes from the axes of a boom along x, with its foot at the smaller end. */
  private turnOfBoom(i: number, parent: number, axis: number): Matrix4 {
    const turn = new Matrix4();
    if (axis === 1) turn.makeRotationZ(Math.PI / 2);
    if (axis === 2) turn.makeRotationY(-Math.PI / 2);
    return this.footSide(i, parent, axis) > 0 ? turn.multiply(new Matrix4().makeRotationZ(Math.PI)) : turn;
  }

  /** Adds stays to a slender boom on a column, if nothing else supports the boom. */
  private addStays(i: number): void {
    const { model, roles, boxes } = this.scene;
    const { parent, shape } = model.bodies[i];
    const under = model.bodies.findIndex(({ name }) => name === parent);
    const column = model.bodies[under]?.shape;
    const edges = edgesOf(boxes[i]);
    const axis = longestAxis(boxes[i]);
    const [length, width, height] = [[0, 1, 2], [1, 0, 2], [2, 1, 0]][axis].map((k) => edges[k]);
    if (roles[under] !== "column" || column?.kind !== "cylinder" || shape?.kind !== "box" || !isLattice(length, width, height)) return;
    const turn = this.turnOfBoom(i, under, axis);
    const toBody = (along: number, across: number, up: number) => new Vector3(along, across, up).applyMatrix4(turn).toArray();
    const stays = addStays(this.works[under], { body: under, radius: column.radius_m, head: column.length_m / 2, boom_rad: this.boomCourse(i, under) }, { body: i, length, width, height, toBody });
    this.stays.push(...stays);
  }

  /** Returns the direction of a boom in plan, in the axes of its carrier, rad. */
  private boomCourse(boom: number, column: number): number {
    const { poses } = this.scene;
    const [x, y] = new Place(poses, column).toBody(new Place(poses, boom).toWorld([0, 0, 0]));
    return Math.atan2(y, x);
  }

  /** Returns the sign of the end of a body, along an axis, that is nearer to its carrier. */
  private footSide(i: number, parent: number, axis: number): number {
    const { boxes, poses, model } = this.scene;
    const away = [boxes[i].low[axis], boxes[i].high[axis]].map((end) => {
      const world = new Place(poses, i).toWorld(vec3((k) => (k === axis ? end : 0)));
      const point = new Place(poses, parent).toBody(world);
      return distance(point, nearestOf(model.bodies[parent], boxes[parent], point));
    });
    return away[1] < away[0] ? 1 : -1;
  }

  /** Adds a bracket from a column to the foot of its boom, if there is a gap. */
  private addHinge(i: number): void {
    const { model, roles, boxes, poses } = this.scene;
    const parent = model.bodies.findIndex(({ name }) => name === model.bodies[i].parent);
    if (roles[i] !== "boom" || parent < 0) return;
    const axis = longestAxis(boxes[i]);
    const side = this.footSide(i, parent, axis);
    const end = side > 0 ? boxes[i].high[axis] : boxes[i].low[axis];
    const foot = new Place(poses, i).toWorld(vec3((k) => (k === axis ? end : 0)));
    if (roles[parent] === "column") this.hold(parent, new Place(poses, parent).toBody(foot), 0.16 * Math.min(...edgesOf(boxes[i])));
  }

  private addAnchor({ body, point, radius, kind }: Anchor): void {
    if (this.scene.roles[body] === "cargo" && kind === "line") return;
    this.hold(body, point, radius);
  }

  /** Adds a bracket to a point outside a body's solid. */
  private hold(body: number, point: Vec3, radius: number): void {
    const { model, boxes } = this.scene;
    const outline = this.outlines[body];
    const nearest = outline ? nearestOnHull(outline, point) : nearestOf(model.bodies[body], boxes[body], point);
    if (distance(nearest, point) < NEAR_M) return;
    const size = Math.min(0.3, Math.max(0.05, radius, 0.05 * Math.min(...edgesOf(boxes[body]))));
    const [x, y] = [Math.abs(point[0] - nearest[0]), Math.abs(point[1] - nearest[1])];
    addBracket(this.works[body], nearest, point, outline || x < y ? [1, 0, 0] : [0, 1, 0], size);
  }

  /** Returns the last body that a boom carries and that is neither a boom nor a drum; null if there is none. */
  private lastCarried(): number | null {
    const { model, roles } = this.scene;
    const isOnBoom = (i: number) => roles[model.bodies.findIndex(({ name }) => name === model.bodies[i].parent)] === "boom";
    return roles.flatMap((role, i) => (role !== "boom" && role !== "drum" && isOnBoom(i) ? [i] : [])).pop() ?? null;
  }

  /** Adds a hook to each load that hangs on a single line. */
  private addHooks(anchors: readonly Anchor[]): void {
    const { roles, boxes, model, poses } = this.scene;
    roles.forEach((role, i) => {
      const { shape, mass_kg } = model.bodies[i];
      const own = anchors.filter(({ body, kind, towards }) => body === i && kind === "line" && new Place(poses, i).toWorld(towards)[2] > new Place(poses, i).toWorld([0, 0, 0])[2]);
      if (own.length !== 1 || role === "hull" || role === "boom" || role === "column" || role === "quay" || role === "drum") return;
      const [{ point, towards, length }] = own;
      const top = Math.max(point[2], shape?.kind === "box" || shape?.kind === "sphere" || shape?.kind === "point" ? boxes[i].high[2] : point[2]);
      if (towards[2] <= 0 || towards[2] < 0.5 * Math.hypot(...towards)) return;
      const share = (top - point[2]) / towards[2];
      const eye = vec3((k) => point[k] + share * towards[k]);
      this.load ??= i;
      addHook(this.works[i], eye, Math.min(0.55 * Math.cbrt(mass_kg / 1000), 0.3 * length));
    });
  }
}

/** Returns the point of a hull nearest to a position; the position itself if it is inside the hull. */
function nearestOnHull({ box, halfAt }: Outline, [x, y, z]: Vec3): Vec3 {
  const along = Math.min(box.high[0], Math.max(box.low[0], x));
  const half = halfAt(along);
  return [along, Math.min(half, Math.max(-half, y)), Math.min(box.high[2], Math.max(box.low[2], z))];
}
