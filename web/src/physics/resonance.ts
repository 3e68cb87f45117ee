import type { Run, Session } from "../app/session";
import type { ParameterInfo } from "../engine/engine";
import { texts } from "../texts";
import { make, setText } from "../ui/dom";
import { heelOver } from "./heel";
import { HeelChart } from "./heel_chart";
import { DEGREES } from "./loss_chart";
import type { FromSweep } from "./messages";
import { linesOf, valuesOver } from "./modes";
import type { ModesAt } from "./modes";
import type { Periods } from "./periods";
import { PeriodsChart } from "./periods_chart";
import { legendOf, meetings, tableOf, withUnit } from "./resonance_words";
import type { Meetings } from "./resonance_words";
import type { SeaSpectrum } from "./sea_spectrum";

/** Address of the gallery's scenario for this lesson. */
const EXAMPLE = "?scenario=offshore_vessel&waves=true";
const VALUES = 25;
/** Largest number of reasons that are shown for values that were left out. */
const MOST_REASONS = 3;
/** Duration over which the roll is shown, s. */
const ROLL_S = 120;

/** A parameter with a range of numbers. */
type Varied = ParameterInfo & { range: [number, number] };

/** Results of a sweep so far; `key` identifies its scenario and values. */
interface Found {
  key: string;
  sea: SeaSpectrum | null;
  modes: ModesAt[];
  skipped: { value: number; why: string }[];
  fault: string;
}

/**
 * Lesson on resonance: natural periods over a parameter, the peak period of the sea, and runs at values where they are
 * equal.
 */
export class ResonanceLesson {
  readonly element = make("div", { class: "lesson", "data-testid": "lesson-resonance" });
  private readonly choice = make("select", { id: "varied", "data-testid": "varied" });
  private readonly button = make("button", { type: "button", class: "button button-primary", "data-testid": "compute-periods" });
  private readonly progress = make("span", { class: "muted", role: "status", "data-testid": "periods-progress" });
  private readonly chart = new PeriodsChart();
  private readonly roll = new HeelChart();
  private readonly legend = make("span", { class: "plot-legend" });
  private readonly meetings = make("ul", { class: "lesson-meetings", "data-testid": "meetings" });
  private readonly skipped = make("p", { class: "muted lesson-source", "data-testid": "skipped" });
  private readonly numbers = make("table");
  private readonly body = make("div", { class: "lesson-body" });
  private readonly rolling = make("figure", {}, make("figcaption", {}, make("strong", {}, texts.loss.heel)), this.roll.area);
  private varied: Varied[] = [];
  private found: Found | null = null;
  private written = "";

  constructor(
    private readonly session: Session,
    private readonly periods: Periods,
  ) {
    this.chart.area.classList.add("is-tall");
    this.element.append(make("p", { class: "muted" }, texts.resonance.intro), this.body);
    this.choice.addEventListener("change", () => this.forget());
    this.button.addEventListener("click", () => (this.periods.isBusy ? this.stop() : this.compute()));
  }

  open({ model }: Run): void {
    this.varied = model.parameters.filter((one): one is Varied => one.kind === "number" && one.range !== null);
    const names = this.varied.map(({ name }) => name);
    if (names.join() !== [...this.choice.options].map(({ value }) => value).join()) {
      this.choice.replaceChildren(...this.varied.map(({ name, label, unit }) => make("option", { value: name }, withUnit(label, unit))));
      const first = likeliest(this.varied);
      if (first) this.choice.value = first.name;
      this.build();
    }
    if (this.found && this.found.key !== this.key()) this.forget();
  }

  show(): void {
    const { run } = this.session;
    const parameter = this.parameter();
    if (!run || !parameter) return;
    const { isBusy } = this.periods;
    setText(this.button, isBusy ? texts.resonance.stop : texts.resonance.compute);
    const { found } = this;
    const done = found ? found.modes.length + found.skipped.length : 0;
    setText(this.progress, found?.fault ? texts.resonance.failed(found.fault) : found ? texts.resonance.progress(done, VALUES) : "");
    this.draw(parameter, found);
    this.drawRoll(run);
  }

  private draw(parameter: Varied, found: Found | null): void {
    const lines = linesOf(found?.modes ?? []);
    const now = this.session.values.inForce[parameter.name];
    const met = meetings(lines, found?.sea ?? null);
    const axis = withUnit(parameter.label, parameter.unit);
    const content = { axis, range: parameter.range, lines, sea: found?.sea ?? null, now: typeof now === "number" ? now : null, met: met.crossings };
    this.chart.draw(content, texts.resonance.chart(axis));
    // A button is not replaced while the user presses it.
    const written = JSON.stringify([lines, found?.sea?.peak_s, found?.skipped, axis]);
    if (written === this.written) return;
    this.written = written;
    this.legend.replaceChildren(...legendOf(lines, found?.sea ?? null));
    this.write(parameter, met);
    this.numbers.replaceChildren(...tableOf(axis, lines));
    const left_out = found?.skipped ?? [];
    this.skipped.hidden = left_out.length === 0;
    setText(this.skipped, [texts.resonance.skipped(left_out.length), ...reasons(left_out, parameter.unit)].join(" "));
  }

