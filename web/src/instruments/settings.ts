import { chosenPalette, choosePalette, PALETTES } from "../app/palette";
import { texts } from "../texts";
import { make } from "../ui/dom";
import type { Alarm } from "./alarm";

/** Returns the choice of the page's colours. */
export function paletteChoice(): HTMLElement {
  const { palette, palettes } = texts.instruments;
  const options = [make("option", { value: "" }, palettes.device), ...PALETTES.map((name) => make("option", { value: name }, palettes[name]))];
  const select = make("select", { "data-testid": "palette" }, ...options);
  select.value = chosenPalette() ?? "";
  select.addEventListener("change", () => choosePalette(PALETTES.find((name) => name === select.value) ?? null));
  return make("label", { class: "setting" }, palette, select);
}

/** Returns the switch of the alarm for exceeded limits. */
export function soundSwitch(alarm: Alarm): HTMLElement {
  const box = make("input", { type: "checkbox", "data-testid": "alarm-sound", checked: !alarm.isMuted });
  box.addEventListener("change", () => alarm.mute(!box.checked));
  return make("label", { class: "item item-checkbox" }, box, texts.instruments.sound);
}
