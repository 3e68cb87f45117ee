// Three thousand random changes from one seed. Others, or another number of them:
//
//     KINGPOST_CHANGES_SEED=7 KINGPOST_CHANGES=50000 npx vitest run tests/changes.test.ts
import { afterAll, beforeAll, expect, it } from "vitest";
import { Session } from "../src/app/session";
import type { ParameterInfo, Value } from "../src/engine/engine";
import { DirectEngine } from "./direct";
import { bits, initEngine, read } from "./gallery";
import { isThorough } from "./lane.mjs";
import { Random } from "./random";

const SEED = Number(process.env.KINGPOST_CHANGES_SEED ?? 1);
const CHANGES = Number(process.env.KINGPOST_CHANGES ?? (isThorough ? 3_000 : 300));
/** Scenarios with levers, with live parameters, with variable step size, and one that diverges. */
const SCENARIOS = ["lowering_by_winch", "quayside_lift", "offshore_vessel_on_dp", "paper", "tennis_racket", "chain"];
/** Weight of each kind of change. */
const WEIGHTS = { lever: 22, parameter: 6, live: 8, scrub: 10, start: 9, pause: 6, step: 8, advance: 24, reset: 2, speed: 4, save: 0.5, open: 0.5 };
type Change = keyof typeof WEIGHTS;
/** Kinds of faults that a run may report: a refused value, divergence, an operation that cannot be saved. */
const MAY_FAIL = ["input", "setting", "scenario", "diverged", "two_operations", "unsaved", "run"];
/** Number of turns of the event loop within which every request must be answered. */
const MOST_TURNS = 20_000;

const rejected: unknown[] = [];
const note = (reason: unknown) => rejected.push(reason);

await initEngine();
beforeAll(() => void process.on("unhandledRejection", note));
afterAll(() => void process.off("unhandledRejection", note));

/** A session that is changed at random, with checks after each change. */
class Trial {
  private readonly random = new Random(SEED);
  private readonly engine = new DirectEngine(() => this.random.next() < 0.3, 4);
  readonly session = new Session(this.engine.client);
  private readonly under = new Set<Promise<unknown>>();
  readonly made: string[] = [];
  readonly seen = { branched: 0, stopped: 0, refused: 0 };

  constructor() {
    this.session.listen({ advanced: (_run, frame) => this.see(frame.rows, frame.row_poses), branched: () => this.seeBranch() });
  }

  async open(): Promise<void> {
    const name = this.random.of(SCENARIOS);
    this.ask(`open ${name}`, this.session.open({ text: read(`scenarios/${name}.yaml`), file: `${name}.yaml` }, {}));
    await this.settled();
  }

  /** Several changes may be in progress at the same time. */
  async change(): Promise<void> {
    const before = this.made.length;
    // A scenario may have no lever, or no parameter.
    while (this.made.length === before) await this.make(this.random.weighted<Change>(WEIGHTS));
    if (this.random.next() < 0.4) await this.settled();
    else if (this.random.next() < 0.5) await turn();
  }

  private async make(change: Change): Promise<void> {
    const { session, random } = this;
    switch (change) {
      case "open":
        return random.next() < 0.5 ? this.open() : void this.ask("open nothing", session.open({ text: "version: 2", file: "bad.yaml" }, {}));
      case "lever":
        return this.moveLever();
      case "parameter":
      case "live":
        return this.setParameter(change === "live");
      case "scrub":
        return this.say("scrub", () => session.scrub(random.between(-0.1, 1.1) * (session.shown.recording?.now.time_s ?? 0)));
      case "start":
        return this.say("start", () => session.start());
      case "pause":
        return this.say("pause", () => session.pause());
      case "speed":
        return this.say("speed", () => (session.speed = random.of([0.125, 0.5, 1, 5, 20, Infinity])));
      case "step":
        return this.ask("step", session.step());
      case "advance":
        return this.ask("advance", session.advance(random.of([0, 0.002, 0.016, 0.05, 0.3])));
      case "reset":
        return this.ask("reset", session.reset());
      case "save":
        return this.ask("save", session.save());
    }
  }

  private moveLever(): void {
    const { random, session } = this;
    const inputs = session.run?.inputs ?? [];
    if (inputs.length === 0) return;
    const { name, lower, upper } = random.of(inputs);
    const reach = Math.min(upper, 50);
    const value = random.next() < 0.03 ? 2 * upper : random.next() < 0.3 ? 0 : random.between(Math.max(lower, -reach), reach);
    this.ask(`lever ${name} ${value}`, session.setInput(name, value));
  }

