import type { Run } from "../app/run";
import type { InputInfo } from "../engine/engine";
import type { Axis, Place } from "./axes";
import { Drive } from "./drive";

/** Who moves a lever. */
export type Hand = "thumb" | "keys" | "gamepad" | "slider";

/** Of the stick's way: what is less is none. */
const DEAD = 0.08;
/** Places of a stick from the middle to its end: a thumb that trembles is no new value. */
const PLACES = 50;

/** A deflection without its dead zone, in steps; -1 to 1. */
export function withoutDeadZone(deflection: number): number {
  const size = (Math.min(1, Math.abs(deflection)) - DEAD) / (1 - DEAD);
  return size <= 0 ? 0 : (Math.sign(deflection) * Math.round(PLACES * size)) / PLACES;
}

/** One axis of a stick, and the input that it sets. */
export class Lever {
  readonly drive: Drive;
  /** Whether the input is an angle or a length: the stick then says how fast it changes. */
  readonly isPosition: boolean;
  private readonly hands = new Map<Hand, number>();

  constructor(
    readonly axis: Axis,
    readonly place: Place,
    readonly input: InputInfo,
    run: Run,
  ) {
    this.drive = new Drive(run, input);
    this.isPosition = input.unit === "rad" || input.unit === "m";
  }

  get name(): string {
    return this.input.name.replaceAll("_", " ");
  }

  /** A hand moves it, or lets go of it: null. */
  take(hand: Hand, deflection: number | null): void {
    if (hand !== "slider") this.hands.delete("slider");
    if (deflection === null) this.hands.delete(hand);
    else this.hands.set(hand, deflection);
  }

  letGo(): void {
    this.hands.clear();
  }

  get isHeld(): boolean {
    return this.hands.size > 0;
  }

  /** As the hand has it that moves it farthest. */
  get deflection(): number {
    return [...this.hands.values()].reduce((most, one) => (Math.abs(one) > Math.abs(most) ? one : most), 0);
  }

  /** What the input is set to: between its ends as the stick between its own. */
  get value(): number {
    const share = this.signed(this.deflection);
    return share < 0 ? -share * this.input.lower : share * this.input.upper;
  }

  /** Where an angle or a length goes from `from` in a time. */
  valueAfter(from: number, seconds: number): number {
    const rate = Number.isFinite(this.drive.greatest) ? this.drive.greatest : 1;
    const to = from + this.signed(this.deflection) * rate * seconds;
    return Math.min(this.input.upper, Math.max(this.input.lower, to));
  }

  /** The deflection that a value of the input is. */
  deflectionOf(value: number): number {
    if (this.isPosition) return this.deflection;
    return this.signed(value < 0 ? -value / this.input.lower : value / this.input.upper);
  }

  /** From the stick's sense to the input's, and back. */
  signed(share: number): number {
    return (this.place.reversed ? -share : share) || 0;
  }
}
