const headings: Record<string, string> = {
  scenario: "This scenario cannot be read",
  database: "This is not a scenario",
  file: "This file is too large",
  diverged: "The run diverged",
  setting: "This value is not allowed",
  singular_loop: "A closed loop is at a dead centre",
  open_loop: "A closed loop does not close",
  rope_constraint: "A constraint cannot be kept",
  step: "The integrator cannot go on",
  input: "This value is not allowed",
  engine: "The engine is not available",
  restarted: "The engine was started again",
  network: "A file could not be loaded",
  page: "A part of the page failed",
  address: "The address has a value that is not allowed",
  operation: "The operation cannot go on",
  saved: "Saved, but a run of the file differs",
  link: "This link cannot be opened",
  followed: "A change from the link cannot be repeated",
  two_operations: "The scenario cannot be saved",
  unsaved: "The scenario cannot be saved",
  runs: "The run is not kept",
};

export const alert = {
  other: "Something went wrong",
  headings,
  its_database: "Open the scenario and its database together: choose both files, or drop both here.",
  its_file: "Open the scenario and the file that it names together: choose both files, or drop both here.",
  facts: { place: "Place", field: "Field", found: "Found", allowed: "Allowed", time: "Time", body: "Body" },
};

/** Messages of the page about faults, in addition to those of the engine. */
export const faults = {
  not_allowed: (label: string, found: string, allowed: string) => `${label}: ${found} is not ${allowed}.`,
  own_values: "The scenario opened with its own values.",
  resumed_run: (why: string, time_s: string) => `${why} The run continues at ${time_s} s with another engine; the recording is kept.`,
  lost_run: (why: string) => `${why} The run starts again, with the same values.`,
  run_goes_on: "The run goes on.",
  no_gallery: (why: string) => `${why} There are no scenarios to choose from; files can still be opened.`,
  too_large: (file: string, size: string, most: string) => `${file} holds ${size}; a scenario, and each file that it names, holds at most ${most}.`,
  is_table: (file: string) => `${file} is a table: open it together with the scenario that names it, both files at once.`,
  is_database: (file: string) => `${file} is a hydrodynamic database: open it together with the scenario that names it, both files at once.`,
  no_state: "The recording has no stored state at or before this time. Reset starts the run again.",
};

/** Faults between the page and the engine. */
export const engine = {
  unloaded: "The engine did not load. The connection may be down.",
  not_loaded: (why: string) => `The engine did not load: ${why}.`,
  ended: "The engine was ended, perhaps by the system for lack of memory.",
  silent: (silent_s: number) => `The engine gave no answer for ${silent_s} s.`,
  broke_down: (why: string) => `The engine broke down: ${why}.`,
  not_fetched: (file: string, why: string) => `${file} could not be fetched: ${why}.`,
  no_json: "it is not JSON",
  not_there: "it does not exist",
  too_long: "it took too long",
  no_connection: "the connection failed",
  answered: (status: string) => `the server answered ${status}`,
};
