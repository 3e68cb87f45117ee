import type { Fault } from "../engine/engine";
import { faultOfPage } from "./faults";
import type { Listener } from "./run";

/** Those who are told of the run. What one of them throws is its own failure, not the run's: the others are told all the same. */
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

  /** Whoever shows faults may be the one that fails. */
  private fail(fault: Fault): void {
    if (this.isFailing) return;
    this.isFailing = true;
    this.failed(fault);
    this.isFailing = false;
  }
}
