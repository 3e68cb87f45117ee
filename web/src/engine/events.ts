import { texts } from "../texts";
import { answer } from "./answers";
import type { Engine } from "./engine";
import type { Happened, LeverMove } from "./messages";

export interface EventRecord {
  time_s: number;
  element: string;
  /** Kind of event, in words joined by `_`. */
  code: string;
  what: string;
}

/** Code of a lever move. */
const BY_HAND = "input_set";

/** Largest interval between two moves of one lever in one drag, s. */
const ONE_MOVE_S = 1;

/** Largest number of listed events of one kind: a load that slides on deck has thousands. */
const MOST_ALIKE = 50;

/** Events of a run so far, and moves of levers by hand. */
export class Events {
  private seen = 0;
  private readonly kept: Happened[] = [];
  private readonly alike = new Map<string, number>();

  /** Returns all events and lever moves so far; asks the engine only for new events. */
  of(engine: Engine): Happened[] {
    const fresh = answer(engine, "events_json", this.seen);
    this.seen += fresh.length;
    fresh.forEach((happened) => this.keep(happened));
    return [...this.kept, ...this.moves(engine).map(byHand)];
  }

  /** Returns the lever moves to mark: the last of each drag, without releases of levers that spring back. */
  private moves(engine: Engine): LeverMove[] {
    const ends = answer(engine, "lever_moves_json").filter(isEnd);
    if (ends.every(({ value }) => value !== 0)) return ends;
    const positions = answer(engine, "inputs_json").filter(({ unit }) => unit === "rad" || unit === "m").map(({ name }) => name);
    return ends.filter(({ input, value }) => value !== 0 || positions.includes(input));
  }

  private keep({ time_s, element, code, what }: EventRecord): void {
    const key = `${element} ${what}`;
    const count = (this.alike.get(key) ?? 0) + 1;
    this.alike.set(key, count);
    if (count <= MOST_ALIKE) this.kept.push({ time_s, code, name: element, text: what });
  }
}

function byHand({ time_s, input, value }: LeverMove): Happened {
  return { time_s, code: BY_HAND, name: input, text: texts.scrubber.by_hand(Number(value.toPrecision(4))) };
}

/** Whether a move is the last of one drag: no move of the same input follows within ONE_MOVE_S. */
function isEnd({ time_s, input }: LeverMove, at: number, moves: LeverMove[]): boolean {
  const next = moves[at + 1];
  return !next || next.input !== input || next.time_s - time_s > ONE_MOVE_S;
}
