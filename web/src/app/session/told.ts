import type { Fault } from "../../engine/engine";
import { isOfEngine } from "../../engine/faults";
import { Listeners } from "../listeners";
import { Shown } from "../recording/shown";
import type { Listener, Run, Status } from "../run";

/** The present run: its state, the moment that is shown, its faults, and its listeners. */
export class Told {
  run: Run | null = null;
  readonly shown = new Shown();
  status: Status = "loading";
  /** The last fault, until it is dismissed or something opens. */
  fault: Fault | null = null;
  private readonly listeners = new Listeners((fault) => this.report(fault));

  listen(listener: Listener): void {
    this.listeners.add(listener);
  }

  dismissFault(): void {
    this.tellFault(null);
  }

  report(fault: Fault): void {
    this.tellFault(fault);
  }

  /** A dead engine is reported after the run has started again. */
  protected reportOfRun(fault: Fault): void {
    if (!isOfEngine(fault)) this.report(fault);
  }

  private tellFault(fault: Fault | null): void {
    this.fault = fault;
    this.emit((listener) => listener.faulted?.(fault));
  }

  protected become(status: Status): void {
    if (this.status === status) return;
    this.status = status;
    this.emit((listener) => listener.statusChanged?.(status));
  }

  protected look(time_s: number): void {
    this.shown.moveTo(time_s);
    this.tellMoment();
  }

  protected tellMoment(): void {
    const { run, shown } = this;
    const { moment } = shown;
    if (run && moment) this.emit((listener) => listener.moved?.(run, moment));
  }

  protected emit(message: (listener: Listener) => void): void {
    this.listeners.tell(message);
  }
}
