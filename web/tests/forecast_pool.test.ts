import { describe, expect, it } from "vitest";
import type { FromForeseer, Future } from "../src/forecast/messages";
import { Foreseers } from "../src/forecast/pool";

/** Workers that answer when the test makes them. */
class FakeWorker {
  onmessage: ((event: MessageEvent<FromForeseer>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  readonly told: { kind: string; job?: number; seeds?: number[] }[] = [];
  isOver = false;

  postMessage(message: { kind: string }): void {
    this.told.push(message);
  }

  terminate(): void {
    this.isOver = true;
  }

  say(message: FromForeseer): void {
    this.onmessage?.({ data: message } as MessageEvent<FromForeseer>);
  }
}

describe("pool of forecast engines", () => {
  const scenario = { text: "", file: "", overrides: {}, opened: null, folder: "" };
  const start = { snapshot: new Uint8Array(), past: { time_s: new Float64Array(), x_m: new Float64Array(), y_m: new Float64Array() }, horizon_s: 60, every_s: 0.5 };
  const future = { seed: 1 } as Future;

  async function employed() {
    const workers: FakeWorker[] = [];
    const make = () => (workers.push(new FakeWorker()), workers.at(-1)!) as unknown as Worker;
    const module = {} as WebAssembly.Module;
    let compiled = 0;
    const foreseers = new Foreseers(make, async () => (compiled++, module), 2);
    const heard: Future[] = [];
    const ended = foreseers.look(scenario, start, [1, 2, 3, 4, 5], (one) => heard.push(one));
    await new Promise((resolve) => setTimeout(resolve));
    return { workers, foreseers, heard, ended, compiledOften: () => compiled };
  }

  it("the engines of a pool share one compiled module and divide the seeds", async () => {
    const { workers, compiledOften } = await employed();
    expect(compiledOften()).toBe(1);
    expect(workers.map(({ told }) => told.map(({ kind }) => kind))).toEqual([["module", "look"], ["module", "look"]]);
    expect(workers.map(({ told }) => told[1].seeds)).toEqual([[1, 3, 5], [2, 4]]);
  });

  it("a job ends when all futures are computed, and passes each on before", async () => {
    const { workers, heard, ended } = await employed();
    const { job } = workers[0].told[1];
    workers[0].say({ kind: "future", job: job!, future });
    workers[0].say({ kind: "done", job: job! });
    expect(heard).toEqual([future]);
    workers[1].say({ kind: "done", job: job! });
    expect(await ended).toBe(true);
  });

  it("a newer job stops the previous one, and only its futures are passed on", async () => {
    const { workers, foreseers, heard, ended } = await employed();
    const { job } = workers[0].told[1];
    const newer: Future[] = [];
    void foreseers.look(scenario, start, [9], (one) => newer.push(one));
    expect(await ended).toBe(false);
    await new Promise((resolve) => setTimeout(resolve));
    workers[0].say({ kind: "future", job: job!, future });
    workers[1].say({ kind: "future", job: job! + 1, future });
    expect([heard, newer]).toEqual([[], [future]]);
  });

  it("cancelling stops all engines of the pool", async () => {
    const { workers, foreseers, ended } = await employed();
    foreseers.cancel();
    expect(await ended).toBe(false);
    expect(workers.map(({ told }) => told.at(-1)!.kind)).toEqual(["cancel", "cancel"]);
  });

  it("a breakdown rejects the job, and the next job starts new engines", async () => {
    const { workers, foreseers, ended } = await employed();
    const broken = expect(ended).rejects.toMatchObject({ kind: "engine" });
    workers[1].onerror?.({ message: "out of memory" } as ErrorEvent);
    await broken;
    expect(workers.every(({ isOver }) => isOver)).toBe(true);
    void foreseers.look(scenario, start, [1], () => undefined);
    await new Promise((resolve) => setTimeout(resolve));
    expect(workers.length).toBe(4);
  });
});
