// The app is cached on the device if it is served over a secure connection: it opens without a network, and builds do
// not mix.
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { serve } from "../../scripts/serve.mjs";
import { openApp, sample, settle, stepTo } from "./app.mjs";

const DIST = fileURLToPath(new URL("../../dist", import.meta.url));

const isKept = (page) => page.waitForFunction(() => navigator.serviceWorker.controller !== null, null, { timeout: 60_000 });
const titled = (page, title) => page.waitForFunction((wanted) => document.querySelector("[data-testid=title]").textContent === wanted, title);

/** A copy of the built app, which the test can change into another build. */
function buildOf() {
  const folder = mkdtempSync(join(tmpdir(), "kingpost-"));
  cpSync(DIST, folder, { recursive: true });
  const write = (path, change) => {
    const text = change(readFileSync(join(folder, path), "utf8"));
    writeFileSync(join(folder, path), text);
    return createHash("sha256").update(text).digest("hex").slice(0, 16);
  };
  return {
    folder,
    /** Changes a file of the copy, and its digest in the list of the worker, as another build has them. */
    change(path, how) {
      const digest = write(path, how);
      write("offline.js", (script) => script.replace(new RegExp(`"${path}":"\\w+"`), `"${path}":"${digest}"`));
    },
    remove: () => rmSync(folder, { recursive: true }),
  };
}

const retitled = (title) => (text) => text.replace(/^title: .*/m, `title: ${title}`);

export default {
  async "the app and other scenarios of the gallery open without a network"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=paper", serviceWorkers: "allow" });
    await isKept(page);
    await page.context().setOffline(true);
    await page.getByTestId("gallery").selectOption("offshore_vessel");
    await page.waitForURL(/scenario=offshore_vessel$/);
    await settle(page);
    await stepTo(page, 0.2);
    assert.ok((await sample(page)).poses.length > 0);
    assert.equal(await page.getByTestId("alert").textContent(), "");
    await page.goto(`${host.address}?scenario=barge`);
    await page.waitForFunction(() => window.kingpost?.sample());
    await stepTo(page, 0.2);
    // A part that is loaded only when it is used.
    await page.getByTestId("show-equations").click();
    await page.locator(".matrix").waitFor();
    await page.getByTestId("share").click();
    await page.getByTestId("share-qr").locator("svg").waitFor();
    await close();
  },

  async "the app can be installed: its manifest and icons are in the folder from which it is served"(host) {
    const { page, close } = await openApp(host);
    const found = await page.evaluate(async () => {
      const link = document.querySelector('link[rel="manifest"]').href;
      const manifest = await (await fetch(link)).json();
      const at = (path) => new URL(path, link).href;
      const sizes = await Promise.all(
        manifest.icons.map(async ({ src, sizes, type }) => {
          const answer = await fetch(at(src));
          const { width } = type === "image/png" ? await createImageBitmap(await answer.blob()) : { width: "any" };
          return [sizes, width === "any" ? "any" : `${width}x${width}`, answer.headers.get("content-type") === type];
        }),
      );
      return { start: at(manifest.start_url), scope: at(manifest.scope), name: manifest.short_name, display: manifest.display, sizes, purposes: manifest.icons.map(({ purpose }) => purpose) };
    });
    assert.deepEqual([found.start, found.scope, found.name, found.display], [host.address, host.address, "Kingpost", "standalone"]);
    assert.deepEqual(found.purposes, ["any", "any", "any", "maskable"]);
    for (const [said, is, isTyped] of found.sizes) assert.deepEqual([is, isTyped], [said, true]);
    await close();
  },

  async "the app stays at one build until the user updates, and is then replaced completely"({ browser }) {
    const build = buildOf();
    const { address, stop } = await serve(build.folder, "/deep/below/");
    const { page, close } = await openApp({ browser, address }, { query: "?scenario=paper", serviceWorkers: "allow" });
    await isKept(page);
    build.change("scenarios/paper.yaml", retitled("A newer paper"));
    build.change("scenarios/chain.yaml", retitled("A newer chain"));
    await page.reload();
    await page.getByTestId("notice-update").waitFor();
    assert.match(await page.getByTestId("notice-update").textContent(), /A new version is available/);
    await page.getByTestId("gallery").selectOption("chain");
    await page.waitForURL(/scenario=chain$/);
    await settle(page);
    assert.notEqual(await page.getByTestId("title").textContent(), "A newer chain");

    // Another window has the older build too: an update would mix the two builds there.
    const other = await page.context().newPage();
    await other.goto(`${address}?scenario=paper`);
    await other.waitForFunction(() => window.kingpost?.sample());
    await page.bringToFront();
    await page.getByTestId("update").click();
    await page.getByText("Close the app's other window first").waitFor();
    await other.close();
    await page.getByTestId("update").click();
    await titled(page, "A newer chain");
    assert.equal(await page.getByTestId("notice-update").count(), 0);
    // No file of the older build is left.
    const kept = await page.evaluate(async () => Promise.all((await caches.keys()).map(async (name) => (await (await caches.open(name)).keys()).map(({ url }) => url))));
    assert.equal(kept.length, 1);
    assert.equal(kept[0].filter((url) => url.includes("scenarios/paper.yaml")).length, 1);
    await page.context().setOffline(true);
    await page.goto(`${address}?scenario=paper`);
    await titled(page, "A newer paper");
    await close();
    await stop();
    build.remove();
  },

  async "a local server removes the cached app from the device and serves its own files"({ browser }) {
    const build = buildOf();
    const { address, stop } = await serve(build.folder, "/");
    const { page, close } = await openApp({ browser, address }, { query: "?scenario=paper", serviceWorkers: "allow" });
    await isKept(page);
    // Answers as `kingpost serve`, with another scenario of the same name.
    cpSync(join(build.folder, "offline-leave.js"), join(build.folder, "offline.js"));
    writeFileSync(join(build.folder, "scenarios/paper.yaml"), retitled("Served now")(readFileSync(join(build.folder, "scenarios/paper.yaml"), "utf8")));
    await page.reload();
    await titled(page, "Served now");
    assert.deepEqual(await page.evaluate(() => caches.keys()), []);
    await page.reload();
    await titled(page, "Served now");
    await page.waitForFunction(async () => (await navigator.serviceWorker.getRegistration()) === undefined);
    assert.equal(await page.evaluate(() => navigator.serviceWorker.controller), null);
    await close();
    await stop();
    build.remove();
  },

  async "a build with a file of another build is not cached, and the app runs"({ browser }) {
    const build = buildOf();
    writeFileSync(join(build.folder, "scenarios/chain.yaml"), "version: 1\n");
    const { address, stop } = await serve(build.folder, "/");
    const { page, close } = await openApp({ browser, address }, { query: "?scenario=paper", serviceWorkers: "allow" });
    await page.waitForFunction(async () => (await navigator.serviceWorker.getRegistration()) === undefined);
    await stepTo(page, 0.1);
    assert.equal(await page.evaluate(() => navigator.serviceWorker.controller), null);
    await close();
    await stop();
    build.remove();
  },
};
