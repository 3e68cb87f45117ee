// Draws the icons of the installed app from public/icon.svg: `npm run icons`.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { findBrowser, launch } from "./browser.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const SVG = readFileSync(here("../public/icon.svg"), "utf8");
const GROUND = /<rect[^>]*fill="(#[0-9a-f]+)"/.exec(SVG)[1];
/** What a mask leaves for sure is a circle of 80 % of the width; the drawing is smaller by this, on ground to the edges. */
const WITHIN_MASK = 0.72;

const ICONS = [
  { file: "icon-192.png", size_px: 192, share: 1, ground: "transparent" },
  { file: "icon-512.png", size_px: 512, share: 1, ground: "transparent" },
  { file: "icon-maskable-512.png", size_px: 512, share: WITHIN_MASK, ground: GROUND },
];

const executable = findBrowser();
if (!executable) throw new Error("there is no Chromium on this machine (CHROMIUM=path names one)");
const browser = await launch(executable);
const page = await browser.newPage();
for (const { file, size_px, share, ground } of ICONS) {
  await page.setViewportSize({ width: size_px, height: size_px });
  const drawing = SVG.replace("<svg ", `<svg width="${share * size_px}" height="${share * size_px}" `);
  await page.setContent(`<body style="margin:0;height:100vh;display:grid;place-items:center;background:${ground}">${drawing}</body>`);
  await page.screenshot({ path: here(`../public/${file}`), omitBackground: true });
  console.log(`public/${file}`);
}
await browser.close();
