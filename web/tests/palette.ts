import { Color } from "three";
import type { Palette } from "../src/view/palette";

const COLOURS = ["hull", "bottom", "stripe", "deck", "marking", "load", "plain", "barrel", "rod", "pin", "line", "house", "window", "fitting", "shallow", "foam"];

/** Palette of one grey, for geometry. */
export const PALETTE = { ...Object.fromEntries(COLOURS.map((name) => [name, new Color(0.5, 0.5, 0.5)])), isDark: false } as unknown as Palette;
