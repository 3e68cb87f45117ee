import { expectedAmplitudes } from "../forecast/sea";
import { answer } from "../engine/answers";
import { asFault } from "../engine/engine";
import init, { Simulation } from "../engine/pkg/kingpost_wasm.js";
import moduleUrl from "../engine/pkg/kingpost_wasm_bg.wasm?url";
import { FilesOfScenarios } from "../engine/scenario_files";
import type { FromSweep, Sweep } from "./messages";
import type { NaturalMode } from "./modes";
import { spectrumOf, wavesOf } from "./sea_spectrum";
import type { SeaSpectrum } from "./sea_spectrum";

interface WorkerScope {
  onmessage: ((event: MessageEvent<Sweep>) => void) | null;
  postMessage(message: FromSweep): void;
}

declare const self: WorkerScope;

self.onmessage = ({ data }) => {
  void sweep(data).then(
    () => self.postMessage({ kind: "done" }),
    (thrown) => self.postMessage({ kind: "fault", fault: asFault(thrown) }),
  );
};

async function sweep({ scenario, parameter, values }: Sweep): Promise<void> {
  await init({ module_or_path: moduleUrl });
  const files = JSON.stringify(await new FilesOfScenarios().of(scenario));
  const { text, file, overrides } = scenario;
  self.postMessage({ kind: "sea", sea: seaOf(text, file, JSON.stringify(overrides), files) });
  for (const value of values) {
    try {
      const modes = modesOf(text, file, JSON.stringify({ ...overrides, [parameter]: value }), files);
      self.postMessage({ kind: "modes", found: { value, modes } });
    } catch (thrown) {
      self.postMessage({ kind: "skipped", value, fault: asFault(thrown) });
    }
  }
}

/** Returns the modes about the equilibrium that is nearest to the start of the scenario. */
function modesOf(text: string, file: string, overrides: string, files: string): NaturalMode[] {
  const engine = new Simulation(text, file, overrides, files);
  try {
    return answer(engine, "natural_modes_json");
  } finally {
    engine.free();
  }
}

function seaOf(text: string, file: string, overrides: string, files: string): SeaSpectrum | null {
  const engine = new Simulation(text, file, overrides, files);
  const amplitudes_m = expectedAmplitudes(engine, (resolved) => new Simulation(resolved, file, "{}", files));
  const sea = spectrumOf(wavesOf(engine, amplitudes_m));
  engine.free();
  return sea;
}
