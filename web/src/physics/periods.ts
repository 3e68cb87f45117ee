import { faultOfBreakdown, UNLOADED } from "../engine/faults";
import type { FromSweep, Sweep } from "./messages";

export type SweepWorker = Pick<Worker, "postMessage" | "terminate" | "onmessage" | "onerror">;

/** Natural periods over a parameter, from an engine in its own worker: one sweep at a time; a newer sweep ends it. */
export class Periods {
  private worker: SweepWorker | null = null;

  constructor(
    private readonly startWorker: () => SweepWorker,
    /** Address of the folder that has the files that the gallery's scenarios name. */
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
