// Parts that do not load or that break down: the engine, its worker, the gallery's list. The page reports this and
// offers a way to continue.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { PAPER, WAIT_MS, item, openApp, openFile, openPage, sample, setNumber, stepTo } from "./app.mjs";

const paper = readFileSync(fileURLToPath(new URL("../../../scenarios/paper.yaml", import.meta.url)), "utf8");

const alertOf = (page) => page.getByTestId("alert").textContent();

/** Opens the app while some addresses cannot be reached. */
async function openWithout(host, pattern) {
  const { page } = await openPage(host, { query: PAPER, prepare: (context) => context.route(pattern, (route) => route.abort()) });
  await page.getByTestId("alert-message").waitFor();
  return { page, context: page.context() };
}

async function opensAtReset({ page, context }, pattern) {
  assert.match(await alertOf(page), /The engine did not load/);
  assert.match(await page.getByTestId("hint").textContent(), /Reset tries again/);
  assert.equal(await page.getByTestId("start").isDisabled(), true);
  await context.unroute(pattern);
  await page.getByTestId("reset").click();
  await page.waitForFunction(() => window.kingpost.sample()?.status === "idle");
  assert.equal(await page.getByTestId("alert").textContent(), "");
  assert.equal(await item(page, "torque_history").inputValue(), "pulse", "with the values asked for");
  await stepTo(page, 0.01);
  await context.close();
}

/** Ends the engine during a run of the app, and waits until another engine continues the run from where it was. */
async function goesOn(page, end) {
  await setNumber(page, "crane_x_m", 3);
  await page.getByTestId("start").click();
  await page.waitForFunction(() => window.kingpost.sample().time_s > 0.05);
  const before = (await sample(page)).newest_s;
  await page.workers()[0].evaluate(end);
  await page.waitForFunction(() => document.getElementById("alert").textContent.includes("continues at"));
  await page.waitForFunction((time_s) => window.kingpost.sample().newest_s > time_s + 0.05, before);
  assert.equal(await page.getByTestId("cursor").getAttribute("min"), "0", "the recording is kept");
  assert.equal(await item(page, "crane_x_m").inputValue(), "3");
}

export default {
  async "an engine that does not load is reported, and Reset loads it"(host) {
    await opensAtReset(await openWithout(host, "**/*.wasm"), "**/*.wasm");
  },

  async "a missing engine script is reported, and Reset starts the engine"(host) {
    await opensAtReset(await openWithout(host, "**/worker-*.js"), "**/worker-*.js");
  },

  async "files can be opened if the gallery's list did not load"(host) {
    const { page, context } = await openWithout(host, "**/index.json");
    assert.match(await alertOf(page), /index\.json could not be fetched/);
    assert.match(await page.getByTestId("hint").textContent(), /Open a scenario/);
    await openFile(page, "mine.yaml", paper.replace(/^title: .*/m, "title: A ship of mine"));
    await page.waitForFunction(() => document.querySelector("[data-testid=title]").textContent === "A ship of mine");
    assert.equal(await alertOf(page), "");
    await stepTo(page, 0.01);
    await context.close();
  },

  async "another engine continues a run whose engine breaks down"(host) {
    const { page, close } = await openApp(host);
    await goesOn(page, () => void setTimeout(() => { throw new Error("out of memory"); }));
    await close();
  },

  async "another engine continues a run whose engine is ended without a word, without waiting for silence"(host) {
    const { page, close } = await openApp(host);
    // Half the time after which silence alone tells it.
    page.setDefaultTimeout(30_000);
    await goesOn(page, () => self.close());
    page.setDefaultTimeout(WAIT_MS);
    await close();
  },
};
