import type { Box } from "../fit";
import { LAMPS } from "./house";
import type { Outline } from "./outline";
import { addStrakes } from "./ship";
import { overlap } from "./work";
import type { Work } from "./work";

/** Number of frame lines on the deck. */
const FRAMES = 8;

/**
 * Adds the equipment of a barge: a coaming, bollards, fenders, hatches, plates, and an arrow to the bow; no equipment
 * stands on obstacles.
 */
export function addBarge(work: Work, outline: Outline, obstacles: readonly Box[]): void {
  const { box } = outline;
  const [length, beam, height] = [0, 1, 2].map((k) => box.high[k] - box.low[k]);
  const [cx, cy, deck] = [(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2, box.high[2]];
  const size = Math.min(0.35, 0.04 * beam);
  const free = (x: number, y: number, reach: number) => {
    const room = { low: [x - reach, y - reach, deck + 0.02], high: [x + reach, y + reach, deck + 3 * size] } as const;
    return !obstacles.some((one) => overlap(one, room));
  };
  const { fittings, palette } = work;
  for (let k = 1; k < FRAMES; k++) {
    const x = box.low[0] + (k / FRAMES) * length;
    fittings.box([0.004 * length, 0.86 * beam, 0.012], [x, cy, deck + 0.008], palette.deck.clone().multiplyScalar(0.78));
  }
  for (const side of [-1, 1]) {
    const y = cy + side * (beam / 2 - 1.7 * size);
    for (const share of [-0.42, -0.2, 0.2, 0.42]) {
      const x = cx + share * length;
      if (!free(x, y, 2 * size)) continue;
      addBollard(work, x, y, deck, size);
    }
    addFenders(work, box, side, size);
    fittings.box([0.9 * length, 0.006 * beam, 0.012], [cx, cy + side * 0.43 * beam, deck + 0.01], palette.marking);
    const lamp = [box.high[0] - 2.5 * size, cy + side * (beam / 2 - 2 * size)] as const;
    if (!free(...lamp, size)) continue;
    fittings.rod([...lamp, deck], [...lamp, deck + 3 * size], 0.12 * size, palette.fitting, 6);
    work.lit.ball([...lamp, deck + 3.2 * size], 0.4 * size, side > 0 ? LAMPS.port : LAMPS.starboard);
  }
  addHatches(work, outline, free, size);
  addArrow(work, outline);
  if (height > 4 * size) addStrakes(work, outline);
}

/** Adds a bollard: two posts on a plate. */
function addBollard({ fittings, palette }: Work, x: number, y: number, deck: number, size: number): void {
  fittings.box([3 * size, 1.1 * size, 0.1 * size], [x, y, deck + 0.05 * size], palette.fitting);
  for (const end of [-1, 1]) {
    const line = [[0, 0], [0.32 * size, 0], [0.32 * size, 1.1 * size], [0.42 * size, 1.15 * size], [0.42 * size, 1.3 * size], [0, 1.3 * size]] as const;
    fittings.turned(line, "z", [x + end * 0.9 * size, y, deck], palette.fitting, 12);
  }
}

/** Adds upright rubber fenders along a side. */
function addFenders({ fittings, palette }: Work, box: Box, side: number, size: number): void {
  const [length, height] = [box.high[0] - box.low[0], box.high[2] - box.low[2]];
  const count = Math.max(3, Math.round(length / (14 * size)));
  const y = side > 0 ? box.high[1] : box.low[1];
  for (let k = 0; k < count; k++) {
    const x = box.low[0] + ((k + 0.5) / count) * length;
    fittings.box([0.8 * size, 0.7 * size, 0.3 * height], [x, y, box.high[2] - 0.26 * height], palette.fitting);
  }
}

/** Adds the manholes of the tanks. */
function addHatches({ fittings, palette }: Work, { box }: Outline, free: (x: number, y: number, reach: number) => boolean, size: number): void {
  const [length, beam] = [box.high[0] - box.low[0], box.high[1] - box.low[1]];
  const [cx, cy] = [(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2];
  for (const [u, v] of [[-0.34, 0.3], [-0.34, -0.3], [0.05, 0.34], [0.05, -0.34]] as const) {
    const [x, y] = [cx + u * length, cy + v * beam];
    if (!free(x, y, 1.5 * size)) continue;
    fittings.turned([[0, 0], [0.9 * size, 0], [0.9 * size, 0.45 * size], [1.05 * size, 0.45 * size], [1.05 * size, 0.6 * size], [0, 0.6 * size]], "z", [x, y, box.high[2]], palette.house, 16);
  }
}

/** Adds an arrow that shows the bow from any side. */
function addArrow({ fittings, palette }: Work, { box }: Outline): void {
  const [length, beam] = [box.high[0] - box.low[0], box.high[1] - box.low[1]];
  const [cx, cy] = [(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2];
  fittings.prism(bowArrowPlan(length, beam).map(([x, y]) => [cx + x, cy + y] as const), box.high[2] + 0.004, box.high[2] + 0.018, palette.marking);
}

/** Returns the outline of an arrow along a deck of this length and width, about its centre. */
function bowArrowPlan(l: number, w: number): [number, number][] {
  const [tip, root, wing, stem] = [0.43 * l, 0.31 * l, 0.19 * w, 0.045 * w];
  return [[tip, 0], [root, wing], [root, stem], [0.12 * l, stem], [0.12 * l, -stem], [root, -stem], [root, -wing]];
}
