import init, { Simulation } from "./pkg/kingpost_wasm.js";
import moduleUrl from "./pkg/kingpost_wasm_bg.wasm?url";
import { asFault } from "./engine";
import type { Frame, Reply, Request } from "./messages";
import { Runner } from "./runner";

/** The part of a worker's global scope that is used here. */
interface WorkerScope {
  onmessage: ((event: MessageEvent<{ id: number; request: Request }>) => void) | null;
  postMessage(message: Reply, transfer?: Transferable[]): void;
}

const scope = self as unknown as WorkerScope;
const ready = init({ module_or_path: moduleUrl });
const runner = new Runner(
  (text, file, overrides) => new Simulation(text, file, overrides, "{}"),
  () => performance.now(),
);

function answer(request: Request): unknown {
  switch (request.kind) {
    case "open":
      return runner.open(request.text, request.file, request.overrides);
    case "advance":
      return runner.advance(request.wall_s, request.speed);
    case "step":
      return runner.step();
    case "input":
      runner.input(request.name, request.value);
      return null;
  }
}

/** The buffers of a frame, wherever it stands in an answer; they are handed over, not copied. */
function buffersOf(value: unknown): Transferable[] {
  if (typeof value !== "object" || value === null) return [];
  if ("frame" in value) return buffersOf(value.frame);
  if (!("rows" in value)) return [];
  const frame = value as Frame;
  return [frame.rows.buffer, frame.row.buffer, frame.poses.buffer] as Transferable[];
}

scope.onmessage = async (event) => {
  const { id, request } = event.data;
  try {
    await ready;
    const value = answer(request);
    scope.postMessage({ id, value } satisfies Reply, buffersOf(value));
  } catch (thrown) {
    scope.postMessage({ id, fault: asFault(thrown) } satisfies Reply);
  }
};
