import type { BackgroundEngine } from "../app/background_engine";
import { Calm } from "../app/calm";
import type { Recording } from "../app/recording/recording";
import type { Run, Session } from "../app/session";
import type { Fault, Values } from "../engine/engine";
import { asFault } from "../engine/engine";
import type { ScenarioOf, Start } from "./messages";
import { Outlook } from "./outlook";
import { pastOf } from "./past";
import type { Foreseers } from "./pool";
import { judgedColumns, scoreOf, TrackRecord } from "./score";

/** Number of futures for the moment that is shown, and for each earlier minute by which the forecast is judged. */
export const FUTURES = 64;
const FUTURES_JUDGED = 32;
export const HORIZON_S = 60;
/** Approximate time between two rows of a future, s. */
const EVERY_S = 0.5;
/** Interval between two forecasts during a run, of wall time, and pause after the last change before a forecast, ms. */
const AGAIN_MS = 5000;
const CALM_MS = 200;

/**
 * Computes futures of the moment that is shown, while the forecast is switched on: at a pause, and every few seconds
 * during a run.
 */
export class Forecast {
  isOn = false;
  outlook: Outlook | null = null;
  readonly record = new TrackRecord();
  fault: Fault | null = null;
  private looked_ms = -Infinity;
  private isLooking = false;
  private readonly soon = new Calm(CALM_MS, () => this.look());
  private readonly heard: (() => void)[] = [];

  constructor(
    private readonly session: Session,
    private readonly background: Pick<BackgroundEngine, "snapshot">,
    private readonly foreseers: Pick<Foreseers, "look" | "cancel">,
    private readonly folder: string,
  ) {
    session.listen({
      opened: () => this.begin(0),
      branched: () => this.begin(session.shown.time_s),
      steered: () => this.begin(),
      followed: () => this.begin(),
      moved: () => this.follow(),
      statusChanged: (status) => status === "paused" && this.lookSoon(),
    });
  }

  /** Calls a listener after every change of the futures. */
  onChange(act: () => void): void {
    this.heard.push(act);
  }

  switch(isOn: boolean): void {
    this.isOn = isOn;
    this.begin();
  }

  /** Drops futures that belong to another run or to other lever settings, and scores after `kept_s`. */
  private begin(kept_s = Infinity): void {
    this.foreseers.cancel();
    [this.outlook, this.fault] = [null, null];
    this.record.dropAfter(kept_s);
    this.tell();
    this.lookSoon();
  }

  private follow(): void {
    if (this.session.status !== "running") this.lookSoon();
    else if (!this.isLooking && performance.now() - this.looked_ms > AGAIN_MS) void this.look();
  }

  private lookSoon(): void {
    this.soon.cancel();
    if (this.isOn) this.soon.ask();
  }

  private async look(): Promise<void> {
    const { run, shown } = this.session;
    if (!this.isOn || !run || !shown.recording) return;
    this.isLooking = true;
    this.looked_ms = performance.now();
    try {
      const isWhole = await this.foresee(run, shown.recording).finally(() => (this.isLooking = false));
      // A new forecast may start meanwhile; the remaining minutes are then judged after it.
      if (isWhole) await this.judge(run, shown.recording);
    } catch (thrown) {
      this.fault = asFault(thrown);
      this.tell();
    }
  }

  /** Computes the futures of the moment that is shown; the first one replaces all futures of the previous forecast. */
  private async foresee(run: Run, recording: Recording): Promise<boolean> {
    const { session } = this;
    const [now_s, values] = [session.shown.time_s, session.values.inForce];
    const snapshot = await this.background.snapshot(session);
    if (!snapshot || !this.isOn || run !== session.run) return false;
    const outlook = new Outlook(run.model.sea?.wave_components ? FUTURES : 1, run.columns.width);
    const start = this.startOf(run, recording, snapshot, now_s);
    return this.foreseers.look(this.scenario(values), start, seedsOf(outlook.wanted), (future) => {
      outlook.add(future);
      [this.outlook, this.fault] = [outlook, null];
      this.tell();
    });
  }

  /**
   * Judges the forecast by earlier minutes of the recording: computes futures from the data up to each minute and
   * compares them with the recorded values.
   */
  private async judge(run: Run, recording: Recording): Promise<void> {
    if (!run.model.sea?.wave_components) return;
    const places = judgedColumns(run.model, run.columns);
    for (const minute_s of this.record.due(recording.now.time_s)) {
      const keyframe = recording.keyframeAt(minute_s);
      const isSame = keyframe && keyframe.time_s > minute_s - HORIZON_S && !recording.isSteeredBetween(keyframe.time_s, keyframe.time_s + HORIZON_S);
      const outlook = isSame ? new Outlook(FUTURES_JUDGED, run.columns.width) : null;
      if (keyframe && outlook) {
        const start = this.startOf(run, recording, keyframe.bytes, keyframe.time_s);
        const seeds = seedsOf(FUTURES_JUDGED, 1000 + minute_s);
        const isWhole = await this.foreseers.look(this.scenario(keyframe.values), start, seeds, (future) => outlook.add(future));
        if (!isWhole) return;
      }
      this.record.add(minute_s, outlook && scoreOf(outlook, places, (time_s) => recording.rowAt(time_s)));
      this.tell();
    }
  }

  private startOf(run: Run, recording: Recording, snapshot: Uint8Array, time_s: number): Start {
    const interval_s = Math.max(run.model.record_every_s, run.model.step_s);
    const every_s = interval_s * Math.max(1, Math.round(EVERY_S / interval_s));
    return { snapshot, past: pastOf(run.model, run.columns, recording, time_s), horizon_s: HORIZON_S, every_s };
  }

  private scenario(overrides: Values): ScenarioOf {
    const { text, file, opened } = this.session.source!;
    return { text, file, overrides, opened: opened ?? null, folder: this.folder };
  }

  private tell(): void {
    for (const act of this.heard) act();
  }
}

/**
 * Returns the seeds of the futures: they are equal for all moments, so that only the measurements change from moment to
 * moment.
 */
function seedsOf(count: number, first = 1): number[] {
  return Array.from({ length: count }, (_, i) => first + i);
}
