import type { BackgroundEngine } from "../app/background_engine";
import { fixed } from "../app/format";
import type { Run, Session } from "../app/session";
import { asFault } from "../engine/engine";
import type { Hydrostatics, InputInfo } from "../engine/engine";
import { inWords } from "../plots/lines";
import { swatch } from "../plots/plot";
import { texts } from "../texts";
import { make, setText } from "../ui/dom";
import { furthest, heelOver } from "./heel";
import { HeelChart } from "./heel_chart";
import { COLOURS, DEGREES, LossChart } from "./loss_chart";
import { LossTable } from "./loss_table";
import { isByTimeline, lostWith, releaseOf, releasedAt } from "./release";
import { armOf, bothSides, lossOf, mirror } from "./righting";
import type { Arms, Loss } from "./righting";

/** Address of the gallery's scenario for this lesson. */
const EXAMPLE = "?scenario=loss_of_hook_load";
/** Durations that are shown before the cut, and at least after it, s. */
const TIME_S = { before: 5, after: 30 };

/** The ship of the lesson, with her righting arms to starboard. */
interface Ship {
  body: string;
  before: Arms;
  after: Arms;
}

/**
 * Lesson on the loss of the hook load: the ship's righting arms with and without the load, her present heel on them,
 * and her largest roll.
 */
export class LossLesson {
  readonly element = make("div", { class: "lesson", "data-testid": "lesson-loss" });
  private readonly cut = make("button", { type: "button", class: "button button-primary", "data-testid": "cut" }, texts.loss.cut);
  private readonly back = make("button", { type: "button", class: "button", "data-testid": "before-cut" }, texts.loss.back);
  private readonly said = make("p", { class: "lesson-said", "data-testid": "loss-now" });
  private readonly arms = new LossChart();
  private readonly heel = new HeelChart();
  private readonly table = new LossTable(() => this.show());
  private readonly body = make("div", { class: "lesson-body" });
  private release: InputInfo | null = null;
  private ship: Ship | null = null;
  /** Reason why the lesson has no ship, or has none yet. */
  private lack = "";
  private asked: Run | null = null;

  constructor(
    private readonly session: Session,
    private readonly background: BackgroundEngine,
  ) {
    const intro = make("p", { class: "muted" }, texts.loss.intro);
    this.element.append(intro, this.body);
    this.cut.addEventListener("click", () => void this.cutNow());
    this.back.addEventListener("click", () => this.goBack());
  }

  open({ model, inputs }: Run): void {
    [this.release, this.ship, this.asked, this.lack] = [model.hulls.length > 0 ? releaseOf(model, inputs) : null, null, null, texts.loss.wait];
    this.build();
  }

  /** Computes the righting arms when the panel is visible, because this takes longer than many frames. */
  show(): void {
    const { run, shown } = this.session;
    if (!run || !shown.recording || !this.release) return;
    if (this.asked !== run) void this.ask(run, this.release);
    const cut_s = releasedAt(shown.recording, this.release.name, shown.time_s);
    this.cut.disabled = cut_s !== null;
    this.back.hidden = cut_s === null;
    if (this.ship) this.draw(run, this.ship, cut_s);
    else setText(this.said, this.lack);
  }

  private async ask(run: Run, { name }: InputInfo): Promise<void> {
    this.asked = run;
    const { session } = this;
    const before = await this.afloat([]);
    if (!before || session.run !== run) return;
    const lost = lostWith(before, name, run.model.bodies);
    const after = lost.length > 0 ? await this.afloat(lost) : before;
    if (!after || session.run !== run) return;
    this.ship = shipOf(before, after, name);
    if (!this.ship) this.lack = lackOf(before, after);
    this.build();
    this.show();
  }

  /** Computes the hydrostatics; a failure becomes a warning like those of the engine. */
  private afloat(without: readonly string[]): Promise<Hydrostatics | null> {
    return this.background.hydrostaticsAtStart(this.session, without, "loss").catch((thrown) => ({ hulls: [], warnings: [asFault(thrown).message] }));
  }

