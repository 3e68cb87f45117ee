import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Calm, isCalm } from "../src/app/calm";
import { Rest } from "../src/app/rest";

describe("the rest of the page", () => {
  it("the page is at rest after three frames without a change since the request", async () => {
    const rest = new Rest();
    const told = vi.fn();
    const passed = async (...frames: boolean[]) => {
      for (const isStill of frames) rest.frame(isStill);
      await Promise.resolve();
      return told.mock.calls.length;
    };
    await passed(true, true, true);
    void rest.reached().then(told);
    expect(await passed(true, true, false)).toBe(0);
    expect(await passed(true, true)).toBe(0);
    void rest.reached().then(told);
    expect(await passed(true)).toBe(1);
    expect(await passed(true, true)).toBe(2);
  });
});

describe("work after a pause", () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it("a task after a pause is done once for several requests, and counts until it has ended", async () => {
    let end = () => {};
    const work = vi.fn(() => new Promise<void>((resolve) => (end = resolve)));
    const calm = new Calm(300, work);
    for (let i = 0; i < 3; i++) {
      calm.ask();
      await vi.advanceTimersByTimeAsync(200);
    }
    expect([work.mock.calls.length, isCalm()]).toEqual([0, false]);
    await vi.advanceTimersByTimeAsync(100);
    expect([work.mock.calls.length, isCalm()]).toEqual([1, false]);
    end();
    await vi.advanceTimersByTimeAsync(0);
    expect(isCalm()).toBe(true);
  });

  it("a cancelled task is not done and does not count", async () => {
    const work = vi.fn();
    const calm = new Calm(300, work);
    calm.ask();
    calm.cancel();
    calm.cancel();
    expect(isCalm()).toBe(true);
    await vi.advanceTimersByTimeAsync(1000);
    expect(work).not.toHaveBeenCalled();
  });
});
