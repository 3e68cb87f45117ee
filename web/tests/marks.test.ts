import { expect, it } from "vitest";
import { marksOf, wordsNear } from "../src/ui/marks";

const at = (time_s: number, text = "taut") => ({ time_s, code: "comes_taut", name: "rope", text });

it("events are marked along the track, and close events share a mark", () => {
  const marks = marksOf([at(0), at(5), at(5.01, "slack"), at(10)], 0, 20);
  expect(marks).toEqual([
    { share: 0, words: "0.00 s, rope: taut" },
    { share: 0.25, words: "5.00 s, rope: taut\n5.01 s, rope: slack" },
    { share: 0.5, words: "10.00 s, rope: taut" },
  ]);
  expect(marksOf([at(0)], 0, 0)).toEqual([]);
});

it("a mark names a few events and counts the others", () => {
  const [{ words }] = marksOf(Array.from({ length: 9 }, () => at(1)), 0, 20);
  expect(words.split("\n").length).toBe(5);
  expect(words).toMatch(/and 5 more$/);
});

it("the text at a position is that of the nearest mark", () => {
  const marks = marksOf([at(5), at(5.3, "slack")], 0, 20);
  expect(wordsNear(marks, 0.251, 0.02)).toContain("taut");
  expect(wordsNear(marks, 0.264, 0.02)).toContain("slack");
  expect(wordsNear(marks, 0.4, 0.02)).toBe("");
  expect(wordsNear([], 0.4, 0.02)).toBe("");
});
