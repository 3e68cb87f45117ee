// Looking ahead: futures in the plots and in the picture, with what they are and how far they are to be trusted.
import assert from "node:assert/strict";
import { openApp, stepTo } from "./app.mjs";

const line = (page) => page.getByTestId("ahead-line");

/** Painted pixels of the first plot to the right of a share of its width. */
function paintedAfter(page, share) {
  return page.evaluate((from) => {
    const canvas = document.querySelector("#plot-rates canvas");
    const { width, height } = canvas;
    const { data } = canvas.getContext("2d").getImageData(Math.floor(from * width), 0, Math.floor((1 - from) * width), height);
    let painted = 0;
    for (let i = 3; i < data.length; i += 4) if (data[i] > 0) painted += 1;
    return painted;
  }, share);
}

export default {
  async "looks ahead at a pause: 64 futures come one after another, as a fan on the plots and a cloud in the picture"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=offshore_vessel&waves=true" });
    await stepTo(page, 62);
    assert.equal(await line(page).isVisible(), false);
    const before = await paintedAfter(page, 0.6);
    await page.evaluate(() => {
      window.said = [];
      const line = document.querySelector("[data-testid=ahead-line]");
      new MutationObserver(() => window.said.push(line.textContent)).observe(line, { childList: true, characterData: true, subtree: true });
    });
    await page.getByTestId("look-ahead").click();
    await page.waitForFunction(() => window.said.some((text) => /^64 futures of 60\s+s from 62\.0\s+s\. Each agrees with the wave that was measured at the ship over the last 62\s+s\./.test(text)));
    const said = await page.evaluate(() => window.said);
    assert.ok(said.filter((text) => /^\d+ of 64 futures/.test(text)).length > 5, said.join(" | "));
    // The first minute is whole: futures of it are held against what came.
    await page.waitForFunction(() => /Their 90\s+% band held \d+\s+% of the past minute\./.test(window.said.at(-1)));
    await page.waitForTimeout(200);
    assert.ok((await paintedAfter(page, 0.6)) > before + 500, "the fan stands to the right of now");
    // Going on from there drops them; switched off they are gone.
    await page.getByTestId("look-ahead").click();
    assert.equal(await line(page).isVisible(), false);
    await page.waitForTimeout(200);
    assert.equal(await paintedAfter(page, 0.6), before);
    await close();
  },

  async "looks ahead again from an earlier moment, and while a run goes on"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=offshore_vessel&waves=true" });
    await stepTo(page, 4);
    await page.getByTestId("look-ahead").click();
    await page.waitForFunction(() => /^64 futures of 60\s+s from 4\.0\s+s/.test(document.querySelector("[data-testid=ahead-line]").textContent));
    await page.getByTestId("cursor").focus();
    await page.keyboard.press("ArrowLeft");
    await page.waitForFunction(() => /^64 futures of 60\s+s from 3\.8\s+s/.test(document.querySelector("[data-testid=ahead-line]").textContent));
    await page.getByTestId("start").click();
    await page.waitForFunction(() => Number(/from ([\d.]+)\s+s/.exec(document.querySelector("[data-testid=ahead-line]").textContent)?.[1]) > 4.5);
    await close();
  },

  async "says that there is one future where there are no waves"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=offshore_vessel" });
    await stepTo(page, 1);
    await page.getByTestId("look-ahead").click();
    await page.waitForFunction(() => /^No waves: one future of 60\s+s from 1\.0\s+s/.test(document.querySelector("[data-testid=ahead-line]").textContent));
    await close();
  },
};
