import type { Moment } from "../app/recording/recording";
import type { Run, Session } from "../app/session";
import { texts } from "../texts";
import { byId, make, setText } from "../ui/dom";
import { isPanelOpen, offerPanel, onPanelOpened } from "../ui/switcher";
import { Alarm } from "./alarm";
import { LimitBar } from "./bar";
import { Cockpit } from "./cockpit";
import { gravest, LimitTrack } from "./limits";
import type { LimitState } from "./limits";
import { ReadingTable } from "./reading_table";
import { paletteChoice, soundSwitch } from "./settings";
import { ShipDials } from "./ship_dials";
import { TaskCard } from "./task";

/** Column of the present step of an operation. */
const STEP = "operation.operation_step";

/** Panel of instruments: heel and trim, the limits of the scenario as bars, and readings for a crane operator. */
export class Instruments {
  private readonly panel = byId("instruments");
  private readonly tab = document.querySelector<HTMLElement>('.switcher [data-panel="instruments"]')!;
  private readonly alarm = new Alarm();
  private readonly said = make("p", { class: "visually-hidden", role: "status" });
  private readonly body = make("div", { class: "instruments" });
  private readonly cockpit = new Cockpit();
  private readonly task: TaskCard;
  private tracks: LimitTrack[] = [];
  private bars: LimitBar[] = [];
  private states: LimitState[] = [];
  private parts: { show(run: Run, moment: Moment): void }[] = [];

  constructor(private readonly session: Session) {
    this.task = new TaskCard(session);
    this.panel.append(make("h2", { class: "visually-hidden" }, texts.instruments.title), this.body, make("div", { class: "instruments-settings" }, paletteChoice(), soundSwitch(this.alarm)), this.said);
    session.listen({
      opened: (run, frame) => this.open(run, frame.rows),
      advanced: (run, frame) => this.see(run, frame.rows),
      branched: () => this.tracks.forEach((track) => track.dropAfter(session.shown.time_s)),
      moved: (run, moment) => this.show(run, moment),
    });
    onPanelOpened("instruments", () => this.refresh());
  }

  private open(run: Run, rows: Float64Array): void {
    const { model, columns } = run;
    this.tracks = model.limits.map((limit) => new LimitTrack(limit, columns.at(limit.column), columns.at(STEP)));
    this.bars = this.tracks.map((track) => new LimitBar(track));
    this.states = this.tracks.map(() => "waiting");
    this.cockpit.open(run, this.tracks);
    this.task.open(run);
    this.see(run, rows);
    const [dials, readings] = [ShipDials.of(run, this.session), ReadingTable.of(run, this.session)];
    this.parts = [dials, readings].filter((part) => part !== null);
    const limits = make("section", { class: "limits" }, make("h3", {}, texts.instruments.limits), make("ul", {}, ...this.bars.map(({ element }) => element)));
    const elements = [dials?.element, this.bars.length > 0 ? limits : null, readings?.element];
    this.body.replaceChildren(...elements.filter((element) => element != null));
    offerPanel("instruments", this.body.childElementCount > 0);
    this.refresh();
  }

  private refresh(): void {
    const { run, shown } = this.session;
    if (run && shown.moment) this.show(run, shown.moment);
  }

  private see({ columns }: Run, rows: Float64Array): void {
    const { width } = columns;
    for (let from = 0; from < rows.length; from += width) {
      const row = rows.subarray(from, from + width);
      for (const track of this.tracks) track.see(columns.read(row, "time"), row);
    }
  }

  /**
   * Updates the bars with every picture, also while the panel is closed, for the title of the tab and for the alarm.
   */
  private show(run: Run, moment: Moment): void {
    const states = this.bars.map((bar) => bar.show(moment.time_s, moment.row));
    if (this.session.status === "running") this.warnOf(states);
    this.states = states;
    this.cockpit.show(run, moment, states);
    this.task.show(run, moment, this.tracks);
    this.tab.dataset.state = gravest(states);
    if (isPanelOpen("instruments")) for (const part of this.parts) part.show(run, moment);
  }

  /** Warns once of each limit that the run exceeds. */
  private warnOf(states: LimitState[]): void {
    const now = this.tracks.filter((_, i) => states[i] === "exceeded" && this.states[i] !== "exceeded");
    if (now.length === 0) return;
    this.alarm.sound();
    setText(this.said, texts.instruments.exceeded(now.map(({ limit }) => limit.name.replaceAll("_", " ")).join(", ")));
  }
}
