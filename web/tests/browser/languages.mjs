// The app in Norwegian: all its texts, with space for longer words; and switching to another language and back.
import assert from "node:assert/strict";
import { cases, thorough } from "../lane.mjs";
import { DESKTOP, item, openApp, openPage, PHONE, sample, stepTo } from "./app.mjs";
import { assertAccessible } from "./axe.mjs";
import { assertUncropped } from "./layout.mjs";

const NARROW = { width: 340, height: 640 };
/** English words that would be on the page if a text were not translated. */
const ENGLISH = /\b(Start with|Controls|Plots|Instruments|Equations|Reset|Resume|Speed|Levers|Advanced|Draught|Look ahead|Camera|Show|Language|Export|Save|Share)\b/;

async function openStart(host, { viewport = DESKTOP, locale = "nb-NO", prepare } = {}) {
  const opened = await openPage(host, { viewport, locale, prepare });
  await opened.page.getByTestId("card-paper").waitFor();
  return opened;
}

const languageOf = (page) => page.evaluate(() => document.documentElement.lang);

/** Returns the readable text of the page, except text that is marked as English. */
function ownWords() {
  const words = [];
  const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walk.nextNode(); node; node = walk.nextNode()) {
    const { parentElement } = node;
    if (parentElement.closest("[lang]").lang === "nb" && !parentElement.closest("script, style, noscript") && parentElement.checkVisibility()) words.push(node.textContent.trim());
  }
  return words.filter((word) => word !== "").join(" | ");
}

/** Checks that all texts are present and that none is in English. */
async function assertNorwegian(page, ...words) {
  const found = await page.evaluate(ownWords);
  for (const word of words) assert.ok(found.includes(word), `${word} in ${found}`);
  assert.doesNotMatch(found, ENGLISH);
}

/** Checks each panel of a run: nothing is cropped, and axe finds no violation. */
async function assertPanels(page, viewport) {
  const panels = { plots: "Eksport", instruments: "Avlesninger", equations: "Pek på en blokk", controls: "Avansert" };
  for (const [panel, word] of Object.entries(panels)) {
    const button = page.getByTestId(`show-${panel}`);
    if (!(await button.isVisible())) continue;
    await button.click();
    if (panel === "equations") await page.locator(".matrix-sheet table").waitFor();
    await assertUncropped(page, viewport);
    await assertNorwegian(page, word, "Krengning", "Dypgang", "Bølge", "Nullstill", "Steg");
  }
}

const inNorwegian = cases([DESKTOP, PHONE], (viewport) => viewport === PHONE).map((viewport) => [
  `the page is in Norwegian in a Norwegian browser, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openStart(host, { viewport });
    assert.equal(await languageOf(page), "nb");
    assert.equal(await page.title(), "Kingpost – simulator for skip og kran");
    await assertNorwegian(page, "Skip og kraner til sjøs", "Start med artikkelens kranskip", "Språk");
    assert.equal(await page.locator(".card h3").first().getAttribute("lang"), "en");
    await page.emulateMedia({ reducedMotion: "reduce" });
    await assertAccessible(page, "the start page in Norwegian");
    const { width, inner } = await page.evaluate(() => ({ width: document.querySelector("#start-page").scrollWidth, inner: innerWidth }));
    assert.ok(width <= inner, `nothing is wider than the screen: ${width} in ${inner}`);
    await page.getByTestId("card-offshore_vessel").click();
    await page.waitForFunction(() => window.kingpost?.sample()?.status === "idle");
    await page.getByTestId("step").click();
    await page.waitForFunction(() => document.getElementById("start-label").textContent === "Fortsett");
    await assertPanels(page, viewport);
    await page.locator("#advanced summary").click();
    await page.locator("#about summary").click();
    await assertNorwegian(page, "Steglengde", "Hva er dette?", "krengning");
    await assertAccessible(page, "a run in Norwegian with its folds open");
    await close();
  },
]);

const narrow = [PHONE, NARROW].map((viewport) => [
  `Norwegian texts fit at an earlier moment too, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openApp(host, { viewport, locale: "nb-NO", query: "?scenario=offshore_vessel" });
    await stepTo(page, 0.5);
    await assertUncropped(page, viewport);
    await page.getByTestId("cursor").focus();
    await page.keyboard.press("ArrowLeft");
    await page.waitForFunction(() => document.getElementById("start-label").textContent === "Herfra");
    await assertUncropped(page, viewport);
    await close();
  },
]);

