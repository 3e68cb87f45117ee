// Panels beside the picture: instruments with the limits of the scenario, and the equations with their numbers.
import assert from "node:assert/strict";
import { cases } from "../lane.mjs";
import { assertAccessible } from "./axe.mjs";
import { DESKTOP, openApp, PHONE, sample, stepTo } from "./app.mjs";

const all = [PHONE, DESKTOP].flatMap((viewport) => ["day", "dusk", "night", "bright"].map((palette) => ({ viewport, palette })));
const palettes = cases(all, ({ viewport, palette }) => viewport === PHONE && palette === "night").map(({ viewport, palette }) => [
  `each panel passes axe, ${palette}, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openApp(host, { viewport, query: "?scenario=slew_and_land" });
    await stepTo(page, 0.1);
    // Colours change at once: during a transition their contrast would be another.
    await page.emulateMedia({ reducedMotion: "reduce" });
    await page.getByTestId("show-instruments").click();
    await page.getByTestId("palette").selectOption(palette);
    assert.equal(await page.evaluate(() => document.documentElement.dataset.palette), palette);
    for (const panel of ["instruments", "equations", "controls"]) {
      await page.getByTestId(`show-${panel}`).click();
      if (panel === "equations") await page.locator(".matrix").waitFor();
      await assertAccessible(page, panel);
    }
    await close();
  },
]);

export default {
  ...Object.fromEntries(palettes),

  async "the bar of a limit turns red when it is exceeded, and shows its worst value at any moment"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=barge_crane_200t&limits.list.within=0.002" });
    const bar = page.getByTestId("limit-list");
    await page.getByTestId("show-instruments").click();
    assert.match(await bar.textContent(), /list.*Within ±0.002 deg/s);
    await stepTo(page, 1);
    const { row } = await sample(page);
    const heel = Math.abs((row["hull.roll"] * 180) / Math.PI);
    assert.equal(await bar.getAttribute("data-state"), heel > 0.002 ? "exceeded" : heel > 0.0018 ? "near" : "ok");
    const meter = bar.getByRole("meter");
    assert.ok(Math.abs(Math.abs(Number(await meter.getAttribute("aria-valuenow"))) - heel) < 1e-5);
    // The tab shows the state of the limits beside any other panel.
    await page.getByTestId("show-controls").click();
    assert.equal(await page.getByTestId("show-instruments").getAttribute("data-state"), await bar.getAttribute("data-state"));
    await close();
  },

  async "the matrix B has the engine's numbers at the shown moment, and a block is highlighted on the ship"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=paper&motor_1=true" });
    await page.getByTestId("show-equations").click();
    await page.locator(".matrix").waitFor();
    assert.match(await page.locator(".printed").textContent(), /eqs. 43 and 46b/);
    const cell = page.locator('.matrix td[data-block="2,2"]').first();
    const atStart = await cell.textContent();
    await stepTo(page, 1.5);
    await page.waitForFunction((before) => document.querySelector('.matrix td[data-block="2,1"]').parentElement.textContent !== before, atStart);
    await page.locator('.matrix td[data-block="4,3"]').first().click();
    await page.waitForFunction(() => document.querySelector(".matrix-detail").textContent.startsWith("arm.x_dot by luff"));
    // At unit rate of luffing, the arm's centre moves by its distance from the hinge.
    const entries = (await page.locator(".matrix-detail").textContent()).split(": ")[1].split(" ").map((text) => Number(text.replaceAll("−", "-")));
    const model = await page.evaluate(() => window.kingpost.sample().poses);
    assert.equal(entries.length, 3);
    assert.ok(Math.hypot(...entries) > 0.1 && model.every(Number.isFinite));
    // At the start of the run, B has its initial values again.
    await page.getByTestId("matrix").selectOption("M_star");
    await page.getByTestId("matrix").selectOption("B");
    await page.getByTestId("cursor").focus();
    await page.keyboard.press("Home");
    await page.waitForFunction((text) => document.querySelector('.matrix td[data-block="2,2"]')?.textContent === text, atStart);
    await close();
  },
};
