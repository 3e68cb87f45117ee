// Lessons: loss of the hook load, and resonance.
import assert from "node:assert/strict";
import { cases, thorough } from "../lane.mjs";
import { assertAccessible } from "./axe.mjs";
import { close as near, DESKTOP, openApp, openFile, PHONE, rested, sample, stepTo } from "./app.mjs";

const DEGREE = Math.PI / 180;

/** Returns the first number in a text; the page's minus sign counts as a minus. */
const firstNumber = (text) => Number.parseFloat(text.replaceAll("−", "-").match(/-?\d+(\.\d+)?/)[0]);
const cell = async (page, row) => firstNumber(await page.getByTestId(`loss-${row}`).textContent());

async function openLesson(host, query, lesson, viewport) {
  const { page, close } = await openApp(host, { query, viewport });
  await page.getByTestId("show-physics").click();
  await page.getByTestId(`show-lesson-${lesson}`).click();
  return { page, close };
}

/** A pendulum on a fixed support; its length is a parameter. */
const PENDULUM = `
version: 1
title: A pendulum of a length to choose
parameters:
  - {name: length_m, label: Length, unit: m, default: 20, range: [4, 52], writes: [bodies.bob.joint.revolute.child_position_m.2]}
simulation: {step_s: 0.01, duration_s: 10}
bodies:
  bob: {mass_kg: 3, shape: {point: {}}, joint: {revolute: {axis: [0, 1, 0], child_position_m: [0, 0, 20]}}}
forces: {gravity: {gravity: {}}}
`;

/** Returns the table of periods as numbers: a row for each value. */
const periods = (page) => page.locator("[data-testid=lesson-resonance] details tr").evaluateAll((rows) => rows.slice(1).map((row) => [...row.children].map((cell) => Number(cell.textContent))));

/** Computes the periods and waits for the last one. */
async function compute(page) {
  await page.getByTestId("compute-periods").click();
  await page.waitForFunction(() => /^(25 of 25|The periods)/.test(document.querySelector("[data-testid=periods-progress]").textContent));
  assert.equal(await page.getByTestId("periods-progress").textContent(), "25 of 25 values");
}

/** Checks that no element is wider than its container. */
async function assertFits(page) {
  const tooWide = await page.evaluate(() => [document.documentElement, document.querySelector("#physics"), ...document.querySelectorAll("#physics button")].filter((one) => one.scrollWidth > one.clientWidth + 1).map((one) => one.outerHTML.slice(0, 80)));
  assert.deepEqual(tooWide, []);
}

const losing = cases([DESKTOP, PHONE], (viewport) => viewport === PHONE).map((viewport) => [
  `after the load is cut by the keyboard, the ship rolls no further than her righting arms allow, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openLesson(host, "?scenario=loss_of_hook_load", "loss", viewport);
    await page.getByTestId("loss-reach").waitFor();
    const atRest = await cell(page, "heel_before");
    near(atRest, (await sample(page)).row["hull.roll"] / DEGREE, 0.05, "heel at rest, deg");
    await page.getByTestId("speed").selectOption("20");
    await page.getByTestId("cut").focus();
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => window.kingpost.sample().time_s > 20);
    await page.getByTestId("start").click();
    await page.waitForFunction(() => document.querySelector("[data-testid=cut]").disabled);
    const { row } = await sample(page);
    await page.waitForFunction((heel) => Math.abs(Number.parseFloat(document.querySelector("[data-testid=loss-now]").textContent.replace("−", "-").match(/-?[\d.]+/)[0]) - heel) < 0.01, row["hull.roll"] / DEGREE);
    // The energy gained on the way to the new equilibrium carries the ship beyond it, less the dissipation by the
    // water.
    const [rest, reach, furthest] = [await cell(page, "heel_after"), await cell(page, "reach"), await cell(page, "furthest")];
    assert.ok(furthest > rest + 0.7 * (reach - rest) && furthest < reach, `${rest} < ${furthest} < ${reach}`);
    assert.equal(await page.getByTestId("loss-exposed").textContent(), "met");
    // Water that enters before the roll stops ends area 2.
    await page.getByTestId("flooding").fill(String(rest + 1));
    await page.waitForFunction(() => document.querySelector("[data-testid=loss-exposed]").dataset.state === "exceeded");
    await page.getByTestId("flooding").fill("60");
    await assertFits(page);
    await page.getByTestId("before-cut").click();
    await page.waitForFunction(() => !document.querySelector("[data-testid=cut]").disabled);
    await close();
  },
]);

const all = [DESKTOP, PHONE].flatMap((viewport) => ["day", "dusk", "night", "bright"].map((palette) => ({ viewport, palette })));
const palettes = cases(all, ({ viewport, palette }) => viewport === PHONE && palette === "dusk").map(({ viewport, palette }) => [
  `both lessons pass axe, ${palette}, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openLesson(host, "?scenario=loss_of_hook_load&timeline=false", "loss", viewport);
    await page.getByTestId("loss-reach").waitFor();
    await page.emulateMedia({ reducedMotion: "reduce" });
    await page.getByTestId("show-instruments").click();
    await page.getByTestId("palette").selectOption(palette);
    await page.getByTestId("show-physics").click();
    for (const lesson of ["loss", "resonance"]) {
      await page.getByTestId(`show-lesson-${lesson}`).click();
      await assertAccessible(page, lesson);
    }
    await close();
  },
]);

