import { describe, expect, it } from "vitest";
import { drawnWaves, foamOf, heightAt, refined, roughness } from "../src/view/waves";

const lines = (count: number, every_m: number) => Float64Array.from({ length: count }, (_, k) => (k - (count - 1) / 2) * every_m);

/** Returns a surface on a square grid, with a height given over x and y. */
function surface(count: number, every_m: number, height: (x: number, y: number) => number) {
  const [x_m, y_m] = [lines(count, every_m), lines(count, every_m)];
  const elevation_m = Float32Array.from({ length: count * count }, (_, at) => height(x_m[Math.floor(at / count)], y_m[at % count]));
  return { x_m, y_m, elevation_m };
}

describe("the drawn sea", () => {
  it("the drawn sea has the engine's elevations, and a cubic between them reproduces a parabola", () => {
    const given = surface(9, 2, (x, y) => 0.1 * x * x - 0.2 * y + 1);
    const fine = refined(given);
    expect(fine.x_m).toHaveLength(17);
    // In the interior, where slopes by differences are exact; the values have single precision.
    for (let i = 2; i < 15; i++) {
      for (let j = 2; j < 15; j++) {
        const [x, y] = [fine.x_m[i], fine.y_m[j]];
        expect(fine.elevation_m[i * 17 + j]).toBeCloseTo(0.1 * x * x - 0.2 * y + 1, 5);
      }
    }
  });

  it("a plane sea has the slopes of the plane, and their magnitude as its roughness", () => {
    const drawn = drawnWaves(surface(11, 1, (x, y) => 0.3 * x - 0.4 * y), () => 1);
    expect(drawn.slope[0]).toBeCloseTo(0.3, 6);
    expect(drawn.slope[1]).toBeCloseTo(-0.4, 6);
    expect(roughness(drawn, 3)).toBeCloseTo(0.5, 6);
    expect(heightAt(drawn, 1.25, -0.5)).toBeCloseTo(0.3 * 1.25 + 0.4 * 0.5, 6);
    expect(heightAt(drawn, 100, 0)).toBe(0);
  });

  it("the sea has foam where it is steep near a crest, and none in a trough or on gentle slopes", () => {
    expect(foamOf(0.1, 1)).toBe(0);
    expect(foamOf(0.4, 1)).toBe(1);
    expect(foamOf(0.4, -0.1)).toBe(0);
    expect(foamOf(0.2, 0.1)).toBeGreaterThan(0);
    expect(foamOf(0.2, 0.1)).toBeLessThan(foamOf(0.25, 0.1));
  });
});
