export const figure = {
  start: "Start the figure",
  loading: "Loading…",
  label: "Interactive figure",
  controls: "Controls of the figure",
  failed: (why: string) => `The figure could not be opened: ${why}`,
  not_there: (address: string) => `The figure at ${address} does not answer. Its server may not allow frames on this page.`,
  no_address: "The figure has no address of the app: the attribute src is missing.",
  elsewhere: (address: string) => `scenario: found the address ${address}, allowed: an address on the host of the app`,
  unknown: (name: string, allowed: string) => `${name}: found an unknown name, allowed: ${allowed}`,
  no_number: (name: string, found: string) => `${name}: found ${found}, allowed: a number`,
  no_camera: (found: string, allowed: string) => `camera: found ${found}, allowed: ${allowed}, or six numbers`,
};
