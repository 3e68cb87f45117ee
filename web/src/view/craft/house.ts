import { Color } from "three";
import type { Vec3 } from "../fit";
import { planBetween } from "./outline";
import type { Outline } from "./outline";
import { lofted } from "./pieces";
import type { Plan } from "./pieces";
import type { Work } from "./work";

/** Site of a deckhouse: its ends along the hull, the deck below it, and the height of one storey, m. */
export interface Site {
  from: number;
  to: number;
  deck: number;
  storey: number;
  /** 1 if the front faces forward along x, otherwise -1. */
  looks: 1 | -1;
}

/** Number of storeys below the wheelhouse. */
const STOREYS = 3;
/** Colours of the side lights. */
export const LAMPS = { port: new Color(0xd93a35), starboard: new Color(0x1f9d55) };

/** Adds accommodation, a wheelhouse with wings, a mast and funnels; returns the viewpoint of the officer. */
export function addHouse(work: Work, outline: Outline, site: Site): Vec3 {
  const { storey, from, to } = site;
  const length = to - from;
  const most = Math.max(outline.halfAt(from), outline.halfAt(to));
  for (let k = 0; k < STOREYS; k++) {
    const [aft, fore] = site.looks > 0 ? [from + 0.05 * k * length, to - 0.035 * k * length] : [from + 0.035 * k * length, to - 0.05 * k * length];
    const plan = planBetween(outline, aft, fore, (0.1 + 0.03 * k) * most, 0.84 * most);
    const low = site.deck + k * storey;
    work.fittings.prism(plan, low, low + storey, work.palette.house);
    // Walkway around each storey except the lowest.
    if (k > 0) work.fittings.prism(grown(plan, 0.32 * storey), low - 0.03 * storey, low + 0.03 * storey, work.palette.fitting);
    addWindows(work, plan, low + 0.5 * storey, storey);
  }
  const bridge = site.deck + STOREYS * storey;
  addBridge(work, outline, site, bridge);
  addFunnels(work, site, most, bridge);
  addBoats(work, site, most);
  return [site.looks > 0 ? to - 0.1 * length : from + 0.1 * length, 0, bridge + 0.62 * storey];
}

/** Returns a plan that is enlarged outward from its middle on each side. */
export function grown(plan: Plan, by: number): Plan {
  const ends = [0, 1].map((k) => plan.map((place) => place[k])).map((values) => [Math.min(...values), Math.max(...values)]);
  const share = ends.map(([low, high]) => ({ middle: (low + high) / 2, factor: 1 + (2 * by) / Math.max(1e-6, high - low) }));
  const moved = (value: number, k: number) => share[k].middle + share[k].factor * (value - share[k].middle);
  return plan.map(([x, y]) => [moved(x, 0), moved(y, 1)]);
}

/** Adds a row of evenly spaced windows along the walls of a plan. */
function addWindows(work: Work, plan: Plan, z: number, storey: number): void {
  const [wide, high, apart, proud] = [0.26 * storey, 0.3 * storey, 0.72 * storey, 0.03 * storey];
  let passed = 0;
  plan.forEach((from, i) => {
    const to = plan[(i + 1) % plan.length];
    const wall = Math.hypot(to[0] - from[0], to[1] - from[1]);
    const [u, v] = [(to[0] - from[0]) / wall, (to[1] - from[1]) / wall];
    for (let next = (Math.floor(passed / apart) + 0.5) * apart; next < passed + wall; next += apart) {
      if (next < passed) continue;
      const at = next - passed;
      const corner = (along: number, out: number) => [from[0] + (at + along) * u + out * v, from[1] + (at + along) * v - out * u] as const;
      work.lit.prism([corner(-wide / 2, -proud), corner(wide / 2, -proud), corner(wide / 2, proud), corner(-wide / 2, proud)], z, z + high, work.palette.window);
    }
    passed += wall;
  });
}

/** Adds the wheelhouse: glass all around that leans outward, wings to the sides, and a roof with the mast. */
function addBridge(work: Work, outline: Outline, site: Site, low: number): void {
  const { storey, from, to, looks } = site;
  const { fittings, lit, palette } = work;
  const length = to - from;
  const [aft, fore] = looks > 0 ? [from + 0.42 * length, to - 0.06 * length] : [from + 0.06 * length, to - 0.42 * length];
  const half = 0.78 * Math.max(outline.halfAt(aft), outline.halfAt(fore));
  const plan = planBetween(outline, aft, fore, 0, half);
  const [sill, head, roof] = [low + 0.34 * storey, low + 0.84 * storey, low + storey];
  const lean = 0.11 * storey;
  fittings.add(lofted([{ z: low, plan }, { z: sill, plan }]), palette.house);
  lit.add(lofted([{ z: sill, plan: grown(plan, -0.01) }, { z: head, plan: grown(plan, lean) }]), palette.window);
  fittings.add(lofted([{ z: head, plan: grown(plan, lean) }, { z: roof, plan: grown(plan, 1.6 * lean) }]), palette.house);
  addMullions(work, plan, sill, head, lean);
  const wing = 0.5 * (aft + fore);
  const span = outline.halfAt(wing) + 0.05 * half;
  fittings.box([0.3 * (fore - aft), 2 * span, 0.08 * storey], [wing, 0, low], palette.fitting);
  for (const side of [1, -1]) {
    fittings.box([0.3 * (fore - aft), 0.06 * storey, 0.4 * storey], [wing, side * (span - 0.03 * storey), low + 0.2 * storey], palette.house);
    lit.ball([wing + 0.1 * (fore - aft) * looks, side * span, low + 0.5 * storey], 0.09 * storey, side > 0 ? LAMPS.port : LAMPS.starboard);
  }
  addMast(work, site, (aft + fore) / 2, roof);
}

