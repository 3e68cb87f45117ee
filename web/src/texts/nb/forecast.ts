import type { Texts } from "../index";

export const forecast: Texts["forecast"] = {
  button: "Se framover",
  help: "Hva som kan skje det neste minuttet, med spakene som de er: forløp i sjøer som stemmer med målingene. Båndene i grafene holder 90 og 50 % av forløpene; punktene i bildet er steder der lasten kan være, fra snart til sent.",
  looking: "Ser framover…",
  futures: (known, of, horizon_s) => `${known < of ? `${known} av ` : ""}${of} mulige forløp over ${horizon_s} s`,
  in_short: (percent) => `90 %-båndet holdt ${percent} %`,
  start: (start_s) => `Fra ${start_s} s, med spakene som de er.`,
  agree: (past_s) => `Hvert stemmer med bølgen som er målt ved skipet de siste ${past_s} s.`,
  nothing_measured: "Ingenting er målt ennå: spekteret alene sier hvilke bølger som kommer.",
  held: (percent, minutes) => `90 %-båndet deres holdt ${percent} % av ${minutes === 1 ? "det siste minuttet" : `de siste ${minutes} minuttene`}.`,
  not_judged: "90 %-båndet deres bedømmes etter hvert hele minutt av kjøringen.",
  judged_by: "Etter hiv, rulling og stamping av flytende legemer og lastenes posisjoner, i 32 forløp av hvert minutt, laget av målingene før det.",
  one: (horizon_s) => `Ett forløp over ${horizon_s} s`,
  no_waves: "Uten bølger er det bare ett forløp.",
  foreseen: (time_s) => `ved ${time_s} s, forutsett, 90 %-bånd`,
  band: (low, high) => `${low} til ${high}`,
  gusts: "Alle forløpene har kjøringens vindkast.",
  broken: (count) => `${count} av dem kunne ikke beregnes til slutten.`,
  none: "Ser ikke framover",
};
