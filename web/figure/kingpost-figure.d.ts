/** Types of the element `<kingpost-figure>`. Importing the package defines the element. */

export type FigureValue = boolean | number | string;

/** A parameter of the scenario or an input set by hand. */
export interface FigureSettable {
  name: string;
  label: string;
  unit: string;
  value: FigureValue;
  /** Smallest and largest allowed value; null if there are none. */
  range: [number, number] | null;
  /** Allowed texts; null for other kinds. */
  choices: string[] | null;
}

/** A figure can be played, and `settable` lists what can be set in it. */
export interface ReadyDetail {
  title: string;
  duration_s: number;
  columns: readonly string[];
  settable: readonly FigureSettable[];
}

/** Another moment is shown, or the run has started or paused. */
export interface TimeDetail {
  time_s: number;
  isPlaying: boolean;
}

/** A value was set, by the reader or by the page. */
export interface ChangedDetail {
  name: string;
  value: FigureValue;
}

/** A fault; the figure goes on where it can. */
export interface ErrorDetail {
  code: string;
  message: string;
}

/** Events of a figure by their names. */
export interface FigureEvents {
  "kingpost-ready": CustomEvent<ReadyDetail>;
  "kingpost-time": CustomEvent<TimeDetail>;
  "kingpost-changed": CustomEvent<ChangedDetail>;
  "kingpost-error": CustomEvent<ErrorDetail>;
}

/**
 * A run of a ship and her crane in an article. It is a still until it is touched, or until the page's script asks for
 * something. Requests that come before the engine has loaded are kept and carried out in order.
 */
export interface KingpostFigureElement extends HTMLElement {
  /** Sets a parameter of the scenario, an input, or a field by its path. */
  set(name: string, value: FigureValue): void;
  /** Starts the run, or continues it; another figure that plays is paused. */
  play(): void;
  pause(): void;
  /** Time that is shown, s; setting it shows that time, for which the run is computed as far as needed. */
  time: number;
  /** Viewpoint: `free`, `load`, `cab`, `bridge`, `top`, `section`, or the positions of the eye and its target. */
  camera: string;
  /** Whether the run stands still. */
  readonly paused: boolean;
  /** Results at the moment that is shown by column name, as in the CSV files; empty before the engine has loaded. */
  readonly row: Readonly<Record<string, number>>;
  addEventListener<Name extends keyof FigureEvents>(type: Name, listener: (this: KingpostFigureElement, event: FigureEvents[Name]) => void, options?: boolean | AddEventListenerOptions): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
}

declare global {
  interface HTMLElementTagNameMap {
    "kingpost-figure": KingpostFigureElement;
  }
}
