// Functions with which the tests use the app: open a page, set controls, read numbers.
import assert from "node:assert/strict";

export const PHONE = { width: 390, height: 844 };
export const DESKTOP = { width: 1440, height: 900 };
/**
 * Viewport of the desktop layout. Without a graphics card each pixel costs time, so that tests draw one pixel for two
 * by two unless they need all.
 */
export const WINDOW = { width: 1000, height: 640 };

/** Limit for waiting: with four processes on two processors, all without a graphics card, a run takes a minute. */
export const WAIT_MS = 300_000;

/** Query of the paper's ship as its card opens it: with the load on, and a motor that stops by itself. */
export const PAPER = "?scenario=paper&motor_1=true&load=true&torque_history=pulse";

/** Makes WebGL draw no pixels; everything else of a picture is computed. */
function drawNothing() {
  for (const draw of ["clear", "drawArrays", "drawArraysInstanced", "drawElements", "drawElementsInstanced"]) WebGL2RenderingContext.prototype[draw] = () => {};
}

/**
 * Pages that tests have closed, for the next test that needs a page of the same kind, because a new page compiles the
 * app and the engine again. Storage, routes and emulation of a test are reset when it ends.
 */
const left = new WeakMap();

const leftIn = (browser) => left.get(browser) ?? left.set(browser, new Map()).get(browser);

/** Drops all pages after a failure, because their state is unknown. */
export async function forgetPages(browser) {
  left.delete(browser);
  await Promise.all(browser.contexts().map((context) => context.close()));
}

async function newPage(browser, { draws, ...options }) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  page.setDefaultTimeout(WAIT_MS);
  if (!draws) await page.addInitScript(drawNothing);
  const one = { page, problems: [] };
  page.on("pageerror", (error) => one.problems.push(error.message));
  page.on("console", (message) => message.type() === "error" && one.problems.push(message.text()));
  return one;
}

async function leave(browser, kind, one) {
  const { page } = one;
  const context = page.context();
  await page.evaluate(() => {
    localStorage.clear();
    sessionStorage.clear();
  });
  await page.goto("about:blank");
  await context.unrouteAll();
  await context.clearPermissions();
  leftIn(browser).get(kind).push(one);
}

/**
 * Opens an address of the app. The app is cached on the device only in tests of the cache, and pixels are drawn only in
 * tests of the picture, because drawing takes most of the time without a graphics card. For the same reason the view
 * then comes to rest at once. `prepare` gets a separate context before the address opens.
 */
export async function openPage({ browser, address }, { query = "", draws = false, reducedMotion = draws ? "reduce" : "no-preference", colorScheme = "light", viewport = WINDOW, serviceWorkers = "block", locale, scale = viewport === WINDOW ? 0.5 : 1, prepare } = {}) {
  const isPhone = viewport.width < 600;
  const kept = { deviceScaleFactor: scale, hasTouch: isPhone, isMobile: isPhone, serviceWorkers, locale, draws };
  const kind = JSON.stringify(kept);
  const same = leftIn(browser).get(kind) ?? leftIn(browser).set(kind, []).get(kind);
  const isShared = serviceWorkers === "block" && !prepare;
  const one = (isShared && same.pop()) || (await newPage(browser, kept));
  one.problems.length = 0;
  await prepare?.(one.page.context());
  const { page, problems } = one;
  await page.setViewportSize(viewport);
  await page.emulateMedia({ colorScheme, reducedMotion });
  await page.goto(address + query);
  return {
    page,
    problems,
    async close() {
      if (isShared) await leave(browser, kind, one);
      else await page.context().close();
      assert.deepEqual(problems, [], "the browser's console is clean");
    },
  };
}

/** Opens a scenario in the app and waits until it is open. */
export async function openApp(host, { query = PAPER, ...options } = {}) {
  const opened = await openPage(host, { query, ...options });
  await opened.page.waitForFunction(() => window.kingpost?.sample());
  return opened;
}

export const sample = (page) => page.evaluate(() => window.kingpost.sample());
export const item = (page, name) => page.getByTestId(`parameter-${name}`);

/** Waits until a reset has applied the value of a control to the run. */
export async function settle(page) {
  await page.waitForFunction(() => {
    const { status, pending, isWaiting } = window.kingpost.sample();
    return status === "idle" && pending.length === 0 && !isWaiting;
  });
}

/** Waits until the page is at rest: no request waits, and picture and plots are drawn. */
export const rested = (page) => page.evaluate(() => window.kingpost.rested());

export async function setNumber(page, name, value) {
  await item(page, name).fill(String(value));
  await item(page, name).blur();
  await settle(page);
}

export async function setChecked(page, name, value) {
  await item(page, name).setChecked(value);
  await settle(page);
}

/** Sets the case of the paper's Figs. 9 to 11: crane at the centre, no load, constant torque. */
export async function setFigures(page) {
  await setChecked(page, "load", false);
  await item(page, "torque_history").selectOption("constant");
  await settle(page);
  await setNumber(page, "crane_x_m", 0);
  await setNumber(page, "crane_y_m", 0);
}

