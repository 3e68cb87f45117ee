import { Color } from "three";
import { isDark } from "../app/palette";

/** Colours of the 3D view; they come from the page's theme, so that there is one place for them. */
export interface Palette {
  hull: Color;
  bottom: Color;
  stripe: Color;
  deck: Color;
  marking: Color;
  load: Color;
  plain: Color;
  barrel: Color;
  rod: Color;
  pin: Color;
  line: Color;
  grid: Color;
  /** Of the water. */
  trough: Color;
  crest: Color;
  axes: { x: Color; y: Color; z: Color };
  label: string;
  halo: string;
  isDark: boolean;
}

export function readPalette(): Palette {
  const style = getComputedStyle(document.documentElement);
  const text = (name: string) => style.getPropertyValue(name).trim();
  const colour = (name: string) => new Color(text(name));
  return {
    hull: colour("--scene-hull"),
    bottom: colour("--scene-bottom"),
    stripe: colour("--scene-stripe"),
    deck: colour("--scene-deck"),
    marking: colour("--scene-marking"),
    load: colour("--scene-load"),
    plain: colour("--scene-plain"),
    barrel: colour("--scene-barrel"),
    rod: colour("--scene-rod"),
    pin: colour("--scene-pin"),
    line: colour("--scene-line"),
    grid: colour("--scene-grid"),
    trough: colour("--scene-trough"),
    crest: colour("--scene-crest"),
    axes: { x: colour("--roll"), y: colour("--pitch"), z: colour("--yaw") },
    label: text("--ink"),
    halo: text("--surface"),
    isDark: isDark(),
  };
}
