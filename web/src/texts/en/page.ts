export const page = {
  name: "Kingpost",
  skip: "Skip to the controls",
  line: "Ships and their cranes, by the moving frame method",
  scenario: "Scenario",
  open: "Open scenario…",
  save: "Save scenario",
  save_help: "As a file, with the parameters as they are set and the lever moves as an operation",
  share: "Share",
  share_help: "A link that opens this run with all its settings",
  drop: "Drop the scenario and the databases that it names here to open them",
  title: (scenario: string) => `Kingpost – ${scenario}`,
  panels: "Panels",
  language: "Language",
  language_help: "The page is reloaded, and the run starts again.",
};

export const floating = {
  heel: "Heel",
  heel_help: "Roll: positive to starboard",
  trim: "Trim",
  trim_help: "Pitch: positive by the bow",
  draught: "Draught",
  draught_help: "From still water down to the keel, at the origin of the hull's data",
  wave: "Wave",
  wave_help: "Elevation of the incident waves at the hull's mean position",
  fluid_gm: "Fluid GM",
  fluid_gm_help: "Transverse, at rest in still water with the crane as it stands; hanging loads at their suspension points",
};
