import type { Moment } from "../app/recording/recording";
import type { Run, Session } from "../app/session";
import { texts } from "../texts";
import { byId, make, setText } from "../ui/dom";
import { pullByDefault } from "../ui/switcher";
import { AXES, onSticks, placesOf } from "./axes";
import type { Axis, Places } from "./axes";
import { areHidden, chosenPlaces, choosePlaces, hideSticks } from "./chosen";
import { askForPlaces } from "./dialog";
import { enableGamepad } from "./gamepad";
import { enableKeys, HINTS } from "./keys";
import { Lever } from "./lever";
import type { Hand } from "./lever";
import { Stick } from "./stick";

/** Smallest interval between two values of one lever sent to the engine, ms: each is stored with the run. */
const SEND_EVERY_MS = 60;
/** Interval between two values of an angle or a length that a stick changes, s of the run. */
const WIND_EVERY_S = 0.1;
/** Durations, ms: of a message on the screen, and of a phone's vibration at a limit. */
const MESSAGE_MS = 5000;
const SHAKE_MS = 25;

/**
 * Two sticks over the picture, for the inputs that are set by hand. A lever that is moved during a pause acts when the
 * run continues.
 */
export class Levers {
  private readonly box = byId("sticks");
  private readonly button = byId("levers-button", HTMLButtonElement);
  private readonly message = make("p", { class: "sticks-message", role: "status", "data-testid": "sticks-message" });
  private readonly calm = matchMedia("(prefers-reduced-motion: reduce)");
  private sticks: Stick[] = [];
  private levers: { lever: Lever; stick: Stick; sent_ms: number; timer: number; wound_s: number; wasAtLimit: boolean }[] = [];
  private standard: Places = {};
  private built = "";
  /** Whether the user has hidden the sticks, also if that cannot be stored. */
  private isAway = areHidden();
  private messageTimer = 0;

  constructor(private readonly session: Session) {
    this.button.addEventListener("click", () => this.toggle());
    session.listen({
      opened: (run, { poses }) => this.open(run, poses),
      branched: () => this.sendHeld(),
      inputsChanged: () => this.show(),
      moved: (_run, moment) => this.move(moment),
      statusChanged: () => this.show(),
    });
    enableKeys((axis, deflection) => this.takeAxis(axis, "keys", deflection));
    enableGamepad(
      (axis, deflection) => this.takeAxis(axis, "gamepad", deflection),
      (name, isThere) => this.say(isThere ? texts.levers.gamepad(name) : texts.levers.gamepad_gone),
    );
  }

  /** Asks the user for the input of each axis. */
  ask(): void {
    const { run } = this.session;
    if (run) askForPlaces(onSticks(run.inputs), this.places(), (places) => this.choose(run, places));
  }

  private open(run: Run, poses: ArrayLike<number>): void {
    this.standard = placesOf(run, poses);
    this.build(run);
    this.sendHeld();
    this.show();
  }

  private choose(run: Run, places: Places | null): Places {
    choosePlaces(this.file, places);
    for (const { lever } of this.levers) this.letGo(lever);
    this.build(run, places ?? this.standard);
    this.show();
    return places ?? this.standard;
  }

  private get file(): string {
    return this.session.source?.file ?? "";
  }

  private places(): Places {
    return chosenPlaces(this.file) ?? this.standard;
  }

  /** Sticks that do not change are kept, and a hand can keep holding them. */
  private build(run: Run, places = this.places()): void {
    const inputs = new Map(onSticks(run.inputs).map((input) => [input.name, input]));
    const placed = AXES.flatMap((axis) => {
      const place = places[axis];
      const input = place && inputs.get(place.input);
      return input ? [{ axis, place, input }] : [];
    });
    this.button.hidden = inputs.size === 0;
    const drives = run.model.elements.filter(({ name }) => inputs.has(name));
    const kind = JSON.stringify([placed.map(({ axis, place, input }) => [axis, place, input.lower, input.upper]), drives, run.columns.names]);
    if (kind !== this.built) this.make(placed.map(({ axis, place, input }) => new Lever(axis, place, input, run)));
    this.built = kind;
    this.showButton();
  }

