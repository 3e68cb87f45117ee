// Films of a run: the frames that are encoded, what a player shows of them, pictures of any size, and wrong choices.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { assertAccessible } from "./axe.mjs";
import { openApp, sample, stepTo } from "./app.mjs";

const SIZE = { width: 320, height: 180 };
/** Half a second with six frames. */
const FILM = { from: 0.2, to: 0.7, frames: 10, speed: 1, size: "320x180" };
/** Largest error of decoded frames, as the peak signal-to-noise ratio, dB. */
const LEAST_DB = 35;

/** Keeps the pixels of every canvas that is given to the encoder, in `window.frames_encoded`. */
function keepFrames() {
  window.frames_encoded = [];
  const Native = VideoFrame;
  window.VideoFrame = class extends Native {
    constructor(source, init) {
      if (source instanceof HTMLCanvasElement) {
        const { data } = source.getContext("2d").getImageData(0, 0, source.width, source.height);
        window.frames_encoded.push({ data, time_s: init.timestamp / 1e6 });
      }
      super(source, init);
    }
  };
}

/** Opens the dialog of films from the one of the export, and fills its fields. */
async function openFilm(page, { from, to, frames, speed, size, caption = "", plots = true }) {
  await page.getByTestId("export").click();
  await page.getByTestId("export-film").click();
  await page.getByTestId("film-dialog").waitFor();
  const fields = { "film-from": from, "film-to": to, "film-frames": frames, "film-speed": speed, "film-size": size, "film-caption": caption };
  for (const [field, value] of Object.entries(fields)) await page.getByTestId(field).fill(String(value));
  await page.getByTestId("film-plots").setChecked(plots);
}

async function downloaded(page, button) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(button).click()]);
  return { name: download.suggestedFilename(), base64: readFileSync(await download.path()).toString("base64") };
}

/** Returns the frames that were encoded since the last call as digests, and keeps the last of them in the page. */
const takeFrames = (page) =>
  page.evaluate(async () => {
    const taken = window.frames_encoded.splice(0);
    window.frames_kept = taken;
    return Promise.all(taken.map(async ({ data, time_s }) => ({ time_s, digest: new Uint8Array(await crypto.subtle.digest("SHA-256", data)).join() })));
  });

/** Returns the pixels of a picture as a digest. */
const digestOf = (page, base64) =>
  page.evaluate(async (data) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    pen.drawImage(bitmap, 0, 0);
    return new Uint8Array(await crypto.subtle.digest("SHA-256", pen.getImageData(0, 0, bitmap.width, bitmap.height).data)).join();
  }, base64);

/** Plays a film frame by frame; returns the ratio of each frame to the one that was encoded, dB. */
const ratios = (page, base64, frames_per_s) =>
  page.evaluate(
    async ({ data, rate }) => {
      const video = document.createElement("video");
      video.src = `data:video/webm;base64,${data}`;
      const heard = (event) => new Promise((resolve) => video.addEventListener(event, resolve, { once: true }));
      await heard("loadeddata");
      const pen = new OffscreenCanvas(video.videoWidth, video.videoHeight).getContext("2d");
      const found = [];
      for (const [k, { data: wanted }] of window.frames_kept.entries()) {
        video.currentTime = (k + 0.5) / rate;
        await heard("seeked");
        pen.drawImage(video, 0, 0);
        const shown = pen.getImageData(0, 0, video.videoWidth, video.videoHeight).data;
        let sum = 0;
        for (let i = 0; i < wanted.length; i++) if (i % 4 !== 3) sum += (shown[i] - wanted[i]) ** 2;
        found.push(10 * Math.log10((255 * 255) / (sum / (0.75 * wanted.length))));
      }
      return { found, duration_s: video.duration, size: { width: video.videoWidth, height: video.videoHeight } };
    },
    { data: base64, rate: frames_per_s },
  );

export default {
  async "the same film twice has equal frames, which are the pictures at their times and which a player shows"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=lift_off_from_barge", draws: true, prepare: (context) => context.addInitScript(keepFrames) });
    await stepTo(page, 1);
    await openFilm(page, FILM);
    const film = await downloaded(page, "film-make");
    assert.equal(film.name, "lift_off_from_barge.webm");
    const frames = await takeFrames(page);
    assert.equal(frames.length, 6);
    assert.equal(new Set(frames.map(({ digest }) => digest)).size, 6, "the ship and the sea move");
    const { found, duration_s, size } = await ratios(page, film.base64, FILM.frames);
    assert.ok(Math.min(...found) > LEAST_DB, `the frames differ from the film by ${found} dB`);
    assert.ok(Math.abs(duration_s - 0.6) < 0.01, `the film takes ${duration_s} s`);
    assert.deepEqual(size, SIZE);
    // A later film, after the picture of the page was drawn again, and another moment is shown.
    await page.getByTestId("film-close").click();
    await page.getByTestId("cursor").evaluate((cursor) => {
      cursor.value = "0.5";
      cursor.dispatchEvent(new Event("input", { bubbles: true }));
    });
    assert.ok(Math.abs((await sample(page)).time_s - 0.5) < 0.06);
    await openFilm(page, FILM);
    await downloaded(page, "film-make");
    assert.deepEqual(await takeFrames(page), frames);
    const picture = await downloaded(page, "film-picture");
    assert.equal(picture.name, "lift_off_from_barge.png");
    assert.equal(await digestOf(page, picture.base64), frames[3].digest, "the fourth frame is at 0.5 s");
    await close();
  },

  async "a film is refused outside the recording and in odd sizes, a picture beyond the graphics card, and work is cancelled"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=barge" });
    await stepTo(page, 1);
    await openFilm(page, { ...FILM, to: 9 });
    await assertAccessible(page, "the dialog of films");
    const refused = async (button, says) => {
      await page.getByTestId(button).click();
      await page.getByTestId("film-said").getByText(says).waitFor();
    };
    await refused("film-make", /Times: found 0\.2 to 9 s, allowed: .* 0 to 1 s/);
    await page.getByTestId("film-to").fill("0.9");
    await page.getByTestId("film-size").fill("321x180");
    await refused("film-make", /found 321x180, allowed: even numbers/);
    await page.getByTestId("film-size").fill("big");
    await refused("film-picture", /Size: found .*, allowed: width x height of 64 to 8192/);
    await page.getByTestId("film-size").fill("320x180");
    await page.getByTestId("film-frames").fill("120");
    await page.getByTestId("film-speed").fill("0.01");
    await page.getByTestId("film-make").click();
    await page.getByText(/Frame \d+ of 8401/).waitFor();
    await page.getByTestId("film-cancel").click();
    await page.getByTestId("film-said").getByText("Cancelled; no file was made.").waitFor();
    await page.keyboard.press("Escape");
    await page.waitForFunction(() => !document.querySelector('[data-testid="film-dialog"]').open);
    await stepTo(page, 1.1);
    await close();
  },

  async "a browser without WebCodecs is told what serves instead, and makes pictures"(host) {
    const { page, close } = await openApp(host, { query: "?scenario=barge", draws: true, prepare: (context) => context.addInitScript(() => delete window.VideoEncoder) });
    await openFilm(page, { ...FILM, from: 0, to: 1 });
    assert.equal(await page.getByTestId("film-make").isDisabled(), true);
    assert.match(await page.getByTestId("film-dialog").textContent(), /encodes no film.*kingpost film/);
    const { name } = await downloaded(page, "film-picture");
    assert.equal(name, "barge.png");
    await close();
  },
};