const resonances = [DESKTOP, PHONE].map((viewport) => [
  `the lesson finds the length at resonance with the sea, sets it and runs, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openLesson(host, "?scenario=offshore_vessel&waves=true", "resonance", viewport);
    await page.getByTestId("varied").selectOption("rope_length_m");
    await compute(page);
    await assertFits(page);
    await assertAccessible(page, "with periods");
    const [peak_s] = await page.getByTestId("meetings").evaluate((list) => list.textContent.match(/peak period of the sea is (\d+\.\d+) s/).slice(1).map(Number));
    near(peak_s, 8, 0.4, "peak of the sea, s");
    // The load on its rope is nearly a pendulum: the motion of the ship and the angle of the boom change its period by
    // some per cent.
    const set = page.getByTestId("set-and-run").first();
    const length_m = Number(await set.getAttribute("data-value"));
    near(2 * Math.PI * Math.sqrt(length_m / 9.80665), peak_s, 0.1 * peak_s, "period of the load, s");
    await set.focus();
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => window.kingpost.sample().status === "running" && window.kingpost.sample().time_s > 0.5);
    assert.equal(Number(await page.getByTestId("parameter-rope_length_m").inputValue()), length_m);
    // The results remain, because they belong to the same ship in the same sea.
    assert.equal(await page.getByTestId("periods-progress").textContent(), "25 of 25 values");
    await close();
  },
]);

export default {
  // This computes the modes of a vessel twenty-five times.
  ...thorough(Object.fromEntries(resonances)),
  ...Object.fromEntries(losing),
  ...Object.fromEntries(palettes),

  ...thorough({
    async "the lesson follows a scenario whose timeline releases the load"(host) {
      const { page, close } = await openLesson(host, "?scenario=loss_of_hook_load", "loss", DESKTOP);
      await page.getByTestId("loss-reach").waitFor();
      await stepTo(page, 22);
      await page.waitForFunction(() => document.querySelector("[data-testid=cut]").disabled);
      assert.ok((await cell(page, "furthest")) > 0.5);
      await close();
    },
  }),

  async "the lesson reports a scenario without a releasable load, and links to its own scenario"(host) {
    const { page, close } = await openLesson(host, "?scenario=paper", "loss", DESKTOP);
    await page.getByRole("link", { name: "Open the scenario for this lesson" }).click();
    await page.waitForFunction(() => document.title.includes("loses the load"));
    await close();
  },

  async "a pendulum on a fixed support has the period 2 pi sqrt(L / g) at every length, and calm water is reported"(host) {
    const { page, close } = await openLesson(host, "?scenario=paper", "resonance", DESKTOP);
    await openFile(page, "pendulum.yaml", PENDULUM);
    await page.waitForFunction(() => document.title.includes("pendulum"));
    await compute(page);
    const rows = await periods(page);
    assert.equal(rows.length, 25);
    for (const [length_m, period_s] of rows) near(period_s, 2 * Math.PI * Math.sqrt(length_m / 9.80665), 0.0051, `period at ${length_m} m, s`);
    assert.match(await page.getByTestId("meetings").textContent(), /calm/);
    await close();
  },

  async "impossible values are left out, with the reason"(host) {
    const { page, close } = await openLesson(host, "?scenario=paper", "resonance", DESKTOP);
    // A bob of negative mass, and one of zero mass.
    await openFile(page, "pendulum.yaml", PENDULUM.replace("[4, 52]", "[-1, 23]").replace("bodies.bob.joint.revolute.child_position_m.2", "bodies.bob.mass_kg"));
    await page.waitForFunction(() => document.title.includes("pendulum"));
    await compute(page);
    assert.match(await page.getByTestId("skipped").textContent(), /^2 values were left out: -1 m: .*mass_kg: found -1, allowed/);
    await close();
  },

  async "Stop ends the sweep"(host) {
    const { page, close } = await openLesson(host, "?scenario=offshore_vessel", "resonance", DESKTOP);
    const button = page.getByTestId("compute-periods");
    await rested(page);
    const engines = page.workers().length;
    // Both in one call, so that a fast machine does not finish before the stop.
    const said = await button.evaluate((element) => {
      element.click();
      const between = element.textContent;
      element.click();
      return [between, element.textContent];
    });
    assert.deepEqual(said, ["Stop", "Compute the periods"]);
    // The worker ends, and its computation with it.
    while (page.workers().length > engines) await page.evaluate(() => new Promise(requestAnimationFrame));
    assert.doesNotMatch(await page.getByTestId("periods-progress").textContent(), /^25 of 25/);
    await close();
  },
};
