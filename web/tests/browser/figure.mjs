// Figures in an article on another origin: stills first, then runs with the numbers of the command line.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { serve } from "../../scripts/serve.mjs";
import { openApp, openPage } from "./app.mjs";
import { assertAccessible } from "./axe.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const article = readFileSync(here("article.html"), "utf8");
const cell = readFileSync(here("notebook_cell.html"), "utf8");
const goldens = JSON.parse(readFileSync(here("../../../crates/kingpost/tests/golden/paper.json"), "utf8"));
/** Bytes of an article before the first touch, all of it uncompressed: the requirement on a page with six figures. */
const MOST_BYTES = 150_000;

/** Serves the article from another site than the app, and opens it. */
async function openArticle({ browser, address }, text = article, options = {}) {
  const folder = mkdtempSync(join(tmpdir(), "kingpost-article-"));
  writeFileSync(join(folder, "index.html"), text.replaceAll("APP/", address));
  const served = await serve(folder);
  const seen = [];
  const prepare = async (context) => void context.on("requestfinished", (request) => seen.push(request));
  // `localhost` and the number are two sites for a browser.
  const opened = await openPage({ browser, address: served.address.replace("127.0.0.1", "localhost") }, { prepare, ...options });
  await opened.page.waitForFunction(() => customElements.get("kingpost-figure"));
  return {
    ...opened,
    seen,
    async close() {
      await opened.close();
      await served.stop();
      rmSync(folder, { recursive: true });
    },
  };
}

const rowOf = (page, id) => page.evaluate((name) => Object.values(document.getElementById(name).row), id);

/** Sets the time of a figure, and waits until it is shown. */
async function goTo(page, id, time_s) {
  await page.evaluate(([name, time]) => {
    const figure = document.getElementById(name);
    figure.scrollIntoView();
    figure.time = time;
  }, [id, time_s]);
  await page.waitForFunction(([name, time]) => {
    const figure = document.getElementById(name);
    return figure.paused && Math.abs(figure.time - time) < 1e-9;
  }, [id, time_s]);
}

/** Checks that a row of the paper's page is that of the native engine, to the last bit. */
function assertNative(found) {
  const { row } = goldens.find(({ name }) => name === "page");
  assert.equal(found.length, row.length);
  found.forEach((value, i) => assert.ok(Object.is(value, row[i]), `column ${i}: ${value}, native ${row[i]}`));
}

/** Waits until a figure plays. */
const plays = (page, id) => page.waitForFunction((name) => !document.getElementById(name).paused, id);