/** Sets the unit of angles in the plots: degrees or radians. */
export async function setAngle(page, angle) {
  await page.getByTestId("view-plots").click();
  await page.getByTestId(`unit-${angle}`).click();
  await page.getByTestId("view-done").click();
}

/** Sets the lines of a plot, as a group or one by one, and its kind. */
export async function setPlot(page, place, { figure, lines = [], kind }) {
  await page.getByTestId(`choose-${place}`).click();
  const picker = page.getByTestId("picker");
  if (kind) await page.getByTestId("plot-kind").selectOption(kind);
  if (figure) await picker.getByRole("button", { name: figure, exact: true }).click();
  if (lines.length > 0) {
    while ((await picker.locator(".picker-drop").count()) > 0) await picker.locator(".picker-drop").first().click();
  }
  for (const line of lines) {
    await page.getByTestId("search-lines").fill(line);
    await picker.locator(`input[value="${line}"]`).check();
  }
  await page.getByTestId("picker-done").click();
}

/** Opens a file, together with other files given as texts by name. */
export async function openFile(page, name, text, others = {}) {
  const files = Object.entries({ [name]: text, ...others });
  await page.getByTestId("file").setInputFiles(files.map(([one, content]) => ({ name: one, mimeType: "text/yaml", buffer: Buffer.from(content) })));
}

/**
 * Presses Step until the time is reached: once by the button, then from within the page, which is faster. The picture
 * waits until the end of the steps, because without a graphics card it takes longer than many steps.
 */
export async function stepTo(page, time_s) {
  const before = (await sample(page)).time_s;
  await page.getByTestId("step").click();
  await page.waitForFunction((time) => window.kingpost.sample().time_s > time, before);
  await page.evaluate(async (until) => {
    const button = document.querySelector("[data-testid=step]");
    const now = () => window.kingpost.sample().time_s;
    const draw = window.requestAnimationFrame;
    const waiting = [];
    window.requestAnimationFrame = (frame) => waiting.push(frame);
    try {
      while (now() < until - 1e-9) {
        const last = now();
        button.click();
        while (now() === last) await new Promise((resolve) => setTimeout(resolve, 1));
      }
    } finally {
      window.requestAnimationFrame = draw;
      waiting.forEach((frame) => draw(frame));
    }
  }, time_s);
}

/** Returns the numbers in a text; the page's minus sign counts as a minus. */
export async function numberIn(page, testId) {
  const text = await page.getByTestId(testId).textContent();
  return Number.parseFloat(text.replace("−", "-"));
}

/** Waits until a text of the page is a number near another one: on a busy machine plots are drawn late. */
export const showsNumber = (page, testId, expected, tolerance) =>
  page.waitForFunction(
    ([id, number, allowed]) => Math.abs(Number.parseFloat(document.querySelector(`[data-testid="${id}"]`)?.textContent.replace("−", "-")) - number) <= allowed,
    [testId, expected, tolerance],
  );

/** Waits until a text of the page equals this text. */
export const showsText = (page, testId, text) => page.waitForFunction(([id, wanted]) => document.querySelector(`[data-testid="${id}"]`)?.textContent === wanted, [testId, text]);

export function close(actual, expected, tolerance, what) {
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what}: ${actual}, expected ${expected} within ${tolerance}`);
}

/** Takes a picture of the canvas without what is written over it, in base64. */
export async function picture(page) {
  await page.addStyleTag({ content: ".scene-tools, .scene-note, .frames-legend, .hint, .alert { visibility: hidden }" });
  return (await page.getByTestId("canvas").screenshot()).toString("base64");
}

/**
 * Counts the pixels in a picture of the canvas that are darker than the background, and returns the box around them in
 * pixels of the page.
 */
export async function look(page) {
  return page.evaluate(async (base64) => {
    const blob = await (await fetch(`data:image/png;base64,${base64}`)).blob();
    const bitmap = await createImageBitmap(blob);
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const pen = canvas.getContext("2d");
    pen.drawImage(bitmap, 0, 0);
    const { data, width, height } = pen.getImageData(0, 0, bitmap.width, bitmap.height);
    const seen = { width, height, green: 0, grey: 0, left: width, right: 0, top: height, bottom: 0 };
    for (let i = 0; i < data.length; i += 4) {
      const [r, g, b] = [data[i], data[i + 1], data[i + 2]];
      const [x, y] = [(i / 4) % width, Math.floor(i / 4 / width)];
      if (g > 1.35 * r && g > 1.35 * b && g < 170) seen.green += 1;
      if (Math.max(r, g, b) - Math.min(r, g, b) < 22 && r > 60 && r < 150) seen.grey += 1;
      if (0.3 * r + 0.6 * g + 0.1 * b > 95) continue;
      seen.left = Math.min(seen.left, x);
      seen.right = Math.max(seen.right, x);
      seen.top = Math.min(seen.top, y);
      seen.bottom = Math.max(seen.bottom, y);
    }
    for (const length of ["width", "height", "left", "right", "top", "bottom"]) seen[length] /= devicePixelRatio;
    return seen;
  }, await picture(page));
}
