// Touch gestures, dropped files, and changes of the theme.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { look, openApp, PHONE, rested, stepTo } from "./app.mjs";

const paper = readFileSync(fileURLToPath(new URL("../../../scenarios/paper.yaml", import.meta.url)), "utf8");

/** Two fingers move apart about the middle of the canvas. */
async function spread(page) {
  const box = await page.getByTestId("canvas").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const fingers = (apart) => [{ x: x - apart, y, id: 0 }, { x: x + apart, y, id: 1 }];
  const session = await page.context().newCDPSession(page);
  const send = (type, touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
  await send("touchStart", fingers(30));
  for (const apart of [32, 34, 36]) await send("touchMove", fingers(apart));
  await send("touchEnd", []);
  await rested(page);
}

async function drop(page, name, text) {
  const transfer = await page.evaluateHandle(([file, content]) => {
    const data = new DataTransfer();
    data.items.add(new File([content], file, { type: "text/yaml" }));
    return data;
  }, [name, text]);
  for (const type of ["dragenter", "dragover"]) await page.dispatchEvent("#canvas", type, { dataTransfer: transfer });
  assert.equal(await page.locator("#drop").isVisible(), true, "a file over the page is welcomed");
  await page.dispatchEvent("#canvas", "drop", { dataTransfer: transfer });
  assert.equal(await page.locator("#drop").isVisible(), false);
}

export default {
  async "a pinch zooms the picture and does not scroll the page"(host) {
    const { page, close } = await openApp(host, { draws: true, reducedMotion: "no-preference", viewport: PHONE });
    await page.getByTestId("show-controls").tap();
    await rested(page);
    const before = await look(page);
    await spread(page);
    const after = await look(page);
    assert.ok(after.green > 1.15 * before.green, `green pixels: ${before.green}, then ${after.green}`);
    assert.deepEqual(await page.evaluate(() => [scrollX, scrollY, visualViewport.scale]), [0, 0, 1]);
    await close();
  },

  async "a scenario that is dropped on the page opens"(host) {
    const { page, close } = await openApp(host);
    await drop(page, "mine.yaml", paper.replace(/^title: .*/m, "title: A dropped ship"));
    await page.waitForFunction(() => document.querySelector("[data-testid=title]").textContent === "A dropped ship");
    await drop(page, "bad.yaml", "version: 2");
    await page.waitForFunction(() => document.getElementById("alert").textContent.includes("bad.yaml"));
    await stepTo(page, 0.01);
    await close();
  },

  async "the picture is drawn again after lost graphics are restored, also during a pause"(host) {
    const { page, close } = await openApp(host, { draws: true });
    await stepTo(page, 0.1);
    await rested(page);
    const before = await look(page);
    await page.evaluate(() => {
      window.graphics = document.getElementById("canvas").getContext("webgl2").getExtension("WEBGL_lose_context");
      window.graphics.loseContext();
    });
    await page.getByText("The browser dropped the graphics").waitFor();
    await page.evaluate(() => window.graphics.restoreContext());
    await page.locator("#scene-message").waitFor({ state: "hidden" });
    await rested(page);
    assert.deepEqual(await look(page), before);
    await close();
  },

  async "the page shows the speed of the run, and that it is slower than the chosen speed"(host) {
    // No machine takes this number of steps in so short a time.
    const { page, close } = await openApp(host, { query: "?scenario=flexible_boom&simulation.step_s=1e-7" });
    await page.getByTestId("speed").selectOption("20");
    await page.getByTestId("start").click();
    await page.getByText(/^[\d.]+× slow$/).waitFor();
    // The note is shown below nine tenths of the speed.
    assert.ok(Number.parseFloat(await page.getByTestId("pace").textContent()) < 18);
    await close();
  },

  async "an open page follows changes of the browser's theme"(host) {
    const { page, close } = await openApp(host, { draws: true });
    const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const [light, seenLight] = [await ground(), await look(page)];
    await page.emulateMedia({ colorScheme: "dark" });
    await rested(page);
    assert.notEqual(await ground(), light);
    assert.notDeepEqual(await look(page), seenLight);
    await stepTo(page, 0.01);
    await close();
  },
};
