import { expect, it } from "vitest";
import { LOWEST, Quality, TIERS } from "../src/view/quality";

/** Draws windows of 30 frames of this length; returns how often the level has changed. */
function draw(quality: Quality, windows: number, interval_ms: number): number {
  return Array.from({ length: 30 * windows }, () => quality.drew(interval_ms)).filter(Boolean).length;
}

it("the level of detail decreases while frames are slow, down to the lowest", () => {
  const quality = new Quality();
  expect(draw(quality, 2, 40)).toBe(2);
  expect(quality.tier).toBe(TIERS[2]);
  draw(quality, 20, 40);
  expect(quality.tier).toBe(TIERS[LOWEST]);
});

it("the level of detail is constant at the target frame rate", () => {
  const quality = new Quality(2);
  expect(draw(quality, 5, 16.7)).toBe(0);
});

it("a better level is tried after fast frames, and later each time that it was too slow", () => {
  const quality = new Quality(2);
  draw(quality, 6, 16.7);
  expect(quality.tier).toBe(TIERS[1]);
  draw(quality, 1, 30);
  expect(quality.tier).toBe(TIERS[2]);
  draw(quality, 11, 16.7);
  expect(quality.tier).toBe(TIERS[2]);
  draw(quality, 1, 16.7);
  expect(quality.tier).toBe(TIERS[1]);
});

it("each level of detail needs no more than the level before", () => {
  for (let k = 1; k < TIERS.length; k++) {
    expect(TIERS[k].pixelRatio).toBeLessThanOrEqual(TIERS[k - 1].pixelRatio);
    expect(TIERS[k].shadowSize).toBeLessThanOrEqual(TIERS[k - 1].shadowSize);
  }
});
