import { swarmOf } from "../forecast/swarm";
import type { Outlook } from "../forecast/outlook";
import type { BackgroundEngine } from "../app/background_engine";
import { Playback } from "../app/recording/playback";
import type { Moment } from "../app/recording/recording";
import type { Run, Session } from "../app/session";
import type { ModelInfo } from "../engine/engine";
import { inTheSea } from "../engine/surface";
import { length } from "../app/format";
import type { Runs } from "../runs/runs";
import type { Highlight } from "../equations/highlight";
import { texts } from "../texts";
import { byId, setText } from "../ui/dom";
import { FlowArrows } from "./flow_arrows";
import type { OtherRun } from "./overlays/overlays";
import { Watched } from "./overlays/watched";
import type { Size } from "./size";
import { Stage } from "./stage";
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
  /** Shows the bodies of the kept run that the user has chosen. */
  haunt(runs: Runs): void;
  /** Returns the present picture; copy it at once, because a browser soon clears it. */
  picture(): HTMLCanvasElement | null;
  /** Returns the viewpoint as a text. */
  viewpoint(): string;
  /** Returns the viewpoints that the model offers. */
  cameras(): readonly string[];
  /** Shows a viewpoint by its text; returns false if the model does not offer it. */
  lookBy(text: string): boolean;
  /**
   * Leaves the picture to a stage of a fixed size, until the stage ends; null without WebGL, or if nothing is open. Throws
   * a TooLargeError if the graphics card cannot draw the size.
   */
  stage(size: Size): Stage | null;
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
    return { draw: () => false, highlight() {}, foresee() {}, haunt() {}, picture: () => null, viewpoint: () => "free", cameras: () => [], lookBy: () => false, stage: () => null };
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
  let isStaged = false;
  let runs: Runs | null = null;
  /** Shows what a moment has beside its poses and its sea: liquids, overlays, the ghost. */
  const complete = (run: Run, moment: Moment) => {
    view.showLevels((column) => run.columns.read(moment.row, column));
    watched.show(moment);
    view.showOther(otherAt(runs, run, moment.time_s));
  };
  return {
    draw() {
      if (isStaged) return false;
      const { run, shown } = session;
      const moment = shown.recording && shown.recording.at(timeOfPicture());
      // An unchanged picture is not drawn again; during playback every moment has other poses.
      if (run && moment && moment.poses !== drawn) {
        view.show(moment);
        view.showSea(moment.surface);
        if (tensions) view.showTensions(tensions.read(moment.row));
        legend.show(tensions);
        complete(run, moment);
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
    haunt(list) {
      runs = list;
      list.onChange(() => (drawn = null));
    },
    picture: () => view.picture(),
    viewpoint: () => view.viewpoint,
    cameras: () => view.cameras(),
    lookBy: (text) => view.lookBy(text),
    stage(size) {
      const { run, shown } = session;
      if (!run || !shown.recording) return null;
      const ended = () => {
        isStaged = false;
        drawn = null;
      };
      const stage = new Stage(view, run, shown.recording, size, (moment) => complete(run, moment), ended);
      isStaged = true;
      return stage;
    },
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

/** Returns the run that is shown as a ghost, at a time; null if there is none. */
function otherAt(runs: Runs | null, { model }: Run, time_s: number): OtherRun | null {
  const ghost = runs?.ghost ?? null;
  const poses = ghost && ghost.posesAt(time_s, model);
  return poses && { poses, colour: ghost.colour };
}

/** Returns the note on the grid and the water for the picture. */
function noteOf(model: ModelInfo, spacing: number): string {
  const { sea } = model;
  if (!sea) return texts.picture.no_water(length(spacing));
  if (inTheSea(model).length === 0) return texts.picture.water_without_hull(length(spacing));
  if (sea.wave_components === 0) return texts.picture.still_water;
  return texts.picture.waves(sea.wave_components);
}
