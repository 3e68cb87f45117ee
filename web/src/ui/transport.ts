import type { Session, Status } from "../app/session";
import { fixed } from "../app/format";
import { byId, setText } from "./dom";

const PLAY = "M5 3v14l12-7z";
const PAUSE = "M4 3h4v14H4zM12 3h4v14h-4z";

/** Start and pause, step, reset and speed, and the line that says where the run stands. */
export class Transport {
  private readonly start = byId<HTMLButtonElement>("start");
  private readonly step = byId<HTMLButtonElement>("step");
  private readonly reset = byId<HTMLButtonElement>("reset");
  private readonly speed = byId<HTMLSelectElement>("speed");
  private readonly hint = byId("hint");

  constructor(private readonly session: Session) {
    this.start.addEventListener("click", () => this.toggle());
    this.step.addEventListener("click", () => void session.step());
    this.reset.addEventListener("click", () => void session.reset());
    this.speed.addEventListener("change", () => (session.speed = Number(this.speed.value)));
    session.speed = Number(this.speed.value);
    session.listen({
      statusChanged: (status) => this.show(status),
      valuesChanged: () => this.show(session.status),
    });
    this.show(session.status);
  }

  private toggle(): void {
    if (this.session.isGoing) this.session.pause();
    else this.session.start();
  }

  private show(status: Status): void {
    const running = this.session.isGoing;
    const dead = status === "stopped" || status === "loading" || status === "empty";
    setText(byId("start-label"), running ? "Pause" : status === "paused" ? "Resume" : "Start");
    byId("start-icon").setAttribute("d", running ? PAUSE : PLAY);
    this.start.disabled = dead;
    this.step.disabled = dead;
    this.reset.disabled = status === "loading" || this.session.source === null;
    const pending = status !== "idle" && status !== "empty" && this.session.pending().length > 0;
    this.reset.classList.toggle("is-due", pending || status === "stopped" || (status === "empty" && !this.reset.disabled));
    setText(this.hint, pending ? "Reset to apply the changes." : this.line(status));
    document.documentElement.dataset.status = status;
  }

  private line(status: Status): string {
    const { run, lastFrame } = this.session;
    if (status === "loading") return "Loading the engine…";
    if (status === "empty") return this.session.source ? "Reset tries again." : "Open a scenario.";
    if (!run || !lastFrame || status !== "stopped") return "";
    return `Stopped at ${fixed(run.columns.read(lastFrame.row, "time"), 3)} s. Reset to start again.`;
  }
}
