import type { Texts } from "../index";

export const picture: Texts["picture"] = {
  title: "Modellen i 3D",
  canvas: "Modellen. Piltastene dreier bildet, pluss og minus zoomer, Home tilpasser det.",
  fit: "Tilpass",
  axes: { to_port: "mot babord (y)", up: "opp (z)", forward: "forover (x)" },
  no_graphics: "Denne nettleseren har ikke WebGL, så det er ikke noe bilde; tall og grafer virker fortsatt.",
  graphics_lost: "Nettleseren mistet grafikken; bildet kommer tilbake når den er gjenopprettet. Tall og grafer virker fortsatt.",
  no_water: (spacing) => `Rutenett ${spacing}. Det er ikke vann i dette scenarioet.`,
  water_without_hull: (spacing) => `Rutenett ${spacing}. Ingen skrog flyter her: vannet tegnes ikke.`,
  still_water: "Stille vann.",
  waves: (count) => `Innkommende bølger, ${count} i alt.`,
  camera: "Kamera",
  cameras: {
    free: "Hele veien rundt",
    load: "Følg lasten",
    cab: "Kranførerhuset",
    bridge: "Broen",
    top: "Ovenfra",
    section: "Snitt",
  },
  dive: "Tillat kameraet under vann",
  show: "Vis",
  shown: {
    frames: "Legemenes akser",
    plain: "Enkle former",
    forces: "Krefter",
    axes: "Leddakser",
    masses: "Tyngdepunkter",
    buoyancy: "Oppdrift og metasenter",
    trace: "Lastens bane",
    ghost: "Startposisjon",
  },
  scale: { force: "Kraft", moment: "Moment" },
  tension: { title: "Strekk langs liner", slack: "slakk", largest: "største hittil" },
  shown_help:
    "Enkle former er modellens egne legemer. Overbygg, førerhus, rekkverk, braketter og bommens stag er pynt: modellen har verken vekten eller vindlasten deres.",
};
