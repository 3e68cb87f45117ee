// Menus on the picture: the viewpoints, and the overlays.
import assert from "node:assert/strict";
import { assertAccessible } from "./axe.mjs";
import { look, openApp, openFile, PHONE, picture, rested, stepTo } from "./app.mjs";

/** A buoy that moves up and down on a chain. */
const CHAIN = `version: 1
title: A buoy on a chain
simulation: {step_s: 0.05, duration_s: 10, record_every_s: 0.5}
sea: {depth_m: 40}
bodies:
  buoy:
    mass_t: 5
    shape: {sphere: {radius_m: 1}}
    joint: {prismatic: {axis: [0, 0, 1], mode: {oscillation: {amplitude_m: 1, period_s: 6, ramp_s: 2}}}}
forces:
  gravity: {gravity: {}}
  chain:
    line:
      first: {body: buoy, position_m: [0, 0, 0]}
      second: {body: world, position_m: [60, 0, -40]}
      sections: [{unstretched_length_m: 85, elements: 8, mass_kg_per_m: 20, diameter_m: 0.06, axial_stiffness_kN: 50000}]
      seabed: {friction: 0.5}
`;

/** Opens a scenario of the gallery and waits until its picture is drawn. */
async function openScenario(host, name) {
  const app = await openApp(host, { query: `?scenario=${name}`, draws: true });
  await rested(app.page);
  return app;
}

const offered = (page) => page.$$eval('#cameras input[type="radio"]', (inputs) => inputs.map(({ value }) => value));

