import { texts } from "../texts";
import { answer } from "./answers";
import type { Engine, Warning } from "./engine";
import type { LeverMove } from "./messages";

export interface EventRecord {
  time_s: number;
  element: string;
  what: string;
}

/** Largest interval between two moves of one lever in one drag, s. */
const ONE_MOVE_S = 1;

/** Largest number of listed events of one kind: a load that slides on deck has thousands. */
const MOST_ALIKE = 50;

/** Events of a run so far, and moves of levers by hand. */
export class Events {
  private seen = 0;
  private readonly kept: Warning[] = [];
  private readonly alike = new Map<string, number>();

  /** Returns all events and lever moves so far; asks the engine only for new events. */
  of(engine: Engine): Warning[] {
    const fresh = answer(engine, "events_json", this.seen);
    this.seen += fresh.length;
    fresh.forEach((happened) => this.keep(happened));
    return [...this.kept, ...answer(engine, "lever_moves_json").filter(isEnd).map(byHand)];
  }

  private keep({ time_s, element, what }: EventRecord): void {
    const key = `${element} ${what}`;
    const count = (this.alike.get(key) ?? 0) + 1;
    this.alike.set(key, count);
    if (count <= MOST_ALIKE) this.kept.push({ time_s, name: element, text: what });
  }
}

function byHand({ time_s, input, value }: LeverMove): Warning {
  return { time_s, name: input, text: texts.scrubber.by_hand(Number(value.toPrecision(4))) };
}

/** Whether a move is the last of one drag: no move of the same input follows within ONE_MOVE_S. */
function isEnd({ time_s, input }: LeverMove, at: number, moves: LeverMove[]): boolean {
  const next = moves[at + 1];
  return !next || next.input !== input || next.time_s - time_s > ONE_MOVE_S;
}
