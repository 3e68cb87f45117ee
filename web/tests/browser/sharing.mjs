// A link contains a whole run: it is made in a dialog, and the run that it opens has the same bits.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { DESKTOP, item, openApp, openFile, PHONE, rested, sample, setNumber, stepTo } from "./app.mjs";
import { cases, isThorough } from "../lane.mjs";
import { assertAccessible } from "./axe.mjs";

const winch = readFileSync(fileURLToPath(new URL("../../../scenarios/lowering_by_winch.yaml", import.meta.url)), "utf8");

async function setByHand(page, name, value) {
  await item(page, name).fill(String(value));
  await item(page, name).blur();
}

/** Presses Share and returns the link. */
async function linkOf(page) {
  await page.getByTestId("share").click();
  const field = page.getByTestId("share-link");
  await field.waitFor();
  const link = await field.inputValue();
  await page.keyboard.press("Escape");
  return link;
}

async function openLink(host, link, options = {}) {
  return openApp(host, { ...options, query: link.slice(link.indexOf("#")) });
}

function assertSameBits(again, first) {
  for (const [name, value] of Object.entries(first)) assert.ok(Object.is(again[name], value), `${name}: ${again[name]}, at first ${value}`);
}

const dialogs = cases([DESKTOP, PHONE, { width: 320, height: 640 }], ({ width }) => width === 320).map((viewport) => [
  `the sharing dialog fits and passes axe, ${viewport.width}x${viewport.height}`,
  async (host) => {
    const { page, close } = await openApp(host, { query: "?scenario=lowering_by_winch", viewport });
    await page.emulateMedia({ reducedMotion: "reduce" });
    await stepTo(page, 0.3);
    await page.getByTestId("share").focus();
    await page.keyboard.press("Enter");
    await page.getByTestId("share-qr").locator("svg").waitFor();
    for (const palette of isThorough ? ["day", "dusk", "night", "bright"] : ["day"]) {
      await page.evaluate((name) => (document.documentElement.dataset.palette = name), palette);
      await assertAccessible(page, `the dialog, ${palette}`);
    }
    const boxes = await page.getByTestId("share-dialog").evaluate((dialog) => {
      const box = (element) => (({ left, right, top, bottom, width, height }) => ({ left, right, top, bottom, width, height }))(element.getBoundingClientRect());
      const targets = [...dialog.querySelectorAll("button, textarea")].filter((one) => one.checkVisibility());
      return { dialog: box(dialog), targets: targets.map(box), overflow: dialog.scrollWidth - dialog.clientWidth };
    });
    assert.ok(boxes.dialog.left >= 0 && boxes.dialog.right <= viewport.width && boxes.dialog.top >= 0 && boxes.dialog.bottom <= viewport.height, JSON.stringify(boxes.dialog));
    assert.ok(boxes.overflow <= 0, `it is ${boxes.overflow} wider than it shows`);
    for (const target of boxes.targets) assert.ok(target.width >= 43.5 && target.height >= 43.5, JSON.stringify(target));
    // Tab stays in the dialog, and Escape returns to the button.
    for (let i = 0; i < 8; i++) {
      await page.keyboard.press("Tab");
      assert.ok(await page.evaluate(() => document.activeElement === document.body || document.querySelector("[data-testid=share-dialog]").contains(document.activeElement)));
    }
    await page.keyboard.press("Escape");
    assert.equal(await page.getByTestId("share-dialog").isVisible(), false);
    assert.equal(await page.evaluate(() => document.activeElement.id), "share");
    await close();
  },
]);

