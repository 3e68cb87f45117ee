import type { Fault } from "../engine/engine";
import { faultOfPage } from "./faults";
import type { Listener } from "./run";

/** The listeners of the run. If one throws, that is not a failure of the run: the others are still called. */
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

  /** The part that shows faults may itself fail. */
  private fail(fault: Fault): void {
    if (this.isFailing) return;
    this.isFailing = true;
    this.failed(fault);
    this.isFailing = false;
  }
}
