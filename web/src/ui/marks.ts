import { fixed } from "../app/format";
import type { Happened } from "../engine/messages";
import { texts } from "../texts";

/** Largest distance of events that share one mark, as a share of the track. */
const TOGETHER = 1 / 150;
/** Largest number of events that a mark names; it counts the others. */
const MOST_WORDS = 4;

/** A mark of events on the track. */
export interface Mark {
  /** Position on the track, from 0 at the start to 1 at the end. */
  share: number;
  words: string;
}

/** Returns the marks of events, in order of time; events that are close together on the track share one mark. */
export function marksOf(happened: readonly Happened[], from_s: number, to_s: number): Mark[] {
  const length_s = to_s - from_s;
  if (length_s <= 0) return [];
  const together: { share: number; all: Happened[] }[] = [];
  for (const one of happened) {
    const share = Math.min(1, Math.max(0, (one.time_s - from_s) / length_s));
    const last = together.at(-1);
    if (last && share - last.share < TOGETHER) last.all.push(one);
    else together.push({ share, all: [one] });
  }
  return together.map(({ share, all }) => ({ share, words: wordsOf(all) }));
}

function wordsOf(all: Happened[]): string {
  const words = all.slice(0, MOST_WORDS).map(({ time_s, name, text }) => `${fixed(time_s, 2)} s, ${name}: ${text}`);
  return [...words, ...(all.length > MOST_WORDS ? [texts.scrubber.more(all.length - MOST_WORDS)] : [])].join("\n");
}

/** Returns the text of the nearest mark; empty if none is within `near`. */
export function wordsNear(marks: readonly Mark[], share: number, near: number): string {
  const away = (mark: Mark) => Math.abs(mark.share - share);
  const nearest = marks.reduce<Mark | null>((so, mark) => (so && away(so) <= away(mark) ? so : mark), null);
  return nearest && away(nearest) <= Math.max(near, TOGETHER / 2) ? nearest.words : "";
}
