import { faultOfBreakdown, UNLOADED } from "../engine/faults";
import type { FromSweep, Sweep } from "./messages";

export type SweepWorker = Pick<Worker, "postMessage" | "terminate" | "onmessage" | "onerror">;

/**
 * Computes natural periods over a parameter with an engine in a separate worker, one sweep at a time; a newer sweep
 * ends the previous one.
 */
export class Periods {
  private worker: SweepWorker | null = null;

  constructor(
    private readonly startWorker: () => SweepWorker,
    /** Address of the folder with the files that scenarios of the gallery name. */
    readonly folder: string,
  ) {}

  get isBusy(): boolean {
    return this.worker !== null;
  }

  sweep(sweep: Sweep, hear: (answer: FromSweep) => void): void {
    this.cancel();
    const worker = this.startWorker();
    const tell = (answer: FromSweep) => {
      if (this.worker !== worker) return;
      if (answer.kind === "done" || answer.kind === "fault") this.cancel();
      hear(answer);
    };
    worker.onmessage = ({ data }: MessageEvent<FromSweep>) => tell(data);
    worker.onerror = ({ message }: ErrorEvent) => tell({ kind: "fault", fault: message ? faultOfBreakdown(message) : UNLOADED });
    this.worker = worker;
    worker.postMessage(sweep);
  }

  cancel(): void {
    this.worker?.terminate();
    this.worker = null;
  }
}
