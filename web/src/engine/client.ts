import type { Fault, Value, Values } from "./engine";
import type { Replies, Reply, Request } from "./messages";

interface Waiting {
  resolve(value: never): void;
  reject(fault: Fault): void;
}

/** The engine in its worker, seen from the page: each request answers with a promise, in order. */
export class EngineClient {
  private readonly waiting = new Map<number, Waiting>();
  private lastId = 0;

  /** The files that scenarios name are looked for in a folder, by its address. */
  constructor(
    private readonly worker: Worker,
    private readonly folder: string,
  ) {
    worker.onmessage = (event: MessageEvent<Reply>) => this.settle(event.data);
    worker.onerror = (event) => this.fail({ kind: "internal", message: event.message || "the engine did not load" });
  }

  /** `opened` are the texts of the files that came with it, by their names; null for a scenario of the gallery. */
  open(text: string, file: string, overrides: Values, opened: Record<string, string> | null): Promise<Replies["open"]> {
    return this.ask({ kind: "open", text, file, overrides, opened, folder: this.folder });
  }

  advance(wall_s: number, speed: number): Promise<Replies["advance"]> {
    return this.ask({ kind: "advance", wall_s, speed });
  }

  step(): Promise<Replies["step"]> {
    return this.ask({ kind: "step" });
  }

  hydrostatics(): Promise<Replies["hydrostatics"]> {
    return this.ask({ kind: "hydrostatics" });
  }

  input(name: string, value: number): Promise<null> {
    return this.ask({ kind: "input", name, value });
  }

  parameter(name: string, value: Value): Promise<null> {
    return this.ask({ kind: "parameter", name, value });
  }

  /** The run in hand as a scenario. */
  replay(): Promise<Replies["replay"]> {
    return this.ask({ kind: "replay" });
  }

  private ask<K extends Request["kind"]>(request: Request & { kind: K }): Promise<Replies[K]> {
    const id = ++this.lastId;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.worker.postMessage({ id, request });
    });
  }

  private settle(reply: Reply): void {
    const waiting = this.waiting.get(reply.id);
    this.waiting.delete(reply.id);
    if ("fault" in reply) waiting?.reject(reply.fault);
    else waiting?.resolve(reply.value as never);
  }

  private fail(fault: Fault): void {
    for (const waiting of this.waiting.values()) waiting.reject(fault);
    this.waiting.clear();
  }
}