  private build(): void {
    const made_for_it = make("a", { href: EXAMPLE, class: "button" }, texts.loss.made_for_it);
    if (!this.release) return this.body.replaceChildren(make("p", {}, texts.loss.none), made_for_it);
    const buttons = make("div", { class: "lesson-buttons" }, this.cut, this.back);
    if (!this.ship) return this.body.replaceChildren(buttons, this.said);
    const arms = make("figure", {}, make("figcaption", {}, make("strong", {}, texts.loss.arms), legend()), this.arms.area);
    const heel = make("figure", {}, make("figcaption", {}, make("strong", {}, texts.loss.heel)), this.heel.area);
    const source = make("p", { class: "muted lesson-source" }, texts.loss.source);
    this.body.replaceChildren(buttons, this.said, arms, this.table.element, heel, source);
  }

  private draw(run: Run, { body, before, after }: Ship, cut_s: number | null): void {
    const { shown } = this.session;
    const loss = lossOf(before, after, this.table.flooding_rad);
    const way = loss?.way ?? 1;
    const [side, to_s] = [texts.loss.sides[way], shown.time_s];
    const heel = way * run.columns.read(shown.moment!.row, `${body}.roll`);
    const turned = [before, after].map((arms) => (way > 0 ? arms : mirror(arms)));
    const [from, until] = turned;
    setText(this.said, loss ? this.words(cut_s !== null, heel, armOf(cut_s === null ? from : until, heel), side) : texts.loss.no_rest);
    this.arms.draw({ before: from, after: until, loss, side, heel, isLost: cut_s !== null }, texts.loss.arms_of(inWords(body)));
    const largest = cut_s === null ? null : furthest(shown.recording!, run, body, way, [cut_s, to_s]);
    this.table.show(loss, largest && largest[1]);
    const from_s = Math.max(0, (cut_s ?? to_s) - TIME_S.before);
    const levels = loss && cut_s !== null ? levelsOf(loss) : [];
    const points = heelOver(shown.recording!, run, body, way, [from_s, to_s]);
    const time_s: [number, number] = [from_s, Math.max(to_s, from_s + TIME_S.before + TIME_S.after)];
    this.heel.draw({ axis: texts.loss.heel_axis(side), points, time_s, levels, furthest: largest, now: [to_s, heel * DEGREES] }, texts.loss.heel);
  }

  private words(isLost: boolean, heel: number, arm_m: number, side: string): string {
    const now = Number.isNaN(arm_m) ? texts.loss.beyond(fixed(heel * DEGREES, 2), side) : texts.loss.now(fixed(heel * DEGREES, 2), side, fixed(arm_m, 3));
    return isLost ? now : `${texts.loss.before} ${now}`;
  }

  private async cutNow(): Promise<void> {
    const { release, session } = this;
    if (!release || !session.run) return;
    // An input that a timeline sets cannot be set by hand: the run starts again without the timeline.
    if (isByTimeline(release)) {
      session.set(session.run.timelineSwitch, false);
      await session.reset();
    }
    await session.setInput(release.name, release.upper);
    session.start();
  }

  private goBack(): void {
    const { recording, time_s } = this.session.shown;
    const cut_s = this.release && recording && releasedAt(recording, this.release.name, time_s);
    if (cut_s === null) return;
    if (cut_s > recording!.start_s) this.session.scrub(recording!.beside(cut_s, -1));
    else void this.session.reset();
  }
}

function legend(): HTMLElement {
  const names = Object.entries(texts.loss.curves) as [keyof typeof COLOURS, string][];
  return make("span", { class: "plot-legend" }, ...names.map(([key, name]) => make("span", { class: "plot-entry" }, swatch(COLOURS[key]), name)));
}

function levelsOf({ rest, reach }: Loss): { heel: number; colour: string; name: string }[] {
  const { levels } = texts.loss;
  const first = { heel: rest * DEGREES, colour: COLOURS.after, name: levels.rest };
  return reach === null ? [first] : [first, { heel: reach * DEGREES, colour: COLOURS.area_1, name: levels.reach }];
}

/** Returns the ship that carries the load; null if she has no righting arms with the load or without it. */
function shipOf(before: Hydrostatics, after: Hydrostatics, release: string): Ship | null {
  const hull = before.hulls.find(({ hanging }) => hanging.some(({ joint }) => joint === release));
  const lighter = after.hulls.find(({ force }) => force === hull?.force);
  if (!hull?.righting_arm || !lighter?.righting_arm) return null;
  return { body: hull.body, before: bothSides(hull.righting_arm), after: bothSides(lighter.righting_arm) };
}

function lackOf(...found: Hydrostatics[]): string {
  const warnings = found.flatMap((one) => one.warnings);
  return warnings.length > 0 ? texts.loss.failed(warnings.join(". ")) : texts.loss.none;
}
