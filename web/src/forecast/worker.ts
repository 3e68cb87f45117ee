import { asFault } from "../engine/engine";
import { FilesOfScenarios } from "../engine/scenario_files";
import init, { Simulation } from "../engine/pkg/kingpost_wasm.js";
import { Futures } from "./futures";
import type { FromForeseer, ScenarioOf, ToForeseer } from "./messages";

/** Time of computation between two checks for newer messages, ms. */
const TURN_MS = 20;

interface WorkerScope {
  onmessage: ((event: MessageEvent<ToForeseer>) => void) | null;
  postMessage(message: FromForeseer, transfer?: Transferable[]): void;
}

type Look = ToForeseer & { kind: "look" };

declare const self: WorkerScope;
const files = new FilesOfScenarios();
let ready: Promise<unknown> = Promise.resolve();
/** The present job; a message may replace it while futures are computed. */
let asked: Look | null = null;
let isBusy = false;
let open: { scenario: string; futures: Futures } | null = null;

self.onmessage = ({ data }) => {
  if (data.kind === "module") ready = init({ module_or_path: data.module });
  else {
    asked = data.kind === "look" ? data : null;
    void serve();
  }
};

async function serve(): Promise<void> {
  if (isBusy) return;
  isBusy = true;
  while (asked) {
    const look: Look = asked;
    await answer(look).catch((thrown) => {
      open = null;
      self.postMessage({ kind: "fault", job: look.job, fault: asFault(thrown) });
    });
    if (asked === look) asked = null;
  }
  isBusy = false;
}

async function answer(look: Look): Promise<void> {
  const futures = await opened(look.scenario);
  futures.begin(look.start);
  for (const seed of look.seeds) {
    const running = futures.run(seed);
    let next = running.next();
    for (let since_ms = performance.now(); !next.done; next = running.next()) {
      if (performance.now() - since_ms < TURN_MS) continue;
      await messagesHeard();
      if (asked !== look) return;
      since_ms = performance.now();
    }
    self.postMessage({ kind: "future", job: look.job, future: next.value }, [next.value.rows.buffer]);
    await messagesHeard();
    if (asked !== look) return;
  }
  self.postMessage({ kind: "done", job: look.job });
}

/** Returns the opened scenario; it stays open for the next job. */
async function opened(scenario: ScenarioOf): Promise<Futures> {
  await ready;
  const key = JSON.stringify([scenario.text, scenario.file, scenario.overrides, scenario.opened]);
  if (open?.scenario === key) return open.futures;
  const texts = JSON.stringify(await files.of(scenario));
  open?.futures.free();
  open = null;
  const engine = new Simulation(scenario.text, scenario.file, JSON.stringify(scenario.overrides), texts);
  const futures = new Futures(engine, (resolved) => new Simulation(resolved, scenario.file, "{}", texts));
  open = { scenario: key, futures };
  return futures;
}

const turns = new MessageChannel();

/** Waits until new messages are received; a timer would take some ms each time. */
function messagesHeard(): Promise<void> {
  return new Promise((resolve) => {
    turns.port1.onmessage = () => resolve();
    turns.port2.postMessage(null);
  });
}
