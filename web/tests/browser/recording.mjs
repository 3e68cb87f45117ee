// The recording: any moment of it is shown again, and the run branches from there.
import assert from "node:assert/strict";
import { thorough } from "../lane.mjs";
import { item, look, openApp, PHONE, rested, sample, settle, showsNumber, stepTo } from "./app.mjs";

const cursor = (page) => page.getByTestId("cursor");

/** Shows the recorded moment that is nearest to a time. */
async function scrub(page, time_s) {
  await cursor(page).evaluate((range, value) => {
    range.value = String(value);
    range.dispatchEvent(new Event("input", { bubbles: true }));
  }, time_s);
}

/**
 * Returns the share of pixels that differ between two pictures of the ship; the camera returns to its position within a
 * pixel or two.
 */
const apart = (one, other) => Math.max(...["green", "grey"].map((key) => Math.abs(one[key] - other[key]) / other[key]));

/** Runs from the moment that is shown until a time is recorded, and pauses. */
async function runPast(page, time_s) {
  await page.getByTestId("start").click();
  await page.waitForFunction((until) => window.kingpost.sample().status === "running" && window.kingpost.sample().newest_s > until, time_s);
  await page.getByTestId("start").click();
  await page.waitForFunction(() => window.kingpost.sample().status === "paused");
}

