// The start page, before the engine is loaded.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { thorough } from "../lane.mjs";
import { DESKTOP, PAPER, PHONE, openFile, openPage } from "./app.mjs";
import { assertAccessible } from "./axe.mjs";

const paper = readFileSync(fileURLToPath(new URL("../../../scenarios/paper.yaml", import.meta.url)), "utf8");
/** Largest compressed size of all files that are loaded before a scenario is chosen, bytes. */
const FIRST_LOAD = 1_000_000;
/** Largest compressed sizes of all files that the paper's scenario loads, without the engine and with it, bytes. */
const SCENARIO_LOAD = { without: 600_000, with: 1_800_000 };
const built = (path) => fileURLToPath(new URL(`../../dist/${path}`, import.meta.url));

/** Size of a file as it is sent: in Brotli where the build has such a copy, otherwise by gzip. */
function sentSize(path) {
  const copy = built(`${path}.br`);
  return existsSync(copy) ? readFileSync(copy).length : gzipSync(readFileSync(built(path))).length;
}

/** Viewport of a window of 1280 pixels at 400 %. */
const SMALL = { width: 320, height: 256 };

async function openStart(host, { viewport = DESKTOP, prepare } = {}) {
  const opened = await openPage(host, { viewport, prepare });
  await opened.page.getByTestId("card-paper").waitFor();
  return opened;
}

const isRunning = (page) => page.waitForFunction(() => window.kingpost?.sample()?.time_s > 0);
const isIdle = (page) => page.waitForFunction(() => window.kingpost?.sample()?.status === "idle");

async function isAccessible(page, viewport, palettes) {
  // Colours change at once: during a transition their contrast would be another.
  await page.emulateMedia({ reducedMotion: "reduce" });
  for (const palette of palettes) {
    await page.evaluate((name) => (document.documentElement.dataset.palette = name), palette);
    await assertAccessible(page, `the start page at ${viewport.width} px, ${palette}`);
  }
  const { width, inner } = await page.evaluate(() => ({ width: document.querySelector("#start-page").scrollWidth, inner: innerWidth }));
  assert.ok(width <= inner, `nothing is wider than the screen: ${width} in ${inner}`);
}

