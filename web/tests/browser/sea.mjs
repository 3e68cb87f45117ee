// Ships afloat: the sea is drawn from the engine's elevations, and the page shows how the ship floats.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { cases } from "../lane.mjs";
import { close as near, item, numberIn, openApp, openFile, PHONE, rested, sample, setPlot, showsNumber, stepTo } from "./app.mjs";

/** A barge in a regular wave, with its database. */
const BARGE = `version: 1
title: A barge in a regular wave
simulation: {step_s: 0.02, duration_s: 60, record_every_s: 0.1}
sea:
  waves:
    swell: {regular: {height_m: 1.6, period_s: 4.5, direction_deg: 140}}
bodies:
  hull:
    mass_t: 410
    centre_of_mass_m: [0, 0, 0]
    inertia: {radii_of_gyration: {radii_m: [3.5, 6, 6]}}
    joint: {floating: {initial: {orientation_deg: [4, -2, 0]}}}
forces:
  gravity: {gravity: {}}
  water: {hydrodynamics: {body: hull, database: hydro/barge.hydro.json}}
`;

const DATABASE = { "barge.hydro.json": readFileSync(new URL("../../../scenarios/hydro/barge.hydro.json", import.meta.url), "utf-8") };

const opened = (page, title) => page.waitForFunction((wanted) => document.title.endsWith(wanted), title);

async function openBarge(host, options) {
  const app = await openApp(host, { scale: 1, ...options });
  await openFile(app.page, "barge.yaml", BARGE, DATABASE);
  await opened(app.page, "A barge in a regular wave");
  return app;
}

/**
 * Returns the share of the picture that is bluer than red: water and hull, but not deck, sky near the horizon or bottom
 * paint.
 */
async function blue(page) {
  const picture = (await page.getByTestId("canvas").screenshot()).toString("base64");
  return page.evaluate(async (base64) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    pen.drawImage(bitmap, 0, 0);
    const { data } = pen.getImageData(0, 0, bitmap.width, bitmap.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i + 2] > data[i] + 45) count += 1;
    return count / (data.length / 4);
  }, picture);
}

const looks = cases(["light", "dark"], (colorScheme) => colorScheme === "light").map((colorScheme) => [
  `the sea is drawn around the ship, ${colorScheme}`,
  async (host) => {
    const { page, close } = await openBarge(host, { draws: true, colorScheme, viewport: colorScheme === "light" ? undefined : PHONE });
    await stepTo(page, 3);
    await rested(page);
    const withSea = await blue(page);
    assert.ok(withSea > 0.2, `water is on ${(100 * withSea).toFixed(0)} % of the picture`);
    assert.match(await page.locator("#scene-note").textContent(), /Incident waves, 1 in all/);
    await close();
  },
]);

