// Takes the pictures of the start page from the built app: public/cards/NAME.webp of each scenario, and hero.webp.
// node scripts/cards.mjs [part of a name]
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { findBrowser, launch } from "./browser.mjs";
import { serve } from "./serve.mjs";
import { ALONE, openPage, runTo, turn } from "./shots.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const CARD = { width: 720, height: 450 };
/** The left of a wider picture: its ship stands there, the words beside it. */
const HERO = { width: 1600, height: 700 };
/** The moment of each picture, with what is set over the file; `left` and `up` are turns of the view from where it fits, by arrow keys. */
const SHOTS = {
  paper: { time_s: 1.2, values: "motor_1=true&load=true&torque_history=pulse" },
  barge: { time_s: 30, values: "waves=true" },
  paper_on_a_rope: { time_s: 40 },
  paper_true_draught: { time_s: 3, nearer: 1 },
  lift_off_from_barge: { time_s: 70 },
  supply_boat_lift: { time_s: 60 },
  container_to_quay: { time_s: 120 },
  feeder_cycle: { time_s: 110 },
  slew_and_land: { time_s: 75 },
  slew_without_swing: { time_s: 60, values: "shaper=zvd" },
  slew_without_swing_at_sea: { time_s: 60, values: "shaper=zvd" },
  slew_by_policy: { time_s: 9 },
  quayside_lift: { time_s: 5, nearer: 1 },
  barge_crane_200t: { time_s: 110 },
  subsea_lowering: { time_s: 100 },
  deep_water_lowering: { time_s: 30 },
  lowering_by_winch: { time_s: 30, values: "waves=true", nearer: 1 },
  heave_compensation: { time_s: 60, nearer: 1 },
  hybrid_compensation: { time_s: 60, nearer: 1 },
  dual_draglink_heave_compensation: { time_s: 60, nearer: 1 },
  three_axis_compensation: { time_s: 60, nearer: 1 },
  level_platform: { time_s: 60, nearer: 1 },
  load_held_by_drive_functions: { time_s: 75, nearer: 1 },
  a_frame_over_the_stern: { time_s: 30 },
  spreader_bar_lift: { time_s: 60 },
  four_leg_lift: { time_s: 90 },
  loss_of_hook_load: { time_s: 10 },
  knuckle_boom_crane: { time_s: 10 },
  dual_draglink_crane: { time_s: 12 },
  flexible_boom: { time_s: 4 },
  offshore_vessel: { time_s: 65, values: "waves=true" },
  offshore_vessel_moored: { time_s: 60 },
  offshore_vessel_moored_quasi_static: { time_s: 60 },
  offshore_vessel_on_dp: { time_s: 60 },
  vessel_knuckle_boom: { time_s: 20, values: "waves=true" },
  vessel_dual_draglink: { time_s: 20 },
  two_ships: { time_s: 20 },
  anti_heeling_tank: { time_s: 80 },
  roll_reduction_tank: { time_s: 60 },
  roll_reduction_flooded_tanks: { time_s: 60 },
  roll_reduction_gyros: { time_s: 60 },
  gyro_wave_energy: { time_s: 40, nearer: 1, up: 1 },
  underwater_vehicle: { time_s: 32, nearer: 0, up: 3, left: 31 },
  caudal_fin_swimmer: { time_s: 12.2, nearer: 0, up: 4, left: 1 },
  floating_hemisphere: { time_s: 40 },
  sphere_decay: { time_s: 1.5 },
  chain: { time_s: 1.5, nearer: 0 },
  tennis_racket: { time_s: 3.3, nearer: 1 },
  hero: { scenario: "offshore_vessel", time_s: 65, values: "waves=true", size: { ...HERO, width: 2176 }, clip: { x: 0, y: 0, ...HERO }, quality: 0.8, left: 2, up: -5, nearer: 1 },
};
async function shoot(browser, address, name) {
  const { scenario = name, time_s, values = "", size = CARD, clip, quality = 0.74, left = 0, up = -4, nearer = 2 } = SHOTS[name];
  const page = await openPage(browser, address, `?scenario=${scenario}&${values}`, size);
  await runTo(page, time_s);
  await page.addStyleTag({ content: ALONE });
  await page.waitForTimeout(1000);
  await turn(page, { left, up, nearer });
  await page.waitForTimeout(1500);
  const png = (await page.screenshot({ clip })).toString("base64");
  const webp = await page.evaluate(toWebp, { png, quality });
  writeFileSync(here(`../public/cards/${name}.webp`), Buffer.from(webp, "base64"));
  console.log(`public/cards/${name}.webp: ${Math.round((0.75 * webp.length) / 1000)} kB`);
  await page.context().close();
}

async function toWebp({ png, quality }) {
  const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${png}`)).blob());
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  canvas.getContext("2d").drawImage(bitmap, 0, 0);
  const bytes = new Uint8Array(await (await canvas.convertToBlob({ type: "image/webp", quality })).arrayBuffer());
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary);
}

const wanted = process.argv[2] ?? "";
const { groups } = JSON.parse(readFileSync(here("../../scenarios/gallery.json"), "utf8"));
const names = [...groups.flatMap(({ scenarios }) => scenarios), "hero"].filter((name) => name.includes(wanted));
const missing = names.filter((name) => !(name in SHOTS));
if (missing.length > 0) throw new Error(`no moment is given for ${missing.join(", ")}`);
const executable = findBrowser();
if (!executable) throw new Error("there is no Chromium on this machine (CHROMIUM=path names one)");
mkdirSync(here("../public/cards"), { recursive: true });
const { address, stop } = await serve(here("../dist"), "/");
const browser = await launch(executable);
for (const name of names) await shoot(browser, address, name);
await browser.close();
await stop();
