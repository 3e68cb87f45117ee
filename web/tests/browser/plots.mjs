// Plots of any column, and exported files of a run: checked in the page, and by Python if the package is built.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { parquetMetadata, parquetReadObjects } from "hyparquet";
import { close as near, DESKTOP, numberIn, openApp, PHONE, sample, setPlot, showsNumber, stepTo } from "./app.mjs";
import { cases } from "../lane.mjs";
import { assertAccessible } from "./axe.mjs";

/** Python of `make develop`, or another one that has the package. */
const PYTHON = process.env.KINGPOST_PYTHON ?? fileURLToPath(new URL("../../../.venv/bin/python", import.meta.url));

async function openPlots(host, scenario, viewport = DESKTOP) {
  const opened = await openApp(host, { query: `?scenario=${scenario}`, viewport });
  if (viewport.width < 980) await opened.page.getByTestId("show-plots").click();
  return opened;
}

/** Returns the file that Export saves. */
async function exported(page, what) {
  await page.getByTestId("export").click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(`export-${what}`).click()]);
  await page.waitForFunction((name) => document.querySelector("[data-testid=export-said]").textContent.includes(name), download.suggestedFilename());
  await page.getByTestId("export-close").click();
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

/** Returns the output of a line of Python, given files with these contents. */
function python(code, files) {
  const folder = mkdtempSync(join(tmpdir(), "kingpost-"));
  try {
    for (const [name, bytes] of Object.entries(files)) writeFileSync(join(folder, name), bytes);
    return execFileSync(PYTHON, ["-c", code], { cwd: folder, stdio: ["ignore", "pipe", "pipe"] }).toString();
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const hasPython = existsSync(PYTHON);
if (!hasPython) console.log("plots: not compared with Python, which is not built: KINGPOST_PYTHON=path names one");

/** Returns the width, the height and the number of colours of a picture. */
async function looked(page, bytes) {
  assert.equal(bytes.subarray(1, 4).toString(), "PNG");
  return page.evaluate(async (base64) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const pen = canvas.getContext("2d");
    pen.drawImage(bitmap, 0, 0);
    const { data } = pen.getImageData(0, 0, bitmap.width, bitmap.height);
    const colours = new Set();
    for (let i = 0; i < data.length; i += 4 * 7) colours.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
    return { width: bitmap.width, height: bitmap.height, colours: colours.size };
  }, bytes.toString("base64"));
}

const exporting = cases([DESKTOP, PHONE], (viewport) => viewport === DESKTOP).map((viewport) => [
  `the recording, pictures and the scenario are exported, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openPlots(host, "paper", viewport);
    await stepTo(page, 0.3);
    const { row } = await sample(page);
    const csv = await exported(page, "csv");
    assert.equal(csv.name, "paper.csv");
    const lines = csv.bytes.toString().trimEnd().split("\n");
    assert.equal(lines.length, 32);
    const last = lines.at(-1).split(",").map(Number);
    lines[0].split(",").forEach((column, i) => assert.ok(Object.is(last[i], row[column]), `${column}: ${last[i]}, ${row[column]}`));
    const parquet = await exported(page, "parquet");
    const file = parquet.bytes.buffer.slice(parquet.bytes.byteOffset, parquet.bytes.byteOffset + parquet.bytes.length);
    const rows = await parquetReadObjects({ file });
    assert.equal(rows.length, 31);
    for (const [column, value] of Object.entries(row)) assert.ok(Object.is(rows.at(-1)[column], value), column);
    const about = Object.fromEntries(parquetMetadata(file).key_value_metadata.map(({ key, value }) => [key, value]));
    assert.equal(about.title, "Crane ship of Jardim et al. (2019)");
    assert.equal(JSON.parse(about.units)["ship.roll"], "rad");
    assert.ok(JSON.parse(about.scenario).bodies.ship);
    for (const what of ["ship", "plot-1"]) {
      const picture = await exported(page, what);
      assert.match(picture.name, /^paper-[a-z-]+\.png$/);
      const { width, height, colours } = await looked(page, picture.bytes);
      assert.ok(width > 250 && height > 150 && colours > 20, `${what} is ${width} x ${height} in ${colours} colours`);
    }
    const scenario = await exported(page, "scenario");
    assert.equal(scenario.name, "paper-saved.yaml");
    if (hasPython) comparedWithPython({ "app.csv": csv.bytes, "app.parquet": parquet.bytes });
    await close();
  },
]);

/**
 * Checks the files against the same run by Python: the same text of the table, the same bits in both files, and the
 * same statistics.
 */
function comparedWithPython(files) {
  const code = `
import json, pandas, pyarrow.parquet, kingpost
from kingpost.results import entries, frame, write
found = kingpost.run("paper", {"simulation.duration_s": 0.3})
write(found, "python.csv")
assert open("python.csv").read() == open("app.csv").read(), "csv"
pandas.testing.assert_frame_equal(pandas.read_parquet("app.parquet"), frame(found), check_exact=True)
about = {key.decode(): value.decode() for key, value in pyarrow.parquet.read_schema("app.parquet").metadata.items()}
for name in ("title", "gravity_m_s2", "water_density_kg_m3", "floating_bodies", "axes", "seed"):
    assert about[name] == str(found.attrs[name]), (name, about[name])
theirs = json.loads(about["entries"])
ours = json.loads(entries.as_json(found))
assert theirs == {name: ours[name] for name in ("events", "warnings")}, theirs
print("same")
`;
  assert.equal(python(code, files).trim(), "same");
}

const finding = cases([DESKTOP, PHONE], (viewport) => viewport === DESKTOP).map((viewport) => [
  `a search by the keyboard finds any column, which is drawn on a separate axis and stored for the scenario, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openPlots(host, "paper", viewport);
    await stepTo(page, 0.4);
    await page.getByTestId("choose-1").focus();
    await page.keyboard.press("Enter");
    await page.getByTestId("search-lines").focus();
    await page.keyboard.type("kinetic energy");
    assert.equal(await page.locator(".picker-lines [role=status]").textContent(), "1 line found.");
    await page.locator(".picker-list").focus();
    await page.keyboard.press("Tab");
    await page.keyboard.press("Space");
    await page.keyboard.press("Escape");
    assert.equal(await page.getByTestId("choose-1").evaluate((button) => document.activeElement === button), true);
    const { row } = await sample(page);
    await showsNumber(page, "value-1-kinetic_energy", row.kinetic_energy / 1000, 0.0051);
    // One axis of time and two vertical axes.
    assert.equal(await page.locator("[data-testid=plot-1] .u-axis").count(), 3);
    await page.reload();
    await page.waitForFunction(() => window.kingpost?.sample());
    if (viewport === PHONE) await page.getByTestId("show-plots").click();
    await page.getByTestId("value-1-kinetic_energy").waitFor();
    // Another scenario has other plots; after the change the default plots are shown.
    await page.getByTestId("view-plots").click();
    await page.getByTestId("default-plots").click();
    assert.equal(await page.getByTestId("choose-1").textContent(), "Rates of ship");
    await close();
  },
]);

