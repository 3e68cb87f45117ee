import type { Session } from "./session";

/**
 * Passes the wall time since the last frame to the session, once per frame of the browser; a hidden tab draws no
 * frames, so the run stops.
 */
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
