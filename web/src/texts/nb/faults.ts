import type { Texts } from "../index";

export const alert: Texts["alert"] = {
  other: "Noe gikk galt",
  headings: {
    scenario: "Scenarioet lar seg ikke lese",
    database: "Dette er ikke et scenario",
    file: "Filen er for stor",
    diverged: "Kjøringen divergerte",
    setting: "Verdien er ikke tillatt",
    singular_loop: "En lukket sløyfe står i dødpunkt",
    open_loop: "En lukket sløyfe lukker seg ikke",
    rope_constraint: "En føring kan ikke holdes",
    step: "Integratoren kommer ikke videre",
    input: "Verdien er ikke tillatt",
    engine: "Beregningsmotoren er ikke tilgjengelig",
    restarted: "Beregningsmotoren ble startet på nytt",
    network: "En fil kunne ikke lastes",
    page: "En del av siden sviktet",
    address: "Adressen har en verdi som ikke er tillatt",
    operation: "Operasjonen kommer ikke videre",
    saved: "Lagret, men en kjøring av filen blir en annen",
    link: "Lenken lar seg ikke åpne",
    followed: "En endring fra lenken kan ikke gjentas",
    two_operations: "Scenarioet kan ikke lagres",
    unsaved: "Scenarioet kan ikke lagres",
    runs: "Kjøringen er ikke beholdt",
  },
  its_database: "Åpne scenarioet og databasen sammen: velg begge filene, eller slipp begge her.",
  its_file: "Åpne scenarioet og filen som det viser til, sammen: velg begge filene, eller slipp begge her.",
  facts: { place: "Sted", field: "Felt", found: "Funnet", allowed: "Tillatt", time: "Tid", body: "Legeme" },
};

export const faults: Texts["faults"] = {
  not_allowed: (label, found, allowed) => `${label}: ${found} er ikke tillatt. Tillatt: ${allowed}.`,
  own_values: "Scenarioet ble åpnet med sine egne verdier.",
  resumed_run: (why, time_s) => `${why} Kjøringen går videre ved ${time_s} s med en ny beregningsmotor; opptaket er beholdt.`,
  lost_run: (why) => `${why} Kjøringen starter på nytt, med de samme verdiene.`,
  run_goes_on: "Kjøringen går videre.",
  no_gallery: (why) => `${why} Det er ingen scenarioer å velge blant; filer kan åpnes likevel.`,
  too_large: (file, size, most) => `${file} er på ${size}; et scenario, og hver fil som det viser til, kan være på høyst ${most}.`,
  is_table: (file) => `${file} er en tabell: åpne den sammen med scenarioet som viser til den, begge filene på én gang.`,
  is_database: (file) => `${file} er en hydrodynamisk database: åpne den sammen med scenarioet som viser til den, begge filene på én gang.`,
  no_state: "Opptaket har ingen lagret tilstand ved eller før dette tidspunktet. Nullstill starter kjøringen på nytt.",
};

export const engine: Texts["engine"] = {
  unloaded: "Beregningsmotoren ble ikke lastet. Forbindelsen kan være nede.",
  not_loaded: (why) => `Beregningsmotoren ble ikke lastet: ${why}.`,
  ended: "Beregningsmotoren ble avsluttet, kanskje av systemet fordi det manglet minne.",
  silent: (silent_s) => `Beregningsmotoren svarte ikke på ${silent_s} s.`,
  broke_down: (why) => `Beregningsmotoren brøt sammen: ${why}.`,
  not_fetched: (file, why) => `${file} kunne ikke hentes: ${why}.`,
  no_json: "den er ikke JSON",
  not_there: "den finnes ikke",
  too_long: "det tok for lang tid",
  no_connection: "forbindelsen sviktet",
  answered: (status) => `tjeneren svarte ${status}`,
};
