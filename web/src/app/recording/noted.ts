import type { Happened } from "../../engine/messages";

/** Warnings or events of a run. They are kept when the engine goes back in time and starts its list again. */
export class Noted<One extends Happened> {
  private kept: readonly One[] = [];
  all: readonly One[] = [];
  private heard: readonly One[] = [];

  /** Takes the engine's present list. */
  hear(list: readonly One[]): void {
    const isSame = list.length === this.heard.length && list.every((one, i) => isOne(one, this.heard[i]));
    if (isSame) return;
    this.heard = list;
    const known = new Set(this.kept.map(keyOf));
    this.all = [...this.kept, ...list.filter((one) => !known.has(keyOf(one)))];
  }

  dropAfter(time_s: number): void {
    this.kept = this.all.filter((one) => one.time_s <= time_s);
    [this.all, this.heard] = [this.kept, []];
  }
}

const keyOf = ({ time_s, name, text }: Happened) => `${time_s} ${name} ${text}`;
const isOne = (a: Happened, b: Happened) => a.time_s === b.time_s && a.name === b.name && a.text === b.text;
