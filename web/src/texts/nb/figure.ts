import type { figure as english } from "../en/figure";

export const figure: typeof english = {
  start: "Start figuren",
  loading: "Laster…",
  label: "Interaktiv figur",
  controls: "Kontroller for figuren",
  failed: (why) => `Figuren lot seg ikke åpne: ${why}`,
  not_there: (address) => `Figuren på ${address} svarer ikke. Tjeneren tillater kanskje ikke rammer på denne siden.`,
  no_address: "Figuren mangler adressen til appen: attributtet src er ikke satt.",
  elsewhere: (address) => `scenario: fant adressen ${address}, tillatt: en adresse på samme tjener som appen`,
  unknown: (name, allowed) => `${name}: fant et ukjent navn, tillatt: ${allowed}`,
  no_number: (name, found) => `${name}: fant ${found}, tillatt: et tall`,
  no_camera: (found, allowed) => `camera: fant ${found}, tillatt: ${allowed}, eller seks tall`,
};
