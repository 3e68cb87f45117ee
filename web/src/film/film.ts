import type { BackgroundEngine } from "../app/background_engine";
import type { Moment } from "../app/recording/recording";
import type { Session } from "../app/session";
import type { Fault } from "../engine/engine";
import type { Plot } from "../plots/plot";
import type { Scene } from "../view/scene";
import { TooLargeError } from "../view/size";
import type { Stage } from "../view/stage";
import { countOf, faultOfFilm, faultOfPicture, timeOf } from "./choice";
import type { FilmChoice, PictureChoice } from "./choice";
import { Encoder } from "./encoder";
import { MOST_PLOTS } from "./layout";
import { momentsAt } from "./moments";
import type { FilmedLines } from "./plot";
import { Sheet } from "./sheet";
import { words } from "./words";

/** Parts of the page from which pictures are made. */
export interface Studio {
  session: Session;
  background: BackgroundEngine;
  scene: Scene;
  plots(): readonly Plot[];
}

/** Called after each frame; the canvas has the frame as it was given to the encoder. */
export type Progress = (done: number, of: number, canvas: HTMLCanvasElement) => void;

/** Thrown if the user has cancelled. */
export class CancelledError extends Error {}

/**
 * Makes a film of the recorded run, frame by frame: each frame is computed and drawn for its time alone, however long
 * that takes. Throws a fault if this is not possible, and a CancelledError after `signal`.
 */
export async function makeFilm(studio: Studio, choice: FilmChoice, progress: Progress, signal: AbortSignal): Promise<Blob> {
  const { session } = studio;
  session.pause();
  const wrong = faultOfFilm(choice, session.shown.recording?.now.time_s ?? 0);
  if (wrong) throw wrong;
  const times_s = Array.from({ length: countOf(choice) }, (_, frame) => timeOf(choice, frame));
  return staged(studio, choice, [choice.from_s, choice.to_s], times_s, async (sheet, frames) => {
    const encoder = await Encoder.begin(sheet.canvas, choice.format, choice.frames_per_s);
    try {
      let done = 0;
      for await (const _ of frames) {
        await encoder.add(done);
        done += 1;
        progress(done, times_s.length, sheet.canvas);
        if (signal.aborted) throw new CancelledError();
      }
      return await encoder.finish();
    } catch (thrown) {
      await encoder.cancel();
      throw thrown;
    }
  });
}

/** Makes a picture of a moment as a PNG file: a frame of a film of `range_s`. */
export async function makePicture(studio: Studio, choice: PictureChoice, time_s: number, range_s: readonly [number, number]): Promise<Blob> {
  const wrong = faultOfPicture(choice.size);
  if (wrong) throw wrong;
  studio.session.pause();
  return staged(studio, choice, range_s, [time_s], async (sheet, frames) => {
    for await (const _ of frames);
    return (await sheet.png()) ?? refuse(words.no_picture);
  });
}

/** Draws moments one after another on a sheet, for a task that uses each of them. */
function staged<T>(studio: Studio, choice: PictureChoice, range_s: readonly [number, number], times_s: readonly number[], use: (sheet: Sheet, frames: AsyncIterable<unknown>) => Promise<T>): Promise<T> {
  const { background, session } = studio;
  const { recording } = session.shown;
  return background.lend(async (client) => {
    if (!session.run || !recording) return refuse(words.nothing_open);
    const { length } = recording.rows.items;
    const [from_s, to_s] = length > 1 && range_s[1] > range_s[0] ? range_s : [range_s[0], range_s[0] + 1];
    const sheet = new Sheet({ choice, title: session.run.model.title, plots: linesOf(studio.plots()), range_s: [from_s, to_s], recording });
    const stage = stageOf(studio.scene, sheet);
    const { run } = session;
    const draw = (moment: Moment) => {
      if (session.run !== run || session.shown.recording !== recording) refuse(words.run_changed);
      sheet.draw(stage.draw(moment), moment);
      if (stage.isLost) refuse(words.graphics_lost);
    };
    try {
      return await use(sheet, drawnBy(draw, momentsAt(client, session, times_s)));
    } finally {
      stage.end();
    }
  });
}

async function* drawnBy(draw: (moment: Moment) => void, moments: AsyncIterable<Moment>): AsyncGenerator<void> {
  for await (const moment of moments) {
    draw(moment);
    yield;
  }
}

function stageOf(scene: Scene, { ship }: Sheet): Stage {
  try {
    return scene.stage(ship) ?? refuse(words.no_graphics);
  } catch (thrown) {
    if (thrown instanceof TooLargeError) refuse(words.too_large(thrown.size.width, thrown.size.height, thrown.most));
    throw thrown;
  }
}

/** Returns the lines of the plots over time, as many plots as a picture has room for. */
function linesOf(plots: readonly Plot[]): FilmedLines[] {
  const overTime = plots.filter(({ view, drawn }) => view.kind === "time" && drawn.length > 0);
  return overTime.slice(0, MOST_PLOTS).map(({ heading, drawn }) => ({ title: heading, lines: drawn }));
}

function refuse(message: string): never {
  throw { kind: "setting", message } satisfies Fault;
}
