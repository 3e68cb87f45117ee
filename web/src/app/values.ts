import type { ModelInfo, Value, Values } from "../engine/engine";
import type { Opened } from "../engine/messages";

/** The values of a scenario: what the controls say, and what the run in hand has. */
export class SetValues {
  /** What the controls say over the scenario's own. */
  wanted: Values = {};
  /** What of these the run in hand has; the same object until one is set under way. */
  overrides: Values = {};
  /** What it began with. */
  begun: Values = {};
  /** Of values that the run set again by itself, what the controls said before. */
  private readonly before = new Map<string, Value | undefined>();
  /** All that the run in hand has. */
  private applied: Values = {};

  /** A run was opened with these. */
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

  /** The run in hand took it under way. */
  apply(name: string, value: Value): void {
    this.applied = { ...this.applied, [name]: value };
    this.overrides = { ...this.overrides, [name]: value };
  }

  /** The run in hand set it again by itself: the control shows it, until a reset. */
  follow(name: string, value: Value): void {
    const before = this.before.has(name) ? this.before.get(name) : this.wanted[name];
    this.want(name, value);
    this.before.set(name, before);
    this.apply(name, value);
  }

  /** What the controls say for another start: what the run set by itself is as before. */
  forStart(): Values {
    const kept = Object.entries({ ...this.wanted, ...Object.fromEntries(this.before) }).filter(([, value]) => value !== undefined);
    this.before.clear();
    return (this.wanted = Object.fromEntries(kept) as Values);
  }

  /** All that the run in hand has; another object after a change. */
  get inForce(): Values {
    return this.applied;
  }

  /** The run in hand went back to before it was set under way; a control keeps a value that was asked for and not yet applied. */
  goBack(name: string, value: Value): void {
    if (this.wanted[name] === this.applied[name]) this.want(name, value);
    this.apply(name, value);
  }

  /** These were refused: back to what the run in hand has, unless something newer is wanted by now. */
  giveUp(tried: Values): void {
    if (Object.keys(this.wanted).some((name) => this.wanted[name] !== tried[name])) return;
    const kept = Object.keys(this.wanted).map((name) => [name, this.applied[name]]);
    this.wanted = Object.fromEntries(kept.filter(([, value]) => value !== undefined));
  }

  /** Names of the values that wait for a reset. */
  pending(): string[] {
    return Object.keys(this.wanted).filter((name) => this.wanted[name] !== this.applied[name]);
  }

  /** What a control shows. */
  shown(name: string): Value | undefined {
    return this.wanted[name] ?? this.applied[name];
  }
}

/** Whether a parameter, or a setting by its path, can be set while a run goes on. */
export function isLive({ parameters, live_settings }: Pick<ModelInfo, "parameters" | "live_settings">, name: string): boolean {
  return live_settings.includes(name) || parameters.some((one) => one.name === name && one.live);
}

/** Every value that a control shows, by parameter name or path. */
function valuesOf({ model, settings }: Opened): Values {
  const values: Values = {
    "simulation.integrator": settings.integrator,
    "simulation.form": settings.form,
    "simulation.step_s": settings.step_s,
  };
  for (const parameter of model.parameters) values[parameter.name] = parameter.value;
  return values;
}
