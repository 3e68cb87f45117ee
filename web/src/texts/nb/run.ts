import type { Texts } from "../index";

export const transport: Texts["transport"] = {
  title: "Kjøring",
  start: "Start",
  pause: "Pause",
  resume: "Fortsett",
  from_here: "Herfra",
  from_here_help: "Fortsetter fra øyeblikket som vises; kjøringen så langt blir beholdt i listen over kjøringer",
  space: "Mellomromstasten starter og stopper også",
  step: "Steg",
  reset: "Nullstill",
  speed: "Tempo",
  fastest: "Maks",
  fastest_help: "Så fort som mulig",
  reset_to_apply: "Nullstill for å ta i bruk endringene.",
  loading: "Laster beregningsmotoren…",
  starts_then: "Starter når alt er lastet.",
  try_again: "Nullstill prøver igjen.",
  open_one: "Åpne et scenario.",
  stopped: (time_s) => `Stoppet ved ${time_s} s. Nullstill for å starte på nytt.`,
};

export const scrubber: Texts["scrubber"] = {
  title: "Opptaket",
  happened: "Hendelser",
  moment: "Øyeblikket som vises",
  time: (shown_s, newest_s) => `${shown_s} s av ${newest_s} s`,
  more: (count) => `og ${count} til`,
  by_hand: (value) => `satt til ${value} for hånd`,
};

export const readouts: Texts["readouts"] = {
  title: "Kjøringen",
  time: "Tid",
  pace: "Går i",
  pace_help: "Simulert tid over klokketid, de siste sekundene",
  slow: (pace) => `${pace} tregt`,
  numerics: "Numerikk",
  step: "Steg",
  integrator: "Integrator",
  energy_error: "Energifeil",
  momentum_error: "Spinnfeil",
  errors: (how, worst) => `${how}; feil ${worst}`,
  no_errors: "ingen",
};

export const announcer: Texts["announcer"] = {
  loading: "Laster beregningsmotoren.",
  empty: "Ingenting er åpnet.",
  idle: (scenario) => `${scenario}: ved start.`,
  stepping: "Tar et steg.",
  running: "Kjører.",
  paused: (time) => `Pause ved ${time}.`,
  stopped: (time) => `Stoppet ved ${time}.`,
  back: (time, newest_s) => `Viser ${time} av ${newest_s} s.`,
};

export const warnings: Texts["warnings"] = {
  dismiss: "Lukk",
  of_model: (count) => (count === 1 ? "Advarsel om modellen" : `${count} advarsler om modellen`),
  title: (count) => (count === 1 ? "Advarsel" : `${count} advarsler`),
};
