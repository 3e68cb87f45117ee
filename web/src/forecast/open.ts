import type { BackgroundEngine } from "../app/background_engine";
import type { Session } from "../app/session";
import { fetched, said } from "../engine/network";
import moduleUrl from "../engine/pkg/kingpost_wasm_bg.wasm?url";
import { language } from "../texts";
import { Forecast } from "./forecast";
import { Foreseers } from "./pool";

/**
 * Largest number of engines in addition to the engine of the run. On a machine with more than two cores, one core is
 * left for the run and the page.
 */
const MOST_WORKERS = 6;

export function openForecast(session: Session, background: BackgroundEngine, folder: string): Forecast {
  const cores = navigator.hardwareConcurrency || 2;
  const count = Math.max(1, Math.min(MOST_WORKERS, cores > 2 ? cores - 1 : cores));
  const startWorker = () => new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name: language });
  return new Forecast(session, background, new Foreseers(startWorker, loadModule, count), folder);
}

/** Loads the engine's module; it is compiled once and shared by the workers. */
async function loadModule(): Promise<WebAssembly.Module> {
  const response = await fetched(moduleUrl);
  if (!response.ok) throw new Error(said(response));
  return WebAssembly.compile(await response.arrayBuffer());
}
