import type { Box, Vec3 } from "../fit";
import { addHouse, grown } from "./house";
import type { Site } from "./house";
import { planBetween } from "./outline";
import type { Outline } from "./outline";
import { overlap } from "./work";
import type { Work } from "./work";

/** Height of a storey, as a share of the hull's length, and its upper bound, m. */
const STOREY = { share: 1 / 30, most_m: 2.8 };
/** Positions of a deckhouse, as shares of the length from the stern: forward if there is space, otherwise aft. */
const SITES = [
  { from: 0.6, to: 0.82, looks: 1 },
  { from: 0.05, to: 0.25, looks: 1 },
] as const;
/** Start of the forecastle, as a share of the length from the stern. */
const FORECASTLE = 0.57;
/** Height that a deckhouse needs above the deck, storeys. */
const ROOM = 8;

/**
 * Adds the equipment on a ship's deck and sides, except at obstacles; returns the viewpoint of her bridge. Hull axes.
 */
export function addShip(work: Work, outline: Outline, obstacles: readonly Box[]): Vec3 | null {
  const { box } = outline;
  const length = box.high[0] - box.low[0];
  const storey = Math.min(STOREY.most_m, STOREY.share * length);
  const at = (share: number) => box.low[0] + share * length;
  const deck = box.high[2];
  const isFree = (from: number, to: number, high: number) => {
    const room = { low: [at(from), box.low[1], deck + 0.02], high: [at(to), box.high[1], deck + high] } as const;
    return !obstacles.some((one) => overlap(one, room));
  };
  const hasForecastle = isFree(FORECASTLE, 1, storey);
  if (hasForecastle) addForecastle(work, outline, at(FORECASTLE), storey);
  let bridge: Vec3 | null = null;
  const site = SITES.find(({ from, to }) => isFree(from, to, ROOM * storey));
  if (site) {
    const stands = deck + (hasForecastle && site.from > FORECASTLE ? storey : 0);
    const place: Site = { from: at(site.from), to: at(site.to), deck: stands, storey, looks: site.looks };
    bridge = addHouse(work, outline, place);
  }
  addWorkingDeck(work, outline, site && site.from < 0.5 ? at(site.to) : box.low[0], hasForecastle ? at(FORECASTLE) : at(0.96), storey);
  addStrakes(work, outline);
  return bridge;
}

/** Adds the raised deck at the bow, with its bulwark, windlass and mooring bitts. */
function addForecastle(work: Work, outline: Outline, from: number, storey: number): void {
  const { fittings, palette } = work;
  const { box } = outline;
  const [deck, bow] = [box.high[2], box.high[0]];
  const plan = planBetween(outline, from, bow - 0.003 * (bow - box.low[0]));
  const flared = grown(plan, 0.06 * storey);
  fittings.prism(plan, deck - 0.01, deck + storey, palette.hull);
  fittings.prism(planBetween(outline, from, bow - 0.02 * (bow - box.low[0]), 0.08 * storey), deck + storey - 0.05, deck + storey + 0.02, palette.deck);
  // The bulwark is open at its after end: two sides that meet at the stem.
  const inner = planBetween(outline, from, bow - 0.012 * (bow - box.low[0]), 0.04 * storey);
  const wall = [...flared, ...[...inner].reverse()];
  fittings.prism(wall, deck + storey, deck + 1.42 * storey, palette.hull);
  fittings.prism(wall, deck + 1.42 * storey, deck + 1.47 * storey, palette.stripe);
  const windlass = bow - 0.1 * (bow - box.low[0]);
  const reach = outline.halfAt(windlass);
  fittings.turned([[0, -0.55 * reach], [0.2 * storey, -0.55 * reach], [0.2 * storey, 0.55 * reach], [0, 0.55 * reach]], "y", [windlass, 0, deck + 1.3 * storey], palette.fitting, 16);
  fittings.box([0.5 * storey, 0.5 * reach, 0.3 * storey], [windlass, 0, deck + 1.12 * storey], palette.fitting);
}

/** Adds cargo rails along the sides, planks between them, and a roller at the stern. */
function addWorkingDeck(work: Work, outline: Outline, from: number, to: number, storey: number): void {
  const { fittings, palette } = work;
  const { box } = outline;
  const deck = box.high[2];
  const half = Math.min(outline.halfAt(from + 0.02 * (to - from)), outline.halfAt(to));
  const wood = palette.deck.clone().multiplyScalar(0.72);
  const margin = 0.45 * storey;
  const [aft, fore] = [from + 0.5 * storey, to - 0.3 * storey];
  fittings.box([fore - aft, 2 * (half - margin), 0.02], [(aft + fore) / 2, 0, deck + 0.012], wood);
  for (const side of [1, -1]) {
    fittings.box([fore - aft, 0.05 * storey, 0.01], [(aft + fore) / 2, side * (half - margin), deck + 0.025], palette.marking);
    addRail(work, aft, fore, side * (half - 0.1 * storey), deck, storey);
  }
  const roller = 0.16 * storey;
  if (from === box.low[0]) fittings.turned([[0, -0.5 * half], [roller, -0.5 * half], [roller, 0.5 * half], [0, 0.5 * half]], "y", [box.low[0], 0, deck - 0.3 * roller], palette.fitting, 16);
}

/** Adds a railing: posts with three bars. */
function addRail({ fittings, palette }: Work, from: number, to: number, y: number, deck: number, storey: number): void {
  const height = 0.42 * storey;
  const bar = 0.028 * storey;
  const count = Math.max(2, Math.round((to - from) / (0.9 * storey)));
  for (let k = 0; k <= count; k++) {
    const x = from + (k / count) * (to - from);
    fittings.rod([x, y, deck], [x, y, deck + height], bar, palette.fitting, 4);
  }
  for (const share of [0.35, 0.68, 1]) fittings.rod([from, y, deck + share * height], [to, y, deck + share * height], bar, palette.fitting, 5);
}

/** Adds a rubbing strake along both sides below the edge of the deck, and a strake of paint. */
export function addStrakes({ fittings, palette }: Work, outline: Outline): void {
  const { box } = outline;
  const [length, height] = [box.high[0] - box.low[0], box.high[2] - box.low[2]];
  const thick = 0.008 * (box.high[1] - box.low[1]);
  const [from, to] = [box.low[0] + 0.004 * length, box.high[0] - (outline.isShip ? 0.06 : 0.004) * length];
  const sides = planBetween(outline, from, to);
  const half = sides.length / 2;
  for (const side of [sides.slice(0, half), sides.slice(half)]) {
    const sign = side[0][1] < 0 ? -1 : 1;
    const wall = [...side, ...[...side].reverse().map(([x, y]) => [x, y + sign * thick] as const)];
    const low = box.high[2] - 0.09 * height;
    fittings.prism(wall, low, low + 0.035 * height, palette.fitting);
  }
}
