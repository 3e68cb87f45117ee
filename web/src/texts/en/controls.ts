export const controls = {
  title: "Controls",
  intro: "At the start every change acts at once. During a run some act at once, and the others restart it; in a pause they wait for the restart.",
  switches: "Switches",
  choices: "Choices",
  numbers: "Numbers",
  none: "This scenario has no parameters.",
  slider: (control: string) => `${control}, slider`,
  by: (input: string, signal: string) => `${input} by ${signal}`,
  set_by_scenario: (inputs: string) => `Set by the scenario: ${inputs}.`,
  moves_are_kept: "Save scenario keeps the lever moves as an operation.",
  live: "acts at once",
  restart: "restarts the run",
  restart_now: "Restart with these values",
};

const limits: Record<string, string> = {
  speed: "at its largest speed",
  effort: "torque or force at its limit",
  power: "power at its limit",
};

export const levers = {
  title: "Levers",
  about_title: "The sticks",
  about:
    "Where a scenario has levers, two sticks stand over the picture, as in a crane's cab: towards you hoists and raises a boom, away " +
    "lowers, left and right slew. The letters W A S D and I J K L also move them (with Shift only a little), and so does a gamepad. A stick " +
    "that is released springs back. A lever that is set during a pause acts when the run continues. The marks on the rim show the " +
    "drives: amber at their largest speed, red where torque, force or power is at its limit.",
  sides: { left: "Left stick", right: "Right stick" },
  asked: (percent: number) => `command ${percent} %`,
  does: (rate: string) => `rate ${rate}`,
  limits,
  at_limit: (limit: string) => `${limit} at its limit`,
  stands: "The run is paused: the levers act when it continues.",
  gamepad: (name: string) => `Gamepad connected: its two sticks move the levers. ${name}`,
  gamepad_gone: "The gamepad was disconnected.",
  choose_axes: "Axes of the sticks…",
  axes_title: "Axes of the sticks",
  axes: { left_x: "Left, across", left_y: "Left, up and down", right_x: "Right, across", right_y: "Right, up and down" },
  none: "None",
  reverse: "Reverse",
  standard: "Default of the model",
  close: "Close",
};

const labels: Record<string, string> = {
  "simulation.integrator": "Integrator",
  "simulation.form": "Equations",
  "simulation.step_s": "Step size",
};

export const settings = {
  title: "Advanced",
  labels,
  integrators: {
    forward_euler: "Forward Euler",
    midpoint_euler: "Midpoint Euler",
    semi_implicit_euler: "Semi-implicit Euler",
    rk4: "RK4 (Munthe-Kaas)",
    dormand_prince: "Dormand-Prince 5(4)",
    newmark: "Newmark",
    generalized_alpha: "Generalized-alpha",
    implicit_midpoint: "Implicit midpoint",
  },
  forms: {
    recursive: "Recursive (fast)",
    moving_frame: "Moving frame (the paper's)",
    moving_frame_without_d: "Moving frame, D left out",
  },
};
