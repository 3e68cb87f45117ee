import type { Session } from "../app/session";
import { length } from "../app/format";
import { byId, setText } from "../ui/dom";
import { View } from "./view";

/** Ties the 3D picture to the run and to its buttons; without WebGL it says so, and the rest runs. */
export function createScene(session: Session): { draw(): void } {
  let view: View;
  try {
    view = new View(byId<HTMLCanvasElement>("canvas"));
  } catch {
    const message = byId("scene-message");
    message.hidden = false;
    message.textContent = "This browser offers no WebGL, so there is no picture; the numbers and plots run.";
    return { draw() {} };
  }
  const frames = byId<HTMLButtonElement>("frames");
  frames.addEventListener("click", () => {
    const shown = frames.getAttribute("aria-pressed") !== "true";
    frames.setAttribute("aria-pressed", String(shown));
    byId("frames-legend").hidden = !shown;
    byId("scene-note").hidden = shown;
    view.showFrames(shown);
  });
  byId("fit").addEventListener("click", () => view.fit());
  session.listen({
    opened: (run, frame, isAnother) => {
      view.build(run.model, frame.poses, isAnother);
      setText(byId("scene-note"), `Grid ${length(view.spacing())}. No water in this version.`);
    },
    advanced: (_run, frame) => view.show(frame.poses),
  });
  return { draw: () => view.draw() };
}
