import type { Fault } from "../../engine/engine";
import { isOfEngine } from "../../engine/faults";
import { Listeners } from "../listeners";
import { Shown } from "../recording/shown";
import type { Listener, Run, Source, Status } from "../run";
import { SetValues } from "../values";

/**
 * The state of the page and its listeners: the run, the moment that is shown, the values of the controls and the last
 * fault.
 */
export class SessionState {
  run: Run | null = null;
  /** The scenario that Reset opens. */
  source: Source | null = null;
  readonly shown = new Shown();
  readonly values = new SetValues();
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

  /** Reports a fault of the run; a dead engine is reported later, when the run has started again. */
  reportOfRun(fault: Fault): void {
    if (!isOfEngine(fault)) this.report(fault);
  }

  private tellFault(fault: Fault | null): void {
    this.fault = fault;
    this.emit((listener) => listener.faulted?.(fault));
  }

  become(status: Status): void {
    if (this.status === status) return;
    this.status = status;
    this.emit((listener) => listener.statusChanged?.(status));
  }

  look(time_s: number): void {
    this.shown.moveTo(time_s);
    this.tellMoment();
  }

  tellMoment(): void {
    const { run, shown } = this;
    const { moment } = shown;
    if (run && moment) this.emit((listener) => listener.moved?.(run, moment));
  }

  emit(message: (listener: Listener) => void): void {
    this.listeners.tell(message);
  }
}
