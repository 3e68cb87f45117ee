import { fixed } from "../app/format";
import { Pace } from "../app/pace";
import type { Session } from "../app/session";
import { texts } from "../texts";
import { byId, setText } from "./dom";

/** Shows the speed of the run relative to wall time, and whether it is slower than the chosen speed. */
export function showPace(session: Session): void {
  const pace = new Pace();
  const shown = byId("pace");
  const show = (): void => {
    const { factor } = pace;
    const isSlow = session.status === "running" && pace.isSlow(session.speed);
    shown.classList.toggle("is-slow", isSlow);
    const words = Number.isNaN(factor) ? "–" : `${fixed(factor, factor < 10 ? 2 : 1)}×`;
    setText(shown, isSlow ? texts.readouts.slow(words) : words);
  };
  let speed = session.speed;
  session.listen({
    statusChanged: () => {
      pace.begin();
      show();
    },
    advanced: (run, frame) => {
      if (session.status !== "running") return;
      if (session.speed !== speed) pace.begin();
      speed = session.speed;
      pace.see(performance.now() / 1000, run.columns.read(frame.row, "time"));
      show();
    },
  });
}
