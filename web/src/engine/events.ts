import type { Engine, Warning } from "./engine";

interface Happened {
  time_s: number;
  element: string;
  what: string;
}

interface LeverMove {
  time_s: number;
  input: string;
  value: number;
}

interface ParameterSet {
  time_s: number;
  parameter: string;
}

/** Moves of a lever that follow one another within this are one, s: a hand draws it. */
const ONE_MOVE_S = 1;

/** What happened in the run so far and what a hand set in it. An engine's own table of events has the parameters that were set. */
export function eventsOf(engine: Engine): Warning[] {
  const moves = JSON.parse(engine.lever_moves_json()) as LeverMove[];
  const told = moves.filter(isEnd).map(({ time_s, input, value }) => ({ time_s, name: input, text: `set to ${Number(value.toPrecision(4))} by hand` }));
  if (engine.events_json) {
    const events = JSON.parse(engine.events_json()) as Happened[];
    return [...events.map(({ time_s, element, what }) => ({ time_s, name: element, text: what })), ...told];
  }
  const set = JSON.parse(engine.parameters_set_json()) as ParameterSet[];
  return [...set.map(({ time_s, parameter }) => ({ time_s, name: parameter, text: "was set" })), ...told];
}

/** Whether a lever stays where it was moved to. */
function isEnd({ time_s, input }: LeverMove, at: number, moves: LeverMove[]): boolean {
  const next = moves[at + 1];
  return !next || next.input !== input || next.time_s - time_s > ONE_MOVE_S;
}