export default {
  async "the paper's scenario loads at most 0.6 MB without the engine, and 1.8 MB with it"(host) {
    const paths = new Set();
    const note = (response) => paths.add(response.url().slice(host.address.length).replace(/\?.*/, "") || "index.html");
    const { page, close } = await openPage(host, { query: PAPER, prepare: (context) => context.on("response", note) });
    await isIdle(page);
    await page.waitForLoadState("networkidle");
    const sizes = [...paths].filter((path) => existsSync(built(path))).map((path) => [path, sentSize(path)]);
    const sum = (some) => some.reduce((total, [, bytes]) => total + bytes, 0);
    const [all, without] = [sum(sizes), sum(sizes.filter(([path]) => !path.endsWith(".wasm")))];
    console.log(`        ${sizes.length} files, ${without} bytes without the engine, ${all} with it`);
    assert.ok(without <= SCENARIO_LOAD.without && all <= SCENARIO_LOAD.with && all > without, sizes.map((one) => one.join(" ")).join(", "));
    await close();
  },

  async "the start page shows the gallery's cards without the engine, within one megabyte"(host) {
    const sizes = [];
    const measure = async (response) => sizes.push({ url: response.url(), bytes: (await response.body().catch(() => Buffer.alloc(0))).length });
    const { page, close } = await openStart(host, { prepare: (context) => context.on("response", measure) });
    await page.waitForLoadState("networkidle");
    const cards = await page.locator(".card").count();
    const gallery = await (await fetch(`${host.address}scenarios/index.json`)).json();
    assert.equal(cards, gallery.length);
    assert.ok(!sizes.some(({ url }) => /wasm|simulator|worker/.test(url)), "nothing of the engine came");
    const total = sizes.reduce((sum, { bytes }) => sum + bytes, 0);
    assert.ok(total > 50_000 && total < FIRST_LOAD, `the first load is ${total} bytes`);
    assert.equal(await page.title(), "Kingpost – ship and crane simulator");
    await close();
  },

  async "a card opens a run, Back shows the start page, and Forward the unchanged run"(host) {
    const { page, close } = await openStart(host, { viewport: PHONE });
    await page.getByTestId("card-chain").tap();
    await isIdle(page);
    assert.match(page.url(), /\?scenario=chain$/);
    assert.match(await page.title(), /^Kingpost – Chain of ten links/);
    await page.getByTestId("start").tap();
    await page.waitForFunction(() => window.kingpost.sample().time_s > 0.1);
    await page.goBack();
    await page.getByTestId("card-chain").waitFor();
    assert.equal(await page.evaluate(() => window.kingpost.sample().status), "paused", "the run waits");
    await page.goForward();
    await page.getByTestId("canvas").waitFor();
    assert.ok((await page.evaluate(() => window.kingpost.sample().time_s)) > 0.1, "it is the same run");
    await page.getByTestId("to-start").tap();
    await page.getByTestId("card-paper").tap();
    await page.waitForFunction(() => document.querySelector("[data-testid=title]").textContent.startsWith("Crane ship"));
    assert.ok(page.url().endsWith(PAPER));
    await close();
  },

  async "a user's own file opens from the start page, and Back and Forward keep it"(host) {
    const { page, close } = await openStart(host);
    await openFile(page, "mine.yaml", paper.replace(/^title: .*/m, "title: A ship of mine"));
    await page.waitForFunction(() => document.querySelector("[data-testid=title]").textContent === "A ship of mine");
    await page.goBack();
    await page.getByTestId("card-paper").waitFor();
    await page.goForward();
    await page.getByTestId("canvas").waitFor();
    assert.equal(await page.title(), "Kingpost – A ship of mine");
    await close();
  },

  async "a file that is too large is refused unread, on both pages"(host) {
    const { page, close } = await openStart(host);
    const drop = () =>
      page.evaluate(() => {
        const files = new DataTransfer();
        files.items.add(new File([new Uint8Array(100_000_001)], "film.yaml"));
        dispatchEvent(new DragEvent("drop", { dataTransfer: files, cancelable: true }));
      });
    await drop();
    assert.match(await page.getByTestId("start-alert").textContent(), /^film\.yaml holds 101 MB; a scenario, .* at most 100 MB\.$/);
    await page.getByTestId("card-chain").click();
    await isIdle(page);
    await drop();
    assert.match(await page.getByTestId("alert-message").textContent(), /film\.yaml holds 101 MB/);
    assert.equal(await page.evaluate(() => window.kingpost.sample().status), "idle");
    await close();
  },

  async "a list or simulator that does not load is reported, with a way to continue"(host) {
    const { page } = await openPage(host, { prepare: (context) => context.route("**/index.json", (route) => route.abort()) });
    const context = page.context();
    await page.waitForFunction(() => /could not be loaded/.test(document.querySelector("[data-testid=start-alert]")?.textContent ?? ""));
    await context.unroute("**/index.json");
    await page.reload();
    await context.route("**/simulator-*.js", (route) => route.abort());
    await page.getByTestId("card-chain").click();
    await page.waitForFunction(() => /simulator did not load/.test(document.querySelector("[data-testid=start-alert]").textContent));
    assert.ok(await page.getByTestId("card-chain").isVisible());
    await context.close();
  },

  ...thorough(Object.fromEntries([DESKTOP, PHONE, SMALL].map((viewport) => [
    `the start page passes axe in each palette, ${viewport.width}x${viewport.height}`,
    async (host) => {
      const { page, close } = await openStart(host, { viewport });
      await isAccessible(page, viewport, ["day", "dusk", "night", "bright"]);
      await close();
    },
  ]))),

  async "the start page is usable in a window at 400 % and by the keyboard"(host) {
    const { page, close } = await openStart(host, { viewport: SMALL });
    await isAccessible(page, SMALL, ["day"]);
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.dataset.testid), "open-paper");
    await page.keyboard.press("Enter");
    await isRunning(page);
    await close();
  },

  async "a press of Start before the simulator has loaded starts the run"(host) {
    let load = () => {};
    const asked = new Promise((resolve) => (load = resolve));
    const slowly = (context) => context.route("**/simulator-*.js", async (route) => (await asked, route.continue()));
    const { page, close } = await openPage(host, { query: PAPER, viewport: PHONE, prepare: slowly });
    await page.getByTestId("start").tap();
    await page.getByText("Starts when it is loaded.").waitFor();
    load();
    await isRunning(page);
    await close();
  },
};
