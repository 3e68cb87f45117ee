// Nothing is cropped on a phone or a desktop, and all controls are labelled, reachable and large enough.
import assert from "node:assert/strict";
import { cases } from "../lane.mjs";
import { DESKTOP, look, openApp, PHONE, rested, setAngle, settle, stepTo } from "./app.mjs";
import { assertAccessible } from "./axe.mjs";

const SCREENS = { phone: PHONE, "narrow phone": { width: 340, height: 640 }, "phone on its side": { width: 844, height: 390 }, desktop: DESKTOP };
/** Screens on which the page was once too small for its parts, or for the lines of its plots. */
const SMALL = { "window at 400 %": { width: 320, height: 256 }, "short phone": { width: 390, height: 460 }, tablet: { width: 1024, height: 768 }, "small window": { width: 1000, height: 640 } };
/** Smallest height of the lines of a plot, pixels. */
const PLOT_PX = 130;

/** Returns the visible targets of a finger with their sizes; a checkbox counts together with its label. */
function targets() {
  const shown = [...document.querySelectorAll("button, select, input, summary, canvas, label.item-checkbox")];
  return shown
    .filter((element) => element.checkVisibility() && element.type !== "checkbox" && element.type !== "file")
    .map((element) => {
      const { left, right, top, bottom, width, height } = element.getBoundingClientRect();
      const name = element.dataset.testid ?? element.id ?? element.textContent;
      const fixed = element.closest(".panel, .plots") === null;
      return { name: name || element.textContent.trim(), left, right, top, bottom, width, height, fixed };
    });
}

export async function assertUncropped(page, screen) {
  const scrolls = await page.evaluate(() => getComputedStyle(document.body).overflowY === "auto");
  const size = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]);
  assert.ok(size[0] <= screen.width && (scrolls || size[1] <= screen.height), `the page is ${size}, the screen ${screen.width}`);
  for (const { name, left, right, top, bottom, height, width, fixed } of await page.evaluate(targets)) {
    assert.ok(left >= -0.5 && right <= screen.width + 0.5, `${name} ends at ${left}, ${right}`);
    if (fixed && !scrolls) assert.ok(top >= -0.5 && bottom <= screen.height + 0.5, `${name} ends at ${top}, ${bottom}`);
    assert.ok(height >= 43.5 && width >= 43.5, `${name} is ${width} x ${height}`);
  }
  const cropped = await page.evaluate(() =>
    [...document.querySelectorAll(".button, .readouts dt, .readouts dd, .switcher button, .item label, .item-checkbox")]
      .filter((element) => element.checkVisibility() && element.scrollWidth > element.clientWidth + 1 && element.clientWidth > 0)
      .map((element) => element.textContent.trim()),
  );
  assert.deepEqual(cropped, [], "texts that do not fit");
}

/** Checks that lines have space, and that each axis has at least two numbers. */
async function assertPlotted(page) {
  const areas = await page.evaluate(() => [...document.querySelectorAll(".plot-area")].map(({ clientWidth, clientHeight }) => [clientWidth, clientHeight]));
  for (const [width, height] of areas) assert.ok(width >= 260 && height >= PLOT_PX, `a plot is ${width} x ${height}`);
}

/** Checks that Fit places the ship in the part of the picture that no control covers. */
async function assertInSight(page) {
  const covers = await page.evaluate(() => {
    const picture = document.getElementById("canvas").getBoundingClientRect();
    const parts = [...document.querySelectorAll(".floating, .scene-tools, .readouts")].filter((part) => part.checkVisibility());
    return parts.map((part) => part.getBoundingClientRect()).map((one) => ({ left: one.left - picture.left, right: one.right - picture.left, top: one.top - picture.top, bottom: one.bottom - picture.top }));
  });
  await page.addStyleTag({ content: ".floating, .readouts { visibility: hidden }" });
  const ship = await look(page);
  const meets = (cover) => cover.left < ship.right && cover.right > ship.left && cover.top < ship.bottom && cover.bottom > ship.top;
  assert.deepEqual(covers.filter(meets), [], `the ship is at ${JSON.stringify(ship)}`);
}

