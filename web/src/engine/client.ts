import type { Change } from "./changes";
import type { Fault, Value, Values } from "./engine";
import { ENDED, faultOfBreakdown, faultOfSilence, isOfEngine, UNLOADED } from "./faults";
import { layLifeline, whenCut } from "./lifeline";
import type { FromWorker, LeverMove, Replies, Reply, Request, Snapshot } from "./messages";

/** Interval between two checks whether the worker is alive, while an answer is expected, ms. */
const LOOK_EVERY_MS = 1000;
/**
 * Number of checks without a sign of life after which the worker counts as dead. A worker gives no sign of life during
 * one step or one opening, which may take half a minute on a phone or a busy machine.
 */
const MOST_SILENT_LOOKS = 60;

interface Waiting {
  resolve(value: never): void;
  reject(fault: Fault): void;
}

/**
 * The engine in its worker, as the page uses it: each request returns a promise, and answers come in order. A worker
 * that fails or does not answer is ended, waiting requests are rejected with a fault of the kind `engine`, and the next
 * request starts another worker.
 */
export class EngineClient {
  private readonly waiting = new Map<number, Waiting>();
  private worker: Worker | null = null;
  private lastId = 0;
  private silentLooks = 0;
  /** Fault of a worker that ended while no request waited: the next request is rejected with it. */
  private lost: Fault | null = null;
  private timer: ReturnType<typeof setInterval> | undefined;

  /** `folder` is the address of the gallery's folder, with the files that scenarios name. */
  constructor(
    private readonly startWorker: () => Worker,
    private readonly folder: string,
  ) {
    this.employed();
  }

  /**
   * Opens a scenario. `opened` holds the texts of the files that were opened with it, by name; null for a scenario of
   * the gallery. `changes` are made at their times. `beside` is the address of the folder with the scenario's files, if
   * that is not the gallery's.
   */
  open(
    text: string,
    file: string,
    overrides: Values,
    opened: Record<string, string> | null,
    changes: readonly Change[] = [],
    beside?: string,
  ): Promise<Replies["open"]> {
    return this.ask({ kind: "open", text, file, overrides, opened, changes, folder: this.folder, beside });
  }

  advance(wall_s: number, speed: number, until_s = Infinity): Promise<Replies["advance"]> {
    return this.ask({ kind: "advance", wall_s, speed, until_s });
  }

  step(): Promise<Replies["step"]> {
    return this.ask({ kind: "step" });
  }

  /** Computes how the hulls float at rest: at present, or without some bodies and with the crane as at the start. */
  hydrostatics(without: readonly string[] | null = null): Promise<Replies["hydrostatics"]> {
    return this.ask({ kind: "hydrostatics", without });
  }

  equations(): Promise<Replies["equations"]> {
    return this.ask({ kind: "equations" });
  }

  /** Sets an input; resolves with the time at which it acts, s. */
  input(name: string, value: number): Promise<number> {
    return this.ask({ kind: "input", name, value });
  }

  /** Sets a parameter; resolves with the time at which it acts, s. */
  parameter(name: string, value: Value): Promise<number> {
    return this.ask({ kind: "parameter", name, value });
  }

  /** Asks for the present run as a scenario. */
  replay(): Promise<Replies["replay"]> {
    return this.ask({ kind: "replay" });
  }

  /** Asks for the changes made so far in the present run. */
  changes(): Promise<Replies["changes"]> {
    return this.ask({ kind: "changes" });
  }

  snapshot(): Promise<Uint8Array> {
    return this.ask({ kind: "snapshot" });
  }

  /** Continues from an earlier state; `moves` are the lever moves after it, which are repeated. */
  restore(snapshot: Uint8Array, moves: LeverMove[] = []): Promise<Replies["restore"]> {
    return this.ask({ kind: "restore", snapshot, moves });
  }

  /** Continues the run of another engine from a keyframe, after an opening with all changes of the run. */
  resume(keyframe: Snapshot): Promise<Replies["resume"]> {
    return this.ask({ kind: "resume", keyframe });
  }

  /** Whether an answer is expected. */
  get isAsked(): boolean {
    return this.waiting.size > 0;
  }

  private ask<K extends Request["kind"]>(request: Request & { kind: K }): Promise<Replies[K]> {
    const id = ++this.lastId;
    const { lost } = this;
    this.lost = null;
    // The next worker has no scenario open.
    if (lost && request.kind !== "open") return Promise.reject(lost);
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.watch();
      this.employed().postMessage({ id, request });
    });
  }

  private employed(): Worker {
    if (this.worker) return this.worker;
    const worker = this.startWorker();
    const lose = (fault: Fault) => this.worker === worker && this.lose(fault);
    worker.onmessage = ({ data }: MessageEvent<FromWorker>) => {
      if ("holds" in data) whenCut(data.holds, () => lose(ENDED));
      else if (this.worker === worker) this.hear(data);
    };
    worker.onerror = ({ message }) => lose(message ? faultOfBreakdown(message) : UNLOADED);
    this.worker = worker;
    layLifeline(worker);
    return worker;
  }

  private hear(message: Reply | { isAlive: true }): void {
    this.silentLooks = 0;
    if ("id" in message) this.settle(message);
  }

  private settle(reply: Reply): void {
    if ("fault" in reply && isOfEngine(reply.fault)) return this.lose(reply.fault);
    const waiting = this.waiting.get(reply.id);
    this.waiting.delete(reply.id);
    if (this.waiting.size === 0) this.stopWatching();
    if ("fault" in reply) waiting?.reject(reply.fault);
    else waiting?.resolve(reply.value as never);
  }

  /**
   * Starts to check that the worker is alive: a dead worker does not answer, and a busy one cannot. Checks are counted
   * instead of time, because a suspended page makes no checks.
   */
  private watch(): void {
    this.timer ??= setInterval(() => {
      this.silentLooks += 1;
      if (this.silentLooks > MOST_SILENT_LOOKS) this.lose(faultOfSilence((MOST_SILENT_LOOKS * LOOK_EVERY_MS) / 1000));
      else this.worker?.postMessage({ isThere: true });
    }, LOOK_EVERY_MS);
  }

  private stopWatching(): void {
    clearInterval(this.timer);
    this.timer = undefined;
    this.silentLooks = 0;
  }

  private lose(fault: Fault): void {
    this.worker?.terminate();
    this.worker = null;
    this.stopWatching();
    const waiting = [...this.waiting.values()];
    this.waiting.clear();
    if (waiting.length === 0 && fault !== UNLOADED) this.lost = fault;
    for (const { reject } of waiting) reject(fault);
  }
}
