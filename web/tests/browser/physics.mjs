// The lessons on the physics: losing the load, and finding the resonance.
import assert from "node:assert/strict";
import { assertAccessible } from "./axe.mjs";
import { close as near, DESKTOP, openApp, PHONE, sample, stepTo } from "./app.mjs";

const DEGREE = Math.PI / 180;

/** The first number of a text, with the page's minus sign read as one. */
const firstNumber = (text) => Number.parseFloat(text.replaceAll("−", "-").match(/-?\d+(\.\d+)?/)[0]);
const cell = async (page, row) => firstNumber(await page.getByTestId(`loss-${row}`).textContent());

async function openLesson(host, query, lesson, viewport) {
  const { page, close } = await openApp(host, { query, viewport });
  await page.getByTestId("show-physics").click();
  await page.getByTestId(`show-lesson-${lesson}`).click();
  return { page, close };
}

/** Nothing is wider than its place. */
async function assertFits(page) {
  const tooWide = await page.evaluate(() => [document.documentElement, document.querySelector("#physics"), ...document.querySelectorAll("#physics button")].filter((one) => one.scrollWidth > one.clientWidth + 1).map((one) => one.outerHTML.slice(0, 80)));
  assert.deepEqual(tooWide, []);
}

const losing = [DESKTOP, PHONE].map((viewport) => [
  `cuts the load by the keyboard, and the ship rolls no further than her righting arms allow, ${viewport.width}x${viewport.height}`,
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
    // What she gains on the way to her new rest carries her beyond it, less what the water takes.
    const [rest, reach, furthest] = [await cell(page, "heel_after"), await cell(page, "reach"), await cell(page, "furthest")];
    assert.ok(furthest > rest + 0.7 * (reach - rest) && furthest < reach, `${rest} < ${furthest} < ${reach}`);
    assert.equal(await page.getByTestId("loss-exposed").textContent(), "held");
    // Water that enters before she has stopped is the end of her.
    await page.getByTestId("flooding").fill(String(rest + 1));
    await page.waitForFunction(() => document.querySelector("[data-testid=loss-exposed]").dataset.state === "exceeded");
    await page.getByTestId("flooding").fill("60");
    await assertFits(page);
    await page.getByTestId("before-cut").click();
    await page.waitForFunction(() => !document.querySelector("[data-testid=cut]").disabled);
    await close();
  },
]);

const palettes = [DESKTOP, PHONE].map((viewport) => [
  `passes axe with both lessons in all four palettes, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openLesson(host, "?scenario=loss_of_hook_load&timeline=false", "loss", viewport);
    await page.getByTestId("loss-reach").waitFor();
    await page.emulateMedia({ reducedMotion: "reduce" });
    for (const palette of ["day", "dusk", "night", "bright"]) {
      await page.getByTestId("show-instruments").click();
      await page.getByTestId("palette").selectOption(palette);
      await page.getByTestId("show-physics").click();
      for (const lesson of ["loss", "resonance"]) {
        await page.getByTestId(`show-lesson-${lesson}`).click();
        await assertAccessible(page, `${palette}, ${lesson}`);
      }
    }
    await close();
  },
]);

export default {
  ...Object.fromEntries(losing),
  ...Object.fromEntries(palettes),

  async "follows the timeline of a scenario that lets the load go by itself"(host) {
    const { page, close } = await openLesson(host, "?scenario=loss_of_hook_load", "loss", DESKTOP);
    await page.getByTestId("loss-reach").waitFor();
    await stepTo(page, 22);
    await page.waitForFunction(() => document.querySelector("[data-testid=cut]").disabled);
    assert.ok((await cell(page, "furthest")) > 0.5);
    await close();
  },

  async "says where nothing can be let go, and leads to the scenario that is made for it"(host) {
    const { page, close } = await openLesson(host, "?scenario=paper", "loss", DESKTOP);
    await page.getByRole("link", { name: "Open the scenario that is made for it" }).click();
    await page.waitForFunction(() => document.title.includes("loses the load"));
    await close();
  },
};
