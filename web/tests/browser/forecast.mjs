// Forecast: futures in the plots and in the picture, with a description and their reliability.
import assert from "node:assert/strict";
import { openApp, PHONE, rested, stepTo } from "./app.mjs";
import { thorough } from "../lane.mjs";
import { assertAccessible } from "./axe.mjs";

const box = (page) => page.getByTestId("ahead");
const said = (page, pattern) => page.waitForFunction((source) => new RegExp(source).test(document.querySelector("[data-testid=ahead]").innerText.replaceAll("\u00a0", " ")), pattern.source);

/** Returns the number of painted pixels of the first plot to the right of a share of its width. */
function paintedAfter(page, share) {
  return page.evaluate((from) => {
    const canvas = document.querySelector("[data-testid=plot-1] canvas");
    const { width, height } = canvas;
    const { data } = canvas.getContext("2d").getImageData(Math.floor(from * width), 0, Math.floor((1 - from) * width), height);
    let painted = 0;
    for (let i = 3; i < data.length; i += 4) if (data[i] > 0) painted += 1;
    return painted;
  }, share);
}

const accessible = ["day", "dusk", "night", "bright"].map((palette) => [
  `the forecast line passes axe, open and closed, ${palette}`,
  async (host) => {
    const { page, close } = await openApp(host, { viewport: PHONE, query: "?scenario=offshore_vessel&waves=true" });
    await page.emulateMedia({ reducedMotion: "reduce" });
    await page.evaluate((name) => (document.documentElement.dataset.palette = name), palette);
    await page.getByTestId("look-ahead").click();
    await said(page, /^64 futures/);
    await assertAccessible(page, "before the line is touched");
    await box(page).locator("summary").click();
    await assertAccessible(page, "after");
    await close();
  },
]);

export default {
  // This computes a hundred futures of a vessel in waves, each of one minute.
  ...thorough({
    async "at a pause 64 futures are computed one after another and shown as a fan and a cloud"(host) {
      const { page, close } = await openApp(host, { query: "?scenario=offshore_vessel&waves=true" });
      await stepTo(page, 62);
      assert.equal(await box(page).isVisible(), false);
      await rested(page);
      const before = await paintedAfter(page, 0.6);
      await page.evaluate(() => {
        window.heads = [];
        const head = document.querySelector("[data-testid=ahead] summary");
        new MutationObserver(() => window.heads.push(head.textContent)).observe(head, { childList: true, characterData: true, subtree: true });
      });
      await page.getByTestId("look-ahead").click();
      await said(page, /^64 futures of 60 s/);
      await said(page, /From 62\.0 s, with the present lever positions\. Each future agrees with the wave that was measured at the ship over the last 62 s\./);
      const heads = await page.evaluate(() => window.heads);
      assert.ok(heads.filter((text) => /^\d+ of 64 futures/.test(text)).length > 5, heads.join(" | "));
      // The first minute is complete: its futures are compared with the recording.
      await said(page, /The 90 % band contained \d+ % of the recorded values of the past minute\./);
      await rested(page);
      // The table for screen readers has the same values.
      await page.waitForFunction(() => /forecast at 12[0-9.]+.s, 90.% band.*\d to .*\d/.test(document.querySelector("[data-testid=plot-1] .visually-hidden table").textContent));
      assert.ok((await paintedAfter(page, 0.6)) > before + 500, "the fan stands to the right of now");
      // Continuing the run drops the futures, and switching off hides them.
      await page.getByTestId("look-ahead").click();
      assert.equal(await box(page).isVisible(), false);
      await rested(page);
      assert.equal(await paintedAfter(page, 0.6), before);
      await close();
    },

    async "the forecast is computed again from an earlier moment and during a run"(host) {
      const { page, close } = await openApp(host, { query: "?scenario=offshore_vessel&waves=true" });
      await stepTo(page, 4);
      await page.getByTestId("look-ahead").click();
      await said(page, /^64 futures[^]*From 4\.0 s/);
      await page.getByTestId("cursor").focus();
      await page.keyboard.press("ArrowLeft");
      await said(page, /^64 futures[^]*From 3\.8 s/);
      await page.getByTestId("start").click();
      await said(page, /From (4\.[5-9]|[5-9]\.|\d\d)/);
      await close();
    },
  }),

  ...thorough(Object.fromEntries(accessible)),

  async "the forecast reports a single future without waves, until it is switched off"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=offshore_vessel" });
    await stepTo(page, 1);
    await page.getByTestId("look-ahead").click();
    await said(page, /^One future of 60 s[^]*From 1\.0 s, with the present lever positions\. Without waves/);
    await page.getByTestId("look-ahead").click();
    assert.equal(await box(page).isVisible(), false);
    await close();
  },
};
