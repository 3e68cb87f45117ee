/** Palettes of OpenBridge: for daylight, twilight, a dark bridge and glaring sun. */
export const PALETTES = ["day", "dusk", "night", "bright"] as const;
export type PaletteName = (typeof PALETTES)[number];

const KEY = "kingpost.palette";
const darkness = matchMedia("(prefers-color-scheme: dark)");
const listeners: (() => void)[] = [];

/** Palette that the user chose; null if it follows the device. */
export function chosenPalette(): PaletteName | null {
  try {
    return PALETTES.find((name) => name === localStorage.getItem(KEY)) ?? null;
  } catch {
    return null;
  }
}

export function choosePalette(name: PaletteName | null): void {
  try {
    if (name) localStorage.setItem(KEY, name);
    else localStorage.removeItem(KEY);
  } catch {
    // Without storage, the choice is valid for this page only.
  }
  apply(name);
}

export function isDark(): boolean {
  return ["dusk", "night"].includes(document.documentElement.dataset.palette ?? "");
}

/** Calls a listener whenever the colours of the page change. */
export function onPalette(listener: () => void): void {
  listeners.push(listener);
}

/** Applies the palette now and whenever the device changes between light and dark. */
export function enablePalettes(): void {
  apply(chosenPalette());
  darkness.addEventListener("change", () => apply(chosenPalette()));
}

function apply(name: PaletteName | null): void {
  document.documentElement.dataset.palette = name ?? (darkness.matches ? "dusk" : "day");
  for (const listener of listeners) listener();
}
