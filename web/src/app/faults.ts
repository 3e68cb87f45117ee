import type { Fault, ParameterInfo } from "../engine/engine";

/** How the reader names where a value comes from that was set over a scenario. */
const SET = "--set ";

/** Labels of the settings, which are no parameters. */
export const SETTING_LABELS: Record<string, string> = {
  "simulation.integrator": "Integrator",
  "simulation.form": "Equations",
  "simulation.step_s": "Step size",
};

/** A refused value in the words of the control that it was set by, not of the command line. */
export function faultOfControl(fault: Fault, parameters: readonly ParameterInfo[]): Fault {
  const { file, field, found, allowed } = fault;
  if (!file?.startsWith(SET) || found === undefined || allowed === undefined) return fault;
  const name = file.slice(SET.length);
  const parameter = parameters.find((one) => one.name === name);
  const label = parameter?.label ?? SETTING_LABELS[name] ?? field ?? name;
  const unit = parameter?.unit ? ` ${parameter.unit}` : "";
  return { kind: "input", message: `${label}: ${found}${unit} is not ${allowed}${/\d$/.test(allowed) ? unit : ""}.` };
}

/** Values of the address that the scenario does not take, in the words of an address. */
export function faultOfAddress(fault: Fault): Fault {
  return { kind: "address", message: `${fault.message.replaceAll(SET, "")}. It opened with its own values.` };
}

/** A run that was lost with its engine, and begins anew in another. */
export function faultOfLostRun({ message }: Fault): Fault {
  return { kind: "restarted", message: `${message} The run begins anew, with the values as they were set.` };
}

/** What a part of the page threw; the run goes on. */
export function faultOfPage(thrown: unknown): Fault {
  return { kind: "page", message: `${thrown instanceof Error ? thrown.message : String(thrown)}. The run goes on.` };
}

/** What to say where the gallery's list did not come. */
export function faultOfGallery({ message }: Fault): Fault {
  return { kind: "network", message: `${message} There are no scenarios to choose from; files can be opened all the same.` };
}

/** A file that is too large to be a scenario or what one names. */
export function faultOfSize({ name, size }: File, most_bytes: number): Fault {
  const megabytes = (bytes: number) => `${Math.ceil(bytes / 1e6)} MB`;
  return { kind: "file", message: `${name} holds ${megabytes(size)}; a scenario, and each file that it names, holds at most ${megabytes(most_bytes)}.` };
}

/** What to say of a hydrodynamic database, or a table, that was opened by itself. */
export function faultOfDatabase(name: string): Fault {
  return {
    kind: "database",
    message: `${name} is a ${name.endsWith(".csv") ? "table" : "hydrodynamic database"}: open it together with the scenario that names it, both files at once.`,
  };
}
