import type { Texts } from "../index";

export const page: Texts["page"] = {
  name: "Kingpost",
  skip: "Hopp til styringen",
  line: "Skip og kraner, med moving frame-metoden",
  scenario: "Scenario",
  open: "Åpne scenario…",
  save: "Lagre scenario",
  save_help: "Som fil, med parametrene slik de er satt og spakbevegelsene som en operasjon",
  share: "Del",
  share_help: "En lenke som åpner denne kjøringen med alle innstillingene",
  drop: "Slipp scenarioet her for å åpne det, sammen med databasene som det viser til",
  title: (scenario) => `Kingpost – ${scenario}`,
  panels: "Paneler",
  language: "Språk",
  language_help: "Siden lastes på nytt, og kjøringen starter på nytt.",
};

export const floating: Texts["floating"] = {
  heel: "Krengning",
  heel_help: "Rulling: positiv mot styrbord",
  trim: "Trim",
  trim_help: "Stamping: positiv når baugen går ned",
  draught: "Dypgang",
  draught_help: "Fra stille vann ned til kjølen, ved origo for skrogets data",
  wave: "Bølge",
  wave_help: "Overflatens høyde i de innkommende bølgene ved skrogets middelposisjon",
  fluid_gm: "Korr. GM",
  fluid_gm_help:
    "Metasenterhøyde for krengning, korrigert for frie væskeoverflater, i ro i stille vann med kranen slik den står; hengende laster regnes i opphengspunktet",
  wind: "Vind",
  wind_help: "Middelhastighet i referansehøyden. Pilen viser hvor vinden blåser: oppover er bort fra øyet",
  current: "Strøm",
  current_help: "Hastighet i overflaten. Pilen viser hvor vannet strømmer: oppover er bort fra øyet",
};
