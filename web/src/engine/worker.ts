import init, { Simulation } from "./pkg/kingpost_wasm.js";
import moduleUrl from "./pkg/kingpost_wasm_bg.wasm?url";
import { asFault } from "./engine";
import { faultOfLoading } from "./faults";
import { isOfGallery } from "./files";
import { holdLifeline } from "./lifeline";
import type { FromWorker, Replay, Replies, Request, ToWorker } from "./messages";
import { fetched, said } from "./network";
import { Runner } from "./runner";
import { fileNames, FilesOfScenarios } from "./scenario_files";

/** The part of a worker's global scope that this worker uses. */
interface WorkerScope {
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
  postMessage(message: FromWorker, transfer?: Transferable[]): void;
}

declare const self: WorkerScope;
const ready = load();
// The first request reports the error.
ready.catch(() => undefined);
const runner = new Runner(
  (text, file, overrides, files) => new Simulation(text, file, overrides, files),
  () => performance.now(),
);

async function load(): Promise<void> {
  try {
    const response = await fetched(moduleUrl);
    if (!response.ok) throw new Error(said(response));
    await init({ module_or_path: response });
  } catch (thrown) {
    throw faultOfLoading(asFault(thrown).message.replace(/\.$/, ""));
  }
}

const files = new FilesOfScenarios();

/** Returns the present run as a scenario, with the names of the files that must lie in its folder. */
function replay(): Replay {
  const found = runner.replay();
  return { ...found, files: fileNames(found.scenario).filter((name) => !isOfGallery(name)) };
}

async function answer(request: Request): Promise<Replies[keyof Replies]> {
  switch (request.kind) {
    case "open":
      return runner.open(request.text, request.file, request.overrides, await files.of(request), request.changes);
    case "advance":
      return runner.advance(request.wall_s, request.speed, request.until_s);
    case "step":
      return runner.step();
    case "hydrostatics":
      return runner.hydrostatics(request.without);
    case "equations":
      return runner.equations();
    case "input":
      return runner.input(request.name, request.value);
    case "replay":
      return replay();
    case "changes":
      return runner.made();
    case "snapshot":
      return runner.snapshot();
    case "restore":
      return runner.restore(request.snapshot, request.moves);
    case "resume":
      return runner.resume(request.keyframe);
    case "parameter":
      return runner.parameter(request.name, request.value);
  }
}

/** Returns the buffers of a frame in an answer; they are transferred, not copied. */
function buffersOf(value: Replies[keyof Replies]): Transferable[] {
  if (typeof value !== "object" || value === null) return [];
  if ("frame" in value) return buffersOf(value.frame);
  if (!("rows" in value)) return [];
  const { rows, row_poses, row_line_points, row, poses, line_points, surface, keyframes } = value;
  const arrays = [rows, row_poses, row_line_points, row, poses, line_points, surface?.elevation_m, ...keyframes.map(({ bytes }) => bytes)];
  return arrays.flatMap((array) => (array?.buffer instanceof ArrayBuffer ? [array.buffer] : []));
}

let turn: Promise<void> = Promise.resolve();

// Requests are handled one after another: otherwise a request could act on another scenario while an opening waits for
// a file.
self.onmessage = ({ data }) => {
  if ("isThere" in data) self.postMessage({ isAlive: true });
  else if ("lifeline" in data) holdLifeline(data.lifeline, () => self.postMessage({ holds: data.lifeline }));
  else turn = turn.then(() => settle(data));
};

async function settle({ id, request }: { id: number; request: Request }): Promise<void> {
  try {
    await ready;
    const value = await answer(request);
    self.postMessage({ id, value }, buffersOf(value));
  } catch (thrown) {
    self.postMessage({ id, fault: asFault(thrown) });
  }
}
