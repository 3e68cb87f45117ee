import type { Change } from "../engine/changes";
import type { EngineClient } from "../engine/client";
import type { Fault, Value, Values } from "../engine/engine";
import { isOfEngine } from "../engine/faults";
import type { Frame, LeverMove, Opened } from "../engine/messages";
import { faultOfControl, faultOfLostRun } from "./faults";
import { Recording } from "./recording/recording";
import { rewind } from "./recording/rewind";
import { runOf } from "./run";
import type { Run, Source } from "./run";
import { faultOfSaving, savedFile, type SavedFile } from "./saved";
import { Told } from "./told";
import { Latest, Turns } from "./turns";
import { isLive, SetValues } from "./values";

export type { Listener, Run, Status } from "./run";

/** The one state of the page: which scenario, which values, where the run stands, and which moment of it is shown. */
export class Session extends Told {
  /** Over wall time; infinite for as fast as it goes. */
  speed = 1;
  readonly values = new SetValues();
  /** What Reset opens. */
  source: Source | null = null;
  private resetDue = false;
  /** Live values on their way to the engine. */
  private readonly live = new Latest<Value>((name, value) => this.setLive(name, value));
  private readonly levers = new Latest<number>((name, value) => this.moveLever(name, value));
  /** Openings and resets under way. */
  private readonly turns = new Turns(() => this.goOn());
  /** What was asked for while one was under way, to be done after it. */
  private due: "start" | "step" | null = null;
  private advancing = false;
  /** Where a run as fast as it goes pauses. */
  private until_s = Infinity;
  private branching: Promise<void> | null = null;
  private isRecovering = false;

  constructor(private readonly client: EngineClient) {
    super();
  }

  /** Opens another scenario; one that does not read leaves the run in hand as it was. */
  open(source: Source, overrides: Values): Promise<boolean> {
    this.pause();
    this.live.clear();
    this.levers.clear();
    return this.turns.take(async () => {
      try {
        this.accept(await this.read(source, overrides), { ...overrides }, source);
        return true;
      } catch (fault) {
        this.due = null;
        this.refuseOpening(source, overrides, fault as Fault);
        return false;
      }
    });
  }

  /** Where the engine of a run in hand turns out to be gone, another one is asked. */
  private async read({ text, file, opened, changes }: Source, overrides: Values): Promise<Opened> {
    const answer = () => this.client.open(text, file, overrides, opened ?? null, changes);
    return answer().catch((fault: Fault) => {
      if (!this.run || !isOfEngine(fault)) throw fault;
      return answer();
    });
  }

  /** Keeps what could not be opened for Reset where something did not come. */
  private refuseOpening(source: Source, overrides: Values, fault: Fault): void {
    if (!this.run) {
      if (isOfEngine(fault) || fault.kind === "network") [this.source, this.values.wanted] = [source, { ...overrides }];
      this.become("empty");
    } else if (isOfEngine(fault)) void this.recover(fault);
    this.report(fault);
  }

  /** Back to the start with the values that the controls show. */
  reset(): Promise<void> {
    this.pause();
    return this.reopen();
  }

  /** As a reset, and the run goes on if it went. */
  restart(): void {
    const { isGoing } = this;
    void this.reset();
    if (isGoing) this.start();
  }

  /** Calls together are one. */
  private async reopen(): Promise<void> {
    if (this.resetDue) return;
    this.resetDue = true;
    await this.turns.take(async () => {
      this.resetDue = false;
      if (!this.source) return;
      const overrides = { ...this.values.forStart() };
      try {
        this.accept(await this.read(this.source, overrides), overrides, this.run ? null : this.source);
      } catch (fault) {
        this.refuse(overrides, fault as Fault);
      }
    });
  }

  /** Sets a value; at the start the picture follows at once, under way a live one does, and another waits for the reset. */
  set(name: string, value: Value): void {
    this.values.want(name, value);
    this.emit((listener) => listener.valuesChanged?.());
    if (this.status === "idle") void this.reopen();
    else if (this.run && isLive(this.run.model, name)) void this.live.set(name, value);
  }

  /** A live value that is refused waits for the reset. */
  private async setLive(name: string, value: Value): Promise<void> {
    if (!(await this.isReady()) || this.values.inForce[name] === value) return;
    const { run } = this;
    await this.asked(this.client.parameter(name, value)).then(
      () => {
        if (run === this.run) this.values.apply(name, value);
        this.emit((listener) => listener.steered?.());
      },
      (fault: Fault) => this.reportOfRun(faultOfControl(fault, run?.model.parameters ?? [])),
    );
    this.emit((listener) => listener.valuesChanged?.());
  }

  /** Acts from the moment that is shown on. */
  setInput(name: string, value: number): Promise<void> {
    return this.levers.set(name, value);
  }

