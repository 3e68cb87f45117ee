import type { Moment } from "../app/recording/recording";
import type { Run } from "../app/session";
import type { Channel } from "../engine/engine";
import { texts } from "../texts";
import { byId, make, setText } from "../ui/dom";
import { number, plain } from "./bar";
import { gravest } from "./limits";
import type { LimitState, LimitTrack } from "./limits";
import { SHOWN } from "./readings";

/** The load on the hook: its column with the unit, and its limit: a rated load in a column, or a limit of the scenario. */
export interface Hook {
  column: string;
  unit: string;
  rated: string | null;
  track: LimitTrack | null;
}

/** Returns the reading of the load on the hook: by the load chart, otherwise the first tension. */
export function hookOf(channels: readonly Channel[], tracks: readonly LimitTrack[]): Hook | null {
  const first = (variable: string) => channels.find((channel) => channel.variable === variable);
  const channel = first("hook_load") ?? first("rope_tension") ?? first("line_tension");
  if (!channel) return null;
  const column = channel.columns[0];
  const rated = channel.variable === "hook_load" ? (first("rated_load")?.columns[0] ?? null) : null;
  const track = tracks.find(({ limit }) => limit.column === column && limit.at_most !== null) ?? null;
  return { column, unit: channel.units[0], rated, track };
}

/** Returns the limit with the least room at a moment, among those that apply; null if none does. */
export function worstOf(tracks: readonly LimitTrack[], time_s: number, row: ArrayLike<number>): LimitTrack | null {
  const applying = tracks.filter((track) => track.appliesTo(time_s, row));
  return applying.reduce<LimitTrack | null>((worst, track) => (worst && worst.roomIn(row) <= track.roomIn(row) ? worst : track), null);
}

interface Cell {
  element: HTMLElement;
  name: HTMLElement;
  value: HTMLElement;
}

/**
 * The load on the hook with its limit, and the worst limit of the scenario, on the picture of a narrow screen. The
 * picture has a red rim while a limit is exceeded.
 */
export class Cockpit {
  private readonly element = byId("cockpit");
  private readonly scene = byId("scene");
  private readonly load = cell("cockpit-load");
  private readonly worst = cell("cockpit-worst");
  private tracks: readonly LimitTrack[] = [];
  private hook: Hook | null = null;

  constructor() {
    setText(this.load.name, texts.instruments.hook_load);
    this.element.append(this.load.element, this.worst.element);
  }

  open({ channels }: Run, tracks: readonly LimitTrack[]): void {
    this.tracks = tracks;
    this.hook = hookOf(channels, tracks);
    this.load.element.hidden = this.hook === null;
    this.element.hidden = this.hook === null && tracks.length === 0;
  }

  show({ columns }: Run, { time_s, row }: Moment, states: readonly LimitState[]): void {
    const load = this.hook && this.showLoad(this.hook, (column) => columns.read(row, column), time_s, row);
    const others = this.tracks.filter((track) => track !== this.hook?.track);
    const worst = worstOf(others, time_s, row);
    this.worst.element.hidden = worst === null;
    if (worst) this.showWorst(worst, time_s, row);
    this.scene.dataset.limits = gravest(load ? [...states, load] : states);
  }

  private showLoad(hook: Hook, read: (column: string) => number, time_s: number, row: ArrayLike<number>): LimitState {
    const [unit, factor] = SHOWN[hook.unit] ?? [hook.unit, 1];
    const { track } = hook;
    if (track && !hook.rated) {
      put(this.load, number(track.valueIn(row)), plain(track.limit.at_most!), track.limit.unit, track.state(time_s, row));
      return track.state(time_s, row);
    }
    const value = read(hook.column) * factor;
    const rated = hook.rated === null ? null : read(hook.rated) * factor;
    const state = rated !== null && value > rated ? "exceeded" : "ok";
    put(this.load, number(value), rated === null ? null : number(rated), unit, state);
    return state;
  }

  private showWorst(track: LimitTrack, time_s: number, row: ArrayLike<number>): void {
    const { limit } = track;
    const value = track.valueIn(row);
    setText(this.worst.name, limit.name.replaceAll("_", " "));
    put(this.worst, number(value), plain(track.boundNear(value)), limit.unit === "1" ? "" : limit.unit, track.state(time_s, row));
  }
}

function cell(testId: string): Cell {
  const [name, value] = [make("dt", {}), make("dd", {})];
  return { element: make("div", { "data-testid": testId }, name, value), name, value };
}

function put({ element, value }: Cell, now: string, bound: string | null, unit: string, state: LimitState): void {
  element.dataset.state = state;
  setText(value, `${now}${bound === null ? "" : ` / ${bound}`} ${unit}`.trimEnd());
}
