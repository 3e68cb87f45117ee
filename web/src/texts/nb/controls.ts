import type { Texts } from "../index";

export const controls: Texts["controls"] = {
  title: "Styring",
  intro: "Ved start virker alle endringer med en gang. Under kjøring virker noen med en gang, og de andre starter den på nytt; i en pause venter de på ny start.",
  switches: "Brytere",
  choices: "Valg",
  numbers: "Tall",
  none: "Dette scenarioet har ingen parametrer.",
  slider: (control) => `${control}, skyveknapp`,
  by: (input, signal) => `${input} av ${signal}`,
  set_by_scenario: (inputs) => `Satt av scenarioet: ${inputs}.`,
  moves_are_kept: "Lagre scenario tar vare på spakbevegelsene som en operasjon.",
  live: "virker straks",
  restart: "starter på nytt",
  restart_now: "Start på nytt med disse verdiene",
};

export const levers: Texts["levers"] = {
  title: "Spaker",
  about_title: "Styrespakene",
  about:
    "Der et scenario har spaker, står to styrespaker over bildet, som i førerhuset på en kran: mot deg hiver og topper bommen opp, fra " +
    "deg firer og topper ned, til venstre og høyre svinger. Bokstavene W A S D og I J K L beveger dem også, med Shift bare litt, og det " +
    "gjør en spillkontroll med. En styrespak som slippes, går tilbake til midten. En spak som settes under pause, virker når kjøringen går " +
    "videre. Merkene på kanten viser driften: gult ved største hastighet, rødt der moment, kraft eller effekt er ved grensen.",
  sides: { left: "Venstre styrespak", right: "Høyre styrespak" },
  asked: (percent) => `kommando ${percent} %`,
  does: (rate) => `hastighet ${rate}`,
  limits: { speed: "ved største hastighet", effort: "moment eller kraft ved grensen", power: "effekt ved grensen" },
  at_limit: (limit) => `${limit} ved grensen`,
  stands: "Kjøringen er på pause: spakene virker når den går videre.",
  gamepad: (name) => `Spillkontroll koblet til: de to styrespakene på den beveger spakene. ${name}`,
  gamepad_gone: "Spillkontrollen er koblet fra.",
  choose_axes: "Styrespakenes akser…",
  axes_title: "Styrespakenes akser",
  axes: { left_x: "Venstre, sideveis", left_y: "Venstre, opp og ned", right_x: "Høyre, sideveis", right_y: "Høyre, opp og ned" },
  none: "Ingen",
  reverse: "Snu",
  standard: "Modellens standard",
  close: "Lukk",
};

export const settings: Texts["settings"] = {
  title: "Avansert",
  labels: { "simulation.integrator": "Integrator", "simulation.form": "Likninger", "simulation.step_s": "Steglengde" },
  integrators: {
    forward_euler: "Forlengs Euler",
    midpoint_euler: "Euler med midtpunkt",
    semi_implicit_euler: "Semi-implisitt Euler",
    rk4: "RK4 (Munthe-Kaas)",
    dormand_prince: "Dormand-Prince 5(4)",
    newmark: "Newmark",
    generalized_alpha: "Generalisert alfa",
    implicit_midpoint: "Implisitt midtpunkt",
  },
  forms: {
    recursive: "Rekursiv (rask)",
    moving_frame: "Moving frame (artikkelens)",
    moving_frame_without_d: "Moving frame, uten D",
  },
};
