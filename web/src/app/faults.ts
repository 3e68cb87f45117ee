import type { Fault, ParameterInfo } from "../engine/engine";
import { texts } from "../texts";

/** The engine's names for the origin of a value that overrides a scenario. */
const SET = "--set ";

/** A refused value, in the words of its control instead of those of the command line. */
export function faultOfControl(fault: Fault, parameters: readonly ParameterInfo[]): Fault {
  const { file, field, found, allowed } = fault;
  if (!file?.startsWith(SET) || found === undefined || allowed === undefined) return fault;
  const name = file.slice(SET.length);
  const parameter = parameters.find((one) => one.name === name);
  const label = parameter?.label ?? texts.settings.labels[name] ?? field ?? name;
  const unit = parameter?.unit ? ` ${parameter.unit}` : "";
  return { kind: "setting", message: texts.faults.not_allowed(label, `${found}${unit}`, `${allowed}${/\d$/.test(allowed) ? unit : ""}`) };
}

/** Values of the address that the scenario does not accept, in the words of an address. */
export function faultOfAddress(fault: Fault): Fault {
  return { kind: "address", message: `${fault.message.replaceAll(SET, "")}.`, note: texts.faults.own_values };
}

/** A run that was lost with its engine and starts again in another one. */
export function faultOfLostRun({ message }: Fault): Fault {
  return { kind: "restarted", message: texts.faults.lost_run(message) };
}

/** An exception in a part of the page; the run goes on. */
export function faultOfPage(thrown: unknown): Fault {
  return { kind: "page", message: `${thrown instanceof Error ? thrown.message : String(thrown)}.`, note: texts.faults.run_goes_on };
}

/** The message if the gallery's list could not be loaded. */
export function faultOfGallery({ message }: Fault): Fault {
  return { kind: "network", message: texts.faults.no_gallery(message) };
}

/** A file that is too large for a scenario or a file of one. */
export function faultOfSize({ name, size }: File, most_bytes: number): Fault {
  const megabytes = (bytes: number) => `${Math.ceil(bytes / 1e6)} MB`;
  return { kind: "file", message: texts.faults.too_large(name, megabytes(size), megabytes(most_bytes)) };
}

/** The message for a hydrodynamic database, or a table, that was opened without a scenario. */
export function faultOfDatabase(name: string): Fault {
  return { kind: "database", message: name.endsWith(".csv") ? texts.faults.is_table(name) : texts.faults.is_database(name) };
}
