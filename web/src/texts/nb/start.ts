import type { Texts } from "../index";

export const start: Texts["start"] = {
  lead: "Skip og kraner til sjøs, simulert i nettleseren din",
  intro:
    "Sving, topp og heis. Se hvordan last, skip og sjø beveger hverandre, med alle tall for hånden. Også på telefonen: ingenting " +
    "installeres, og ingenting sendes noe sted.",
  open_paper: "Start med artikkelens kranskip",
  open_file: "Åpne ditt eget scenario…",
  choose: "Eller velg et",
  ungrouped: "Dine egne",
  loading: "Laster listen…",
  failed: (why) => `Listen over scenarioer kunne ikke lastes. ${why}`,
  no_simulator: (why) => `Simulatoren ble ikke lastet: ${why}. Sjekk forbindelsen og prøv igjen.`,
  about:
    "Den samme beregningsmotoren går på kommandolinjen, i Python og her. Den regner med moving frame-metoden til Jardim, Rein, Haveland, " +
    "Rykkje og Impelluso (2019). Scenarioene og meldingene fra beregningsmotoren er på engelsk.",
  page_title: "Kingpost – simulator for skip og kran",
};

export const offline: Texts["offline"] = {
  update: "Det er kommet en ny versjon",
  update_help: "Når siden lastes på nytt, starter kjøringen på nytt. Lag først en lenke med Del hvis du vil beholde den.",
  reload: "Last på nytt",
  others: (count) => `Lukk først ${count === 1 ? "det andre vinduet" : `de ${count} andre vinduene`} til appen: der går den eldre versjonen.`,
};
