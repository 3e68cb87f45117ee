import { fixed } from "../app/format";
import { texts } from "../texts";
import { make, setText } from "../ui/dom";
import type { Doing } from "./drive";
import type { Hand, Lever } from "./lever";
import { withoutDeadZone } from "./lever";

/** Change of the deflection by one press of an arrow key. */
const KEY_STEP = 0.1;

/** Moves an axis of a stick; null releases it. */
type Take = (lever: Lever, hand: Hand, deflection: number | null) => void;

/** Display of one lever of the stick. */
interface Shown {
  lever: Lever;
  isAcross: boolean;
  slider: HTMLElement;
  mark: HTMLElement;
  line: HTMLElement;
  /** Bar with the rate of the drive over its largest rate. */
  share: HTMLElement;
}

/** A stick for a thumb: a pad with a knob, marks for the state of the drives, and a line of text for each axis. */
export class Stick {
  readonly element: HTMLElement;
  private readonly knob = make("span", { class: "stick-knob", "aria-hidden": "true" });
  private readonly pad: HTMLElement;
  private readonly axes: Shown[];
  private pointer: number | null = null;

  constructor(
    side: "left" | "right",
    levers: Lever[],
    keys: string[],
    private readonly take: Take,
  ) {
    this.axes = levers.map((lever) => this.axisOf(lever));
    const hints = keys.map((key, i) => make("kbd", { class: `stick-key stick-key-${["up", "left", "down", "right"][i]}`, "aria-hidden": "true" }, key));
    this.pad = make("div", { class: "stick-pad", "data-testid": `stick-${side}` }, ...this.axes.flatMap(({ slider, mark }) => [slider, mark]), ...hints, this.knob);
    const lines = make("div", { class: "stick-lines", "aria-hidden": "true" }, ...this.axes.map(({ line }) => line));
    this.element = make("div", { class: `stick stick-${side}`, role: "group", "aria-label": texts.levers.sides[side] }, lines, this.pad);
    this.listen();
  }

  private axisOf(lever: Lever): Shown {
    const isAcross = lever.axis.endsWith("_x");
    const way = isAcross ? "across" : "along";
    const slider = make("span", {
      class: `stick-axis stick-${way}`,
      role: "slider",
      tabindex: 0,
      "aria-label": lever.name,
      "aria-orientation": isAcross ? "horizontal" : "vertical",
      "aria-valuemin": -100,
      "aria-valuemax": 100,
      "aria-valuenow": 0,
      "data-testid": `lever-${lever.input.name}`,
    });
    slider.addEventListener("keydown", (event) => this.key(lever, event));
    const mark = make("span", { class: `stick-mark stick-mark-${way}`, "aria-hidden": "true", hidden: true });
    const share = make("span", { class: "stick-share" });
    const line = make("p", { class: "stick-line" }, make("span", { class: "stick-name" }, `${isAcross ? "↔" : "↕"} ${lever.name}`), share);
    return { lever, isAcross, slider, mark, line, share };
  }

  private listen(): void {
    const { pad } = this;
    pad.addEventListener("pointerdown", (event) => {
      if (this.pointer !== null || event.button !== 0) return;
      this.pointer = event.pointerId;
      pad.setPointerCapture(event.pointerId);
      pad.classList.add("is-held");
      this.move(event);
      event.preventDefault();
    });
    pad.addEventListener("pointermove", (event) => event.pointerId === this.pointer && this.move(event));
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const) {
      pad.addEventListener(end, (event) => event.pointerId === this.pointer && this.letGo());
    }
    // A long press must not open the browser's menu.
    pad.addEventListener("contextmenu", (event) => event.preventDefault());
  }

  private move({ clientX, clientY }: PointerEvent): void {
    const { left, top, width, height } = this.pad.getBoundingClientRect();
    const across = (clientX - left - width / 2) / (0.36 * width);
    const along = -(clientY - top - height / 2) / (0.36 * height);
    for (const { lever, isAcross } of this.axes) this.take(lever, "thumb", withoutDeadZone(isAcross ? across : along));
  }

  private letGo(): void {
    this.pointer = null;
    this.pad.classList.remove("is-held");
    for (const { lever } of this.axes) this.take(lever, "thumb", null);
  }

  /** Moves a lever by the arrow keys; it stays there when the key is released, for users of screen readers. */
  private key(lever: Lever, event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const steps: Record<string, number> = { ArrowUp: KEY_STEP, ArrowRight: KEY_STEP, ArrowDown: -KEY_STEP, ArrowLeft: -KEY_STEP, Home: -2, End: 2 };
    if (event.key in steps) this.take(lever, "slider", Math.min(1, Math.max(-1, Math.round(10 * (lever.deflection + steps[event.key])) / 10)));
    else if (["0", "Escape", "Delete", " "].includes(event.key)) this.take(lever, "slider", null);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Shows a lever's deflection and the state of its drive; null if unknown. */
  show(of: Lever, deflection: number, doing: Doing | null): void {
    const axis = this.axes.find(({ lever }) => lever === of)!;
    this.knob.style.setProperty(axis.isAcross ? "--across" : "--along", String(deflection));
    const limits = doing?.limits ?? [];
    const isHard = limits.some((limit) => limit !== "speed");
    axis.mark.hidden = !doing || !Number.isFinite(doing.share);
    axis.mark.style.setProperty("--share", String(of.signed(doing?.share || 0)));
    for (const part of [axis.mark, axis.line]) part.dataset.limit = isHard ? "hard" : limits.length > 0 ? "speed" : "none";
    const does = doing && Number.isFinite(doing.rate) ? `${fixed(doing.rate, 2)} ${of.drive.unit}` : "";
    setText(axis.share, Number.isFinite(doing?.share) ? `${fixed(100 * of.signed(doing!.share), 0)} %` : "");
    const words = [texts.levers.asked(Math.round(100 * deflection)), does && texts.levers.does(does), ...limits.map((limit) => texts.levers.limits[limit] ?? texts.levers.at_limit(limit))];
    say(axis.slider, Math.round(100 * deflection), words.filter((word) => word).join(", "));
  }
}

function say(slider: HTMLElement, value: number, text: string): void {
  if (slider.getAttribute("aria-valuetext") === text) return;
  slider.setAttribute("aria-valuenow", String(value));
  slider.setAttribute("aria-valuetext", text);
}
