export type Vec3 = readonly [number, number, number];

/** Returns a vector of three components, each computed from its index. */
export function vec3(of: (k: number) => number): [number, number, number] {
  return [of(0), of(1), of(2)];
}

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function unit(a: Vec3): Vec3 {
  const length = Math.hypot(...a) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
}

/** Rotates v by the unit quaternion w, x, y, z. */
export function rotate([w, x, y, z]: readonly [number, number, number, number], v: Vec3): Vec3 {
  const t = cross([x, y, z], v);
  const u = cross([x, y, z], [t[0] + w * v[0], t[1] + w * v[1], t[2] + w * v[2]]);
  return [v[0] + 2 * u[0], v[1] + 2 * u[1], v[2] + 2 * u[2]];
}

/** A box in body axes, by its smallest and its largest corner. */
export interface Box {
  low: Vec3;
  high: Vec3;
}

/** Returns the eight corners of each body's box in the world; poses are x y z qw qx qy qz for each body. */
export function cornersOf(poses: ArrayLike<number>, boxes: readonly Box[]): Vec3[] {
  return boxes.flatMap(({ low, high }, body) => {
    const at = 7 * body;
    const turn = [poses[at + 3], poses[at + 4], poses[at + 5], poses[at + 6]] as const;
    return CORNERS.map(([x, y, z]): Vec3 => {
      const v = rotate(turn, [x ? high[0] : low[0], y ? high[1] : low[1], z ? high[2] : low[2]]);
      return [poses[at] + v[0], poses[at + 1] + v[1], poses[at + 2] + v[2]];
    });
  });
}

/** Largest distance of a followed body from the first one, in distances of the farthest corner at the start. */
const STRAYED = 2;

/** Returns the distance of the farthest corner of all boxes from the first body, m. */
export function reachOf(poses: ArrayLike<number>, boxes: readonly Box[]): number {
  return cornersOf(poses, boxes).reduce((reach, [x, y, z]) => Math.max(reach, Math.hypot(x - poses[0], y - poses[1], z - poses[2])), 0);
}

/**
 * Returns the corners of the bodies that belong in the picture: all except those that have gone far from the first
 * body, for example a load that was lost. `reach` is the reach at the start of the run, m.
 */
export function gatheredCorners(poses: ArrayLike<number>, boxes: readonly Box[], reach: number): Vec3[] {
  const corners = cornersOf(poses, boxes);
  const isNear = ([x, y, z]: Vec3) => Math.hypot(x - poses[0], y - poses[1], z - poses[2]) <= STRAYED * reach;
  return boxes.flatMap((_, body) => {
    const own = corners.slice(CORNERS.length * body, CORNERS.length * (body + 1));
    return body === 0 || own.every(isNear) ? own : [];
  });
}

const CORNERS = [0, 1].flatMap((x) => [0, 1].flatMap((y) => [0, 1].map((z) => [x, y, z])));

export function middleOf(points: readonly Vec3[]): Vec3 {
  const middle = (i: number) => {
    const values = points.map((point) => point[i]);
    return (Math.min(...values) + Math.max(...values)) / 2;
  };
  return [middle(0), middle(1), middle(2)];
}

export interface Lens {
  /** Vertical field of view, rad. */
  fov: number;
  /** Ratio of width to height. */
  aspect: number;
}

/** Returns a target and a distance of the eye at which the points fill the picture with equal margins. */
export function frame(points: readonly Vec3[], back: Vec3, up: Vec3, lens: Lens): { target: Vec3; distance: number } {
  const right = unit(cross(up, back));
  const top = cross(back, right);
  let target = middleOf(points);
  let distance = fitDistance(points, target, back, up, lens);
  for (let i = 0; i < 8; i++) {
    const seen = points.map((point) => {
      const p: Vec3 = [point[0] - target[0], point[1] - target[1], point[2] - target[2]];
      const depth = distance - dot(p, back);
      return [dot(p, right) / depth, dot(p, top) / depth];
    });
    const off = [0, 1].map((k) => {
      const values = seen.map((place) => place[k]);
      return ((Math.min(...values) + Math.max(...values)) / 2) * distance;
    });
    target = vec3((k) => target[k] + off[0] * right[k] + off[1] * top[k]);
    distance = fitDistance(points, target, back, up, lens);
  }
  return { target, distance };
}

/**
 * Returns the smallest distance of the eye from `target`, along the unit vector `back`, at which every point is in the
 * picture. `up` need not be perpendicular to `back`.
 */
export function fitDistance(points: readonly Vec3[], target: Vec3, back: Vec3, up: Vec3, lens: Lens): number {
  const right = unit(cross(up, back));
  const top = cross(back, right);
  const tanY = Math.tan(lens.fov / 2);
  const tanX = tanY * lens.aspect;
  return points.reduce((distance, point) => {
    const p: Vec3 = [point[0] - target[0], point[1] - target[1], point[2] - target[2]];
    const needed = dot(p, back) + Math.max(Math.abs(dot(p, right)) / tanX, Math.abs(dot(p, top)) / tanY);
    return Math.max(distance, needed);
  }, 0);
}

/** A rectangle on the screen, pixels; y is positive downwards. */
export interface Area {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** Returns the best uncovered part of a picture of this size; by default the largest part. */
export function roomIn(width: number, height: number, covers: readonly Area[], worth: (area: Area) => number = sizeOf): Area {
  const edges = (ends: number[], of: (cover: Area) => number) => [...ends, ...covers.map(of)];
  const covered = (area: Area) => covers.some((one) => one.left < area.right && one.right > area.left && one.top < area.bottom && one.bottom > area.top);
  const whole: Area = { left: 0, top: 0, right: width, bottom: height };
  let best: Area | undefined;
  let most = 0;
  for (const left of edges([0], (cover) => cover.right)) {
    for (const right of edges([width], (cover) => cover.left)) {
      for (const top of edges([0], (cover) => cover.bottom)) {
        for (const bottom of edges([height], (cover) => cover.top)) {
          const area = { left, top, right, bottom };
          if (sizeOf(area) === 0 || covered(area)) continue;
          const found = worth(area);
          if (found > most) [best, most] = [area, found];
        }
      }
    }
  }
  return best ?? whole;
}

function sizeOf({ left, top, right, bottom }: Area): number {
  return Math.max(0, right - left) * Math.max(0, bottom - top);
}

/** Returns the factor by which an eye steps back so that a picture shows at least what another lens shows; at least 1. */
export function backOf(lens: Lens, least: Lens): number {
  const [tan, needed] = [lens, least].map(({ fov }) => Math.tan(fov / 2));
  return Math.max(1, needed / tan, (needed * least.aspect) / (tan * lens.aspect));
}