const layouts = cases(Object.entries({ ...SCREENS, ...SMALL }), ([name]) => ["desktop", "window at 400 %"].includes(name)).map(([name, viewport]) => [
  `the page crops nothing on a ${name}, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openApp(host, { draws: true, viewport });
    await assertUncropped(page, viewport);
    if (await page.getByTestId("show-plots").isVisible()) {
      await page.getByTestId("show-plots").click();
      await assertUncropped(page, viewport);
    }
    await assertPlotted(page);
    const seen = await look(page);
    assert.ok(seen.left > 3 && seen.right < seen.width - 4, `the ship is at ${seen.left} to ${seen.right} of ${seen.width}`);
    assert.ok(seen.top > 3 && seen.bottom < seen.height - 4, `the ship is at ${seen.top} to ${seen.bottom} of ${seen.height}`);
    assert.ok(seen.right - seen.left > 0.4 * Math.min(seen.width, 1.5 * seen.height), "the ship fills the picture");
    await assertInSight(page);
    await close();
  },
]);

const lookedUp = cases([DESKTOP, SMALL.tablet, PHONE, { width: 320, height: 640 }], ({ width }) => width === 320).map((viewport) => [
  `the page crops nothing at an earlier moment, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openApp(host, { viewport });
    await page.getByTestId("speed").selectOption("Infinity");
    await page.getByTestId("start").click();
    await page.waitForFunction(() => window.kingpost.sample().newest_s > 100);
    await page.getByTestId("cursor").focus();
    await page.keyboard.press("PageDown");
    await page.waitForFunction(() => document.getElementById("start-label").textContent === "From here");
    await assertUncropped(page, viewport);
    const track = await page.evaluate(() => [".track", ".scrubber-time"].map((part) => document.querySelector(part).getBoundingClientRect()).map(({ left, right, width }) => ({ left, right, width })));
    assert.ok(track[0].width > 150 && track[0].right <= track[1].left && track[1].right <= viewport.width, JSON.stringify(track));
    await close();
  },
]);

const schemes = ["light", "dark"].flatMap((colorScheme) => [PHONE, DESKTOP].map((viewport) => ({ colorScheme, viewport })));
const accessible = cases(schemes, ({ colorScheme, viewport }) => colorScheme === "dark" && viewport === PHONE).map(({ colorScheme, viewport }) => [
  `the page passes axe, ${colorScheme}, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openApp(host, { viewport, colorScheme, query: "?scenario=nonesuch" });
    await stepTo(page, 0.01);
    for (const fold of ["#advanced", "#about"]) await page.locator(`${fold} summary`).click();
    await assertAccessible(page, "with its folds open");
    await close();
  },
]);

export default {
  ...Object.fromEntries(layouts),
  ...Object.fromEntries(accessible),
  ...Object.fromEntries(lookedUp),

  async "screen readers get the state of the run and the plots as tables"(host) {
    const { page, close } = await openApp(host);
    const says = (words) => page.waitForFunction((text) => document.getElementById("announcer").textContent.startsWith(text), words);
    await says("Crane ship of Jardim et al. (2019): at the start.");
    await stepTo(page, 0.05);
    await says("Paused at 0.05 s.");
    await setAngle(page, "rad");
    // A table is written at most once a second.
    const tabled = (words) => words.every((one) => document.querySelector("[data-testid=plot-1] .visually-hidden table").textContent.includes(one));
    await page.waitForFunction(tabled, ["0.05 s", "rad/s"]);
    const rows = await page.locator("[data-testid=plot-1] .visually-hidden table tr").allTextContents();
    assert.equal(rows[0], "Pitch, rad/sYaw, rad/sRoll, rad/s");
    assert.match(rows[1], /^Min/);
    assert.match(rows[2], /^Max/);
    assert.match(rows.at(-1), /^0\.05 s−?0\.\d{5}/);
    await page.getByTestId("start").click();
    await says("Running.");
    await close();
  },

  async "controls on the picture are large enough for a finger"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=paper_true_draught", viewport: PHONE });
    await page.getByTestId("floating-warnings").waitFor();
    await assertUncropped(page, PHONE);
    await close();
  },

  async "the ship is fitted again when the window changes"(host) {
    const { page, close } = await openApp(host, { draws: true, scale: 1 });
    await page.setViewportSize(PHONE);
    await settle(page);
    await rested(page);
    await assertUncropped(page, PHONE);
    const seen = await look(page);
    assert.ok(seen.left > 3 && seen.right < seen.width - 4, `the ship is at ${seen.left} to ${seen.right} of ${seen.width}`);
    await close();
  },

  async "every control is reached by the Tab key and visible with focus"(host) {
    const { page, close } = await openApp(host);
    const wanted = await page.evaluate(() => {
      const all = [...document.querySelectorAll("button, select, input, summary, canvas")];
      return all.filter((one) => one.checkVisibility() && !one.disabled).map((one) => one.dataset.testid ?? one.id ?? one.textContent);
    });
    const reached = new Set();
    for (let i = 0; i < wanted.length + 12; i++) {
      await page.keyboard.press("Tab");
      const focus = await page.evaluate(() => {
        const one = document.activeElement;
        const framed = one.closest(".item-checkbox") ?? one;
        return { name: one.dataset.testid ?? one.id ?? one.textContent, outline: getComputedStyle(framed).outlineStyle, isBody: one === document.body };
      });
      if (!focus.isBody) assert.equal(focus.outline, "solid", `${focus.name} shows its focus`);
      reached.add(focus.name);
    }
    assert.deepEqual(wanted.filter((name) => !reached.has(name)), []);
    await close();
  },
};
