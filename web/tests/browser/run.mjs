// Drives the built app in Chromium: [KINGPOST_LANE=thorough] node tests/browser/run.mjs [part of a test's name].
import { existsSync } from "node:fs";
import { availableParallelism } from "node:os";
import { fileURLToPath } from "node:url";
import { findBrowser, launch } from "../../scripts/browser.mjs";
import { serve } from "../../scripts/serve.mjs";
import addresses from "./address.mjs";
import figure from "./figure.mjs";
import film from "./film.mjs";
import forecast from "./forecast.mjs";
import controls from "./controls.mjs";
import faults from "./faults.mjs";
import gestures from "./gestures.mjs";
import languages from "./languages.mjs";
import layout from "./layout.mjs";
import levers from "./levers.mjs";
import losses from "./losses.mjs";
import numbers from "./numbers.mjs";
import offline from "./offline.mjs";
import panels from "./panels.mjs";
import physics from "./physics.mjs";
import picture from "./picture.mjs";
import plots from "./plots.mjs";
import recording from "./recording.mjs";
import runs from "./runs.mjs";
import saving from "./saving.mjs";
import scenarios from "./scenarios.mjs";
import sea from "./sea.mjs";
import sharing from "./sharing.mjs";
import start from "./start.mjs";
import { forgetPages } from "./app.mjs";
import { isThorough, leftOut } from "../lane.mjs";

const DIST = fileURLToPath(new URL("../../dist", import.meta.url));
// Limit for tests that hang; on a busy machine a test takes minutes.
const LIMIT_MS = 600_000;
// Number of browsers at the same time; BROWSERS=1 if the duration of tests matters.
const BROWSERS = Number(process.env.BROWSERS ?? Math.min(2, availableParallelism()));

const executable = findBrowser();
if (!executable) {
  console.log("browser: skipped, there is no Chromium on this machine (CHROMIUM=path names one)");
  process.exit(0);
}
if (!existsSync(DIST)) {
  console.error("web/dist is not there: npm run build makes it");
  process.exit(1);
}

const wanted = process.argv[2] ?? "";
const SUITES = [start, scenarios, numbers, recording, controls, gestures, faults, layout, languages, addresses, losses, saving, sea, panels, physics, levers, picture, plots, runs, sharing, figure, film, offline, forecast];
const tests = SUITES.flatMap((suite) => Object.entries(suite)).filter(([name]) => name.includes(wanted));
// A path below the root, as on many static hosts.
const { address, stop } = await serve(DIST, "/a/folder/");
const waiting = [...tests];
let failed = 0;

/** Runs waiting tests in a separate browser until none is left; a failed test closes only the pages of its browser. */
async function drive() {
  const browser = await launch(executable);
  for (let next = waiting.shift(); next; next = waiting.shift()) {
    const [name, test] = next;
    const start = performance.now();
    const limit = new Promise((_, reject) => setTimeout(() => reject(new Error(`took longer than ${LIMIT_MS / 1000} s`)), LIMIT_MS).unref());
    try {
      await Promise.race([test({ browser, address }), limit]);
      console.log(`ok      ${name} (${((performance.now() - start) / 1000).toFixed(1)} s)`);
    } catch (error) {
      failed += 1;
      console.log(`FAILED  ${name}\n${error.stack ?? error}`);
      await forgetPages(browser);
    }
  }
  await browser.close();
}

await Promise.all(Array.from({ length: BROWSERS }, drive));
await stop();
if (!isThorough) console.log(`left to KINGPOST_LANE=thorough: ${leftOut} cases`);
console.log(`browser: ${tests.length - failed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
