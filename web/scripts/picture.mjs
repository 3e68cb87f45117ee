// Takes the pictures of the README and of docs/app.md from the built app into docs/images/: node scripts/picture.mjs [part of a name]
// The moving one is put together by Pillow, which comes with the Python side.
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { findBrowser, launch } from "./browser.mjs";
import { serve } from "./serve.mjs";
import { ALONE, lookAt, openPage, runTo, turn } from "./shots.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const DESKTOP = { width: 1440, height: 900 };
const PHONE = { width: 390, height: 844 };
/** What stands in a picture: the address, the moment, what is opened or pressed first. */
const PICTURES = {
  "app-start.png": { query: "", viewport: DESKTOP },
  "app-lift.png": { query: "?scenario=lift_off_from_barge", time_s: 72, viewport: DESKTOP, press: ["show-instruments"] },
  "app-cab.png": { query: "?scenario=lift_off_from_barge", time_s: 45, viewport: DESKTOP, camera: "cab" },
  "app-equations.png": { query: "?scenario=paper&motor_1=true&load=true", time_s: 1.2, viewport: DESKTOP, press: ["show-equations"] },
  "app-resonance.png": { query: "?scenario=offshore_vessel&waves=true", viewport: DESKTOP, press: ["show-physics", "show-lesson-resonance", "compute-periods"], until: "25 of 25" },
  "app-phone.png": { query: "?scenario=paper&motor_1=true&load=true", time_s: 1.2, viewport: PHONE, press: ["show-plots"] },
  "app-levers.png": { query: "?scenario=quayside_lift", viewport: PHONE },
};
/** Frames of the moving picture: from when to when, how many a second of it and of the run. */
const MOVING = { query: "?scenario=slew_and_land", from_s: 20, until_s: 80, frames: 60, frames_a_second: 10, size: { width: 800, height: 450 } };

async function take(browser, address, file, { query, time_s, viewport, press = [], until, camera }) {
  const page = await openPage(browser, address, query, viewport, viewport === PHONE ? 2 : 1);
  for (const button of press) await page.getByTestId(button).click();
  if (camera) await page.getByTestId(`camera-${camera}`).evaluate((input) => input.click());
  if (time_s) await runTo(page, time_s);
  if (until) await page.getByText(until).waitFor({ timeout: 200_000 });
  // What the engine warns of would stand before the plots.
  const dismiss = page.getByTestId("run-warnings").getByLabel("Dismiss");
  if (await dismiss.isVisible()) await dismiss.click();
  await page.waitForTimeout(2500);
  await page.screenshot({ path: here(`../../docs/images/${file}`) });
  await page.context().close();
}

async function takeMoving(browser, address, file) {
  const { query, from_s, until_s, frames, frames_a_second, size } = MOVING;
  const folder = mkdtempSync(join(tmpdir(), "kingpost-"));
  const page = await openPage(browser, address, query, size);
  await runTo(page, until_s);
  await page.addStyleTag({ content: ALONE });
  await page.waitForTimeout(500);
  await turn(page, { up: -4 });
  for (let k = 0; k < frames; k += 1) {
    await lookAt(page, from_s + ((until_s - from_s) * k) / (frames - 1));
    await page.waitForTimeout(250);
    await page.screenshot({ path: join(folder, `${String(k).padStart(4, "0")}.png`) });
  }
  await page.context().close();
  execFileSync(here("../../.venv/bin/python"), [here("moving_picture.py"), folder, here(`../../docs/images/${file}`), String(1000 / frames_a_second)]);
  rmSync(folder, { recursive: true });
}

async function main(wanted) {
  const executable = findBrowser();
  if (!executable) throw new Error("there is no Chromium on this machine (CHROMIUM=path names one)");
  mkdirSync(here("../../docs/images/"), { recursive: true });
  const { address, stop } = await serve(here("../dist"), "/");
  const browser = await launch(executable);
  const files = { ...Object.fromEntries(Object.entries(PICTURES).map(([file, shot]) => [file, () => take(browser, address, file, shot)])), "app.webp": () => takeMoving(browser, address, "app.webp") };
  for (const [file, make] of Object.entries(files)) {
    if (!file.includes(wanted)) continue;
    await make();
    console.log(`docs/images/${file}`);
  }
  await browser.close();
  await stop();
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await main(process.argv[2] ?? "");
