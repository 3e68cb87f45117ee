import { swarmOf } from "../forecast/swarm";
import type { Outlook } from "../forecast/outlook";
import type { BackgroundEngine } from "../app/background_engine";
import { Playback } from "../app/recording/playback";
import type { Session } from "../app/session";
import type { ModelInfo } from "../engine/engine";
import { inTheSea } from "../engine/surface";
import { length } from "../app/format";
import type { Highlight } from "../equations/highlight";
import { texts } from "../texts";
import { byId, setText } from "../ui/dom";
import { FlowArrows } from "./flow_arrows";
import { Watched } from "./overlays/watched";
import { Tensions } from "./tension";
import { TensionLegend } from "./tension_legend";
import { Tools } from "./tools";
import { View } from "./view";

export interface Scene {
  /** Draws the picture if something has changed; returns whether it was drawn. */
  draw(): boolean;
  /** Highlights bodies and their motion; null for nothing. */
  highlight(what: Highlight | null): void;
  /** Shows possible future positions of the loads. */
  foresee(outlook: Outlook | null): void;
  /** Returns the present picture; copy it at once, because a browser soon clears it. */
  picture(): HTMLCanvasElement | null;
  /** Returns the viewpoint as a text. */
  viewpoint(): string;
}

/**
 * Connects the 3D picture to the run and to its buttons; without WebGL it shows a message, and the rest of the page
 * works.
 */
export function createScene(session: Session, background: BackgroundEngine): Scene {
  let view: View;
  try {
    view = new View(byId("canvas", HTMLCanvasElement));
  } catch {
    const message = byId("scene-message");
    message.hidden = false;
    message.textContent = texts.picture.no_graphics;
    return { draw: () => false, highlight() {}, foresee() {}, picture: () => null, viewpoint: () => "free" };
  }
  showLosses(byId("canvas"), view);
  const watched = new Watched(session, background, view);
  const tools = new Tools(view, watched);
  const legend = new TensionLegend();
  const flows = new FlowArrows();
  let tensions: Tensions | null = null;
  byId("fit").addEventListener("click", () => view.fit());
  session.listen({
    opened: (run, frame, isAnother) => {
      tensions = new Tensions(run.lines, run.channels);
      const tints = tensions.read(frame.row);
      view.showTensions([]);
      // The view fits the ship beside the legend.
      legend.show(tensions);
      view.build(run, frame, isAnother);
      view.showTensions(tints);
      view.showLevels((column) => run.columns.read(frame.row, column));
      view.showSea(frame.surface);
      tools.offer();
      setText(byId("scene-note"), noteOf(run.model, view.spacing()));
    },
  });
  const timeOfPicture = follow(session);
  let drawn: unknown = null;
  /** Update of the futures for the next picture: futures arrive faster than pictures are drawn. */
  let due: (() => void) | null = null;
  return {
    draw() {
      const { recording } = session.shown;
      const moment = recording && recording.at(timeOfPicture());
      // An unchanged picture is not drawn again; during playback every moment has other poses.
      if (moment && moment.poses !== drawn) {
        view.show(moment);
        view.showSea(moment.surface);
        view.showLevels((column) => session.run?.columns.read(moment.row, column) ?? NaN);
        if (tensions) view.showTensions(tensions.read(moment.row));
        legend.show(tensions);
        watched.show(moment);
        drawn = moment.poses;
      }
      due?.();
      due = null;
      const isNew = view.draw();
      if (moment) flows.show(moment.surface?.flows, view.ahead);
      watched.showScale();
      return isNew;
    },
    highlight: (what) => view.highlight(what),
    foresee: (outlook) => (due = () => view.showCloud(outlook && session.run && swarmOf(outlook, session.run))),
    picture: () => view.picture(),
    viewpoint: () => view.viewpoint,
  };
}

/**
 * Returns a function for the time of the picture: during a run slightly earlier than the newest frame, otherwise the
 * moment that is shown.
 */
export function follow(session: Session): () => number {
  const playback = new Playback();
  const wall_s = () => performance.now() / 1000;
  const jump = () => playback.begin(session.shown.time_s, wall_s());
  session.listen({
    opened: jump,
    statusChanged: (status) => status === "running" && jump(),
    moved: (_run, { time_s }) => (session.status === "running" ? playback.hear(time_s, wall_s()) : jump()),
  });
  return () => playback.at(wall_s());
}

/**
 * Reports that the browser has dropped the graphics context, and repaints after it is restored, because it is then
 * empty.
 */
export function showLosses(canvas: HTMLElement, view: View): void {
  const message = byId("scene-message");
  canvas.addEventListener("webglcontextlost", () => {
    message.hidden = false;
    message.textContent = texts.picture.graphics_lost;
  });
  canvas.addEventListener("webglcontextrestored", () => {
    message.hidden = true;
    view.repaint();
  });
}

/** Returns the note on the grid and the water for the picture. */
function noteOf(model: ModelInfo, spacing: number): string {
  const { sea } = model;
  if (!sea) return texts.picture.no_water(length(spacing));
  if (inTheSea(model).length === 0) return texts.picture.water_without_hull(length(spacing));
  if (sea.wave_components === 0) return texts.picture.still_water;
  return texts.picture.waves(sea.wave_components);
}
