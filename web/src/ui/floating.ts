import { afloat } from "../app/afloat";
import { fixed } from "../app/format";
import type { Run, Session } from "../app/session";
import type { Frame } from "../engine/messages";
import { byId, byTestId, setText } from "./dom";

/** How the ship floats, over the picture: heel, trim, draught and the wave, where there is a hull. */
export class Floating {
  private readonly list = byId("floating");

  constructor(session: Session) {
    session.listen({
      opened: (run, frame) => this.show(run, frame),
      advanced: (run, frame) => this.show(run, frame),
    });
  }

  private show(run: Run, frame: Frame): void {
    const found = afloat(run.model, run.columns, frame.row, frame.poses);
    this.list.hidden = found === null;
    if (!found) return;
    setText(byTestId("heel"), degrees(found.heel_rad));
    setText(byTestId("trim"), degrees(found.trim_rad));
    setText(byTestId("draught"), `${fixed(found.draught_m, 2)} m`);
    setText(byTestId("wave"), `${fixed(found.wave_m, 2)} m`);
  }
}

function degrees(radians: number): string {
  return `${fixed((radians * 180) / Math.PI, 2)}°`;
}
