import { Columns } from "../engine/columns";
import type { EngineClient } from "../engine/client";
import type { Channel, DrawnLine, Fault, Hydrostatics, InputInfo, ModelInfo, Value, Values } from "../engine/engine";
import type { Frame, Opened } from "../engine/messages";
import { Accuracy } from "./accuracy";
import { faultOfControl } from "./faults";
import { faultOfSaving, savedFile } from "./saved";
import type { SavedFile } from "./saved";

/** idle: at the start; stopped: the run cannot go on. */
export type Status = "loading" | "idle" | "running" | "paused" | "stopped";

/** A scenario opened, with all that follows from its channels. */
export interface Run {
  model: ModelInfo;
  lines: DrawnLine[];
  channels: Channel[];
  columns: Columns;
  inputs: InputInfo[];
  accuracy: Accuracy;
}

interface Source {
  text: string;
  file: string;
  /** Texts of the files that were opened with it, by their names; left out for a scenario of the gallery. */
  opened?: Record<string, string>;
}

export interface Listener {
  /** A scenario was opened, or the same one reset: everything starts anew. */
  opened?(run: Run, frame: Frame, isAnother: boolean): void;
  advanced?(run: Run, frame: Frame): void;
  statusChanged?(status: Status): void;
  valuesChanged?(): void;
  faulted?(fault: Fault | null): void;
}

/** The one state of the page: which scenario, which values, and where the run stands. */
export class Session {
  run: Run | null = null;
  lastFrame: Frame | null = null;
  status: Status = "loading";
  /** What went wrong last, until it is dismissed or something opens. */
  fault: Fault | null = null;
  speed = 1;
  /** What the controls say. */
  wanted: Values = {};
  /** What the run in hand was opened with. */
  applied: Values = {};
  private source: Source | null = null;
  private resetDue = false;
  /** Live values on their way to the engine. */
  private readonly live = new Map<string, Value>();
  private turn: Promise<unknown> = Promise.resolve();
  private advancing = false;
  private readonly listeners: Listener[] = [];

  constructor(private readonly client: EngineClient) {}

  listen(listener: Listener): void {
    this.listeners.push(listener);
  }

  /** Opens another scenario; one that does not read leaves the run in hand as it was. */
  open(source: Source, overrides: Values): Promise<boolean> {
    return this.inTurn(async () => {
      this.pause();
      try {
        this.accept(await this.read(source, overrides), { ...overrides }, source);
        return true;
      } catch (fault) {
        this.report(fault as Fault);
        return false;
      }
    });
  }

  private read({ text, file, opened }: Source, overrides: Values): Promise<Opened> {
    return this.client.open(text, file, overrides, opened ?? null);
  }

  /** Back to the start with the values that the controls show. Calls that come together are one. */
  async reset(): Promise<void> {
    if (this.resetDue) return;
    this.resetDue = true;
    await this.inTurn(async () => {
      this.resetDue = false;
      if (!this.source) return;
      this.pause();
      const overrides = { ...this.wanted };
      try {
        this.accept(await this.read(this.source, overrides), overrides, null);
      } catch (fault) {
        this.refuse(overrides, fault as Fault);
      }
    });
  }

  /** Sets a value; at the start the picture follows at once, under way a live one does, and another waits for the reset. */
  set(name: string, value: Value): void {
    this.wanted = { ...this.wanted, [name]: value };
    this.emit((listener) => listener.valuesChanged?.());
    if (this.status === "idle") void this.reset();
    else if (this.run?.model.parameters.some((one) => one.name === name && one.live)) void this.setLive(name, value);
  }

  /** Hands live values to the run in hand, one after another, of each name the last. One that is refused waits for the reset. */
  private async setLive(name: string, value: Value): Promise<void> {
    const isUnderWay = this.live.size > 0;
    this.live.set(name, value);
    if (isUnderWay) return;
    for (let next = this.live.entries().next(); !next.done; next = this.live.entries().next()) {
      const [due, given] = next.value;
      const run = this.run;
      await this.client.parameter(due, given).then(
        () => {
          if (run === this.run) this.applied = { ...this.applied, [due]: given };
        },
        (fault: Fault) => this.report(faultOfControl(fault, run?.model.parameters ?? [])),
      );
      if (this.live.get(due) === given) this.live.delete(due);
      this.emit((listener) => listener.valuesChanged?.());
    }
  }

