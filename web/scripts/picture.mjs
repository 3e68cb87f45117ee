// Takes the pictures of the README from the built app: docs/images/app.png and app-phone.png.
import { mkdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { setChecked, stepTo } from "../tests/browser/app.mjs";
import { findBrowser, launch } from "./browser.mjs";
import { serve } from "./serve.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const PICTURES = [
  {
    file: "app.png",
    scenario: "offshore_vessel",
    viewport: { width: 1440, height: 900 },
    scale: 1,
    time_s: 65,
    turn_on: "waves",
  },
  {
    file: "app-phone.png",
    scenario: "paper",
    viewport: { width: 390, height: 844 },
    scale: 2,
    time_s: 1.2,
    panel: "plots",
  },
];

const executable = findBrowser();
if (!executable) throw new Error("there is no Chromium on this machine (CHROMIUM=path names one)");
const folder = here("../../docs/images/");
mkdirSync(folder, { recursive: true });
const { address, stop } = await serve(here("../dist"), "/");
const browser = await launch(executable);
for (const { file, scenario, viewport, scale, time_s, panel, turn_on } of PICTURES) {
  const context = await browser.newContext({ viewport, deviceScaleFactor: scale, colorScheme: "light", serviceWorkers: "block" });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  await page.goto(`${address}?scenario=${scenario}`);
  await page.waitForFunction(() => window.kingpost?.sample());
  if (turn_on) await setChecked(page, turn_on, true);
  if (panel) await page.getByTestId(`show-${panel}`).click();
  await stepTo(page, time_s);
  // What the engine warns of would stand before the plots.
  const dismiss = page.getByTestId("run-warnings").getByLabel("Dismiss");
  if (await dismiss.isVisible()) await dismiss.click();
  await page.waitForTimeout(2000);
  await page.screenshot({ path: folder + file });
  console.log(`docs/images/${file}`);
  await context.close();
}
await browser.close();
await stop();
