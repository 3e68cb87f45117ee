// Takes the picture of docs/job from the app that `kingpost serve lift.yaml` serves: node scripts/job.mjs ADDRESS PICTURE.jpeg
import { findBrowser, launch } from "./browser.mjs";
import { ALONE, openPage, runTo, turn } from "./shots.mjs";

const [address, picture] = process.argv.slice(2);
const executable = findBrowser();
if (!executable) throw new Error("there is no Chromium on this machine (CHROMIUM=path names one)");
const browser = await launch(executable);
const { origin, pathname, search } = new URL(address);
const page = await openPage(browser, `${origin}${pathname}`, search, { width: 1000, height: 600 });
// The load is over the side, and on its way down.
await runTo(page, 160);
await page.addStyleTag({ content: ALONE });
await page.waitForTimeout(1000);
await turn(page, { left: 10, up: -4, nearer: 5 });
await page.waitForTimeout(1500);
await page.screenshot({ path: picture, type: "jpeg", quality: 82 });
await browser.close();
