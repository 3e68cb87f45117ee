import type { Fault } from "../engine/engine";
import { faultOfBreakdown, UNLOADED } from "../engine/faults";
import type { FromForeseer, Future, ScenarioOf, Start, ToForeseer } from "./messages";

/** A job in progress. */
interface Job {
  id: number;
  left: number;
  hear(future: Future): void;
  end(isWhole: boolean): void;
  fail(fault: Fault): void;
}

/** The part of a worker that the pool uses. */
export type ForeseerWorker = Pick<Worker, "postMessage" | "terminate" | "onmessage" | "onerror">;

/**
 * Pool of engines in workers, in addition to the engine of the run: they share one compiled module, and each computes a
 * part of the futures.
 */
export class Foreseers {
  private workers: ForeseerWorker[] = [];
  private job: Job | null = null;
  private lastId = 0;

  constructor(
    private readonly startWorker: () => ForeseerWorker,
    private readonly loadModule: () => Promise<WebAssembly.Module>,
    private readonly count: number,
  ) {}

  /**
   * Computes futures from a start, one for each seed, and passes each to `hear`; returns true after the last one, false
   * if a newer job has replaced this one.
   */
  async look(scenario: ScenarioOf, start: Start, seeds: readonly number[], hear: (future: Future) => void): Promise<boolean> {
    this.job?.end(false);
    const id = ++this.lastId;
    const ended = new Promise<boolean>((end, fail) => (this.job = { id, left: this.count, hear, end, fail }));
    await this.employ().catch(() => this.lose(UNLOADED));
    if (this.job?.id !== id) return ended;
    this.workers.forEach((worker, at) => {
      const own = seeds.filter((_, i) => i % this.count === at);
      this.tell(worker, { kind: "look", job: id, scenario, start, seeds: own });
    });
    return ended;
  }

  cancel(): void {
    this.job?.end(false);
    this.job = null;
    for (const worker of this.workers) this.tell(worker, { kind: "cancel" });
  }

  private tell(worker: ForeseerWorker, message: ToForeseer): void {
    worker.postMessage(message);
  }

  private async employ(): Promise<void> {
    if (this.workers.length > 0) return;
    const module = await this.loadModule();
    if (this.workers.length > 0) return;
    this.workers = Array.from({ length: this.count }, () => this.startWorker());
    for (const worker of this.workers) {
      worker.onmessage = ({ data }: MessageEvent<FromForeseer>) => this.hear(data);
      worker.onerror = ({ message }: ErrorEvent) => this.lose(message ? faultOfBreakdown(message) : UNLOADED);
      this.tell(worker, { kind: "module", module });
    }
  }

  private hear(message: FromForeseer): void {
    const { job } = this;
    if (!job || message.job !== job.id) return;
    if (message.kind === "future") return job.hear(message.future);
    if (message.kind === "fault") {
      job.fail(message.fault);
      return this.cancel();
    }
    job.left -= 1;
    if (job.left > 0) return;
    this.job = null;
    job.end(true);
  }

  private lose(fault: Fault): void {
    for (const worker of this.workers) worker.terminate();
    this.workers = [];
    const { job } = this;
    this.job = null;
    job?.fail(fault);
  }
}
