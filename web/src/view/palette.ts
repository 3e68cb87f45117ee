import { Color } from "three";
import { isDark } from "../app/palette";

/** Colours of the 3D view, from the page's theme. */
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
  seabed: Color;
  /** Colours of a line without tension, at half of its largest tension, and at the largest. */
  slack: Color;
  taut: Color;
  tautest: Color;
  /** Colours of the air and the water, the zenith first. */
  zenith: Color;
  haze: Color;
  sun: Color;
  deep: Color;
  shallow: Color;
  foam: Color;
  /** Colours of the surroundings if there is no sea. */
  studioHigh: Color;
  studioLow: Color;
  /** Colours of deck equipment. */
  house: Color;
  window: Color;
  fitting: Color;
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
    seabed: colour("--scene-seabed"),
    slack: colour("--tension-slack"),
    taut: colour("--tension-half"),
    tautest: colour("--tension-largest"),
    zenith: colour("--scene-zenith"),
    haze: colour("--scene-haze"),
    sun: colour("--scene-sun"),
    deep: colour("--scene-deep"),
    shallow: colour("--scene-shallow"),
    foam: colour("--scene-foam"),
    studioHigh: colour("--sky-high"),
    studioLow: colour("--sky-low"),
    house: colour("--scene-house"),
    window: colour("--scene-window"),
    fitting: colour("--scene-fitting"),
    axes: { x: colour("--roll"), y: colour("--pitch"), z: colour("--yaw") },
    label: text("--ink"),
    halo: text("--surface"),
    isDark: isDark(),
  };
}
