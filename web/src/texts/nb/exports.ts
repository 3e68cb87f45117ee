import type { Texts } from "../index";

export const exports: Texts["exports"] = {
  open: "Eksport",
  title: "Eksport",
  recording: "Opptaket",
  rows: (kept, until_s) => `${kept} ${kept === 1 ? "rad" : "rader"}, 0 til ${until_s} s`,
  thinned: (kept, of, until_s) =>
    `Opptaket er langt: ${kept} av om lag ${of} rader er beholdt. Noen rader før ${until_s} s mangler i disse filene; alle senere rader er med.`,
  csv: "Tabell (CSV)",
  csv_help: "Alle kolonner i SI-enheter, slik kingpost run skriver dem",
  events: "Hendelser (CSV)",
  parquet: "Parquet",
  parquet_help: "Alle kolonner med enheter og scenario, for Python",
  pictures: "Bilder",
  picture: "Skipet (PNG)",
  plot: (title) => `${title} (PNG)`,
  film: "Film, og bilder i enhver størrelse",
  open_film: "Lag film …",
  film_help: "WebM eller MP4 av en del av opptaket, eller en PNG, i en valgt størrelse",
  scenario: "Scenarioet",
  save: "Scenario (YAML)",
  save_help: "Med parametrene og spakbevegelsene; det samme som Lagre scenario",
  close: "Lukk",
  failed: "Filen kunne ikke lages",
  done: (file) => `${file} er lagret.`,
};

export const saved: Texts["saved"] = {
  by: (time) => `Lagret av Kingposts app ved ${time} av en kjøring, med parametrene slik de var satt.`,
  moves: (count) => `Operasjonen har ${count === 1 ? "spakbevegelsen" : `de ${count} spakbevegelsene`} som ble gjort for hånd.`,
  waiting: (names) => `Verdier som ventet på en nullstilling, er ikke med: ${names}.`,
  same: "En kjøring av denne filen gir de samme tallene.",
  implicit: "Integratoren er implisitt: en kjøring utenfor nettleseren stemmer innenfor toleransen, ikke til siste bit.",
  needs: (files) => `Den trenger disse filene i samme mappe: ${files}.`,
  lost: (count) => `en kjøring av denne filen blir annerledes: ${count} ${count === 1 ? "endring ble" : "endringer ble"} gjort før beregningsmotoren ble byttet ut; en lenke fra Del har dem med`,
  set_at: (parameter, time) => `${parameter} ved ${time}`,
  differs: (set) =>
    `En kjøring av denne filen blir en annen enn den lagrede, fordi parametrer ble satt underveis i den: ${set}. Filen har de siste verdiene fra start.`,
  two_operations:
    "Spaker ble beveget for hånd mens scenarioets egen operasjon var på, og en fil har plass til én operasjon. " +
    "Slå den av (operation.enabled: false) og beveg alle spakene for hånd; eller nullstill, og lagre uten bevegelsene.",
};