export default {
  ...Object.fromEntries(dialogs),

  async "a shared run repeats changes by hand up to the link's moment, to the same bits"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=lowering_by_winch" });
    await setNumber(page, "load_t", 13.7);
    await stepTo(page, 1);
    await setByHand(page, "input-hoist", -10);
    await stepTo(page, 2.5);
    await setByHand(page, "input-hoist", 4.321);
    await stepTo(page, 4);
    const first = await sample(page);
    const link = await linkOf(page);
    assert.ok(link.startsWith(`${host.address}#k1=`), link);
    await close();

    const other = await openLink(host, link);
    const notice = other.page.getByTestId("notice-link");
    assert.match(await notice.textContent(), /The run repeats the 2 changes made by hand.*The link was made at 4\.00 s/);
    assert.equal(Number(await item(other.page, "load_t").inputValue()), 13.7);
    assert.match(await other.page.getByTestId("gallery").locator("option:checked").textContent(), /^From a link: /);
    await assertAccessible(other.page, "with the notice of a link");
    await other.page.getByTestId("run-to").click();
    await other.page.getByText("The numbers are the same to the last bit").waitFor();
    const again = await sample(other.page);
    assert.equal(again.status, "paused");
    assertSameBits(again.row, first.row);
    assert.equal(Number(await item(other.page, "input-hoist").inputValue()), 4.321);
    assert.ok(other.page.url().endsWith(link.slice(link.indexOf("#"))), "the address is still the link");
    // Back from another scenario returns to the link.
    await other.page.getByTestId("gallery").selectOption("chain");
    await other.page.waitForURL(/\?scenario=chain$/);
    assert.equal(await notice.count(), 0);
    await other.page.goBack();
    await notice.waitFor();
    assert.equal((await sample(other.page)).time_s, 0);
    await other.close();
  },

  async "a shared run sets live parameters at their times and shows them in the controls"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=offshore_vessel_on_dp" });
    await stepTo(page, 0.6);
    await setByHand(page, "wind_speed_m_s", 15);
    await page.waitForFunction(() => window.kingpost.sample().pending.length === 0);
    await stepTo(page, 2);
    const first = await sample(page);
    const link = await linkOf(page);
    await page.goto("about:blank");
    await page.goto(link);
    await page.getByTestId("run-to").waitFor();
    const before = await item(page, "wind_speed_m_s").inputValue();
    assert.notEqual(before, "15");
    await stepTo(page, 2);
    assert.equal(await item(page, "wind_speed_m_s").inputValue(), "15");
    assertSameBits((await sample(page)).row, first.row);
    await page.getByTestId("reset").click();
    await page.waitForFunction(() => window.kingpost.sample().status === "idle");
    assert.equal(await item(page, "wind_speed_m_s").inputValue(), before);
    await close();
  },

  async "a link contains a user's own scenario as text, and the dialog states this"(host) {
    const { page, close } = await openApp(host);
    await openFile(page, "mine.yaml", winch.replace(/^title: .*/m, "title: My winch"));
    await page.waitForFunction(() => document.querySelector("[data-testid=title]").textContent === "My winch");
    await page.getByTestId("share").click();
    await page.getByText("who has the link can read it").waitFor();
    const link = await page.getByTestId("share-link").inputValue();
    await page.getByTestId("share-qr").getByText("too long for a QR code").waitFor();
    await page.goto("about:blank");
    await page.goto(link);
    await page.waitForFunction(() => document.querySelector("[data-testid=title]")?.textContent === "My winch");
    await close();
  },

  async "the link is copied if the page may use the clipboard, and otherwise shown as text"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=paper" });
    await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    await page.getByTestId("share").click();
    await page.getByTestId("share-copy").click();
    await page.getByText("Copied.").waitFor();
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), await page.getByTestId("share-link").inputValue());
    await page.getByTestId("share-close").click();
    // A page without a secure connection, as on a phone over plain http.
    await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { value: undefined, configurable: true }));
    await page.getByTestId("share").click();
    await page.getByText("Select the link and copy it").waitFor();
    assert.equal(await page.getByTestId("share-copy").isVisible(), false);
    await page.getByTestId("share-link").focus();
    const selected = await page.getByTestId("share-link").evaluate(({ selectionStart, selectionEnd, value }) => selectionEnd - selectionStart === value.length);
    assert.ok(selected);
    await close();
  },

  async "the link is sent to other programs if the browser supports it"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=paper", viewport: PHONE });
    await page.evaluate(() => {
      navigator.canShare = ({ url }) => url.startsWith("http");
      navigator.share = async (given) => (window.shared = given);
    });
    await page.getByTestId("share").click();
    await page.getByTestId("share-send").click();
    const shared = await page.waitForFunction(() => window.shared);
    assert.match((await shared.jsonValue()).url, /#k1=/);
    await close();
  },

  async "a link that does not open is reported, and the default scenario opens"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=paper" });
    const link = await linkOf(page);
    const broken = [
      [link.slice(0, -12), /The link was cut: its end is missing/],
      [link.replace("#k1=", "#k1=x"), /The link is damaged/],
      [`${host.address}#k2=AAAA`, /made by a newer version of Kingpost/],
      [`${host.address}#k1=${"A".repeat(70_000)}`, /reads at most 64000/],
    ];
    for (const [given, says] of broken) {
      await page.goto("about:blank");
      await page.goto(given);
      await page.getByTestId("alert-message").waitFor();
      const shown = await page.getByTestId("alert").textContent();
      assert.match(shown, /This link cannot be opened/);
      assert.match(shown, says);
      assert.match(shown, /opened its default scenario instead/);
      assert.equal(new URL(page.url()).hash, "");
      await page.waitForFunction(() => window.kingpost?.sample()?.status === "idle");
    }
    // An open run stays, and so does its address.
    await stepTo(page, 0.1);
    await page.evaluate(() => (location.hash = "#k1=broken"));
    await page.getByText("The link was cut").waitFor();
    assert.ok((await sample(page)).time_s > 0);
    assert.equal(new URL(page.url()).hash, "");
    await close();
  },

  async "a change of the gallery after the link was made is reported"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=lowering_by_winch" });
    await stepTo(page, 0.5);
    const link = await linkOf(page);
    await page.context().route("**/lowering_by_winch.yaml", (route) => route.fulfill({ contentType: "text/plain", body: winch.replace(/(?<=load_t: .*)default: [\d.]+/, "default: 9").concat("\n# changed\n") }));
    await page.goto("about:blank");
    await page.goto(link);
    await page.getByText("have changed since the link was made").waitFor();
    await close();
  },

  async "skipping to the controls keeps the link in the address"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=chain" });
    const link = await linkOf(page);
    await page.goto("about:blank");
    await page.goto(link);
    await page.getByTestId("notice-link").waitFor();
    await stepTo(page, 0.1);
    await page.locator(".skip-link").focus();
    await page.keyboard.press("Enter");
    assert.equal(await page.evaluate(() => document.activeElement.id), "controls");
    assert.equal(page.url(), link);
    await rested(page);
    assert.ok(await page.getByTestId("canvas").isVisible());
    assert.ok((await sample(page)).time_s > 0);
    await close();
  },

  async "a link opens beside the setting of the picture's quality"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=chain" });
    const link = await linkOf(page);
    await page.goto("about:blank");
    await page.goto(link.replace("#", "#quality=best&"));
    await page.getByTestId("notice-link").waitFor();
    assert.match(await page.getByTestId("gallery").locator("option:checked").textContent(), /^From a link: /);
    await close();
  },
};
