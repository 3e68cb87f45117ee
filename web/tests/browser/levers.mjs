// The crane by hand: two thumbs on a phone, keys, a gamepad, and parameters that are set during a run.
import assert from "node:assert/strict";
import { cases, thorough } from "../lane.mjs";
import { assertAccessible } from "./axe.mjs";
import { DESKTOP, item, openApp, PHONE, sample, settle, stepTo } from "./app.mjs";

const QUAYSIDE = "?scenario=quayside_lift";
const QUAY_HEIGHT_M = 2;
const BOX_HEIGHT_M = 2.4;
const SLACK_M = 1;

/** Two thumbs, each on a stick or off it. */
class Thumbs {
  static async on(page) {
    const box = async (id) => page.getByTestId(id).boundingBox();
    const thumbs = new Thumbs();
    thumbs.page = page;
    thumbs.pads = [await box("stick-left"), await box("stick-right")];
    thumbs.down = [null, null];
    thumbs.session = await page.context().newCDPSession(page);
    return thumbs;
  }

  points() {
    const at = ({ x, y, width, height }, [across, along], id) => ({ x: x + width * (0.5 + 0.36 * across), y: y + height * (0.5 - 0.36 * along), id });
    return this.down.map((place, id) => place && at(this.pads[id], place, id)).filter((point) => point !== null);
  }

  /** Puts a thumb on a stick or moves it there; across and along from -1 to 1. */
  async move(stick, ...place) {
    const isNew = this.down[stick] === null;
    this.down[stick] = isNew ? [0, 0] : place;
    await this.session.send("Input.dispatchTouchEvent", { type: isNew ? "touchStart" : "touchMove", touchPoints: this.points() });
    if (isNew) await this.move(stick, ...place);
  }

  async letGo(stick) {
    const lifted = this.points().filter(({ id }) => id === stick);
    this.down[stick] = null;
    await this.session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: lifted });
  }
}

const LEFT = 0;
const RIGHT = 1;

/** Waits until a column of the shown row meets a condition. */
const until = (page, column, test) => page.waitForFunction(([name, body]) => new Function("value", `return ${body}`)(window.kingpost.sample().row[name]), [column, test]);
const asked = async (page, input) => Number(await page.getByTestId(`lever-${input}`).getAttribute("aria-valuenow"));
const waitAsked = (page, input, percent) => page.waitForFunction(([id, value]) => document.querySelector(`[data-testid="${id}"]`).getAttribute("aria-valuenow") === value, [`lever-${input}`, String(percent)]);

/**
 * Waits until a column meets a condition and pauses the run there, so that the next move of a thumb acts at that moment
 * also on a slow machine.
 */
async function pausedWhen(page, column, test) {
  const press = ([name, body]) => new Function("value", `return ${body}`)(window.kingpost.sample().row[name]) && (document.querySelector("[data-testid=start]").click(), true);
  await page.waitForFunction(press, [column, test]);
}

const goOn = (page) => page.evaluate(() => document.querySelector("[data-testid=start]").click());

/**
 * Lifts the box, carries it over the quay and sets it down, guided by its height and the slewing angle of the crane.
 */
async function landByThumb(page) {
  const thumbs = await Thumbs.on(page);
  await page.getByTestId("speed").selectOption("5");
  await thumbs.move(RIGHT, 0, -1);
  await goOn(page);
  await pausedWhen(page, "box.position.z", "value > 5.5");
  // Both thumbs at the same time: the hoist goes on while the crane begins to slew to port.
  await thumbs.move(LEFT, 0.8, 0);
  await goOn(page);
  await pausedWhen(page, "box.position.z", "value > 7");
  await thumbs.letGo(RIGHT);
  assert.equal(await asked(page, "hoist"), 0, "the stick springs back");
  assert.ok((await asked(page, "slewing_gear")) > 50, "the other thumb still holds its own");
  await goOn(page);
  await pausedWhen(page, "slew.joint_position", "value < -1.35");
  await thumbs.letGo(LEFT);
  await goOn(page);
  await until(page, "box.position.y", "value > 16");
  await pausedWhen(page, "slew.joint_velocity", "Math.abs(value) < 1e-3");
  await thumbs.move(RIGHT, 0, 0.9);
  await goOn(page);
  await pausedWhen(page, "box.position.z", "value < 4.3");
  await thumbs.move(RIGHT, 0, 0.4);
  await goOn(page);
  await until(page, "on_quay.contact_normal_force", "value > 4e4");
  await until(page, "hoist_rope.rope_tension", "value < 100");
  // Slack for the ship's motion: without it, the next roll of the ship would lift part of the weight again.
  const { row } = await sample(page);
  await pausedWhen(page, "hoist_rope.rope_length", `value > ${row["hoist_rope.rope_length"] + SLACK_M}`);
  await thumbs.letGo(RIGHT);
}

