export const exports = {
  open: "Export",
  title: "Export",
  recording: "The recording",
  rows: (kept: number, until_s: string) => `${kept} ${kept === 1 ? "row" : "rows"}, 0 to ${until_s} s`,
  thinned: (kept: number, of: number, until_s: string) =>
    `The recording is long: ${kept} of about ${of} rows are kept. Some rows before ${until_s} s are missing from these files; all later rows are included.`,
  csv: "Table (CSV)",
  csv_help: "All columns in SI units, as kingpost run writes them",
  events: "Events (CSV)",
  parquet: "Parquet",
  parquet_help: "All columns with their units and the scenario, for Python",
  pictures: "Pictures",
  picture: "Ship (PNG)",
  plot: (title: string) => `${title} (PNG)`,
  film: "Film, and pictures of any size",
  open_film: "Film …",
  film_help: "WebM or MP4 of a part of the recording, or a PNG, in a size of your choice",
  scenario: "The scenario",
  save: "Scenario (YAML)",
  save_help: "With the parameters and the lever moves; the same as Save scenario",
  close: "Close",
  failed: "The file could not be made",
  done: (file: string) => `${file} is saved.`,
};

/** Comments at the top of a saved scenario. */
export const saved = {
  by: (time: string) => `Saved by Kingpost's app at ${time} of a run, with the parameters as they were set.`,
  moves: (count: number) => `The operation has ${count === 1 ? "the lever move" : `the ${count} lever moves`} made by hand.`,
  waiting: (names: string) => `This file leaves out values that take effect only after a reset: ${names}.`,
  same: "A run of this file gives the same numbers.",
  implicit: "Its integrator is implicit: a run outside the browser agrees within its tolerance, not to the last bit.",
  needs: (files: string) => `It needs these files in the same folder: ${files}.`,
  lost: (count: number) => `a run of this file differs: ${count} ${count === 1 ? "change was" : "changes were"} made before the engine was replaced; a link of Share holds them`,
  set_at: (parameter: string, time: string) => `${parameter} at ${time}`,
  differs: (set: string) =>
    `A run of this file differs from the saved one, because parameters were set during that run: ${set}. The file has their last values from the start.`,
  two_operations:
    "Levers were moved by hand while the scenario's own operation was on, and a file holds one operation. " +
    "Switch it off (operation.enabled: false) and move all levers by hand; or reset, and save without the moves.",
};
