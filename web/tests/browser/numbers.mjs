// The app's numbers compared with the paper's reference row and with native golden runs.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { close, openApp, rested, sample, setAngle, setChecked, setFigures, settle, showsNumber, stepTo } from "./app.mjs";

const GOLDEN = fileURLToPath(new URL("../../../crates/kingpost/tests/golden/paper.json", import.meta.url));
const goldens = JSON.parse(readFileSync(GOLDEN, "utf8"));
const golden = (name) => goldens.find((one) => one.name === name);

/** Reference values: ship's centre fixed, crane at the centre, no load, only the tower's motor, t = 0.5 s. */
const TRUTH = {
  "ship.angular_velocity.y": 0.19709,
  "ship.angular_velocity.z": -0.12348,
  "ship.angular_velocity.x": -0.07719,
  "slew.joint_velocity": 6.6699,
  "luff.joint_velocity": 0.0338,
  "slew.joint_position": 1.7159,
  "luff.joint_position": 0.0632,
};

/** Tolerances: half a unit of the last given digit, but at least 1e-5 for the ship's rates. */
const tolerance = (name) => (name.startsWith("ship.") ? 1e-5 : 5.001e-5);

function assertBits(actual, expected) {
  const values = Object.values(actual);
  assert.equal(values.length, expected.length);
  Object.keys(actual).forEach((name, i) => assert.ok(Object.is(values[i], expected[i]), `${name}: ${values[i]}, native ${expected[i]}`));
}

export default {
  async "the app opens with the paper's ship: stern corner, load on, pulse, motor 1"(host) {
    const { page, close: done } = await openApp(host);
    const says = async (name) => page.getByTestId(`parameter-${name}`);
    for (const [name, checked] of [["motor_1", true], ["motor_2", false], ["load", true], ["hold_centre", true]]) {
      assert.equal(await (await says(name)).isChecked(), checked, name);
    }
    assert.equal(await (await says("torque_history")).inputValue(), "pulse");
    assert.equal(await (await says("crane_x_m")).inputValue(), "-10");
    assert.equal(await (await says("crane_y_m")).inputValue(), "-5");
    assert.equal((await sample(page)).time_s, 0);
    await stepTo(page, 2);
    assertBits((await sample(page)).row, golden("page").row);
    await done();
  },

  async "a run has the values of the reference row: motor 1, crane at the centre, no load, 0.5 s"(host) {
    const { page, close: done } = await openApp(host);
    await setFigures(page);
    await setChecked(page, "motor_1", false);
    await setChecked(page, "motor_1", true);
    await stepTo(page, 0.5);
    const { row, time_s } = await sample(page);
    assert.equal(time_s, 0.5);
    for (const [name, value] of Object.entries(TRUTH)) close(row[name], value, tolerance(name), name);
    assertBits(row, golden("truth").row);
    await setAngle(page, "rad");
    await showsNumber(page, "value-1-ship.angular_velocity.y", 0.19709, 1e-5);
    await showsNumber(page, "value-1-ship.angular_velocity.z", -0.12348, 1e-5);
    await showsNumber(page, "value-1-ship.angular_velocity.x", -0.07719, 1e-5);
    assert.equal(await page.getByTestId("time").textContent(), "0.50 s");
    assert.equal(await page.getByTestId("step-size").textContent(), "1 ms");
    assert.equal(await page.getByTestId("integrator").textContent(), "RK4");
    assert.match(await page.getByTestId("energy-error").textContent(), /×10⁻/);
    assert.match(await page.getByTestId("momentum-error").textContent(), /×10⁻/);
    await done();
  },

  async "running, pausing and stepping give the same bits"(host) {
    const { page, close: done } = await openApp(host);
    await page.getByTestId("speed").selectOption("0.125");
    await page.getByTestId("start").click();
    // The page itself presses the button: a slow machine could pass the end of the golden run between two checks from
    // outside.
    await page.waitForFunction(() => window.kingpost.sample().time_s > 0.1 && (document.querySelector("[data-testid=start]").click(), true));
    await rested(page);
    const { status, time_s } = await sample(page);
    assert.equal(status, "paused");
    assert.ok(time_s > 0.1 && time_s < 2, `paused at ${time_s} s`);
    await stepTo(page, 2);
    assertBits((await sample(page)).row, golden("page").row);
    await done();
  },

  async "a run goes on after the scenario's duration until it is paused"(host) {
    const { page, close: done } = await openApp(host);
    await page.getByTestId("speed").selectOption("20");
    await page.getByTestId("start").click();
    await page.waitForFunction(() => window.kingpost.sample().time_s > 3.2);
    assert.equal((await sample(page)).status, "running");
    await page.getByTestId("start").click();
    await rested(page);
    const { time_s } = await sample(page);
    await rested(page);
    assert.equal((await sample(page)).time_s, time_s);
    await page.getByTestId("reset").click();
    await settle(page);
    assert.equal((await sample(page)).time_s, 0);
    await done();
  },
};
