import type { Frame } from "../engine/messages";
import type { Recording } from "../app/recording/recording";
import type { Run, Session } from "../app/session";
import { duration, fixed, integratorName, scientific } from "../app/format";
import { texts } from "../texts";
import { byTestId, setText } from "./dom";

/** Shows the time, and, in a line that can be opened, the numerical method and its errors. */
export class Readouts {
  private readonly time = byTestId("time");
  private readonly energy = byTestId("energy-error");
  private readonly momentum = byTestId("momentum-error");
  private readonly energyAbsolute = byTestId("energy-error-absolute");
  private readonly momentumAbsolute = byTestId("momentum-error-absolute");

  private readonly summary = byTestId("numerics-summary");
  private how = "";

  constructor(session: Session) {
    session.listen({
      opened: (run, frame) => {
        this.showScheme(run, run.model.integrator);
        setText(byTestId("title"), run.model.title);
        see(run, frame);
        this.show(run, frame.row);
      },
      advanced: see,
      valuesChanged: () => session.run && this.showScheme(session.run, String(session.values.inForce["simulation.integrator"])),
      moved: (run, { row }) => this.show(run, row),
      branched: (run) => session.shown.recording && seeAnew(run, session.shown.recording),
    });
  }

  /** Shows the integrator, which can change during a run, and the step size. */
  private showScheme({ model }: Run, integrator: string): void {
    const name = integratorName(integrator);
    const short = name.replace(/ \(.*/, "");
    setText(byTestId("step-size"), duration(model.step_s));
    setText(byTestId("integrator"), short);
    byTestId("integrator").title = name;
    this.how = `${short}, ${duration(model.step_s)}`;
  }

  private show(run: Run, row: Float64Array): void {
    const errors = run.accuracy.errors(row);
    setText(this.time, `${fixed(run.columns.read(row, "time"), 2)} s`);
    setText(this.energy, relative(errors.energy, errors.energy_J, `${scientific(errors.energy_J)} J`));
    setText(this.momentum, relative(errors.momentum, errors.momentum_N_m_s, "–"));
    setText(this.energyAbsolute, `${scientific(errors.energy_J)} J`);
    setText(this.momentumAbsolute, `${scientific(errors.momentum_N_m_s)} N m s`);
    const worst = Math.max(errors.energy || 0, errors.momentum || 0);
    setText(this.summary, texts.readouts.errors(this.how, worst > 0 ? scientific(worst) : texts.readouts.no_errors));
  }
}

/** Updates the scales of the errors, the largest energy and momentum, with all rows of a frame. */
function see(run: Run, frame: Frame): void {
  const { width } = run.columns;
  for (let at = 0; at < frame.rows.length; at += width) run.accuracy.see(frame.rows.subarray(at, at + width));
  run.accuracy.see(frame.row);
}

function seeAnew(run: Run, { rows }: Recording): void {
  run.accuracy.begin();
  for (const { row } of rows.items) run.accuracy.see(row);
}

/**
 * Formats a relative error; before anything has moved there is no scale, and a nonzero error is shown as `inItself`.
 */
function relative(value: number, absolute: number, inItself: string): string {
  if (Number.isNaN(value)) return absolute === 0 ? "0" : inItself;
  return scientific(value);
}