export default {
  async "the viewpoints of a scenario are offered, and each shows its view"(host) {
    const { page, close } = await openScenario(host, "lift_off_from_barge");
    assert.deepEqual(await offered(page), ["free", "load", "cab", "bridge", "top", "section"]);
    const seen = new Set([JSON.stringify(await look(page))]);
    for (const camera of ["load", "cab", "bridge", "top", "section"]) {
      await page.getByTestId(`camera-${camera}`).evaluate((input) => input.click());
      await rested(page);
      seen.add(JSON.stringify(await look(page)));
      assert.equal(await page.getByTestId(`camera-${camera}`).isChecked(), true);
    }
    assert.equal(seen.size, 6, "each camera has a picture of its own");
    await page.getByTestId("gallery").selectOption("tennis_racket");
    await page.waitForFunction(() => document.querySelectorAll('#cameras input[type="radio"]').length === 2);
    assert.deepEqual(await offered(page), ["free", "top"]);
    assert.equal(await page.getByTestId("camera-free").isChecked(), true, "another scenario is seen from all around");
    await close();
  },

  async "a viewpoint is chosen by the keyboard, which also closes the menu"(host) {
    const { page, close } = await openScenario(host, "paper");
    await page.locator("#cameras > summary").focus();
    await page.keyboard.press("Enter");
    await page.locator("#cameras .menu-panel").waitFor();
    await page.keyboard.press("Tab");
    await page.keyboard.press("ArrowDown");
    assert.equal(await page.getByTestId("camera-cab").isChecked(), true);
    await page.keyboard.press("Escape");
    assert.equal(await page.locator("#cameras").evaluate((menu) => menu.open), false);
    assert.equal(await page.evaluate(() => document.activeElement.parentElement.id), "cameras");
    await close();
  },

  async "menus stay inside the picture on a phone, with targets that are large enough"(host) {
    const { page, close } = await openApp(host, { viewport: PHONE });
    for (const menu of ["cameras", "show"]) {
      await page.locator(`#${menu} > summary`).click();
      // The browser reports an opened menu a little later; then the menu gets its height.
      await page.waitForFunction((id) => document.querySelector(`#${id} .menu-panel`).style.maxHeight !== "", menu);
      const [panel, scene] = [await page.locator(`#${menu} .menu-panel`).boundingBox(), await page.locator("#scene").boundingBox()];
      assert.ok(panel.x >= scene.x && panel.x + panel.width <= scene.x + scene.width + 1, `${menu}: ${JSON.stringify(panel)}`);
      assert.ok(panel.y + panel.height <= scene.y + scene.height + 1, `${menu} ends in the picture`);
      const heights = await page.$$eval(`#${menu} .menu-item`, (items) => items.map((item) => item.getBoundingClientRect().height));
      assert.ok(Math.min(...heights) >= 43.9, `${menu}: ${heights}`);
    }
    await close();
  },

  async "the camera stays above the sea until it may go under water"(host) {
    const { page, close } = await openScenario(host, "barge");
    /** Turns the view down to its limit. */
    const sink = async () => {
      await page.getByTestId("canvas").focus();
      for (let i = 0; i < 30; i++) await page.keyboard.press("ArrowDown");
      await page.getByTestId("canvas").blur();
      await rested(page);
      return look(page);
    };
    const mayDive = (may) => page.getByTestId("camera-dive").evaluate((input, wanted) => input.checked === wanted || input.click(), may);
    await sink();
    const above = await sink();
    assert.deepEqual(await sink(), above, "it goes no deeper");
    await mayDive(true);
    const under = await sink();
    assert.notDeepEqual(under, above, "it dives where it may");
    await mayDive(false);
    await rested(page);
    assert.notDeepEqual(await look(page), under, "it comes up again");
    await close();
  },

  async "chosen overlays are drawn, with a scale of the arrows"(host) {
    const { page, close } = await openScenario(host, "slew_and_land");
    await stepTo(page, 1);
    assert.equal(await page.getByTestId("arrow-scale").isVisible(), false);
    for (const overlay of ["forces", "masses", "plain"]) {
      const before = await look(page);
      await page.getByTestId(`show-${overlay}`).evaluate((input) => input.click());
      await rested(page);
      assert.notDeepEqual(await look(page), before, overlay);
    }
    assert.match(await page.getByTestId("arrow-scale").textContent(), /^Force[125]0{0,2} [kM]N.*Moment[125]0{0,2} [kM]N m/);
    const bar = await page.locator("#arrow-scale i").first().boundingBox();
    assert.ok(bar.width > 10 && bar.width <= 90, `the bar is ${bar.width} pixels long`);
    await page.getByTestId("show-forces").evaluate((input) => input.click());
    await page.waitForFunction(() => document.querySelector("#arrow-scale").hidden);
    await close();
  },

  async "lines are coloured by the tension along them, with a legend"(host) {
    for (const options of [{}, { viewport: PHONE }]) {
      const { page, close } = await openApp(host, { query: "?scenario=paper", draws: true, ...options });
      const legend = page.getByTestId("tension-legend");
      assert.equal(await legend.isVisible(), false, "there are no lines");
      await openFile(page, "chain.yaml", CHAIN);
      await legend.waitFor();
      assert.match(await legend.textContent(), /^Tension along linesslacklargest so farchain[\d.]+ kN$/);
      assert.equal(await legend.locator("dl").isVisible(), options.viewport === undefined, "on a phone the numbers are folded");
      const at = await legend.boundingBox();
      const [from, to] = [at.x, at.x + at.width];
      assert.ok(from >= 0 && to <= page.viewportSize().width, `the legend is from ${from} to ${to} pixels`);
      await assertAccessible(page, "the legend of tensions");
      await close();
    }
  },

  async "joint axes and heights above the keel agree with the engine"(host) {
    const { page, close } = await openScenario(host, "vessel_knuckle_boom");
    for (const overlay of ["axes", "buoyancy"]) {
      const before = await picture(page);
      assert.equal(await picture(page), before, "a ship at rest looks the same");
      await page.getByTestId(`show-${overlay}`).evaluate((input) => input.click());
      await rested(page);
      assert.notEqual(await picture(page), before, overlay);
    }
    await close();
  },

  async "an open menu passes axe"(host) {
    const { page, close } = await openApp(host);
    for (const menu of ["cameras", "show"]) {
      await page.locator(`#${menu} > summary`).click();
      await assertAccessible(page, menu);
    }
    await close();
  },
};
