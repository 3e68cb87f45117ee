import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { EngineClient } from "../src/engine/client";
import type { FromWorker, ToWorker } from "../src/engine/messages";

const SILENT_MS = 70_000;

/** A worker that records the messages it gets, and sends those that the test gives it. */
class FakeWorker {
  static all: FakeWorker[] = [];
  readonly heard: ToWorker[] = [];
  isEnded = false;
  onmessage: ((event: { data: FromWorker }) => void) | null = null;
  onerror: ((event: { message: string }) => void) | null = null;

  constructor() {
    FakeWorker.all.push(this);
  }

  postMessage(message: ToWorker): void {
    this.heard.push(message);
  }

  terminate(): void {
    this.isEnded = true;
  }

  say(message: FromWorker): void {
    this.onmessage?.({ data: message });
  }

  get lastId(): number {
    return this.heard.flatMap((message) => ("id" in message ? [message.id] : [])).at(-1)!;
  }
}

const last = () => FakeWorker.all.at(-1)!;
const kindOf = (answer: Promise<unknown>) => answer.then(() => "answered", (fault: { kind: string }) => fault.kind);

describe("the engine's client", () => {
  let client: EngineClient;

  beforeEach(() => {
    vi.useFakeTimers();
    FakeWorker.all = [];
    client = new EngineClient(() => new FakeWorker() as unknown as Worker, "");
  });
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  it("the client ends a worker that stops answering, reports it, and starts another for the next request", async () => {
    const lost = kindOf(client.step());
    const first = last();
    await vi.advanceTimersByTimeAsync(SILENT_MS);
    expect(await lost).toBe("engine");
    expect(first.isEnded).toBe(true);
    const answer = client.step();
    expect(last()).not.toBe(first);
    last().say({ id: last().lastId, value: "a frame" });
    expect(await answer).toBe("a frame");
  });

  it("the client rejects the next request after a breakdown without waiting requests, unless it opens a scenario", async () => {
    last().onerror!({ message: "out of memory" });
    const opened = kindOf(client.open("", "", {}, null));
    last().say({ id: last().lastId, value: null });
    expect(await opened).toBe("answered");
    last().onerror!({ message: "out of memory" });
    expect(await kindOf(client.step())).toBe("engine");
    const answer = kindOf(client.step());
    last().say({ id: last().lastId, value: null });
    expect(await answer).toBe("answered");
  });

  it("the client waits for a busy worker that gives signs of life", async () => {
    const answer = kindOf(client.step());
    for (let s = 0; s < 120; s++) {
      await vi.advanceTimersByTimeAsync(1000);
      if (s % 10 === 0) last().say({ isAlive: true });
    }
    last().say({ id: last().lastId, value: null });
    expect(await answer).toBe("answered");
    expect(FakeWorker.all.length).toBe(1);
  });

  it("the client learns at once that a worker was ended that held its lifeline", async () => {
    const cut = new Map<string, () => void>();
    vi.stubGlobal("navigator", { locks: { request: async (name: string, cutNow: () => void) => void cut.set(name, cutNow) } });
    client = new EngineClient(() => new FakeWorker() as unknown as Worker, "");
    const first = last();
    const laid = first.heard.flatMap((message) => ("lifeline" in message ? [message.lifeline] : []));
    expect(laid.length).toBe(1);
    first.say({ holds: laid[0] });
    const lost = kindOf(client.step());
    cut.get(laid[0])!();
    expect(await lost).toBe("engine");
    const answer = client.step();
    last().say({ id: last().lastId, value: "a frame" });
    expect(await answer).toBe("a frame");
    // The lock of a worker that the client has ended itself becomes free too.
    cut.get(laid[0])!();
    expect(last().isEnded).toBe(false);
  });

  it("the client asks for no sign of life while no request waits", async () => {
    await vi.advanceTimersByTimeAsync(10 * SILENT_MS);
    expect(FakeWorker.all.length).toBe(1);
    expect(last().heard).toEqual([]);
  });

  it("the client reports a missing engine script, and starts another worker for the next request", async () => {
    // Before any request: the script fails sooner than a scenario is fetched.
    last().onerror?.({ message: "" });
    const answer = kindOf(client.step());
    expect(FakeWorker.all.length).toBe(2);
    last().onerror?.({ message: "" });
    expect(await answer).toBe("engine");
  });

  it("the client ends an engine that broke down and rejects all waiting requests", async () => {
    const answers = [kindOf(client.step()), kindOf(client.hydrostatics())];
    last().say({ id: last().lastId, fault: { kind: "engine", message: "unreachable" } });
    expect(await Promise.all(answers)).toEqual(["engine", "engine"]);
    expect(last().isEnded).toBe(true);
  });

  it("the client rejects only the request that the engine refuses", async () => {
    const refused = kindOf(client.input("hoist", 1));
    last().say({ id: last().lastId, fault: { kind: "input", message: "no" } });
    expect(await refused).toBe("input");
    expect(last().isEnded).toBe(false);
  });
});
