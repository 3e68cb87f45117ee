import type { ModelInfo, Value, Values } from "../engine/engine";
import type { Opened } from "../engine/messages";

/** The values of a scenario: those of the controls, and those of the present run. */
export class SetValues {
  /** Values of the controls that override the scenario's. */
  wanted: Values = {};
  /** Values that override the scenario's in the present run; the same object until a value is set during the run. */
  overrides: Values = {};
  /** Overriding values of the present run at its start. */
  begun: Values = {};
  /** Values that the controls had before the run set parameters again from a link. */
  private readonly before = new Map<string, Value | undefined>();
  /** All values of the present run. */
  private applied: Values = {};

  /** Takes the values with which a run was opened. */
  begin(opened: Opened, overrides: Values): void {
    this.overrides = overrides;
    this.begun = overrides;
    this.before.clear();
    this.applied = { ...valuesOf(opened), ...overrides };
  }

  want(name: string, value: Value): void {
    this.before.delete(name);
    this.wanted = { ...this.wanted, [name]: value };
  }

  /** Records a value that the present run has accepted. */
  apply(name: string, value: Value): void {
    this.applied = { ...this.applied, [name]: value };
    this.overrides = { ...this.overrides, [name]: value };
  }

  /** Records a value that the present run has set again from a link: the control shows it until a reset. */
  follow(name: string, value: Value): void {
    const before = this.before.has(name) ? this.before.get(name) : this.wanted[name];
    this.want(name, value);
    this.before.set(name, before);
    this.apply(name, value);
  }

  /** Returns the values of the controls for a new start, without the values that the run set again from a link. */
  forStart(): Values {
    const kept: Values = {};
    for (const [name, value] of Object.entries({ ...this.wanted, ...Object.fromEntries(this.before) })) {
      if (value !== undefined) kept[name] = value;
    }
    this.before.clear();
    return (this.wanted = kept);
  }

  /** All values of the present run; a new object after a change. */
  get inForce(): Values {
    return this.applied;
  }

  /**
   * Records that the present run went back to before a value was set; a control keeps a value that is not yet applied.
   */
  goBack(name: string, value: Value): void {
    if (this.wanted[name] === this.applied[name]) this.want(name, value);
    this.apply(name, value);
  }

  /** Replaces refused values by those of the present run, unless the user has set newer ones. */
  giveUp(tried: Values): void {
    if (Object.keys(this.wanted).some((name) => this.wanted[name] !== tried[name])) return;
    const kept = Object.keys(this.wanted).map((name) => [name, this.applied[name]]);
    this.wanted = Object.fromEntries(kept.filter(([, value]) => value !== undefined));
  }

  /** Returns the names of the values that wait for a reset. */
  pending(): string[] {
    return Object.keys(this.wanted).filter((name) => this.wanted[name] !== this.applied[name]);
  }

  /** Returns the value that a control shows. */
  shown(name: string): Value | undefined {
    return this.wanted[name] ?? this.applied[name];
  }
}

/** Whether a parameter, or a setting given by its path, can be set during a run. */
export function isLive({ parameters, live_settings }: Pick<ModelInfo, "parameters" | "live_settings">, name: string): boolean {
  return live_settings.includes(name) || parameters.some((one) => one.name === name && one.live);
}

/** Returns every value that a control shows, by parameter name or path. */
function valuesOf({ model, settings }: Opened): Values {
  const values: Values = {
    "simulation.integrator": settings.integrator,
    "simulation.form": settings.form,
    "simulation.step_s": settings.step_s,
  };
  for (const parameter of model.parameters) values[parameter.name] = parameter.value;
  return values;
}