export default {
  async "an article with six figures loads less than 150 kB before the first touch, and axe finds nothing"(host) {
    const { page, seen, close } = await openArticle(host);
    await page.waitForLoadState("networkidle");
    // The article is read to its end: scrolling alone starts nothing.
    await page.getByTitle("The ship of the paper").scrollIntoViewIfNeeded();
    const plain = await (await page.waitForSelector("#plain")).contentFrame();
    await plain.waitForSelector("#still:not([hidden])");
    await page.waitForLoadState("networkidle");
    const sizes = await Promise.all(seen.map(async (request) => (await request.sizes()).responseBodySize));
    const total = sizes.reduce((sum, size) => sum + size, 0);
    console.log(`        ${seen.length} requests, ${total} bytes before the first touch`);
    assert.ok(total < MOST_BYTES, `${total} bytes: ${seen.map((request, i) => `${request.url()} ${sizes[i]}`).join(", ")}`);
    assert.deepEqual(seen.filter((request) => /\.wasm|worker/.test(request.url())).map((request) => request.url()), []);
    assert.equal(page.frames().length, 2, "only the plain frame is there");
    await assertAccessible(page, "stills");
    await close();
  },

  async "figures have the numbers of kingpost run to the last bit"(host) {
    const { page, close } = await openArticle(host);
    await goTo(page, "paper", 2);
    const found = await rowOf(page, "paper");
    assertNative(found);
    // Back in time, and forward again.
    await goTo(page, "paper", 1);
    await goTo(page, "paper", 2);
    assert.deepEqual(await rowOf(page, "paper"), found);
    await close();
  },

  async "a notebook that was exported plays the run of its cell, with the numbers of kingpost run to the last bit"(host) {
    const page_of_cell = `<!doctype html><html lang="en"><title>A notebook</title><link rel="icon" href="data:,"><main>${cell.replaceAll("http://app.example/", "APP/")}</main></html>`;
    const { page, close } = await openArticle(host, page_of_cell);
    await page.evaluate(() => (document.querySelector("kingpost-figure").id = "cell"));
    await goTo(page, "cell", 2);
    assertNative(await rowOf(page, "cell"));
    await close();
  },

  async "a touch plays a figure, and a second figure that plays pauses the first"(host) {
    const { page, close } = await openArticle(host);
    const start = (id) => page.locator(`#${id}`).getByRole("button", { name: /^Start the figure/ });
    await start("chain").click();
    await plays(page, "chain");
    await page.waitForFunction(() => document.getElementById("chain").time > 0);
    // By the keyboard: a click just after scrolling past a frame of another site may still go to that frame in Chromium.
    await start("racket").press("Enter");
    await plays(page, "racket");
    await page.waitForFunction(() => document.getElementById("chain").paused);
    assert.equal(await page.evaluate(() => document.getElementById("racket").paused), false);
    const frame = page.frames().find((one) => one.url().includes("scenario=tennis_racket"));
    await frame.getByTestId("play").click();
    await page.waitForFunction(() => document.getElementById("racket").paused);
    await assertAccessible(frame, "a figure that runs");
    await assertAccessible(page, "an article with figures that run");
    await close();
  },

  async "a number of the article moves a figure's ship, and a step of the text sets time and camera"(host) {
    const { page, close } = await openArticle(host);
    await page.evaluate(() => (document.getElementById("place").value = "7"));
    await page.getByRole("slider", { name: /along the ship/ }).dispatchEvent("input");
    await page.waitForFunction(() => window.heard.some(({ type, value }) => type === "kingpost-changed" && value === 7));
    const frame = page.frames().find((one) => one.url().includes("scenario=paper") && one.url().includes("awake"));
    assert.equal(await frame.locator("#parameter-crane_x_m").inputValue(), "7");
    const at = (await page.evaluate(() => document.getElementById("paper").row))["tower.position.x"];
    await page.evaluate(() => (document.getElementById("paper").camera = "top"));
    await goTo(page, "paper", 0.5);
    // A value that needs a new run keeps the time that the text shows.
    await page.evaluate(() => document.getElementById("paper").set("crane_x_m", -3));
    await page.waitForFunction(() => document.getElementById("paper").row["tower.position.x"] < 0 && Math.abs(document.getElementById("paper").time - 0.5) < 1e-9);
    assert.equal(typeof at, "number");
    await page.evaluate(() => document.getElementById("paper").set("nonesuch", 1));
    await page.waitForFunction(() => window.heard.some(({ code, message }) => code === "name" && /nonesuch.*crane_x_m/.test(message)));
    await page.evaluate(() => (document.getElementById("paper").camera = "moon"));
    await page.waitForFunction(() => window.heard.some(({ message }) => /camera: found moon/.test(message ?? "")));
    await close();
  },

  async "a figure in a plain frame plays after a touch, and refuses messages without a greeting"(host) {
    const { page, problems, close } = await openArticle(host);
    const element = await page.waitForSelector("#plain");
    await element.scrollIntoViewIfNeeded();
    const frame = await element.contentFrame();
    await frame.waitForSelector("#wake");
    await page.evaluate(() => {
      const { contentWindow } = document.getElementById("plain");
      for (const message of [null, 3, "play", {}, { kingpost: 1 }, { kingpost: 1, kind: "set" }, { kingpost: 99, kind: "play" }, { kingpost: 1, kind: "play" }]) contentWindow.postMessage(message, "*");
    });
    assert.equal(await frame.getByTestId("wake").isVisible(), true, "no message without a greeting starts it");
    await frame.getByTestId("wake").click();
    await frame.waitForFunction(() => document.getElementById("time").textContent > "0.05 s");
    await frame.getByTestId("play").click();
    assert.deepEqual(problems, []);
    await close();
  },

  async "a figure of a scenario file beside the page takes the files of its folder, and refuses one from another host"(host) {
    const mine = readFileSync(here("../../../scenarios/chain.yaml"), "utf8").replace(/^title: .*/m, "title: A chain of mine");
    // As on a static host: the article, the scenario and the app in one folder.
    const { page, close } = await openPage(host, {
      query: "article/",
      prepare: async (context) => {
        await context.route("**/article/", (route) => route.fulfill({ contentType: "text/html", body: `<!doctype html><html lang="en"><title>Mine</title><main><h1>Mine</h1><script src="../kingpost-figure.js"></script><kingpost-figure id="mine" scenario="mine.yaml" plot="base.position.z"></kingpost-figure><kingpost-figure id="other" scenario="https://other.example/mine.yaml"></kingpost-figure></main>` }));
        await context.route("**/article/mine.yaml", (route) => route.fulfill({ contentType: "text/plain", body: mine }));
      },
    });
    const title = await page.evaluate(() => new Promise((tell) => {
      const figure = document.getElementById("mine");
      figure.addEventListener("kingpost-ready", ({ detail }) => tell(detail.title));
      figure.time = 0;
    }));
    assert.equal(title, "A chain of mine");
    const refusal = await page.evaluate(() => new Promise((tell) => {
      const figure = document.getElementById("other");
      figure.addEventListener("kingpost-error", ({ detail }) => tell(detail.message));
      figure.play();
    }));
    assert.match(refusal, /other\.example.*allowed: an address on the host of the app/);
    await close();
  },

  async "the embed code of Share shows the run as a figure"(host) {
    const { page, close } = await openApp(host);
    await page.getByTestId("share").click();
    await page.getByTestId("embed").locator("summary").click();
    const code = await page.getByTestId("embed-code").inputValue();
    assert.match(code, /scenario="paper"/);
    assert.match(code, /set="motor_1=true; load=true; torque_history=pulse"/);
    await page.getByTestId("embed-frame").check();
    assert.match(await page.getByTestId("embed-code").inputValue(), /^<iframe src="[^"]*figure\.html\?scenario=paper&amp;/);
    await assertAccessible(page, "the dialog with the embed code");
    await close();

    const own = await openArticle(host, `<!doctype html><html lang="en"><title>Embedded</title><link rel="icon" href="data:," /><main><h1>Embedded</h1>${code.replace("<kingpost-figure", '<kingpost-figure id="embedded"')}</main>`);
    await goTo(own.page, "embedded", 2);
    assert.deepEqual(await rowOf(own.page, "embedded"), goldens.find(({ name }) => name === "page").row);
    await own.close();
  },

  async "the mark figure in the app's address leads to the figure page"(host) {
    const { page, close } = await openPage(host, { query: "?figure&scenario=chain&caption=A+chain." });
    await page.waitForURL(/figure\.html\?scenario=chain&caption=A\+chain\.$/);
    await page.getByText("A chain.").last().waitFor();
    await close();
  },
};