const spectra = cases([DESKTOP, PHONE], (viewport) => viewport === PHONE).map((viewport) => [
  `a plot shows a spectrum with its resolution, or one line over another, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openPlots(host, "barge&waves=true", viewport);
    await stepTo(page, 104);
    // A warning of the engine would cover the plots.
    const dismiss = page.getByTestId("run-warnings").getByLabel("Dismiss");
    if (await dismiss.isVisible()) await dismiss.click();
    await setPlot(page, 1, { lines: ["water.wave_elevation"], kind: "spectrum" });
    const notes = page.locator("[data-testid=plot-1] > .plot-notes");
    await page.waitForFunction(() => document.querySelector("[data-testid=plot-1] > .plot-notes").textContent.includes("resolution"));
    // Eight segments would have 128 records of 0.1 s, less than three periods of the waves: 256 records that overlap by
    // half, 2 pi / 25.6 s.
    assert.match(await notes.textContent(), /Hann window: 7 segments of the records from 0 to 104 s, resolution 0\.245 rad\/s/);
    await page.getByTestId("choose-1").click();
    await page.getByTestId("plot-parts").selectOption("2");
    await page.getByTestId("picker-done").click();
    await page.waitForFunction(() => document.querySelector("[data-testid=plot-1] > .plot-notes").textContent.includes("resolution 0.123"));
    // The waves of the scenario have a peak period of 8 s; the largest density of one realisation is near it.
    const peak = Number((await notes.textContent()).match(/peak at ([\d.]+) rad\/s/)[1]);
    near(peak, (2 * Math.PI) / 8, 0.25, "peak, rad/s");
    await setPlot(page, 2, { lines: ["ship.roll", "ship.angular_velocity.x"], kind: "phase" });
    assert.equal(await page.getByTestId("choose-2").textContent(), "angular velocity x against roll");
    const heads = await page.locator("[data-testid=plot-2] .visually-hidden th[scope=col]").allTextContents();
    assert.deepEqual(heads, ["roll, °", "angular velocity x, °/s"]);
    const { colours } = await looked(page, (await exported(page, "plot-2")).bytes);
    assert.ok(colours > 10);
    await close();
  },
]);

const accessible = cases(["day", "night", "bright"], (palette) => palette === "bright").map((palette) => [
  `open dialogs of the plots pass axe, ${palette}`,
  async (host) => {
    const { page, close } = await openPlots(host, "barge", PHONE);
    await stepTo(page, 1);
    await page.emulateMedia({ reducedMotion: "reduce" });
    await page.getByTestId("statistics-1").click();
    await page.evaluate((name) => (document.documentElement.dataset.palette = name), palette);
    await assertAccessible(page, "plots");
    for (const [open, shut] of [["choose-1", "picker-done"], ["view-plots", "view-done"], ["export", "export-close"]]) {
      await page.getByTestId(open).click();
      await assertAccessible(page, open);
      await page.getByTestId(shut).click();
    }
    await close();
  },
]);

export default {
  ...Object.fromEntries(finding),
  ...Object.fromEntries(spectra),
  ...Object.fromEntries(exporting),

  async "plots are added and removed, up to six"(host) {
    const { page, close } = await openPlots(host, "paper", PHONE);
    for (let place = 3; place <= 6; place++) {
      await page.getByTestId("add-plot").click();
      await page.getByTestId("picker").getByRole("button", { name: "Angles of ship", exact: true }).click();
      await page.getByTestId("picker-done").click();
      assert.equal(await page.getByTestId(`choose-${place}`).textContent(), "Angles of ship");
    }
    assert.equal(await page.getByTestId("add-plot").isDisabled(), true);
    for (let place = 6; place >= 1; place--) {
      await page.getByTestId(`choose-${place}`).click();
      await page.getByTestId("remove-plot").click();
    }
    assert.equal(await page.locator(".plot").count(), 0);
    assert.equal(await page.getByTestId("add-plot").isDisabled(), false);
    await close();
  },

  async "the statistics of the visible time agree with the exported table"(host) {
    const { page, close } = await openPlots(host, "barge");
    await stepTo(page, 20);
    await page.getByTestId("view-plots").click();
    await page.getByTestId("plot-window").selectOption("between");
    await page.getByTestId("window-from").fill("5");
    await page.getByTestId("window-to").fill("15");
    await page.getByTestId("window-to").blur();
    await page.getByTestId("view-done").click();
    await setPlot(page, 1, { lines: ["ship.roll"] });
    await page.getByTestId("statistics-1").click();
    await page.getByTestId("mean-1-ship.roll").waitFor();
    const [names, ...rows] = (await exported(page, "csv")).bytes.toString().trimEnd().split("\n").map((line) => line.split(","));
    const at = names.indexOf("ship.roll");
    const kept = rows.filter(([time]) => Number(time) >= 5 && Number(time) <= 15 + 1e-9).map((row) => (Number(row[at]) * 180) / Math.PI);
    assert.equal(kept.length, 101);
    const mean = kept.reduce((sum, value) => sum + value, 0) / kept.length;
    const deviation = Math.sqrt(kept.reduce((sum, value) => sum + (value - mean) ** 2, 0) / kept.length);
    const expected = { mean, standard_deviation: deviation, minimum: Math.min(...kept), maximum: Math.max(...kept) };
    for (const [name, value] of Object.entries(expected)) near(await numberIn(page, `${name}-1-ship.roll`), value, 0.0051, name);
    await close();
  },

  async "a drag with the mouse selects the visible time in all plots"(host) {
    const { page, close } = await openPlots(host, "paper");
    await stepTo(page, 2);
    const area = await page.locator("[data-testid=plot-1] .u-over").boundingBox();
    const at = (share) => [area.x + share * area.width, area.y + area.height / 2];
    await page.mouse.move(...at(0.2));
    await page.mouse.down();
    await page.mouse.move(...at(0.3), { steps: 3 });
    await page.mouse.move(...at(0.4), { steps: 3 });
    await page.mouse.up();
    await page.getByTestId("view-plots").click();
    assert.equal(await page.getByTestId("plot-window").inputValue(), "between");
    // The selection is a part of the 3 s that the plots show at first.
    near(Number(await page.getByTestId("window-from").inputValue()), 0.6, 0.03, "from, s");
    near(Number(await page.getByTestId("window-to").inputValue()), 1.2, 0.03, "to, s");
    await page.getByTestId("plot-window").selectOption("last 10");
    await page.getByTestId("view-done").click();
    await page.getByTestId("tall-plots").click();
    const { height } = await page.locator("[data-testid=plot-1] .plot-area").boundingBox();
    assert.ok(height > 350, `a large plot is ${height} high`);
    await close();
  },

  async "righting arms are shown with the ship's present heel, and a column with its limits"(host) {
    const { page, close } = await openPlots(host, "barge_crane_200t");
    await stepTo(page, 0.5);
    await page.waitForFunction(() => document.querySelector("[data-testid=plot-2] .visually-hidden").textContent.includes("Limit: list"));
    const limits = await page.locator("[data-testid=plot-2] .visually-hidden tr").filter({ hasText: "Limit: list" }).allTextContents();
    assert.deepEqual(limits.map((text) => text.replace("Limit: list", "")), ["−3.00", "3.00"]);
    await setPlot(page, 1, { kind: "arms" });
    const notes = page.locator("[data-testid=plot-1] > .plot-notes");
    await page.waitForFunction(() => /now heels [\d.−]+° to starboard, GZ/.test(document.querySelector("[data-testid=plot-1] > .plot-notes").textContent));
    const heel = Number((await notes.textContent()).match(/now heels ([\d.]+)°/)[1]);
    const { row } = await sample(page);
    near(heel, (row["hull.roll"] * 180) / Math.PI, 0.0051, "heel");
    assert.match(await notes.textContent(), /equilibrium at [\d.]+°; largest [\d.]+ m at [\d.]+°/);
    await close();
  },

  ...Object.fromEntries(accessible),
};
