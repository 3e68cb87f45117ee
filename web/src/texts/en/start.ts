export const start = {
  lead: "Ships and their cranes at sea, simulated in your browser",
  intro: "Slew, luff and hoist. See how load, ship and sea move each other, with every number at hand. It also works on a phone; nothing is installed, and nothing is sent anywhere.",
  open_paper: "Start with the paper's crane ship",
  open_file: "Open your own scenario…",
  choose: "Or choose one",
  ungrouped: "Your own",
  loading: "Loading the list…",
  failed: (why: string) => `The list of scenarios could not be loaded. ${why}`,
  no_simulator: (why: string) => `The simulator did not load: ${why}. Check the connection and try again.`,
  about: "The same engine runs on the command line, in Python and here. It computes with the moving frame method of Jardim, Rein, Haveland, Rykkje and Impelluso (2019).",
  page_title: "Kingpost – ship and crane simulator",
};

export const offline = {
  update: "A new version is available",
  update_help: "Reloading restarts the run. To keep it, make a link with Share first.",
  reload: "Reload",
  others: (count: number) => `Close the app's other ${count === 1 ? "window" : `${count} windows`} first: they have the older version.`,
};
