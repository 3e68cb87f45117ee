// Faults are shown, and the app continues to run.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { thorough } from "../lane.mjs";
import { item, openApp, openFile, sample, setNumber, settle, setFigures, stepTo } from "./app.mjs";

const paper = readFileSync(fileURLToPath(new URL("../../../scenarios/paper.yaml", import.meta.url)), "utf8");
const message = (page) => page.getByTestId("alert-message").textContent();

export default {
  async "an invalid scenario is reported with its place, and the previous one stays"(host) {
    const { page, close } = await openApp(host);
    await stepTo(page, 0.02);
    const bad = paper.replace("mass_kg: 10000", "mass_kg: -5");
    const line = bad.split("\n").findIndex((text) => text.includes("mass_kg: -5")) + 1;
    await openFile(page, "bad.yaml", bad);
    await page.getByTestId("alert-message").waitFor();
    const text = await message(page);
    assert.ok(text.startsWith(`bad.yaml:${line}:`), text);
    assert.match(text, /bodies\.ship\.mass_kg: found -5, allowed: /);
    await stepTo(page, 0.04);
    assert.equal(await page.getByTestId("title").textContent(), "Crane ship of Jardim et al. (2019)");
    await page.getByRole("button", { name: "Dismiss" }).click();
    assert.equal(await page.getByTestId("alert").textContent(), "");
    await close();
  },

  async "an empty file, another format or an unknown field gives one clear error"(host) {
    const { page, close } = await openApp(host);
    const cases = { "empty.yaml": "", "picture.yaml": "\u0089PNG\r\n\u001a\n\u0000", "field.yaml": paper.replace("title:", "titel:") };
    for (const [name, text] of Object.entries(cases)) {
      await openFile(page, name, text);
      await page.waitForFunction((file) => document.getElementById("alert").textContent.includes(file), name);
      assert.ok((await message(page)).startsWith(name), await message(page));
    }
    await stepTo(page, 0.01);
    await close();
  },

  ...thorough({
    async "a valid file of the user opens"(host) {
      const { page, close } = await openApp(host);
      await openFile(page, "mine.yaml", paper.replace(/^title: .*/m, "title: A ship of mine"));
      await page.waitForFunction(() => document.querySelector("[data-testid=title]").textContent === "A ship of mine");
      assert.equal(await item(page, "load").isChecked(), false, "a file opens with its own defaults");
      await stepTo(page, 0.01);
      await close();
    },
  }),

  async "an unknown name of a scenario is reported, and the paper's ship opens"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=nonesuch" });
    assert.match(await message(page), /found nonesuch, allowed: paper/);
    await stepTo(page, 0.01);
    await close();
  },

  async "a database that is opened without a scenario is reported as such"(host) {
    const { page, close } = await openApp(host);
    await openFile(page, "barge.hydro.json", "{}");
    await page.getByTestId("alert-message").waitFor();
    assert.match(await page.getByTestId("alert").textContent(), /barge\.hydro\.json is a hydrodynamic database: open it together with the scenario/);
    await close();
  },

  async "a value out of range is refused, and the control returns to the previous value"(host) {
    const { page, close } = await openApp(host);
    await item(page, "crane_x_m").fill("50");
    await item(page, "crane_x_m").blur();
    await page.getByTestId("alert-message").waitFor();
    const shown = await page.getByTestId("alert").textContent();
    assert.match(shown, /This value is not allowed/);
    assert.match(shown, /50 m is not a number from -10 to 10 m\./);
    assert.ok(!shown.includes("--set"));
    assert.equal(await item(page, "crane_x_m").inputValue(), "-10");
    // An emptied field shows the present value again.
    await item(page, "crane_x_m").fill("");
    await item(page, "crane_x_m").blur();
    assert.equal(await item(page, "crane_x_m").inputValue(), "-10");
    await page.locator("#advanced summary").click();
    await item(page, "simulation.step_s").fill("0");
    await item(page, "simulation.step_s").blur();
    await page.waitForFunction(() => document.getElementById("alert").textContent.includes("Step size"));
    assert.equal(await item(page, "simulation.step_s").inputValue(), "0.001");
    await stepTo(page, 0.01);
    await close();
  },

  async "a diverged run stops with its time and body, and the plots stay"(host) {
    const { page, close } = await openApp(host);
    await setFigures(page);
    await item(page, "motor_2").check();
    await settle(page);
    await page.locator("#advanced summary").click();
    await page.getByTestId("parameter-simulation.integrator").selectOption("forward_euler");
    await settle(page);
    await setNumber(page, "simulation.step_s", 0.05);
    await page.getByTestId("start").click();
    await page.waitForFunction(() => window.kingpost.sample().status === "stopped");
    const text = await page.getByTestId("alert").textContent();
    assert.match(text, /The run diverged/);
    assert.match(text, /Body(ship|tower|arm)/);
    assert.match(text, /\d s/);
    const { row, time_s } = await sample(page);
    assert.ok(time_s > 0.2 && Number.isFinite(row["ship.angular_velocity.x"]));
    assert.equal(await page.getByTestId("start").isDisabled(), true);
    assert.notEqual(await page.getByTestId("value-1-ship.angular_velocity.y").textContent(), "–");
    await page.getByTestId("reset").click();
    await settle(page);
    assert.equal(await page.getByTestId("alert").textContent(), "");
    await stepTo(page, 0.05);
    await close();
  },
};
