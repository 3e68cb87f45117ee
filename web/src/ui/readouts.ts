import type { Frame } from "../engine/messages";
import type { Run, Session } from "../app/session";
import { duration, fixed, integratorName, scientific } from "../app/format";
import { byTestId, setText } from "./dom";

/** The numbers that are always in sight: time, step, integrator, energy and momentum error. */
export class Readouts {
  private readonly time = byTestId("time");
  private readonly energy = byTestId("energy-error");
  private readonly momentum = byTestId("momentum-error");
  private readonly energyAbsolute = byTestId("energy-error-absolute");
  private readonly momentumAbsolute = byTestId("momentum-error-absolute");

  constructor(session: Session) {
    session.listen({
      opened: (run, frame) => {
        const name = integratorName(run.model.integrator);
        setText(byTestId("step-size"), duration(run.model.step_s));
        setText(byTestId("integrator"), name.replace(/ \(.*/, ""));
        byTestId("integrator").title = name;
        setText(byTestId("title"), run.model.title);
        this.show(run, frame);
      },
      advanced: (run, frame) => this.show(run, frame),
    });
  }

  private show(run: Run, frame: Frame): void {
    const { width } = run.columns;
    for (let at = 0; at < frame.rows.length; at += width) run.accuracy.see(frame.rows.subarray(at, at + width));
    run.accuracy.see(frame.row);
    const errors = run.accuracy.errors(frame.row);
    setText(this.time, `${fixed(run.columns.read(frame.row, "time"), 2)} s`);
    setText(this.energy, relative(errors.energy, errors.energy_J, `${scientific(errors.energy_J)} J`));
    setText(this.momentum, relative(errors.momentum, errors.momentum_N_m_s, "–"));
    this.energy.title = `${scientific(errors.energy_J)} J`;
    this.momentum.title = `${scientific(errors.momentum_N_m_s)} N m s`;
    setText(this.energyAbsolute, this.energy.title);
    setText(this.momentumAbsolute, this.momentum.title);
  }
}

/** Before anything has moved there is nothing to be in proportion to: no error is 0, and another is as it is. */
function relative(value: number, absolute: number, inItself: string): string {
  if (Number.isNaN(value)) return absolute === 0 ? "0" : inItself;
  return scientific(value);
}
