import type { Texts } from "../index";

export const about: Texts["about"] = {
  title: "Hva er dette?",
  acts: "Krefter og drifter",
  off: (element) => `${element}, av`,
  recording: "Opptaket",
  recording_text:
    "Sporet under bildet dekker alt som er beregnet siden start. Dra i det, eller bruk piltastene på det, for å se et øyeblikk igjen. " +
    "Start, Steg eller en spak fortsetter kjøringen derfra, og alt som kom etter, slettes. Eksport, ved siden av grafene, " +
    "lagrer opptaket som fil.",
  reading: "Slik leses det",
  signs:
    "Fortegn: **rulling** er positiv med babord side opp, **stamping** med baugen ned, **giring** med baugen mot babord. Vinkelhastigheter " +
    "er om legemets egne akser. x er forover, y mot babord, z oppover.",
  afloat:
    "Flytende: **krengning** er rulling, positiv mot styrbord; **trim** er stamping, positiv når baugen går ned; dypgangen er den til " +
    "origo for skrogets data, under stille vann. **Korr. GM** er metasenterhøyden for krengning, i ro med kranen slik den sto da kjøringen " +
    "begynte eller ble satt på pause, med hengende laster regnet i opphengspunktet og fratrukket virkningen av slakke tanker. Sjøen i " +
    "bildet er den innkommende bølgen som skroget kjenner; bølgene som skroget selv lager eller kaster tilbake, er ikke tegnet, og langt " +
    "unna er sjøen tegnet flat.",
  picture:
    "Bildet: et skrog med baug er tegnet som et skip, et langt og slankt legeme på en søyle som bommen på den; hvert har samme størrelse som " +
    "modellens legeme. Utstyret på dem (overbygg, førerhus, rekkverk, stag, braketter) har verken vekt eller vindlast i modellen. " +
    "**Enkle former** under Vis skjuler det.",
  errors:
    "Energifeil: tilført energi minus utført arbeid, over den største kinetiske energien eller det største arbeidet så langt; i J " +
    "så lenge den er mindre enn tusen avrundinger av den potensielle energien, som for et skip i ro. Spinnfeil: spinnet minus " +
    "impulsen av momentene, over det største så langt. Begge skal være ørsmå, og den ene alene beviser lite: utelat metodens D-matrise (under " +
    "Avansert), og energien stemmer fortsatt, mens spinnet straks blir galt.",
};
