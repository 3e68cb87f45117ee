import type { Texts } from "../index";

export const forecast: Texts["forecast"] = {
  button: "Se framover",
  help: "Mulige forløp det neste minuttet med spakene i stillingen de har nå, i sjøer som stemmer med målingene. Båndene i grafene inneholder 90 og 50 % av forløpene; punktene i bildet er steder der lasten kan være, fra snart til sent.",
  looking: "Ser framover…",
  futures: (known, of, horizon_s) => `${known < of ? `${known} av ` : ""}${of} mulige forløp over ${horizon_s} s`,
  in_short: (percent) => `90 %-båndet inneholdt ${percent} %`,
  start: (start_s) => `Fra ${start_s} s, med spakene i stillingen de har nå.`,
  agree: (past_s) => `Hvert forløp stemmer med bølgen som er målt ved skipet de siste ${past_s} s.`,
  nothing_measured: "Det er ingen målinger ennå: bølgene følger av spekteret alene.",
  held: (percent, minutes) => `90 %-båndet inneholdt ${percent} % av verdiene i opptaket for ${minutes === 1 ? "det siste minuttet" : `de siste ${minutes} minuttene`}.`,
  not_judged: "90 %-båndet bedømmes etter hvert hele minutt av kjøringen.",
  judged_by: "For hvert minutt beregnes 32 forløp fra målingene før det, og de sammenlignes med opptaket av hiv, rulling og stamping for flytende legemer og av lastenes posisjoner.",
  one: (horizon_s) => `Ett forløp over ${horizon_s} s`,
  no_waves: "Uten bølger er det bare ett forløp.",
  foreseen: (time_s) => `prognose ved ${time_s} s, 90 %-bånd`,
  band: (low, high) => `${low} til ${high}`,
  gusts: "Alle forløpene har kjøringens vindkast.",
  broken: (count) => `${count} forløp kunne ikke beregnes til slutten.`,
  none: "Ingen prognose: det oppsto en feil",
};
