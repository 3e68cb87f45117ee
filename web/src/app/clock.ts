import type { Session } from "./session";

/** Asks the session for the wall time since the last frame, once per frame that the browser draws; a hidden tab pauses. */
export function runClock(session: Session, draw: () => void): void {
  let last_ms = performance.now();
  const tick = (now_ms: number) => {
    const wall_s = Math.max(0, now_ms - last_ms) / 1000;
    last_ms = now_ms;
    void session.advance(wall_s);
    draw();
    requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
  document.addEventListener("visibilitychange", () => document.hidden && session.pause());
}
