import type { Texts } from "../index";

export const instruments: Texts["instruments"] = {
  title: "Instrumenter",
  ship: "Krengning og trim",
  minute: (range) => `siste min. ${range}`,
  dial: (name, angle, low, high) => `${name} ${angle}, fra ${low} til ${high}`,
  limits: "Grenser",
  readings: "Avlesninger",
  columns: ["Nå", "Min.", "Maks."],
  height: "høyde",
  rise: "vertikal hastighet",
  worst: (value, time_s) => `Verste verdi ${value} ved ${time_s} s`,
  counts_from: (time_s) => `Gjelder fra ${time_s} s`,
  within: (bound) => `Innenfor ±${bound}`,
  between: (low, high) => `Fra ${low} til ${high}`,
  at_most: (bound) => `Høyst ${bound}`,
  at_least: (bound) => `Minst ${bound}`,
  states: { ok: "innenfor grensen", near: "nær grensen", exceeded: "utenfor grensen", waiting: "gjelder ikke ennå" },
  exceeded: (names) => `Grense overskredet: ${names}.`,
  palette: "Farger",
  palettes: { device: "Som enheten", day: "Dag", dusk: "Skumring", night: "Natt", bright: "Sterk sol" },
  sound: "Lyd når en grense overskrides",
};
