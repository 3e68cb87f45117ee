// The app with any scenario of the gallery: by default with one for each kind of craft. tests/gallery.test.ts checks
// all of them without a browser.
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { cases, KINDS } from "../lane.mjs";
import { look, openApp, rested, sample, setAngle, setPlot, settle, showsNumber, showsText, stepTo } from "./app.mjs";

const FILES = readdirSync(new URL("../../../scenarios", import.meta.url)).filter((file) => file.endsWith(".yaml"));

/** Opens one scenario of the gallery and steps it: it has a title and a description, is in the picture, and moves. */
async function runs(host, file) {
  const gallery = await (await fetch(`${host.address}scenarios/index.json`)).json();
  const { name, title } = gallery.find((entry) => entry.file === file);
  const { page, close } = await openApp(host, { draws: true, query: `?scenario=${name}` });
  assert.equal(await page.title(), `Kingpost – ${title}`);
  await page.locator("#about summary").click();
  assert.equal(await page.getByTestId("about-title").textContent(), title);
  assert.ok((await page.getByTestId("about-text").textContent()).length > 80, `${name} says what it is`);
  const { status, row } = await sample(page);
  assert.equal(status, "idle");
  await stepTo(page, 0.2);
  const after = await sample(page);
  assert.ok(after.time_s >= 0.2 - 1e-9 && Object.values(after.row).every(Number.isFinite), `${name} runs`);
  assert.notDeepEqual(after.row, row);
  await rested(page);
  const seen = await look(page);
  assert.ok(seen.right - seen.left > 40 && seen.bottom - seen.top > 40, `${name} is in the picture`);
  await close();
}

export default {
  ...Object.fromEntries(cases(FILES, (file) => KINDS.includes(file.replace(".yaml", ""))).map((file) => [`runs ${file} of the gallery and shows it`, (host) => runs(host, file)])),

  async "any joint of a scenario is plotted from the start of the run"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=chain" });
    await page.getByTestId("choose-2").click();
    await page.getByTestId("search-lines").fill("joint position");
    const found = page.locator(".picker-list input");
    assert.deepEqual((await found.evaluateAll((boxes) => boxes.map(({ value }) => value))).slice(0, 2), ["link_1.joint_position", "link_2.joint_position"]);
    await page.getByTestId("picker-done").click();
    await stepTo(page, 0.3);
    await setPlot(page, 2, { lines: ["link_1.joint_position"] });
    await setAngle(page, "rad");
    const { row } = await sample(page);
    await showsNumber(page, "value-2-link_1.joint_position", row["link_1.joint_position"], 1e-5);
    // A reset keeps the plots; another scenario has its own plots, and the first scenario gets its plots back.
    const title = page.getByTestId("choose-2");
    await page.getByTestId("reset").click();
    await settle(page);
    assert.equal(await title.textContent(), "link 1 joint position");
    await page.getByTestId("gallery").selectOption("paper");
    await showsText(page, "choose-2", "Angles of ship");
    await page.getByTestId("gallery").selectOption("chain");
    await showsText(page, "choose-2", "link 1 joint position");
    await close();
  },
};
