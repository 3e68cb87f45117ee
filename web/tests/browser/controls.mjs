// Controls, the picture and the plots.
import assert from "node:assert/strict";
import { isThorough, thorough } from "../lane.mjs";
import { item, look, openApp, rested, sample, setChecked, setNumber, settle, stepTo } from "./app.mjs";

const TOWER = 7;

export default {
  async "the space bar starts and pauses, except where an element uses it"(host) {
    const { page, close } = await openApp(host);
    await page.getByTestId("canvas").focus();
    await page.keyboard.press("Space");
    await page.waitForFunction(() => window.kingpost.sample().status === "running");
    await page.keyboard.press("Space");
    await page.waitForFunction(() => window.kingpost.sample().status === "paused");
    await item(page, "load").focus();
    await page.keyboard.press("Space");
    assert.equal((await sample(page)).status, "paused");
    await close();
  },

  async "at the start the picture follows a slider at once"(host) {
    const { page, close } = await openApp(host, { draws: true });
    const before = await look(page);
    await page.getByTestId("slider-crane_x_m").fill("8");
    await settle(page);
    const { poses, time_s } = await sample(page);
    assert.equal(time_s, 0);
    assert.deepEqual([poses[TOWER], poses[TOWER + 1]], [8, -5]);
    assert.equal(await item(page, "crane_x_m").inputValue(), "8");
    const ends = page.locator(".slider", { has: page.getByTestId("slider-crane_x_m") }).locator(".slider-end");
    assert.deepEqual(await ends.allTextContents(), ["−10", "10"]);
    await rested(page);
    const after = await look(page);
    assert.notDeepEqual(after, before);
    await close();
  },

  async "Start right after a typed value starts the run with it"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=offshore_vessel_moored" });
    const name = "parameter-load_t";
    for (const more of isThorough ? [1, 2] : [1]) {
      const value = Number(await page.getByTestId(name).inputValue());
      await page.getByTestId(name).fill(String(value + more));
      await page.getByTestId("start").click();
      await page.waitForFunction(() => window.kingpost.sample().time_s > 0);
      assert.deepEqual((await sample(page)).pending, []);
      assert.equal(Number(await page.getByTestId(name).inputValue()), value + more);
      await page.getByTestId("reset").click();
      await settle(page);
    }
    await close();
  },

  async "Pause or Reset ends a long Step"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=paper&simulation.step_s=1e-9" });
    await page.getByTestId("step").click();
    await page.waitForFunction(() => window.kingpost.sample().status === "stepping");
    assert.equal(await page.locator("#start-label").textContent(), "Pause");
    await page.getByTestId("start").click();
    await page.waitForFunction(() => window.kingpost.sample().status === "paused");
    const { time_s } = await sample(page);
    assert.ok(time_s > 0 && time_s < 0.01, `${time_s}`);
    await page.getByTestId("step").click();
    await page.waitForFunction(() => window.kingpost.sample().status === "stepping");
    await page.getByTestId("reset").click();
    await settle(page);
    assert.equal((await sample(page)).time_s, 0);
    await close();
  },

  ...thorough({
    async "a lever shows its initial value after a reset"(host) {
      const { page, close } = await openApp(host, { query: "?scenario=lowering_by_winch" });
      const lever = item(page, "input-hoist");
      const before = await lever.inputValue();
      await stepTo(page, 0.1);
      await page.getByTestId("slider-input-hoist").fill("-10");
      assert.equal(await lever.inputValue(), "-10");
      await page.getByTestId("reset").click();
      await settle(page);
      assert.equal(await lever.inputValue(), before);
      assert.equal(await page.getByTestId("slider-input-hoist").inputValue(), before);
      await close();
    },
  }),

  async "a change during a run waits for the reset, and the page reports it"(host) {
    const { page, close } = await openApp(host);
    await stepTo(page, 0.02);
    await item(page, "crane_y_m").fill("5");
    await item(page, "crane_y_m").blur();
    assert.match(await page.getByTestId("hint").textContent(), /Reset to apply/);
    assert.equal((await sample(page)).poses[TOWER + 1].toFixed(1), "-5.0");
    await page.getByTestId("reset").click();
    await settle(page);
    assert.equal((await sample(page)).poses[TOWER + 1], 5);
    assert.equal(await page.getByTestId("hint").textContent(), "");
    await close();
  },

  async "the picture has the gray tower, the green arm, and the load if it is on"(host) {
    const { page, close } = await openApp(host, { draws: true, scale: 1 });
    const seen = await look(page);
    assert.ok(seen.green > 1500, `green pixels: ${seen.green}`);
    assert.ok(seen.grey > 1500, `gray pixels: ${seen.grey}`);
    assert.equal((await sample(page)).poses.length, 4 * 7);
    await setChecked(page, "load", false);
    assert.equal((await sample(page)).poses.length, 3 * 7);
    await close();
  },

  async "keys and dragging turn the view, and Fit restores it"(host) {
    const { page, close } = await openApp(host, { draws: true });
    const fitted = await look(page);
    await page.getByTestId("canvas").focus();
    for (let i = 0; i < 6; i++) await page.keyboard.press("ArrowLeft");
    await page.getByTestId("canvas").blur();
    await rested(page);
    const turned = await look(page);
    assert.notDeepEqual(turned, fitted);
    await page.getByTestId("canvas").focus();
    const box = await page.getByTestId("canvas").boundingBox();
    await page.mouse.move(box.x + 300, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 420, box.y + 240, { steps: 4 });
    await page.mouse.up();
    await rested(page);
    assert.notDeepEqual(await look(page), turned);
    await page.keyboard.press("Home");
    await page.getByTestId("canvas").blur();
    await rested(page);
    assert.deepEqual(await look(page), fitted);
    await close();
  },

  async "body frames are drawn on demand"(host) {
    const { page, close } = await openApp(host, { draws: true });
    const before = await look(page);
    await page.getByTestId("frames").evaluate((box) => box.click());
    await rested(page);
    assert.equal(await page.getByTestId("frames").isChecked(), true);
    assert.notDeepEqual(await look(page), before);
    await close();
  },

  async "the legend shows the values at the crosshair"(host) {
    const { page, close } = await openApp(host);
    await stepTo(page, 0.3);
    await rested(page);
    const area = await page.locator("[data-testid=plot-1] .u-over").boundingBox();
    await page.mouse.move(area.x + 0.05 * area.width, area.y + 0.5 * area.height);
    // Both plots follow.
    await page.waitForFunction(() => [1, 2].every((place) => /^at 0\.\d\d s$/.test(document.querySelector(`[data-testid=plot-${place}] .plot-at`).textContent)));
    await close();
  },

  async "integrator and step size are changed in the advanced settings"(host) {
    const { page, close } = await openApp(host);
    await page.locator("#advanced summary").click();
    await page.getByTestId("parameter-simulation.integrator").selectOption("midpoint_euler");
    await settle(page);
    await setNumber(page, "simulation.step_s", 0.002);
    assert.equal(await page.getByTestId("integrator").textContent(), "Midpoint Euler");
    assert.equal(await page.getByTestId("step-size").textContent(), "2 ms");
    await stepTo(page, 0.01);
    assert.equal((await sample(page)).time_s, 0.01);
    await close();
  },
};
