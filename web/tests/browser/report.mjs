// Checks the report of a study in a browser without a network: node tests/browser/report.mjs FILE [width height].
// Prints the faults and ends with 1; python/tests/test_study_report.py calls it.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";
import { findBrowser, launch } from "../../scripts/browser.mjs";
import { WAIT_MS } from "./app.mjs";
import { assertAccessible } from "./axe.mjs";

const [file, ...size] = process.argv.slice(2);
const [width, height] = size.length ? size.map(Number) : [1280, 900];
const browser = await launch(findBrowser());
const context = await browser.newContext({ offline: true, viewport: { width, height } });
const page = await context.newPage();
page.setDefaultTimeout(WAIT_MS);
const asked = [];
const errors = [];
page.on("request", (request) => asked.push(request.url()));
page.on("pageerror", (error) => errors.push(String(error)));
await page.goto(pathToFileURL(file).href);

const outside = asked.filter((address) => !address.startsWith("file:") && !address.startsWith("data:"));
assert.deepEqual(outside, [], "a report asks for nothing outside it");
assert.equal(asked.filter((address) => address.startsWith("file:")).length, 1, "a report is one file");
assert.deepEqual(errors, []);
const pictures = await page.evaluate(() => [...document.images].filter((image) => !image.complete || image.naturalWidth === 0).length);
assert.equal(pictures, 0, "every picture is drawn");
const across = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
assert.ok(across <= 0, `the page is ${across} px wider than the window`);
await assertAccessible(page, `report at ${width} x ${height}`);

// On A4 paper less its margins, at 96 dpi, no table is wider than the page, so that nothing is cropped.
await page.emulateMedia({ media: "print" });
await page.setViewportSize({ width: Math.floor(((210 - 28) / 25.4) * 96), height: 1000 });
const cut = await page.evaluate(() => {
  const right = document.documentElement.clientWidth;
  return [...document.querySelectorAll("table, figure, pre")].filter((one) => one.getBoundingClientRect().right > right + 1 || one.scrollWidth > one.clientWidth + 1).map((one) => one.textContent.trim().slice(0, 40));
});
assert.deepEqual(cut, [], "tables that are cut on A4");
await browser.close();