export default {
  ...Object.fromEntries(looks),

  async "the sea moves with the engine's wave, and heel, trim and draught are shown"(host) {
    const { page, close } = await openBarge(host);
    near(await numberIn(page, "heel"), 4, 0.005, "heel");
    near(await numberIn(page, "trim"), -2, 0.005, "trim");
    const upright = Math.cos((4 * Math.PI) / 180) * Math.cos((2 * Math.PI) / 180);
    near(await numberIn(page, "draught"), 2 * upright, 0.0051, "draught");
    await stepTo(page, 2);
    const { row, surface, poses, time_s } = await sample(page);
    near(await numberIn(page, "heel"), (row["hull.roll"] * 180) / Math.PI, 0.0051, "heel shown");
    near(await numberIn(page, "trim"), (row["hull.pitch"] * 180) / Math.PI, 0.0051, "trim shown");
    near(await numberIn(page, "wave"), row["water.wave_elevation"], 0.0051, "wave shown");
    // Compares every crossing with the documented wave a cos(k (x cos b + y sin b) - w t), k = w^2 / g.
    const [omega, direction] = [(2 * Math.PI) / 4.5, (140 * Math.PI) / 180];
    const [x_m, y_m, elevations] = [surface.x_m, surface.y_m, surface.elevation_m].map(Object.values);
    elevations.forEach((elevation, at) => {
      const [x, y] = [x_m[Math.floor(at / y_m.length)], y_m[at % y_m.length]];
      const along = x * Math.cos(direction) + y * Math.sin(direction);
      near(elevation, 0.8 * Math.cos((omega ** 2 / 9.80665) * along - omega * time_s), 1e-9, `the surface at ${x}, ${y}`);
    });
    assert.ok(x_m[0] < poses[0] - 10 && x_m.at(-1) > poses[0] + 10 && y_m[0] < poses[1] - 5 && y_m.at(-1) > poses[1] + 5);
    await setPlot(page, 2, { figure: "Heave of hull" });
    await showsNumber(page, "value-2-hull.heave", row["hull.position.z"], 1e-4);
    await close();
  },

  async "the fluid metacentric height is shown, and a hull on the surface of the water gives a warning"(host) {
    const { page, close } = await openBarge(host);
    const height = page.getByTestId("metacentric-height");
    const shown = () => page.waitForFunction(() => document.querySelector("[data-testid=metacentric-height]").textContent !== "–");
    await shown();
    // KB + BM - KG = T/2 + B^2/(12 T) - T, with the centre of mass on the water plane.
    near(Number.parseFloat(await height.textContent()), 1 + 100 / 24 - 2, 0.0051, "GM");
    assert.equal(await page.getByTestId("floating-warnings").isVisible(), false);
    // A slack tank reduces it by rho l b^3 / 12 over the mass.
    const tank = "  bilge: {slack_tank: {body: hull, position_m: [0, 0, -1], length_m: 5, breadth_m: 8, height_m: 1, filling: 0.5}}\n";
    await openFile(page, "slack.yaml", BARGE.replace("in a regular wave", "with a slack tank") + tank, DATABASE);
    await opened(page, "A barge with a slack tank");
    await shown();
    near(Number.parseFloat(await height.textContent()), 1 + 100 / 24 - 2 - (1.025 * 5 * 8 ** 3) / 12 / 410, 0.0051, "GM, a tank slack");
    await page.getByTestId("gallery").selectOption("paper_true_draught");
    await page.getByTestId("floating-warnings").waitFor();
    await page.getByTestId("floating-warnings").click();
    assert.match(await page.getByTestId("floating-warnings").textContent(), /its bottom comes out of the water at about 0\.67 deg/);
    await close();
  },

  async "chains whose inertia is left out give warnings about the model"(host) {
    const { page, close } = await openBarge(host);
    const warnings = page.getByTestId("model-warnings");
    assert.equal(await warnings.isVisible(), false);
    await page.getByTestId("gallery").selectOption("offshore_vessel_moored_quasi_static");
    await warnings.waitFor();
    assert.equal(await warnings.locator("summary").textContent(), "4 warnings about the model");
    await warnings.locator("summary").click();
    assert.match(await warnings.textContent(), /port_bow: its inertia and drag are left out/);
    await close();
  },

  async "a ship that heels beyond the range of her hydrodynamic loads gives a warning"(host) {
    const { page, close } = await openApp(host);
    await openFile(page, "steep.yaml", BARGE.replace("orientation_deg: [4, -2, 0]", "orientation_deg: [24, 0, 0]"), DATABASE);
    await opened(page, "A barge in a regular wave");
    const warnings = page.getByTestId("run-warnings");
    assert.match(await warnings.textContent(), /hull: it heeled to 24\.00 deg, at 0 s/);
    await stepTo(page, 1.2);
    assert.match(await warnings.textContent(), /hull: it heeled to/);
    await warnings.getByLabel("Dismiss").click();
    assert.equal(await warnings.textContent(), "");
    await close();
  },

  async "a warning on a phone covers no control"(host) {
    const { page, close } = await openApp(host, { viewport: PHONE });
    await openFile(page, "steep.yaml", BARGE.replace("orientation_deg: [4, -2, 0]", "orientation_deg: [24, 0, 0]"), DATABASE);
    await opened(page, "A barge in a regular wave");
    const warning = await page.getByTestId("run-warnings").locator(".alert-box").boundingBox();
    for (const part of [".switcher", "#controls", ".transport"]) {
      const box = await page.locator(part).boundingBox();
      assert.ok(box.height > 40, `${part} has room beside a warning`);
      assert.ok(box.y >= warning.y + warning.height || box.y + box.height <= warning.y, `a warning covers ${part}`);
    }
    await close();
  },

  async "still water is drawn level, and no water if the scenario has none"(host) {
    const { page, close } = await openApp(host);
    assert.equal(await page.getByTestId("floating").isVisible(), false);
    assert.equal((await sample(page)).surface, null);
    assert.match(await page.locator("#scene-note").textContent(), /No water in this scenario/);
    await openFile(page, "calm.yaml", BARGE.replace("regular: {", "regular: {enabled: false, ").replace("in a regular wave", "in still water"), DATABASE);
    await opened(page, "A barge in still water");
    await stepTo(page, 0.5);
    const { surface } = await sample(page);
    assert.ok(Object.values(surface.elevation_m).every((elevation) => elevation === 0));
    assert.match(await page.locator("#scene-note").textContent(), /Still water/);
    await close();
  },

  async "a missing file of a scenario is reported by name"(host) {
    const { page, close } = await openApp(host);
    // The gallery has a file of this name, but for another hull.
    await openFile(page, "lost.yaml", BARGE);
    await page.waitForFunction(() => document.querySelector("[data-testid=alert]").textContent.includes("no file"));
    assert.match(await page.getByTestId("alert").textContent(), /barge\.hydro\.json.*Open the scenario and its database together/);
    await close();
  },

  async "a scenario opens with a user's own database"(host) {
    const { page, close } = await openApp(host);
    const scenario = BARGE.replace("hydro/barge.hydro.json", "data/mine.hydro.json");
    await openFile(page, "mine.yaml", scenario, { "mine.hydro.json": DATABASE["barge.hydro.json"] });
    await opened(page, "A barge in a regular wave");
    await stepTo(page, 0.5);
    await page.getByTestId("reset").click();
    await page.waitForFunction(() => window.kingpost.sample().time_s === 0);
    near(await numberIn(page, "heel"), 4, 0.005, "heel");
    await close();
  },

  async "the arrows of wind and current follow the numbers of a run"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=offshore_vessel_on_dp" });
    const shown = (name) => page.getByTestId(name).locator("dd");
    assert.equal(await shown("wind").textContent(), "12.0 m/s");
    assert.equal(await shown("current").textContent(), "0.5 m/s");
    await stepTo(page, 0.2);
    await item(page, "wind_speed_m_s").fill("6");
    await item(page, "wind_speed_m_s").blur();
    await page.waitForFunction(() => window.kingpost.sample().pending.length === 0);
    await page.getByTestId("step").click();
    await page.waitForFunction(() => document.querySelector('[data-testid="wind"] dd').textContent === "6.0 m/s");
    await page.getByTestId("gallery").selectOption("paper");
    await page.getByTestId("wind").waitFor({ state: "hidden" });
    await close();
  },

  async "a scenario under water opens under water, from the place that it names"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=underwater_vehicle", draws: true });
    await rested(page);
    assert.ok((await blue(page)) > 0.6, "water is on most of the picture");
    assert.equal(await page.getByTestId("camera-free").isChecked(), true);
    await close();
  },
};
