import type { Run } from "../app/run";
import type { InputInfo } from "../engine/engine";
import type { Axis, Place } from "./axes";
import { Drive } from "./drive";
import { namesOf } from "./names";

/** Device by which a lever is moved. */
export type Hand = "thumb" | "keys" | "gamepad" | "slider";

/** Dead zone, as a share of the stick's travel. */
const DEAD = 0.08;
/** Number of steps of a stick from the middle to its end: a trembling thumb does not change the value. */
const PLACES = 50;

/** Returns a deflection outside the dead zone, rounded to steps; -1 to 1. */
export function withoutDeadZone(deflection: number): number {
  const size = (Math.min(1, Math.abs(deflection)) - DEAD) / (1 - DEAD);
  return size <= 0 ? 0 : (Math.sign(deflection) * Math.round(PLACES * size)) / PLACES;
}

/** An axis of a stick with the input that it sets. */
export class Lever {
  readonly drive: Drive;
  /** Whether the input is an angle or a length; the stick then sets its rate. */
  readonly isPosition: boolean;
  private readonly names: Map<string, string>;
  private readonly hands = new Map<Hand, number>();

  constructor(
    readonly axis: Axis,
    readonly place: Place,
    readonly input: InputInfo,
    run: Run,
  ) {
    this.names = namesOf(run.inputs);
    this.drive = new Drive(run, input);
    this.isPosition = input.unit === "rad" || input.unit === "m";
  }

  get name(): string {
    return this.names.get(this.input.name)!;
  }

  /** Sets the deflection by one device; null releases the lever. */
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

  /** Largest deflection by any device. */
  get deflection(): number {
    return [...this.hands.values()].reduce((most, one) => (Math.abs(one) > Math.abs(most) ? one : most), 0);
  }

  /** Value of the input: the deflection between -1 and 1 maps to the bounds of the input. */
  get value(): number {
    const share = this.signed(this.deflection);
    return share < 0 ? -share * this.input.lower : share * this.input.upper;
  }

  /** Returns the value of an angle or a length after a time, starting at `from`. */
  valueAfter(from: number, seconds: number): number {
    const rate = Number.isFinite(this.drive.greatest) ? this.drive.greatest : 1;
    const to = from + this.signed(this.deflection) * rate * seconds;
    return Math.min(this.input.upper, Math.max(this.input.lower, to));
  }

  /** Returns the deflection for a value of the input. */
  deflectionOf(value: number): number {
    if (this.isPosition) return this.deflection;
    return this.signed(value < 0 ? -value / this.input.lower : value / this.input.upper);
  }

  /** Reverses a deflection if the stick is reversed. */
  signed(share: number): number {
    return (this.place.reversed ? -share : share) || 0;
  }
}
