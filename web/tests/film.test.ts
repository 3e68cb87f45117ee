import { describe, expect, it } from "vitest";
import type { Session } from "../src/app/session";
import { bitsPerSecond, countOf, faultOfFilm, faultOfPicture, LARGEST_BYTES, longestOf, SIZES, sizeOf, timeOf } from "../src/film/choice";
import type { FilmChoice } from "../src/film/choice";
import { layoutOf, MOST_PLOTS } from "../src/film/layout";
import { momentsAt } from "../src/film/moments";
import { ticksOf } from "../src/film/plot";
import { DirectEngine, openedDirectly } from "./direct";
import { bits, initEngine } from "./gallery";
import { until } from "./until";

await initEngine();

const CHOICE: FilmChoice = { format: "webm", from_s: 2, to_s: 12, frames_per_s: 30, speed: 1, size: { width: 1280, height: 720 }, hasPlots: true, caption: "" };

describe("times of a film", () => {
  it.each([
    [{}, 301],
    [{ speed: 4 }, 76],
    [{ speed: 0.25 }, 1201],
    [{ from_s: 0, to_s: 0.5, frames_per_s: 10 }, 6],
    [{ from_s: 0.1, to_s: 0.7, frames_per_s: 10 }, 7],
    [{ to_s: 2.01 }, 1],
  ])("the number of frames counts both ends: %j", (changed, frames) => {
    expect(countOf({ ...CHOICE, ...changed })).toBe(frames);
  });

  it("a frame shows its time of the run, and none is after the end", () => {
    const choice = { ...CHOICE, from_s: 0.1, to_s: 0.7, frames_per_s: 10 };
    expect(timeOf(CHOICE, 0)).toBe(2);
    expect(timeOf({ ...CHOICE, speed: 3 }, 10)).toBe(3);
    expect(timeOf(choice, countOf(choice) - 1)).toBe(0.7);
  });
});

describe("choices of a film", () => {
  const said = (changed: Partial<FilmChoice>, end_s = 20) => faultOfFilm({ ...CHOICE, ...changed }, end_s)?.message ?? null;

  it("sizes are read, and the offered ones can be filmed", () => {
    expect(sizeOf(" 1080 × 1350 ")).toEqual({ width: 1080, height: 1350 });
    expect(["", "720", "1280x", "x720", "1e3x720", "-2x4", "1280x720x3", "999999x2"].map(sizeOf)).toEqual(Array(8).fill(null));
    for (const size of SIZES) expect(said({ size: sizeOf(size)! })).toBeNull();
  });

  it.each([
    [{ size: { width: 1281, height: 720 } }, /found 1281x720, allowed: even numbers/],
    [{ size: { width: 0, height: 0 } }, /found 0x0, allowed: width x height of 64 to 8192/],
    [{ size: { width: 1280, height: 9000 } }, /found 1280x9000/],
    [{ frames_per_s: 0 }, /Frames per second: found 0, allowed: 1 to 120/],
    [{ frames_per_s: NaN }, /found NaN/],
    [{ speed: -1 }, /found -1, allowed: 0.01 to 1000/],
    [{ to_s: 20.1 }, /found 2 to 20.1 s, allowed: .* 0 to 20 s/],
    [{ from_s: 12 }, /found 12 to 12 s/],
    [{ from_s: NaN }, /found NaN to 12 s/],
  ])("a wrong choice is refused with what is allowed: %j", (changed, says) => {
    expect(said(changed)).toMatch(says);
  });

  it("a film that would not fit in memory is refused with the longest length", () => {
    const longest_s = longestOf(CHOICE.size, 30);
    expect((bitsPerSecond(CHOICE.size, 30) / 8) * longest_s).toBeLessThanOrEqual(LARGEST_BYTES);
    expect(said({ from_s: 0, to_s: longest_s - 1 }, 1e4)).toBeNull();
    expect(said({ from_s: 0, to_s: longest_s + 1 }, 1e4)).toMatch(new RegExp(`allowed: up to ${longest_s} s in this size`));
    expect(said({ from_s: 0, to_s: longest_s + 1, speed: 2 }, 1e4)).toBeNull();
  });

  it("a picture may have odd sizes", () => {
    expect(faultOfPicture({ width: 1281, height: 721 })).toBeNull();
    expect(faultOfPicture({ width: 12.5, height: 721 })).not.toBeNull();
  });
});

