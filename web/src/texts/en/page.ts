export const page = {
  name: "Kingpost",
  skip: "Skip to the controls",
  line: "Ships and their cranes, by the moving frame method",
  scenario: "Scenario",
  open: "Open scenario…",
  save: "Save scenario",
  save_help: "As a file, with the parameters as they are set and the lever moves as an operation",
  share: "Share",
  share_help: "A link that opens this run with all that was set in it",
  drop: "Drop the scenario to open it, and the databases that it names",
  title: (scenario: string) => `Kingpost – ${scenario}`,
  panels: "What to show",
  language: "Language",
  language_help: "The page loads anew, and the run begins again.",
};

export const floating = {
  heel: "Heel",
  heel_help: "Roll: positive to starboard",
  trim: "Trim",
  trim_help: "Pitch: positive by the bow",
  draught: "Draught",
  draught_help: "Of the keel under the origin of the hull's data, along the vertical, from still water",
  wave: "Wave",
  wave_help: "Elevation of the incident waves where the hull is on average",
  fluid_gm: "Fluid GM",
  fluid_gm_help: "Across the ship, at rest in still water with the crane as it stands; hanging loads at their suspension points",
};