export default {
  ...Object.fromEntries(inNorwegian),

  ...thorough(Object.fromEntries(narrow)),

  async "the user switches to English and back at the same address"(host) {
    const { page, close } = await openStart(host);
    await page.getByTestId("language").selectOption("en");
    await page.waitForFunction(() => document.documentElement.lang === "en");
    await page.getByText("Start with the paper's crane ship").waitFor();
    assert.equal(page.url(), host.address);
    await page.goto(`${host.address}?scenario=offshore_vessel`);
    await page.waitForFunction(() => window.kingpost?.sample()?.status === "idle");
    assert.equal(await page.getByTestId("reset").textContent().then((text) => text.trim()), "Reset", "it is kept");
    const address = page.url();
    await page.locator("#advanced summary").click();
    await page.getByTestId("language-setting").selectOption("nb");
    await page.waitForFunction(() => document.documentElement.lang === "nb" && window.kingpost?.sample()?.status === "idle");
    assert.equal(page.url(), address);
    await assertNorwegian(page, "Nullstill");
    await close();
  },

  async "lever moves by hand are listed in Norwegian, although the engine's worker reports them"(host) {
    const { page, close } = await openApp(host, { locale: "nb-NO", query: "?scenario=lowering_by_winch" });
    await page.getByTestId("step").click();
    await page.waitForFunction(() => window.kingpost.sample().time_s > 0);
    await item(page, "input-hoist").fill("-66");
    await item(page, "input-hoist").blur();
    await stepTo(page, (await sample(page)).time_s + 0.2);
    const marks = page.getByTestId("marks").locator("li");
    await marks.first().waitFor({ state: "attached" });
    assert.match((await marks.allTextContents()).join(), /hoist: satt til -66 for hånd$/);
    await close();
  },

  async "messages of the engine are marked as English, and those of the page are in Norwegian"(host) {
    const { page, close } = await openApp(host, { locale: "nb-NO", query: "?scenario=quayside_lift&box_t=9999" });
    const message = page.getByTestId("alert-message");
    await message.waitFor();
    assert.equal(await message.textContent(), "box_t: found 9999, allowed: a number from 1 to 8. Scenarioet ble åpnet med sine egne verdier.");
    assert.equal(await message.locator("[lang=en]").textContent(), "box_t: found 9999, allowed: a number from 1 to 8.");
    assert.equal(await page.locator(".alert-heading").first().textContent(), "Adressen har en verdi som ikke er tillatt");
    assert.equal(await page.locator(".alert-close").first().getAttribute("aria-label"), "Lukk");
    await close();
  },

  async "the page has the browser's language if storage is denied"(host) {
    const denied = (context) => context.addInitScript(() => Object.defineProperty(window, "localStorage", { get() { throw new DOMException("denied", "SecurityError"); } }));
    const { page, close } = await openStart(host, { prepare: denied });
    assert.equal(await languageOf(page), "nb");
    await page.getByTestId("language").selectOption("en");
    await page.waitForFunction(() => document.querySelector("[data-testid=language]")?.value === "nb");
    await page.getByTestId("card-paper").waitFor();
    await close();
  },

  ...thorough({
    async "the page is in English in a browser of another language"(host) {
      const { page, close } = await openStart(host, { locale: "ko-KR" });
      assert.equal(await languageOf(page), "en");
      await page.getByText("Start with the paper's crane ship").waitFor();
      await close();
    },
  }),
};