describe("the layout of a picture", () => {
  it.each(SIZES)("the parts fill the picture and do not overlap: %s", (text) => {
    const size = sizeOf(text)!;
    for (const plots of [0, 1, 2, 3, 4, 6]) {
      const { ship, plots: parts, caption } = layoutOf(size, plots, 2);
      expect(parts.length).toBe(Math.min(plots, MOST_PLOTS));
      for (const { left, top, width, height } of [ship, caption, ...parts]) {
        expect(Math.min(left, top)).toBeGreaterThanOrEqual(0);
        expect(Math.min(width, height)).toBeGreaterThan(0);
        expect([left + width <= size.width, top + height <= size.height]).toEqual([true, true]);
      }
      const filled = [ship, caption, ...parts].reduce((sum, { width, height }) => sum + width * height, 0);
      const empty = plots === 3 && parts[0].width < size.width && parts[1].top === parts[0].top ? parts[2].width * parts[2].height : 0;
      expect(Math.abs(filled + empty - size.width * size.height)).toBeLessThan(2 * (size.width + size.height));
    }
  });

  it("plots are beside the ship in a wide picture, and below her in a high one", () => {
    const wide = layoutOf({ width: 1280, height: 720 }, 2, 0);
    expect(wide.plots[0].left).toBe(wide.ship.width);
    const high = layoutOf({ width: 1080, height: 1350 }, 2, 0);
    expect(high.plots[0].top).toBe(high.ship.height);
    expect(high.ship.width).toBe(1080);
  });

  it("marks of an axis are round numbers within its range", () => {
    expect(ticksOf([0, 10], 5)).toEqual([0, 2, 4, 6, 8, 10]);
    expect(ticksOf([-0.31, 0.32], 4)).toEqual([-0.2, 0, 0.2]);
    expect(ticksOf([20, 80], 4)).toEqual([20, 40, 60, 80]);
  });
});

describe("moments of a film", () => {
  async function recorded(scenario: string, steer?: (session: Session) => Promise<void>): Promise<Session> {
    const session = await openedDirectly(scenario);
    session.start();
    await until(() => expect(session.status).toBe("running"));
    for (let i = 0; i < 20; i++) {
      await session.advance(0.13);
      if (i === 8) await steer?.(session);
    }
    session.pause();
    return session;
  }

  async function filmed(session: Session, times_s: number[]): Promise<{ time_s: number; bits: string[]; sea: Float64Array | undefined }[]> {
    const found = [];
    for await (const { time_s, row, poses, surface } of momentsAt(new DirectEngine().client, session, times_s)) {
      found.push({ time_s, bits: bits([...row, ...poses]), sea: surface && Float64Array.from(surface.elevation_m) || undefined });
    }
    return found;
  }

  it.each([
    ["lift_off_from_barge", undefined],
    ["lowering_by_winch", (session: Session) => session.setInput("hoist", -6)],
  ] as const)("moments have the bits of the recording at its times: %s", async (scenario, steer) => {
    const session = await recorded(scenario, steer);
    const rows = session.shown.recording!.rows.items.slice(2, -1);
    const found = await filmed(session, rows.map(({ time_s }) => time_s));
    expect(found.map((one) => one.bits)).toEqual(rows.map(({ row, poses }) => bits([...row, ...poses])));
  });

  it("moments between recording times do not depend on those before, and have the sea of their time", async () => {
    const session = await recorded("lift_off_from_barge");
    const times_s = [0.33, 0.71, 0.7125, 0.75, 0.76, 1.9];
    const together = await filmed(session, times_s);
    together.forEach(({ time_s }, i) => expect(time_s).toBeCloseTo(times_s[i], 9));
    expect(new Set(together.map((one) => String(one.bits))).size).toBe(times_s.length);
    for (const [i, time_s] of times_s.entries()) expect(await filmed(session, [time_s])).toEqual([together[i]]);
    expect(together.every(({ sea }) => sea !== undefined && sea.some((height) => height !== 0))).toBe(true);
  });
});