  private setParameter(isLive: boolean): void {
    const { random, session } = this;
    const parameters = session.run?.model.parameters.filter(({ live }) => live === isLive) ?? [];
    if (!isLive && random.next() < 0.15) return this.setNumerics();
    if (parameters.length === 0) return;
    const parameter = random.of(parameters);
    this.say(`set ${parameter.name}`, () => session.set(parameter.name, this.valueOf(parameter)));
  }

  /** Sets steps that are too long for some of the scenarios, which then diverge. */
  private setNumerics(): void {
    const { random, session } = this;
    const [name, value] = random.next() < 0.7 ? ["simulation.step_s", random.of([0.002, 0.01, 0.05, 1])] : ["simulation.integrator", random.of(["rk4", "semi_implicit_euler", "dormand_prince"])];
    if (session.run) this.say(`set ${name}`, () => session.set(name as string, value));
  }

  private valueOf({ kind, value, range, choices }: ParameterInfo): Value {
    const { random } = this;
    if (kind === "boolean") return random.next() < 0.5;
    if (kind === "choice") return random.of(choices!);
    const [low, high] = range ?? [0.5 * Number(value), 2 * Number(value)];
    return random.next() < 0.03 ? high + 10 * (high - low) + 1 : random.between(low, high);
  }

  /**
   * Checks that the bodies are at their recorded poses, to the bit. A value that was set at that moment changes loads
   * at once, but no pose.
   */
  private seeBranch(): void {
    const { now, rows } = this.session.shown.recording!;
    this.seen.branched += 1;
    if (rows.last!.time_s === now.time_s) expect(bits(now.poses), this.last()).toEqual(bits(rows.last!.poses));
  }

  private say(what: string, act: () => void): void {
    this.made.push(what);
    act();
  }

  private ask(what: string, answer: Promise<unknown>): void {
    this.made.push(what);
    this.under.add(answer);
    void answer.finally(() => this.under.delete(answer));
  }

  private see(...arrays: Float64Array[]): void {
    for (const array of arrays) expect(array.every(Number.isFinite), this.last()).toBe(true);
  }

  /** Checks that all requests are answered and that the shown values are consistent. */
  async settled(): Promise<void> {
    for (let i = 0; this.under.size > 0 || this.engine.isBusy || i < 3; i++) {
      if (i > MOST_TURNS) throw new Error(`hangs after ${this.last()}`);
      await turn();
    }
    this.check();
  }

  private check(): void {
    const { session } = this;
    const { run, status, shown, fault } = session;
    if (fault) this.seen.refused += 1;
    if (status === "stopped") this.seen.stopped += 1;
    expect(fault ? MAY_FAIL : [undefined], `${this.last()}: ${JSON.stringify(fault)}`).toContain(fault?.kind);
    if (status === "stopped") expect(fault, this.last()).not.toBeNull();
    expect(["idle", "running", "paused", "stopped"], this.last()).toContain(status);
    const recording = shown.recording!;
    this.see(recording.now.row, recording.now.poses, shown.moment!.row, shown.moment!.poses);
    const times = recording.rows.items.map(({ time_s }) => time_s);
    expect(times.every((time, i) => i === 0 || time > times[i - 1]), this.last()).toBe(true);
    expect(shown.time_s <= recording.now.time_s && times[0] === 0 && times.at(-1)! <= recording.now.time_s, this.last()).toBe(true);
    expect(status !== "idle" || recording.now.time_s === 0, this.last()).toBe(true);
    // The page's values of the run are those of the engine.
    expect(this.engine.runner.replay().time_s, this.last()).toBe(recording.now.time_s);
    expect(run!.inputs, this.last()).toEqual(this.engine.inputs());
    if (this.made.length % 20 === 0) for (const parameter of this.engine.parameters()) this.checkValue(parameter);
    expect(session.pending().every((name) => name in session.values.wanted), this.last()).toBe(true);
  }

  /** Conversion to radians and back rounds degrees. */
  private checkValue({ name, value }: ParameterInfo): void {
    const has = this.session.values.inForce[name];
    if (typeof value === "number") expect(has, `${name}: ${this.last()}`).toBeCloseTo(value, 9);
    else expect(has, `${name}: ${this.last()}`).toBe(value);
  }

  last(): string {
    return `seed ${SEED}, change ${this.made.length}: ${this.made.slice(-12).join(", ")}`;
  }
}

const turn = () => new Promise<void>((resolve) => setImmediate(resolve));

it(
  `a session stays consistent through ${CHANGES} random changes`,
  async () => {
    const trial = new Trial();
    await trial.open();
    for (let i = 0; i < CHANGES; i++) await trial.change();
    await trial.settled();
    expect(rejected).toEqual([]);
    expect(trial.made.length).toBeGreaterThan(CHANGES);
    if (CHANGES >= 3000) expect(Object.values(trial.seen).every((times) => times > 5), JSON.stringify(trial.seen)).toBe(true);
  },
  600_000,
);