  private make(levers: Lever[]): void {
    for (const { timer } of this.levers) clearTimeout(timer);
    const of = (side: "left" | "right") => levers.filter(({ axis }) => axis.startsWith(side));
    const sides = (["left", "right"] as const).filter((side) => of(side).length > 0);
    this.sticks = sides.map((side) => new Stick(side, of(side), HINTS[side], (lever, hand, deflection) => this.take(lever, hand, deflection)));
    const stickOf = ({ axis }: Lever) => this.sticks[sides.findIndex((side) => axis.startsWith(side))];
    this.levers = levers.map((lever) => ({ lever, stick: stickOf(lever), sent_ms: 0, timer: 0, wound_s: 0, wasAtLimit: false }));
    this.box.replaceChildren(...this.sticks.map(({ element }) => element), this.message);
  }

  private toggle(): void {
    this.isAway = !this.isAway;
    hideSticks(this.isAway);
    if (this.isAway) for (const { lever } of this.levers) this.letGo(lever);
    this.showButton();
    this.show();
  }

  private showButton(): void {
    this.box.hidden = this.button.hidden || this.isAway;
    this.button.setAttribute("aria-pressed", String(!this.box.hidden));
    document.documentElement.dataset.levers = this.box.hidden ? "away" : "there";
    pullByDefault(this.box.hidden ? "up" : "down");
  }

  private letGo(lever: Lever): void {
    if (!lever.isHeld) return;
    lever.letGo();
    this.send(lever);
  }

  private takeAxis(axis: Axis, hand: Hand, deflection: number | null): void {
    const found = this.levers.find(({ lever }) => lever.axis === axis);
    // Keys and a gamepad also work while another panel is open.
    if (found && (deflection === null || this.box.checkVisibility())) this.take(found.lever, hand, deflection);
  }

  private take(lever: Lever, hand: Hand, deflection: number | null): void {
    const before = [lever.isHeld, lever.deflection];
    lever.take(hand, deflection);
    if (before[0] === lever.isHeld && before[1] === lever.deflection) return;
    if (lever.deflection !== 0 && !this.session.isGoing) this.say(texts.levers.stands);
    this.sendSoon(lever);
    this.show();
  }

  /** Sends a lever's value, at most once per interval; the last value is always sent. */
  private sendSoon(lever: Lever): void {
    const own = this.levers.find((one) => one.lever === lever);
    if (!own || lever.isPosition) return;
    const wait_ms = own.sent_ms + SEND_EVERY_MS - performance.now();
    clearTimeout(own.timer);
    if (wait_ms > 0 && lever.isHeld) own.timer = window.setTimeout(() => this.sendSoon(lever), wait_ms);
    else {
      own.sent_ms = performance.now();
      this.send(lever);
    }
  }

  private send(lever: Lever): void {
    if (lever.isPosition) return;
    void this.session.setInput(lever.input.name, lever.value);
  }

  /** Sends the values of held levers again after a reset or a branch: a held lever stays where the hand holds it. */
  private sendHeld(): void {
    for (const { lever } of this.levers) if (lever.isHeld) this.send(lever);
    this.show();
  }

  private move(moment: Moment): void {
    if (this.session.status === "running") for (const own of this.levers) this.wind(own, moment.time_s);
    this.show();
  }

  /** Changes an angle or a length at the rate that the deflection gives. */
  private wind(own: (typeof this.levers)[number], time_s: number): void {
    const { lever } = own;
    if (!lever.isPosition) return;
    const passed_s = time_s - own.wound_s;
    if (lever.deflection === 0 || passed_s < 0 || passed_s > 10) own.wound_s = time_s;
    else if (passed_s >= WIND_EVERY_S) {
      own.wound_s = time_s;
      const { name } = lever.input;
      void this.session.setInput(name, lever.valueAfter(this.session.input(name), passed_s));
    }
  }

  private show(): void {
    const { run, shown } = this.session;
    const { moment } = shown;
    if (!run || !moment || this.box.hidden) return;
    for (const own of this.levers) {
      const { lever, stick } = own;
      const value = this.session.input(lever.input.name);
      const doing = lever.drive.doing(moment.row);
      stick.show(lever, lever.isHeld ? lever.deflection : lever.deflectionOf(value), doing);
      const isAtLimit = doing.limits.length > 0;
      if (isAtLimit && !own.wasAtLimit && lever.isHeld) this.shake();
      own.wasAtLimit = isAtLimit;
    }
  }

  private shake(): void {
    if (!this.calm.matches && navigator.userActivation?.hasBeenActive) navigator.vibrate?.(SHAKE_MS);
  }

  private say(text: string): void {
    setText(this.message, text);
    clearTimeout(this.messageTimer);
    this.messageTimer = window.setTimeout(() => setText(this.message, ""), MESSAGE_MS);
  }
}
