import type { Session, Status } from "../app/session";
import { fixed } from "../app/format";
import { texts } from "../texts";
import { byId, setText } from "./dom";

const words = texts.transport;

const PLAY = "M5 3v14l12-7z";
const PAUSE = "M4 3h4v14H4zM12 3h4v14h-4z";

/** Buttons to start, pause, step and reset, the choice of the speed, and the line with the state of the run. */
export class Transport {
  private readonly start = byId("start", HTMLButtonElement);
  private readonly step = byId("step", HTMLButtonElement);
  private readonly reset = byId("reset", HTMLButtonElement);
  private readonly speed = byId("speed", HTMLSelectElement);
  private readonly hint = byId("hint");
  private isBack = false;

  constructor(private readonly session: Session) {
    this.start.addEventListener("click", () => this.toggle());
    addEventListener("keydown", (event) => this.key(event));
    this.step.addEventListener("click", () => void session.step());
    this.reset.addEventListener("click", () => void session.reset());
    this.speed.addEventListener("change", () => (session.speed = Number(this.speed.value)));
    session.speed = Number(this.speed.value);
    session.listen({
      statusChanged: (status) => this.show(status),
      valuesChanged: () => this.show(session.status),
      moved: () => this.showBack(),
    });
    this.show(session.status);
  }

  private toggle(): void {
    if (this.session.isGoing) this.session.pause();
    else this.session.start();
  }

  /** Starts and pauses by Space, unless the element with focus uses it. */
  private key(event: KeyboardEvent): void {
    const { key, target, repeat, ctrlKey, metaKey, altKey } = event;
    if (key !== " " || repeat || ctrlKey || metaKey || altKey || event.defaultPrevented || this.start.disabled || byId("app").hidden) return;
    if (target instanceof Element && target.closest("input, select, textarea, button, summary, a, dialog, .panel, .plots, [role=slider], [contenteditable]")) return;
    event.preventDefault();
    this.toggle();
  }

  /** Shows whether Start continues from an earlier moment. */
  private showBack(): void {
    if (this.isBack === this.session.shown.isBack) return;
    this.isBack = this.session.shown.isBack;
    this.show(this.session.status);
  }

  private show(status: Status): void {
    const running = this.session.isGoing;
    const { isBack } = this.session.shown;
    const dead = (status === "stopped" && !isBack) || status === "empty";
    setText(byId("start-label"), running ? words.pause : isBack ? words.from_here : status === "paused" ? words.resume : words.start);
    this.start.title = isBack ? words.from_here_help : words.space;
    byId("start-icon", SVGElement).setAttribute("d", running ? PAUSE : PLAY);
    this.start.disabled = dead;
    this.step.disabled = dead || status === "loading";
    this.reset.disabled = status === "loading" || this.session.source === null;
    const pending = status !== "idle" && status !== "empty" && this.session.pending().length > 0;
    this.reset.classList.toggle("is-due", pending || status === "stopped" || (status === "empty" && !this.reset.disabled));
    setText(this.hint, pending ? words.reset_to_apply : this.line(status));
    document.documentElement.dataset.status = status;
  }

  private line(status: Status): string {
    const { run, shown } = this.session;
    if (status === "loading") return this.session.isGoing ? words.starts_then : words.loading;
    if (status === "empty") return this.session.source ? words.try_again : words.open_one;
    if (!run || !shown.recording || status !== "stopped") return "";
    return words.stopped(fixed(shown.recording.now.time_s, 3));
  }
}
