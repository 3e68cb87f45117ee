import type { Description } from "../generated/model";
import type { NaturalMode } from "../physics/modes";
import type { Channel, DrawnLine, Equations, Hydrostatics, InputInfo, Settings, Warning } from "./engine";
import type { EventRecord } from "./events";
import type { LeverMove, Replay } from "./messages";

/** Fields of a resolved scenario that the page reads. */
export interface Resolved {
  simulation: Settings;
  parameters?: { name: string; writes?: string[] }[];
  bodies?: Record<string, ResolvedBody>;
  sea?: { waves?: Record<string, Record<string, { realisation?: { amplitudes?: string } }>> };
  wind?: { gusts?: { enabled: boolean } };
  operation?: { enabled?: boolean };
  limits?: unknown;
}

interface ResolvedBody {
  enabled?: boolean;
  joint?: Record<string, { axis?: unknown; child_position_m?: unknown }>;
  centre_of_mass_m?: unknown;
}

/** Types of the engine's JSON answers, by the methods that return them. */
interface Answers {
  channels_json: Channel[];
  equations_json: Equations;
  events_json: EventRecord[];
  hydrostatics_json: Hydrostatics;
  inputs_json: InputInfo[];
  lever_moves_json: LeverMove[];
  lines_json: DrawnLine[];
  model_json: Description;
  natural_modes_json: NaturalMode[];
  parameters_set_json: Replay["parameters"];
  resolved_json: Resolved;
  warnings_json: Warning[];
}

/** Parses an answer that was given as JSON. */
export function parsed<Name extends keyof Answers>(_: Name, json: string): Answers[Name] {
  return JSON.parse(json);
}

/** Calls a method of the engine and parses its JSON answer. */
export function answer<Name extends keyof Answers>(
  engine: Record<Name, (...of: number[]) => string>,
  name: Name,
  ...of: number[]
): Answers[Name] {
  return parsed(name, engine[name](...of));
}
