// How pictures of the app are taken: a page, a moment of its run, the turn of its view.

/** As fast as it goes, then back to the very moment. */
export async function runTo(page, time_s) {
  await page.getByTestId("speed").selectOption("Infinity");
  await page.getByTestId("start").click();
  await page.waitForFunction((until) => window.kingpost.sample().newest_s >= until || window.kingpost.sample().status === "stopped", time_s);
  await lookAt(page, time_s);
}

export async function lookAt(page, time_s) {
  await page.evaluate((time) => {
    const cursor = document.getElementById("cursor");
    cursor.value = String(time);
    cursor.dispatchEvent(new Event("input", { bubbles: true }));
  }, time_s);
}

export async function openPage(browser, address, query, viewport, scale = 1) {
  const isPhone = viewport.width < 600;
  const context = await browser.newContext({ viewport, deviceScaleFactor: scale, colorScheme: "light", reducedMotion: "reduce", hasTouch: isPhone, isMobile: isPhone, serviceWorkers: "block" });
  const page = await context.newPage();
  page.setDefaultTimeout(300_000);
  await page.goto(`${address}${query}#quality=best`);
  await page.waitForFunction((isRun) => (isRun ? window.kingpost?.sample() : document.querySelectorAll(".card img").length > 3), query !== "");
  return page;
}

/** The picture alone fills the page. */
export const ALONE = `.scene { position: fixed !important; inset: 0; z-index: 99; border: 0 !important; border-radius: 0 !important }
  .scene > :not(canvas), .alert { display: none !important } canvas { outline: 0 !important }`;

/** Turns the view from where it fits, a press of a key at a time. */
export async function turn(page, { left = 0, up = 0, nearer = 0 }) {
  const press = async (key, times) => {
    for (let k = 0; k < times; k += 1) await page.getByTestId("canvas").press(key);
  };
  await press("Home", 1);
  await press(left < 0 ? "ArrowRight" : "ArrowLeft", Math.abs(left));
  await press(up < 0 ? "ArrowDown" : "ArrowUp", Math.abs(up));
  await press("+", nearer);
}
