import type { BackgroundEngine } from "../../app/background_engine";
import { Calm } from "../../app/calm";
import type { Moment } from "../../app/recording/recording";
import type { Session } from "../../app/session";
import { texts } from "../../texts";
import { byId, make } from "../../ui/dom";
import type { Vec3 } from "../fit";
import type { View } from "../view";
import type { Overlay } from "./overlays";
import { barOf, written } from "./scale";

/** Duration of a pause of the run after which the second engine computes, ms. */
const CALM_MS = 300;
/** Largest number of drawn positions of the load's path. */
const PATH = 800;
/** Largest length of the scale bar, pixels. */
const BAR_PX = 90;

/** Updates the overlays from the run: its moments, its recording, and results of the second engine. */
export class Watched {
  private readonly box = byId("arrow-scale");
  private readonly soon = new Calm(CALM_MS, () => this.ask());
  private moment: Moment | null = null;
  private scaleShown = "";

  constructor(
    private readonly session: Session,
    private readonly background: BackgroundEngine,
    private readonly view: View,
  ) {
    session.listen({
      opened: () => {
        view.overlays.begin();
        this.askSoon();
      },
      statusChanged: (status) => status === "paused" && this.askSoon(),
      branched: () => this.askSoon(),
    });
  }

  turn(overlay: Overlay, isOn: boolean): void {
    const { on } = this.view.overlays;
    if (isOn) on.add(overlay);
    else on.delete(overlay);
    this.askSoon();
    this.refresh();
  }

  show(moment: Moment): void {
    this.moment = moment;
    const { run } = this.session;
    if (run) this.view.showOverlays(run, moment, () => this.path(moment.time_s));
  }

  private refresh(): void {
    if (this.moment) this.show(this.moment);
  }

  /** Returns the path of the load up to a time. */
  private path(until_s: number): Vec3[] {
    const { load } = this.view;
    const rows = this.session.shown.recording?.rows.items ?? [];
    if (load === null) return [];
    const past = rows.filter(({ time_s }) => time_s <= until_s);
    const every = Math.max(1, Math.ceil(past.length / PATH));
    const place = (poses: ArrayLike<number>): Vec3 => [poses[7 * load], poses[7 * load + 1], poses[7 * load + 2]];
    return [...past.filter((_, i) => i % every === 0).map(({ poses }) => place(poses)), ...(this.moment ? [place(this.moment.poses)] : [])];
  }

  private askSoon(): void {
    const { on } = this.view.overlays;
    if (on.has("axes") || on.has("buoyancy")) this.soon.ask();
  }

  private async ask(): Promise<void> {
    const { session, view, background } = this;
    const { run } = session;
    const { on } = view.overlays;
    if (!run) return;
    if (on.has("axes")) {
      const { moment } = session.shown;
      const equations = await background.equations(session, "picture").catch(() => null);
      if (equations && moment && session.run === run) view.overlays.hearEquations(run, equations, moment.poses);
    }
    if (on.has("buoyancy") && run.model.hulls.length > 0) {
      const found = await background.hydrostatics(session, "picture").catch(() => null);
      if (found && session.run === run) view.overlays.hearHydrostatics(found);
    }
    this.refresh();
  }

  /** Shows scale bars, each as long as the arrow of a round force or moment in the middle of the picture. */
  showScale(): void {
    const { metresPer, on } = this.view.overlays;
    this.box.hidden = !on.has("forces");
    if (this.box.hidden) return;
    const px = this.view.pixelsPerMetre();
    const { scale } = texts.picture;
    const bars = [
      { label: scale.force, bar: barOf(metresPer.force * px, BAR_PX), unit: "N", colour: "var(--roll)" },
      { label: scale.moment, bar: barOf(metresPer.moment * px, BAR_PX), unit: "N m", colour: "var(--yaw)" },
    ].flatMap(({ label, bar, unit, colour }) => (bar ? [{ label, text: written(bar.value, unit), style: `width:${bar.px.toFixed(0)}px;background:${colour}` }] : []));
    const say = JSON.stringify(bars);
    if (say === this.scaleShown) return;
    this.scaleShown = say;
    this.box.replaceChildren(...bars.map(({ label, text, style }) => make("div", {}, make("dt", {}, label), make("dd", {}, text), make("i", { style, "aria-hidden": "true" }))));
  }
}