  /** What an input is set to, or will be at once. */
  input(name: string): number {
    return this.levers.due(name) ?? this.run?.inputs.find((input) => input.name === name)?.value ?? 0;
  }

  /** What was meant for a run that a reset replaces is meant for the new one. */
  private async moveLever(name: string, value: number): Promise<void> {
    if (!(await this.isReady())) return;
    const { run } = this;
    await this.asked(this.client.input(name, value)).then(
      (time_s) => {
        if (!run || run !== this.run) return;
        this.noteMove(run, { time_s, input: name, value: value === 0 ? 0 : value });
        this.emit((listener) => listener.inputsChanged?.(run));
        this.emit((listener) => listener.steered?.());
      },
      (fault: Fault) => run === this.run && this.reportOfRun(fault),
    );
  }

  private noteMove(run: Run, move: LeverMove): void {
    this.shown.recording?.noteMove(move);
    run.inputs = run.inputs.map((input) => (input.name === move.input ? { ...input, value: move.value } : input));
  }

  /** The run in hand as a scenario file; null where it cannot be one, which is reported. */
  async save(): Promise<SavedFile | null> {
    try {
      const { source } = this;
      const replay = await this.asked(this.client.replay());
      return source && savedFile(source.file, replay, this.pending());
    } catch (fault) {
      this.reportOfRun(faultOfSaving(fault as Fault));
      return null;
    }
  }

  /** The run in hand as a scenario in JSON, for what is written of it; null where it cannot be one. */
  async resolved(): Promise<string | null> {
    return this.asked(this.client.replay()).then(
      ({ scenario }) => scenario,
      () => null,
    );
  }

  /** What was set in the run in hand so far. */
  changes(): Promise<readonly Change[]> {
    return this.asked(this.client.changes());
  }

  /** Names of the values that wait for a reset. */
  pending(): string[] {
    return this.values.pending();
  }

  /** Whether it runs, or will as soon as a reset under way is through. */
  get isGoing(): boolean {
    return this.status === "running" || this.status === "stepping" || this.due === "start";
  }

  /** Pauses, and shows the recorded moment that is nearest to a time. */
  scrub(time_s: number): void {
    if (this.branching) return;
    this.pause();
    this.look(time_s);
  }

  /** The run is brought back to the moment that is shown, to go on from there: what came after it is dropped. */
  private branch(): Promise<void> {
    const { run, shown } = this;
    const { time_s } = shown;
    this.branching ??= this.turns
      .take(async () => {
        if (run && run === this.run && shown.recording) await this.goBack(run, shown.recording, time_s);
      })
      .finally(() => (this.branching = null));
    return this.branching;
  }

  /** What is set by hand acts from the moment that is shown: false where the run cannot be brought there. */
  private async isAtCursor(): Promise<boolean> {
    if (this.shown.isBack) await this.branch();
    return !this.shown.isBack;
  }

  /** Waits for what is under way: false where another scenario is open then, or the run cannot be brought to the moment that is shown. */
  private async isReady(): Promise<boolean> {
    const { source } = this;
    do {
      await this.turns.over();
      if (source !== this.source || !(await this.isAtCursor())) return false;
    } while (this.turns.isBusy);
    return true;
  }

  private async goBack(run: Run, recording: Recording, time_s: number): Promise<void> {
    const { values } = this;
    try {
      const restored = rewind(this.client, recording, time_s, values.inForce, (name, value) => values.goBack(name, value));
      const { inputs, frame } = await this.asked(restored);
      run.inputs = inputs;
      recording.dropAfter(frame);
    } catch (fault) {
      this.due = null;
      return this.reportOfRun(fault as Fault);
    }
    this.shown.follow();
    if (this.status === "stopped") this.dismissFault();
    this.become("paused");
    this.emit((listener) => listener.branched?.(run));
    this.emit((listener) => listener.valuesChanged?.());
    this.tellMoment();
  }

  /** From an earlier moment that is shown the run branches. */
  start(): void {
    this.until_s = Infinity;
    if (this.shown.isBack) void this.branch();
    if (this.turns.isBusy) this.intend("start");
    else if (this.status === "idle" || this.status === "paused") this.become("running");
  }

  /** As fast as it goes, to a time at which it pauses. */
  runTo(time_s: number): void {
    this.start();
    this.until_s = time_s;
  }

  /** The state of the run in hand, for another engine. */
  snapshot(): Promise<Uint8Array> {
    return this.asked(this.client.snapshot());
  }

  pause(): void {
    if (this.due) this.intend(null);
    if (this.status === "running" || this.status === "stepping") this.become("paused");
  }