/** Adds the posts between the panes. */
function addMullions(work: Work, plan: Plan, sill: number, head: number, lean: number): void {
  const outer = grown(plan, lean);
  const count = plan.length;
  for (let i = 0; i < count; i++) {
    const [from, to, top, topTo] = [plan[i], plan[(i + 1) % count], outer[i], outer[(i + 1) % count]];
    const panes = Math.max(1, Math.round(Math.hypot(to[0] - from[0], to[1] - from[1]) / (1.1 * (head - sill))));
    for (let k = 0; k < panes; k++) {
      const t = k / panes;
      const along = (a: readonly [number, number], b: readonly [number, number], z: number) => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), z] as const;
      work.fittings.rod(along(from, to, sill), along(top, topTo, head), 0.05 * (head - sill), work.palette.house, 4);
    }
  }
}

/** Adds a mast with stays, radar scanners and lamps. */
function addMast(work: Work, { storey, looks }: Site, x: number, z: number): void {
  const { fittings, lit, palette } = work;
  const height = 2.5 * storey;
  const foot = 0.55 * storey;
  for (const side of [1, -1]) fittings.rod([x - looks * foot, side * foot, z], [x, 0, z + 0.72 * height], 0.07 * storey, palette.house, 6);
  fittings.rod([x, 0, z], [x, 0, z + height], 0.12 * storey, palette.house, 8, 0.05 * storey);
  for (const [share, wide] of [[0.42, 1.15], [0.66, 0.8]] as const) {
    fittings.rod([x + looks * 0.25 * storey, 0, z + share * height], [x, 0, z + share * height], 0.06 * storey, palette.house, 6);
    fittings.box([0.1 * storey, wide * storey, 0.1 * storey], [x + looks * 0.34 * storey, 0, z + share * height + 0.1 * storey], palette.fitting);
  }
  fittings.rod([x, -0.7 * storey, z + 0.8 * height], [x, 0.7 * storey, z + 0.8 * height], 0.035 * storey, palette.house, 6);
  for (const side of [1, -1]) fittings.ball([x - looks * 0.6 * storey, side * 0.9 * storey, z + 0.35 * storey], 0.3 * storey, palette.house);
  lit.ball([x, 0, z + height], 0.08 * storey, palette.window);
}

/** Adds a funnel on each side behind the wheelhouse. */
function addFunnels(work: Work, { storey, from, to, looks }: Site, most: number, top: number): void {
  const length = to - from;
  const x = looks > 0 ? from + 0.16 * length : to - 0.16 * length;
  const [long, wide] = [0.16 * length, 0.24 * most];
  for (const side of [1, -1]) {
    const y = side * 0.46 * most;
    const low = top - 0.2 * storey;
    const band = (from_z: number, to_z: number, colour: Color) => work.fittings.box([long, wide, to_z - from_z], [x, y, (from_z + to_z) / 2], colour);
    band(low, low + 0.75 * storey, work.palette.house);
    band(low + 0.75 * storey, low + 1.1 * storey, work.palette.hull);
    band(low + 1.1 * storey, low + 1.3 * storey, work.palette.fitting);
    for (const k of [-1, 1]) work.fittings.rod([x + 0.2 * k * long, y, low + 1.3 * storey], [x + 0.2 * k * long - 0.1 * looks * storey, y, low + 1.7 * storey], 0.09 * storey, work.palette.fitting);
  }
}

/** Adds lifeboats on the sides of the lowest storey. */
function addBoats(work: Work, { storey, from, to, deck, looks }: Site, most: number): void {
  const x = looks > 0 ? from + 0.2 * (to - from) : to - 0.2 * (to - from);
  const [radius, half] = [0.32 * storey, 0.95 * storey];
  const line: [number, number][] = [[0, -half], [0.6 * radius, -0.85 * half], [radius, -0.45 * half], [radius, 0.45 * half], [0.6 * radius, 0.85 * half], [0, half]];
  for (const side of [1, -1]) {
    const y = side * 0.97 * most;
    work.fittings.turned(line, "x", [x, y, deck + 1.35 * storey], work.palette.load, 14);
    for (const end of [-0.6, 0.6]) work.fittings.rod([x + end * half, 0.8 * y, deck + 0.9 * storey], [x + end * half, y, deck + 1.75 * storey], 0.06 * storey, work.palette.house, 6);
  }
}
