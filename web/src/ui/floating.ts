import { afloat } from "../app/afloat";
import type { BackgroundEngine } from "../app/background_engine";
import { Calm } from "../app/calm";
import { fixed } from "../app/format";
import type { Run, Session } from "../app/session";
import type { Hydrostatics } from "../engine/engine";
import type { Moment } from "../app/recording/recording";
import { texts } from "../texts";
import { byId, byTestId, make, setText } from "./dom";

/** Pause after the last change before hydrostatics are computed, ms: they take longer than many frames. */
const CALM_MS = 250;

/** Box over the picture with the heel, trim, draught, wave and metacentric height of the first hull. */
export class Floating {
  private readonly box = byId("floating");
  private readonly warnings = byId("floating-warnings");
  private readonly soon = new Calm(CALM_MS, () => this.ask());

  constructor(
    private readonly session: Session,
    private readonly background: BackgroundEngine,
  ) {
    session.listen({
      opened: (run, frame) => {
        this.show(run, frame);
        this.showAtRest(null);
        this.askSoon();
      },
      moved: (run, moment) => this.show(run, moment),
      statusChanged: (status) => status === "paused" && this.askSoon(),
      branched: () => this.askSoon(),
    });
  }

  private show(run: Run, { row, poses }: Pick<Moment, "row" | "poses">): void {
    const found = afloat(run.model, run.columns, row, poses);
    this.box.hidden = found === null;
    if (!found) return;
    setText(byTestId("heel"), degrees(found.heel_rad));
    setText(byTestId("trim"), degrees(found.trim_rad));
    setText(byTestId("draught"), `${fixed(found.draught_m, 2)} m`);
    setText(byTestId("wave"), `${fixed(found.wave_m, 2)} m`);
  }

  private askSoon(): void {
    if (this.session.run?.model.hulls.length) this.soon.ask();
    else this.soon.cancel();
  }

  private async ask(): Promise<void> {
    const { run } = this.session;
    const found = await this.background.hydrostatics(this.session).catch(() => null);
    if (this.session.run === run && found) this.showAtRest(found);
  }

  /** Shows the hydrostatics of the first hull, as the rest of the box. */
  private showAtRest(found: Hydrostatics | null): void {
    const height_m = found?.hulls[0]?.metacentric_height_m[0];
    setText(byTestId("metacentric-height"), height_m === undefined ? "–" : `${fixed(height_m, 2)} m`);
    this.warnings.hidden = !found || found.warnings.length === 0;
    this.warnings.querySelector("ul")!.replaceChildren(...(found?.warnings ?? []).map((warning) => make("li", {}, warning)));
    setText(this.warnings.querySelector("summary")!, texts.warnings.title(found?.warnings.length ?? 1));
  }
}

function degrees(radians: number): string {
  return `${fixed((radians * 180) / Math.PI, 2)}°`;
}