  async setInput(name: string, value: number): Promise<void> {
    await this.client.input(name, value).catch((fault: Fault) => this.report(fault));
  }

  /** The run in hand as a scenario file; null where it cannot be one, which is reported. */
  async save(): Promise<SavedFile | null> {
    try {
      const { source } = this;
      const replay = await this.client.replay();
      return source && savedFile(source.file, replay, this.pending());
    } catch (fault) {
      this.report(faultOfSaving(fault as Fault));
      return null;
    }
  }

  /** Names of the values that wait for a reset. */
  pending(): string[] {
    return Object.keys(this.wanted).filter((name) => this.wanted[name] !== this.applied[name]);
  }

  start(): void {
    if (this.status === "idle" || this.status === "paused") this.become("running");
  }

  /** How the hulls float at rest with the crane as it stands. */
  hydrostatics(): Promise<Hydrostatics> {
    return this.client.hydrostatics();
  }

  pause(): void {
    if (this.status === "running") this.become("paused");
  }

  /** One recording interval. */
  async step(): Promise<void> {
    if (this.status === "stopped" || this.status === "loading") return;
    this.become("paused");
    await this.take(this.client.step());
  }

  /** One frame of a run, `wall_s` after the one before; asks nothing while an answer is due. */
  async advance(wall_s: number): Promise<void> {
    if (this.status !== "running" || this.advancing) return;
    this.advancing = true;
    await this.take(this.client.advance(wall_s, this.speed));
    this.advancing = false;
  }

  dismissFault(): void {
    this.tellFault(null);
  }

  report(fault: Fault): void {
    this.tellFault(fault);
  }

  private tellFault(fault: Fault | null): void {
    this.fault = fault;
    this.emit((listener) => listener.faulted?.(fault));
  }

  /** Openings and resets wait for one another, so that none answers for another's scenario. */
  private inTurn<T>(work: () => Promise<T>): Promise<T> {
    const result = this.turn.then(work);
    this.turn = result.catch(() => undefined);
    return result;
  }

  private async take(answer: Promise<Frame>): Promise<void> {
    const run = this.run;
    try {
      const frame = await answer;
      if (!run || run !== this.run) return;
      this.lastFrame = frame;
      this.emit((listener) => listener.advanced?.(run, frame));
      if (frame.fault) {
        this.become("stopped");
        this.report(frame.fault);
      }
    } catch (fault) {
      this.become("stopped");
      this.report(fault as Fault);
    }
  }

  private accept(opened: Opened, overrides: Values, source: Source | null): void {
    const columns = new Columns(opened.channels);
    const { model, lines, channels } = opened;
    const run = { model, lines, channels, columns, inputs: opened.inputs, accuracy: new Accuracy(columns) };
    this.run = run;
    this.lastFrame = opened.frame;
    this.applied = { ...valuesOf(opened), ...overrides };
    if (source) {
      this.source = source;
      this.wanted = { ...overrides };
    }
    this.dismissFault();
    this.emit((listener) => listener.opened?.(run, opened.frame, source !== null));
    this.become("idle");
    this.emit((listener) => listener.valuesChanged?.());
  }

  /** A value that the engine refuses: the controls go back to what the run in hand has. */
  private refuse(tried: Values, fault: Fault): void {
    const isNewer = Object.keys(this.wanted).some((name) => this.wanted[name] !== tried[name]);
    if (!isNewer) {
      const kept = Object.entries(this.wanted).map(([name]) => [name, this.applied[name]]);
      this.wanted = Object.fromEntries(kept.filter(([, value]) => value !== undefined));
    }
    this.report(faultOfControl(fault, this.run?.model.parameters ?? []));
    this.emit((listener) => listener.valuesChanged?.());
  }

  /** What a control shows. */
  value(name: string): Value | undefined {
    return this.wanted[name] ?? this.applied[name];
  }

  private become(status: Status): void {
    if (this.status === status) return;
    this.status = status;
    this.emit((listener) => listener.statusChanged?.(status));
  }

  private emit(tell: (listener: Listener) => void): void {
    this.listeners.forEach(tell);
  }
}

/** Every value that a control shows, by parameter name or path. */
function valuesOf({ model, settings }: Opened): Values {
  const values: Values = {
    "simulation.integrator": settings.integrator,
    "simulation.form": settings.form,
    "simulation.step_s": settings.step_s,
  };
  for (const parameter of model.parameters) values[parameter.name] = parameter.value;
  return values;
}
