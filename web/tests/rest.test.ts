import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Calm, isCalm } from "../src/app/calm";
import { Rest } from "../src/app/rest";

describe("the rest of the page", () => {
  it("is reached after three frames with nothing new, counted from when it was asked for", async () => {
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

  it("is done once for requests that come together, and is due until it is over", async () => {
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

  it("is not done, and not due, where it was called off", async () => {
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
