import type { Fault } from "../engine/engine";
import { faultOfPage } from "./faults";
import type { Listener } from "./run";

/** Listeners of the run. An exception in one listener does not end the run: the other listeners are still called. */
export class Listeners {
  private readonly all: Listener[] = [];
  private isFailing = false;

  constructor(private readonly failed: (fault: Fault) => void) {}

  add(listener: Listener): void {
    this.all.push(listener);
  }

  tell(message: (listener: Listener) => void): void {
    for (const listener of this.all) {
      try {
        message(listener);
      } catch (thrown) {
        console.error(thrown);
        this.fail(faultOfPage(thrown));
      }
    }
  }

  /** Reports a fault once: the part that shows faults may itself fail. */
  private fail(fault: Fault): void {
    if (this.isFailing) return;
    this.isFailing = true;
    this.failed(fault);
    this.isFailing = false;
  }
}