  private write(parameter: Varied, { sentences }: Meetings): void {
    const items = sentences(parameter, this.found !== null).map(({ text, value }) => {
      if (value === null) return make("li", {}, text);
      const set = withUnit(String(value), parameter.unit, " ");
      const button = make("button", { type: "button", class: "button", "data-testid": "set-and-run", "data-value": value }, texts.resonance.set(set));
      button.addEventListener("click", () => this.run(parameter.name, value));
      return make("li", {}, text, button);
    });
    this.meetings.replaceChildren(...items);
  }

  private drawRoll(run: Run): void {
    const { shown } = this.session;
    const [hull] = run.model.hulls;
    this.rolling.hidden = !hull;
    if (!hull || !shown.recording || !shown.moment) return;
    const from_s = Math.max(0, shown.time_s - ROLL_S);
    const points = heelOver(shown.recording, run, hull.body, 1, [from_s, shown.time_s]);
    const now: [number, number] = [shown.time_s, run.columns.read(shown.moment.row, `${hull.body}.roll`) * DEGREES];
    const axis = texts.loss.heel_axis(texts.loss.sides[1]);
    this.roll.draw({ axis, points, time_s: [from_s, from_s + ROLL_S], levels: [], furthest: null, now }, texts.loss.heel);
  }

  private build(): void {
    if (this.varied.length === 0) {
      const made_for_it = make("a", { href: EXAMPLE, class: "button" }, texts.resonance.made_for_it);
      return this.body.replaceChildren(make("p", {}, texts.resonance.none), made_for_it);
    }
    const field = make("p", { class: "lesson-field" }, make("label", { for: "varied" }, texts.resonance.parameter), this.choice);
    const buttons = make("div", { class: "lesson-buttons" }, this.button, this.progress);
    const chart = make("figure", {}, make("figcaption", {}, this.legend), this.chart.area);
    const numbers = make("details", {}, make("summary", {}, texts.resonance.table), this.numbers);
    const about = make("p", { class: "muted lesson-source" }, texts.resonance.about);
    this.body.replaceChildren(field, buttons, chart, this.meetings, this.rolling, numbers, this.skipped, about);
  }

  private parameter(): Varied | undefined {
    return this.varied.find(({ name }) => name === this.choice.value);
  }

  /** Returns a key of the scenario and its values without the varied parameter. */
  private key(): string {
    const { source, values } = this.session;
    const others = Object.entries(values.overrides).filter(([name]) => name !== this.choice.value);
    return JSON.stringify([source?.text, others.sort(([a], [b]) => (a < b ? -1 : 1)), this.choice.value]);
  }

  private compute(): void {
    const parameter = this.parameter();
    const { source, values } = this.session;
    if (!source || !parameter) return;
    const found: Found = { key: this.key(), sea: null, modes: [], skipped: [], fault: "" };
    this.found = found;
    const scenario = { text: source.text, file: source.file, overrides: values.overrides, opened: source.opened ?? null, folder: this.periods.folder };
    this.periods.sweep({ scenario, parameter: parameter.name, values: valuesOver(parameter.range, VALUES) }, (answer) => {
      take(found, answer);
      this.show();
    });
    this.show();
  }

  private stop(): void {
    this.periods.cancel();
    this.show();
  }

  private forget(): void {
    this.periods.cancel();
    this.found = null;
    this.show();
  }

  /** Sets the value and starts the run; if the value waits for a reset, the run is reset first. */
  private run(name: string, value: number): void {
    const { session } = this;
    session.set(name, value);
    void session.reset();
    session.start();
  }
}

/**
 * Returns the parameter that most likely changes the ship's periods: live parameters mostly change the sea, and a
 * length is probably that of a pendulum.
 */
function likeliest(varied: readonly Varied[]): Varied | undefined {
  const structural = varied.filter(({ live }) => !live);
  return structural.find(({ unit }) => unit === "m") ?? structural[0] ?? varied[0];
}

/** Returns the reasons why values were left out, each once, with some of the values. */
function reasons(skipped: Found["skipped"], unit: string): string[] {
  const others = skipped.filter(({ why }, k) => skipped.findIndex((one) => one.why === why) === k).slice(0, MOST_REASONS);
  return others.map(({ value, why }) => `${withUnit(String(value), unit, " ")}: ${why}.`);
}

function take(found: Found, answer: FromSweep): void {
  if (answer.kind === "sea") found.sea = answer.sea;
  if (answer.kind === "modes") found.modes.push(answer.found);
  if (answer.kind === "skipped") found.skipped.push({ value: answer.value, why: answer.fault.message });
  if (answer.kind === "fault") found.fault = answer.fault.message;
}