/** A gamepad with the standard layout, whose axes the test sets. */
async function plugIn(page) {
  await page.evaluate(() => {
    window.pad = { id: "A pad of the test", connected: true, mapping: "standard", axes: [0, 0, 0, 0], buttons: [] };
    navigator.getGamepads = () => [window.pad];
    dispatchEvent(Object.assign(new Event("gamepadconnected"), { gamepad: window.pad }));
  });
}

const screens = [PHONE, DESKTOP, { width: 320, height: 640 }, { width: 844, height: 390 }].flatMap((viewport) => ["light", "dark"].map((colorScheme) => ({ viewport, colorScheme })));
const accessible = cases(screens, ({ viewport, colorScheme }) => viewport.width === 320 && colorScheme === "light").map(({ viewport, colorScheme }) => [
  `the page with sticks passes axe, ${colorScheme}, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openApp(host, { query: QUAYSIDE, viewport, colorScheme });
    await stepTo(page, 0.1);
    const stick = await page.getByTestId("stick-right").boundingBox();
    assert.ok(stick.x + stick.width <= viewport.width && stick.y + stick.height <= viewport.height, JSON.stringify(stick));
    const left = await page.getByTestId("stick-left").boundingBox();
    assert.ok(left.x >= 0 && left.x + left.width < stick.x, "the sticks stand apart");
    assert.deepEqual(await page.evaluate(() => [document.documentElement.scrollWidth, scrollY]), [viewport.width, 0]);
    await assertAccessible(page, "with the sticks");
    await close();
  },
]);

export default {
  async "two thumbs lift a box from the deck to the quay on a phone"(host) {
    const { page, close } = await openApp(host, { query: QUAYSIDE, viewport: PHONE });
    await landByThumb(page);
    const { row } = await sample(page);
    assert.ok(Math.abs(row["box.position.z"] - QUAY_HEIGHT_M - BOX_HEIGHT_M / 2) < 0.1, `the box stands at ${row["box.position.z"]} m`);
    assert.ok(row["box.position.y"] > 12, `over the quay, at y = ${row["box.position.y"]} m`);
    assert.ok(row["on_quay.contact_normal_force"] > 4e4 && row["on_deck.contact_normal_force"] === 0, "the quay carries it");
    assert.deepEqual(await page.evaluate(() => [scrollX, scrollY, visualViewport.scale]), [0, 0, 1], "the page stands still under the thumbs");
    await close();
  },

  async "the load is visible between the sticks on a phone, and the sticks can be hidden"(host) {
    const { page, close } = await openApp(host, { query: QUAYSIDE, viewport: PHONE });
    const scene = await page.locator("#scene").boundingBox();
    for (const id of ["stick-left", "stick-right"]) {
      const { x, y, width, height } = await page.getByTestId(id).boundingBox();
      assert.ok(y > scene.y + scene.height / 2 && y + height <= scene.y + scene.height, `${id} is in the lower half of the picture`);
      assert.ok(x >= 0 && x + width <= PHONE.width && width >= 88, `${id} is ${width} wide at ${x}`);
    }
    await page.getByTestId("levers-button").click();
    assert.equal(await page.getByTestId("stick-left").isVisible(), false);
    await page.reload();
    await page.waitForFunction(() => window.kingpost?.sample());
    assert.equal(await page.getByTestId("stick-left").isVisible(), false, "they stay away");
    await page.getByTestId("levers-button").click();
    assert.equal(await page.getByTestId("stick-left").isVisible(), true);
    await page.getByTestId("gallery").selectOption("paper");
    await page.waitForFunction(() => document.title.includes("Jardim"));
    assert.equal(await page.getByTestId("levers-button").isVisible(), false, "where nothing is to steer there are no sticks");
    await close();
  },

  async "load and limits are on the picture of a phone, clear of the sticks, in both orientations"(host) {
    const areas = (page) =>
      page.evaluate(() => {
        const parts = { scene: "#scene", load: '[data-testid="cockpit-load"]', worst: '[data-testid="cockpit-worst"]', left: '[data-testid="stick-left"]', right: '[data-testid="stick-right"]', numbers: "#floating" };
        const area = (part) => (({ left, top, right, bottom }) => ({ left, top, right, bottom }))(document.querySelector(part).getBoundingClientRect());
        return Object.fromEntries(Object.entries(parts).map(([name, part]) => [name, area(part)]));
      });
    const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
    for (const viewport of [PHONE, { width: 844, height: 390 }]) {
      const { page, close } = await openApp(host, { query: QUAYSIDE, viewport });
      assert.match(await page.getByTestId("cockpit-load").textContent(), /^Hook load0\.00 \/ 7\.\d+ t$/);
      assert.match(await page.getByTestId("cockpit-worst").textContent(), /^heel−?\d\.\d+ \/ −?5 deg$/);
      const found = await areas(page);
      for (const name of ["load", "worst"]) {
        const { left, top, right, bottom } = found[name];
        assert.ok(left >= 0 && top >= found.scene.top && right <= viewport.width && bottom <= found.scene.bottom, `${name} is in the picture: ${JSON.stringify(found)}`);
        assert.deepEqual(["left", "right", "numbers"].filter((other) => meet(found[name], found[other])), [], `${name} is clear`);
      }
      assert.ok(!meet(found.numbers, found.left) && !meet(found.numbers, found.right), JSON.stringify(found));
      await close();
    }
  },

  async "the panel is a sheet over the picture of a phone, and the camera's menu closes"(host) {
    for (const viewport of [PHONE, { width: 844, height: 390 }]) {
      const { page, close } = await openApp(host, { query: QUAYSIDE, viewport });
      const before = await page.locator("#canvas").boundingBox();
      assert.equal(await page.locator("#controls").isVisible(), false, "the sticks have the picture");
      await page.getByTestId("show-controls").click();
      assert.deepEqual(await page.locator("#canvas").boundingBox(), before, "the picture keeps its size");
      const sheet = await page.locator("#controls").boundingBox();
      assert.ok(sheet.y >= before.y && sheet.y + sheet.height <= before.y + before.height + 1, JSON.stringify([before, sheet]));
      await page.getByTestId("show-controls").click();
      assert.equal(await page.locator("#controls").isVisible(), false);
      await page.locator(".skip-link").focus();
      await page.keyboard.press("Enter");
      assert.equal(await page.evaluate(() => document.activeElement.id), "controls", "the link leads to the controls");
      assert.ok(await page.locator("#controls").isVisible());
      await page.getByTestId("show-controls").click();
      await page.locator("#cameras summary").click();
      const { bottom, scrolled } = await page.evaluate(() => {
        const panel = document.querySelector("#cameras .menu-panel");
        return { bottom: panel.getBoundingClientRect().bottom, scrolled: panel.scrollHeight - panel.clientHeight };
      });
      assert.ok(scrolled <= 1 && bottom <= before.y + before.height, "every entry is visible");
      await page.getByTestId("camera-top").click();
      assert.equal(await page.locator("#cameras").getAttribute("open"), null);
      const right = await page.getByTestId("stick-right").boundingBox();
      const ahead = await page.evaluate(() => {
        const details = document.getElementById("ahead");
        details.hidden = false;
        details.open = true;
        details.querySelector("p").textContent = "Each future agrees with the wave that was measured at the ship. ".repeat(6);
        return details.getBoundingClientRect().toJSON();
      });
      assert.ok(ahead.bottom <= right.y || ahead.right <= right.x, `look-ahead ends at ${ahead.right}, ${ahead.bottom}, the stick begins at ${right.x}, ${right.y}`);
      await close();
    }
  },

  async "letter keys move the levers, except while a number is typed"(host) {
    const { page, close } = await openApp(host, { query: QUAYSIDE });
    await page.getByTestId("start").click();
    await page.keyboard.down("k");
    await page.keyboard.down("d");
    await until(page, "hoist.drive_reference_rate", "value < -0.5");
    assert.deepEqual([await asked(page, "hoist"), await asked(page, "slewing_gear")], [-100, 100]);
    assert.equal(Number(await item(page, "input-hoist").inputValue()), -2, "the slider among the controls follows");
    await page.keyboard.up("k");
    await page.keyboard.up("d");
    await waitAsked(page, "hoist", 0);
    await page.getByTestId("start").click();
    await item(page, "box_t").focus();
    await page.keyboard.press("k");
    assert.equal(await asked(page, "hoist"), 0);
    await close();
  },

  async "screen readers get the rate of a drive and its reached limit"(host) {
    const { page, close } = await openApp(host, { query: QUAYSIDE });
    const lever = page.getByTestId("lever-hoist");
    await lever.focus();
    // The test waits for the message before it appears, because it is shown only for a few seconds.
    const message = page.getByTestId("sticks-message").getByText("The run is paused").waitFor();
    await page.keyboard.press("End");
    assert.match(await lever.getAttribute("aria-valuetext"), /^command 100 %/);
    await message;
    await page.getByTestId("start").click();
    await page.waitForFunction(() => /command 100 %, rate 2.00 rad\/s, at its largest speed/.test(document.querySelector('[data-testid="lever-hoist"]').getAttribute("aria-valuetext")));
    await lever.focus();
    await page.keyboard.press("0");
    await waitAsked(page, "hoist", 0);
    await close();
  },

  ...thorough({
    async "a lever shows the engine's value after a branch and after a reset"(host) {
      const { page, close } = await openApp(host, { query: QUAYSIDE });
      await stepTo(page, 0.3);
      await page.getByTestId("lever-hoist").focus();
      for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowDown");
      await stepTo(page, 0.6);
      await page.keyboard.press("0");
      await page.getByTestId("lever-hoist").focus();
      await page.keyboard.press("0");
      await waitAsked(page, "hoist", 0);
      await stepTo(page, 0.9);
      await page.getByTestId("cursor").focus();
      for (let i = 0; i < 4; i++) await page.keyboard.press("ArrowLeft");
      await page.getByTestId("step").click();
      await waitAsked(page, "hoist", -50);
      await page.getByTestId("reset").click();
      await settle(page);
      await waitAsked(page, "hoist", 0);
      await close();
    },
  }),

  async "a gamepad moves the levers"(host) {
    const { page, close } = await openApp(host, { query: QUAYSIDE });
    await plugIn(page);
    await page.getByText("Gamepad connected").waitFor();
    await page.getByTestId("start").click();
    await page.evaluate(() => (window.pad.axes = [0, 0, 0, 1]));
    await waitAsked(page, "hoist", -100);
    await until(page, "hoist.drive_reference_rate", "value < -0.5");
    await page.evaluate(() => (window.pad.axes = [0, 0, 0, 0]));
    await waitAsked(page, "hoist", 0);
    await close();
  },

  async "the input of an axis can be changed, and the choice is stored"(host) {
    const { page, close } = await openApp(host, { query: QUAYSIDE });
    const places = () => page.evaluate(() => [...document.querySelectorAll(".stick")].map((stick) => [...stick.querySelectorAll("[role=slider]")].map((axis) => axis.getAttribute("aria-label"))));
    assert.deepEqual(await places(), [["slewing gear", "main luffing"], ["knuckle luffing", "hoist"]]);
    await page.getByTestId("choose-axes").click();
    await page.getByTestId("axis-left_y").selectOption("hoist");
    await page.getByTestId("reverse-left_y").check();
    await assertAccessible(page, "with the choice of axes");
    await page.getByTestId("axes-close").click();
    assert.deepEqual(await places(), [["slewing gear", "hoist"], ["knuckle luffing"]]);
    await page.reload();
    await page.waitForFunction(() => window.kingpost?.sample());
    assert.deepEqual(await places(), [["slewing gear", "hoist"], ["knuckle luffing"]]);
    await page.keyboard.down("w");
    await waitAsked(page, "hoist", 100);
    await page.waitForFunction(() => document.querySelector('[data-testid="parameter-input-hoist"]').value === "-2");
    await page.keyboard.up("w");
    await page.getByTestId("choose-axes").click();
    await page.getByTestId("axes-standard").click();
    await page.getByTestId("axes-close").click();
    assert.deepEqual(await places(), [["slewing gear", "main luffing"], ["knuckle luffing", "hoist"]]);
    await close();
  },

  async "a held stick keeps changing the angle of a drive"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=lowering_by_winch&winch_angle_rad=0" });
    await page.getByTestId("start").click();
    await page.keyboard.down("i");
    await until(page, "winch.joint_position", "value > 1");
    await page.keyboard.up("i");
    const { row, time_s } = await sample(page);
    await page.waitForFunction((until) => window.kingpost.sample().time_s > until, time_s + 3);
    const later = await sample(page);
    assert.ok(later.row["winch.joint_position"] < row["winch.joint_position"] + 3, "it stops where the stick is let go");
    assert.ok(Number(await item(page, "input-hoist").inputValue()) > 1);
    await close();
  },

  async "live parameters of the sea are set during a run; others wait in a pause, and restart a run that goes"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=offshore_vessel_moored" });
    await stepTo(page, 0.5);
    await page.getByTestId("slider-significant_height_m").fill("4");
    await page.waitForFunction(() => window.kingpost.sample().pending.length === 0 && document.querySelector('[data-testid="parameter-significant_height_m"]').value === "4");
    assert.equal(await page.getByTestId("restart").count(), 0);
    assert.match(await page.locator(".item", { has: item(page, "current_x_m_s") }).textContent(), /acts at once/);
    const load = page.locator(".item", { has: item(page, "load_t") });
    assert.match(await load.textContent(), /restarts the run/);
    await item(page, "load_t").fill("30");
    await item(page, "load_t").blur();
    assert.deepEqual((await sample(page)).pending, ["load_t"]);
    assert.equal(await page.getByTestId("restart").count(), 1);
    await page.getByTestId("start").click();
    await item(page, "load_t").fill("31");
    await item(page, "load_t").blur();
    await page.waitForFunction(() => window.kingpost.sample().status === "running" && window.kingpost.sample().pending.length === 0);
    assert.equal(await page.getByTestId("restart").count(), 0);
    assert.equal(await item(page, "load_t").inputValue(), "31");
    await close();
  },

  ...Object.fromEntries(accessible),
};
