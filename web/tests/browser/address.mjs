// The address holds the open scenario and its values; Back returns to the previous scenario.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { item, openApp, openFile, openPage, rested, sample, setNumber, settle } from "./app.mjs";

const paper = readFileSync(fileURLToPath(new URL("../../../scenarios/paper.yaml", import.meta.url)), "utf8");
const OWN = "A ship of mine";

const queryOf = (page) => new URL(page.url()).search;
const titled = (page, title) => page.waitForFunction((wanted) => document.querySelector("[data-testid=title]").textContent === wanted, title);

export default {
  async "an address with a name opens that scenario with the file's own values"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=paper" });
    assert.equal(await item(page, "load").isChecked(), false);
    assert.equal(await item(page, "torque_history").inputValue(), "constant");
    await rested(page);
    assert.equal(queryOf(page), "?scenario=paper");
    await close();
  },

  async "parameters of the address are applied, and an unknown one is reported"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=paper&load=true&crane_x_m=3.5" });
    assert.equal(await item(page, "load").isChecked(), true);
    assert.equal(await item(page, "crane_x_m").inputValue(), "3.5");
    await page.goto(`${host.address}?scenario=paper&nonesuch=3`);
    await page.getByText("The scenario opened with its own values").waitFor();
    assert.match(await page.getByTestId("alert").textContent(), /nonesuch: found an unknown name/);
    assert.equal(queryOf(page), "?scenario=paper");
    await close();
  },

  async "set values are written to the address, which opens the same run again"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=paper" });
    await setNumber(page, "crane_x_m", 7);
    await page.waitForURL(/crane_x_m=7$/);
    await page.reload();
    await page.waitForFunction(() => window.kingpost?.sample());
    assert.equal((await sample(page)).poses[7], 7);
    await close();
  },

  async "an address that holds no run of this app is reported, on both pages"(host) {
    const start = await openPage(host, { query: "#run=AAAA" });
    await start.page.waitForFunction(() => /could not be read: it holds “run”/.test(document.querySelector("[data-testid=start-alert]").textContent));
    await start.close();
    const { page, close } = await openApp(host, { query: "?scenario=chain#run=AAAA" });
    await page.getByTestId("alert-message").waitFor();
    assert.match(await page.getByTestId("alert-message").textContent(), /could not be read: it holds “run”/);
    await close();
  },

  async "an opened file stays among the choices, is not in the address, and Back returns to it"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=paper" });
    await openFile(page, "mine.yaml", paper.replace(/^title: .*/m, `title: ${OWN}`));
    await titled(page, OWN);
    await page.waitForURL(/\/$/);
    const gallery = page.getByTestId("gallery");
    assert.equal(await gallery.locator("option:checked").textContent(), "mine.yaml");
    await gallery.selectOption("chain");
    await page.waitForURL(/\?scenario=chain$/);
    await settle(page);
    await gallery.selectOption({ label: "mine.yaml" });
    await titled(page, OWN);
    await page.goBack();
    await page.waitForFunction(() => document.getElementById("gallery").value === "chain");
    await page.goBack();
    await titled(page, OWN);
    await page.goBack();
    await page.waitForFunction(() => document.getElementById("gallery").value === "paper");
    assert.equal(queryOf(page), "?scenario=paper");
    await close();
  },
};
