import { expect, it } from "vitest";
import { LOWEST, Quality, TIERS } from "../src/view/quality";

/** Draws so many windows of 30 frames, each frame so long; how often the tier changed. */
function draw(quality: Quality, windows: number, interval_ms: number): number {
  return Array.from({ length: 30 * windows }, () => quality.drew(interval_ms)).filter(Boolean).length;
}

it("draws less, tier by tier, while frames come too slowly, and stays at the lowest", () => {
  const quality = new Quality();
  expect(draw(quality, 2, 40)).toBe(2);
  expect(quality.tier).toBe(TIERS[2]);
  draw(quality, 20, 40);
  expect(quality.tier).toBe(TIERS[LOWEST]);
});

it("keeps what it draws at the rate of the display", () => {
  const quality = new Quality(2);
  expect(draw(quality, 5, 16.7)).toBe(0);
});

it("tries a better picture after a while with room, later each time that it was too much", () => {
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

it("asks for no more in each tier than in the one before", () => {
  for (let k = 1; k < TIERS.length; k++) {
    expect(TIERS[k].pixelRatio).toBeLessThanOrEqual(TIERS[k - 1].pixelRatio);
    expect(TIERS[k].shadowSize).toBeLessThanOrEqual(TIERS[k - 1].shadowSize);
  }
});
