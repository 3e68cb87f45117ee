export const transport = {
  title: "Run",
  start: "Start",
  pause: "Pause",
  resume: "Resume",
  from_here: "From here",
  from_here_help: "Continues from the moment that is shown; the run so far is kept in the list of runs",
  space: "The space bar starts and pauses too",
  step: "Step",
  reset: "Reset",
  speed: "Speed",
  fastest: "Max",
  fastest_help: "As fast as possible",
  reset_to_apply: "Reset to apply the changes.",
  loading: "Loading the engine…",
  starts_then: "Starts when it is loaded.",
  try_again: "Reset tries again.",
  open_one: "Open a scenario.",
  stopped: (time_s: string) => `Stopped at ${time_s} s. Reset to start again.`,
};

export const scrubber = {
  title: "The recording",
  happened: "Events",
  moment: "Moment that is shown",
  time: (shown_s: string, newest_s: string) => `${shown_s} s of ${newest_s} s`,
  more: (count: number) => `and ${count} more`,
  by_hand: (value: number) => `set to ${value} by hand`,
};

export const readouts = {
  title: "The run",
  time: "Time",
  pace: "Runs at",
  pace_help: "Simulated time over wall time, for the last seconds",
  slow: (pace: string) => `${pace} slow`,
  numerics: "Numerics",
  step: "Step",
  integrator: "Integrator",
  energy_error: "Energy error",
  momentum_error: "Momentum error",
  errors: (how: string, worst: string) => `${how}; errors ${worst}`,
  no_errors: "none",
};

/** Announcements for screen readers. */
export const announcer = {
  loading: "Loading the engine.",
  empty: "Nothing is open.",
  idle: (scenario: string) => `${scenario}: at the start.`,
  stepping: "Stepping.",
  running: "Running.",
  paused: (time: string) => `Paused at ${time}.`,
  stopped: (time: string) => `Stopped at ${time}.`,
  back: (time: string, newest_s: string) => `Shows ${time} of ${newest_s} s.`,
};

export const warnings = {
  dismiss: "Dismiss",
  of_model: (count: number) => (count === 1 ? "Warning about the model" : `${count} warnings about the model`),
  title: (count: number) => (count === 1 ? "Warning" : `${count} warnings`),
};