  /** One recording interval. */
  async step(): Promise<void> {
    if (!this.run || this.status === "stepping" || (this.status === "stopped" && !this.shown.isBack)) return;
    if (this.shown.isBack) void this.branch();
    if (this.turns.isBusy) return this.intend("step");
    this.become("paused");
    let frame = await this.take(this.client.step());
    if (frame?.isPart && this.status === "paused") this.become("stepping");
    // A pause or a reset may come while an answer is due.
    const isOn = () => this.status === "stepping";
    while (frame?.isPart && isOn()) frame = await this.take(this.client.step());
    if (isOn()) this.become("paused");
  }

  /** One frame of a run, `wall_s` after the one before; asks nothing while an answer is due. */
  async advance(wall_s: number): Promise<void> {
    if (this.status !== "running" || this.advancing) return;
    this.advancing = true;
    const { until_s } = this;
    await this.take(this.client.advance(wall_s, until_s < Infinity ? Infinity : this.speed, until_s));
    if (until_s === this.until_s && this.isPast(until_s)) this.pause();
    this.advancing = false;
  }

  private isPast(time_s: number): boolean {
    const { run, shown } = this;
    return run !== null && shown.recording !== null && shown.recording.now.time_s > time_s - run.model.step_s / 2;
  }

  /** There is nothing to open. */
  beEmpty(fault: Fault): void {
    this.become("empty");
    this.report(fault);
  }

  private intend(due: "start" | "step" | null): void {
    this.due = due;
    this.emit((listener) => listener.statusChanged?.(this.status));
  }

  private goOn(): void {
    const { due } = this;
    if (due) this.intend(null);
    if (due === "start") this.start();
    if (due === "step") void this.step();
  }

  private async take(answer: Promise<Frame | null>): Promise<Frame | null> {
    const run = this.run;
    try {
      const frame = await this.asked(answer);
      if (!frame || !run || run !== this.run) return null;
      this.show(run, frame);
      return frame;
    } catch (fault) {
      if (run === this.run && !isOfEngine(fault)) {
        this.become("stopped");
        this.report(fault as Fault);
      }
      return null;
    }
  }

  private show(run: Run, frame: Frame): void {
    if (frame.changes.length > 0) this.follow(run, frame.changes);
    this.shown.recording?.add(frame, this.values.inForce);
    this.emit((listener) => listener.advanced?.(run, frame));
    if (!this.shown.isBack) this.tellMoment();
    if (!frame.fault) return;
    this.become("stopped");
    this.report(frame.fault);
  }

  /** The run set these again by itself. */
  private follow(run: Run, changes: readonly Change[]): void {
    for (const change of changes) {
      if ("parameter" in change) this.values.follow(change.parameter, change.value);
      else this.noteMove(run, change);
    }
    this.emit((listener) => listener.inputsChanged?.(run));
    this.emit((listener) => listener.followed?.(run));
    this.emit((listener) => listener.valuesChanged?.());
  }

  /** What the engine answers to something asked of the run in hand; where it is gone, the run begins anew in another. */
  private async asked<T>(answer: Promise<T>): Promise<T> {
    return answer.catch((fault: unknown) => {
      if (isOfEngine(fault)) void this.recover(fault as Fault);
      throw fault;
    });
  }

  private async recover(fault: Fault): Promise<void> {
    if (this.isRecovering) return;
    this.isRecovering = true;
    this.pause();
    this.live.clear();
    this.levers.clear();
    const { run } = this;
    await this.reopen();
    // Values that waited for a reset may have been refused.
    if (run === this.run && this.status !== "stopped") await this.reopen();
    this.isRecovering = false;
    if (run !== this.run) this.report(faultOfLostRun(fault));
  }

  private accept(opened: Opened, overrides: Values, source: Source | null): void {
    const run = runOf(opened);
    this.run = run;
    this.values.begin(opened, overrides);
    const interval_s = Math.max(run.model.record_every_s, run.model.step_s);
    this.shown.begin(new Recording(run.columns, interval_s, opened.frame, this.values.inForce));
    if (source) {
      this.source = source;
      this.values.wanted = { ...overrides };
    }
    this.dismissFault();
    this.emit((listener) => listener.opened?.(run, opened.frame, source !== null));
    this.become("idle");
    this.emit((listener) => listener.valuesChanged?.());
  }

  /** A value that the engine refuses: the controls go back to what the run in hand has. */
  private refuse(tried: Values, fault: Fault): void {
    if (this.due) this.intend(null);
    if (isOfEngine(fault)) {
      this.become(this.run ? "stopped" : "empty");
      return this.report(fault);
    }
    this.values.giveUp(tried);
    this.report(faultOfControl(fault, this.run?.model.parameters ?? []));
    this.emit((listener) => listener.valuesChanged?.());
  }

  /** What a control shows. */
  value(name: string): Value | undefined {
    return this.values.shown(name);
  }
}
