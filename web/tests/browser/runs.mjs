// Kept runs: their lines and differences in plots, statistics, files, and branches that delete nothing.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { DESKTOP, openApp, PHONE, sample, setNumber, settle, showsNumber, showsText, stepTo } from "./app.mjs";
import { assertAccessible } from "./axe.mjs";
import { assertUncropped } from "./layout.mjs";

const DEGREES = 180 / Math.PI;
const RATE = "ship.angular_velocity.y";

/** Returns the rows of a CSV file that a press of a button saves; names of runs with a comma are left out. */
async function saved(page, button) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(button).click()]);
  const lines = readFileSync(await download.path(), "utf8").trimEnd().split("\n");
  return { name: download.suggestedFilename(), heads: lines[0].split(","), rows: lines.slice(1).map((line) => line.replace(/^"[^"]*"/, "").split(",")) };
}

/** Checks that a row of a file has the bits of a row of the run. */
function assertRow(heads, cells, row) {
  for (const [column, value] of Object.entries(row)) assert.ok(Object.is(Number(cells[heads.indexOf(column)]), value), `${column}: ${cells[heads.indexOf(column)]}, ${value}`);
}

async function scrub(page, time_s) {
  await page.getByTestId("cursor").evaluate((range, value) => {
    range.value = String(value);
    range.dispatchEvent(new Event("input", { bubbles: true }));
  }, time_s);
}

export default {
  async "two kept runs are drawn, subtracted, told in statistics and exported"(host) {
    const { page, close } = await openApp(host, { viewport: DESKTOP });
    const first = [];
    for (const crane_x_m of [-10, 4]) {
      await setNumber(page, "crane_x_m", crane_x_m);
      await stepTo(page, 0.3);
      await page.getByTestId("keep-run").click();
      first.push((await sample(page)).row);
      await page.getByTestId("reset").click();
      await settle(page);
    }
    await setNumber(page, "crane_x_m", 0);
    await stepTo(page, 0.3);
    const { row } = await sample(page);
    const shown = (run) => `value-1-${RATE}-${run}`;
    for (const [i, mark] of ["A", "B"].entries()) await showsNumber(page, shown(mark), first[i][RATE] * DEGREES, 0.0051);
    await page.getByTestId("compare-difference").click();
    for (const [i, mark] of ["A", "B"].entries()) await showsNumber(page, shown(mark), (row[RATE] - first[i][RATE]) * DEGREES, 0.0051);
    await page.getByTestId("statistics-1").click();
    for (const [i, mark] of ["A", "B"].entries()) await showsNumber(page, `maximum-1-${RATE}-${mark}`, first[i][RATE] * DEGREES, 0.0051);
    await page.getByTestId("run-A").click();
    await page.waitForFunction((id) => !document.querySelector(`[data-testid="${id}"]`), shown("A"));
    await page.getByTestId("export").click();
    const alone = await saved(page, "export-run-A");
    assert.deepEqual([alone.name, alone.rows.length], ["paper-A.csv", 31]);
    assertRow(alone.heads, alone.rows.at(-1), first[0]);
    const all = await saved(page, "export-runs");
    assert.deepEqual([all.name, all.heads[0], all.rows.length], ["paper-runs.csv", "run", 93]);
    for (const [i, expected] of [row, ...first].entries()) assertRow(all.heads, all.rows[31 * i + 30], expected);
    await close();
  },

  async "a branch deletes nothing: the former run is in the list, is renamed, and stays with another scenario"(host) {
    const { page, close } = await openApp(host, { viewport: PHONE });
    await page.getByTestId("show-plots").click();
    await stepTo(page, 0.5);
    const { row } = await sample(page);
    await scrub(page, 0.2);
    await page.getByTestId("step").click();
    await page.waitForFunction(() => window.kingpost.sample().newest_s === 0.21);
    await showsText(page, "runs-said", "Run A is kept: Left at 0.20 s: Crane ship of Jardim et al. (2019).");
    await assertUncropped(page, PHONE);
    await page.getByTestId("manage-runs").click();
    const list = page.getByTestId("run-list");
    assert.match(await list.textContent(), /51 rows, 0\.00 to 0\.50 s/);
    const { heads, rows } = await saved(page, "save-run-A");
    assertRow(heads, rows.at(-1), row);
    await page.getByTestId("name-A").fill("Before");
    await page.getByTestId("name-A").blur();
    await page.getByTestId("ghost-A").check();
    await assertAccessible(page, "the list of kept runs");
    await assertUncropped(page, PHONE);
    await page.getByTestId("close-runs").click();
    await page.getByTestId("gallery").selectOption("chain");
    await page.waitForFunction(() => document.title.includes("Chain"));
    assert.match(await page.getByTestId("run-A").textContent(), /Before/);
    await page.getByTestId("manage-runs").click();
    assert.ok(await page.getByTestId("ghost-A").isDisabled());
    await page.getByTestId("remove-all-runs").click();
    await page.getByTestId("close-runs").click();
    assert.ok(await page.getByTestId("runs").isHidden());
    await close();
  },
};