export default {
  async "any recorded moment is shown again in numbers, plots and picture, also by keys"(host) {
    const { page, close } = await openApp(host, { draws: true, scale: 1 });
    await stepTo(page, 0.4);
    const early = await sample(page);
    await rested(page);
    const pictured = await look(page);
    // The plot shows at least two decimals; their number is updated once a second.
    const plotted = () => showsNumber(page, "value-1-ship.angular_velocity.y", (early.row["ship.angular_velocity.y"] * 180) / Math.PI, 0.0051);
    await plotted();
    await stepTo(page, 1.2);
    await rested(page);
    const last = await look(page);
    await cursor(page).focus();
    await page.keyboard.press("Home");
    assert.equal((await sample(page)).time_s, 0);
    assert.equal(await page.getByTestId("cursor-time").textContent(), "0.00 / 1.20 s");
    for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowRight");
    assert.equal((await sample(page)).time_s, 0.05);
    await scrub(page, 0.4);
    const again = await sample(page);
    assert.deepEqual([again.row, again.poses, again.newest_s], [early.row, early.poses, 1.2]);
    assert.equal(await page.getByTestId("time").textContent(), "0.40 s");
    await plotted();
    assert.equal(await cursor(page).getAttribute("aria-valuetext"), "0.40 s of 1.20 s");
    assert.equal(await page.locator("#start-label").textContent(), "From here");
    await cursor(page).blur();
    await rested(page);
    const seen = await look(page);
    assert.ok(apart(seen, pictured) < 0.02, `${JSON.stringify(seen)}, then ${JSON.stringify(pictured)}`);
    assert.ok(apart(last, pictured) > 0.1, "it was another");
    await cursor(page).focus();
    await page.keyboard.press("End");
    assert.equal((await sample(page)).time_s, 1.2);
    assert.equal(await page.locator("#start-label").textContent(), "Resume");
    await close();
  },

  async "a branch without a change gives the same numbers, and later records are dropped"(host) {
    const { page, close } = await openApp(host);
    await stepTo(page, 1);
    const { row } = await sample(page);
    await scrub(page, 0.314);
    assert.equal((await sample(page)).time_s, 0.31);
    await runPast(page, 1.1);
    await scrub(page, 1);
    assert.deepEqual((await sample(page)).row, row);
    await scrub(page, 0.5);
    await page.getByTestId("step").click();
    await page.waitForFunction(() => window.kingpost.sample().newest_s === 0.51);
    assert.equal((await sample(page)).status, "paused");
    await page.getByTestId("reset").click();
    await settle(page);
    assert.deepEqual([(await sample(page)).time_s, (await sample(page)).newest_s], [0, 0]);
    await close();
  },

  ...thorough({
    async "a lever move at an earlier moment changes the future and is marked"(host) {
      const { page, close } = await openApp(host, { query: "?scenario=lowering_by_winch" });
      await stepTo(page, 3);
      const { row } = await sample(page);
      await scrub(page, 1.5);
      await item(page, "input-hoist").fill("-66");
      await item(page, "input-hoist").blur();
      await page.waitForFunction(() => window.kingpost.sample().newest_s === 1.5);
      await stepTo(page, 3);
      const other = await sample(page);
      assert.equal(other.time_s, 3);
      assert.ok(Math.abs(other.row["winch.joint_position"] - row["winch.joint_position"]) > 0.1);
      assert.deepEqual(await page.getByTestId("marks").locator("li").allTextContents(), ["1.50 s, hoist: set to -66 by hand"]);
      await scrub(page, 0.5);
      await page.getByTestId("step").click();
      await page.waitForFunction(() => window.kingpost.sample().newest_s < 1);
      assert.equal(await page.getByTestId("marks").locator("li").count(), 0);
      assert.equal(await item(page, "input-hoist").inputValue(), "0", "the lever is as it was");
      await close();
    },
  }),

  async "events are marked on the track, with their text at the pointer and the cursor"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=lift_off_from_barge" });
    await stepTo(page, 1);
    const words = /^(\d+\.\d\d) s, hull: comes as near as .* to barge_ship/;
    const marks = page.getByTestId("marks").locator("li");
    const texts = await marks.allTextContents();
    assert.ok(texts.some((text) => text.startsWith("0.00 s, operation: ")), `${texts}`);
    const mark = marks.filter({ hasText: "comes as near" });
    const [, time] = words.exec(await mark.textContent());
    const box = await mark.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + 20);
    assert.match(await cursor(page).getAttribute("title"), words);
    await scrub(page, Number(time));
    assert.match(await cursor(page).getAttribute("aria-valuetext"), /to barge_ship/);
    await close();
  },

  async "a finger on the track pauses the run and moves the shown time"(host) {
    const { page, close } = await openApp(host, { viewport: PHONE });
    await page.getByTestId("start").click();
    await page.waitForFunction(() => window.kingpost.sample().time_s > 0.5);
    const { x, y, width, height } = await cursor(page).boundingBox();
    const finger = await page.context().newCDPSession(page);
    const send = (type, share) => finger.send("Input.dispatchTouchEvent", { type, touchPoints: share === null ? [] : [{ x: x + share * width, y: y + height / 2, id: 0 }] });
    await send("touchStart", 0.8);
    for (const share of [0.7, 0.6, 0.5]) await send("touchMove", share);
    await send("touchEnd", null);
    await rested(page);
    const { status, time_s, newest_s } = await sample(page);
    assert.equal(status, "paused");
    assert.ok(Math.abs(time_s / newest_s - 0.5) < 0.05, `${time_s} of ${newest_s}`);
    await close();
  },

  async "the run pauses in a hidden tab"(host) {
    const { page, close } = await openApp(host);
    await page.getByTestId("start").click();
    await page.waitForFunction(() => window.kingpost.sample().time_s > 0.1);
    await page.evaluate(() => {
      Object.defineProperty(document, "hidden", { get: () => true, configurable: true });
      document.dispatchEvent(new Event("visibilitychange"));
    });
    await page.waitForFunction(() => window.kingpost.sample().status === "paused");
    await rested(page);
    const { newest_s } = await sample(page);
    await rested(page);
    assert.equal((await sample(page)).newest_s, newest_s);
    await close();
  },

  async "a run as fast as possible shows its speed and never counts as slow"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=barge" });
    await page.getByTestId("speed").selectOption("Infinity");
    await page.getByTestId("start").click();
    await page.waitForFunction(() => /^[\d.]+×$/.test(document.querySelector("[data-testid=pace]").textContent));
    await close();
  },
};
