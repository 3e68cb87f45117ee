import type { Fault, ParameterInfo } from "../engine/engine";
import { texts } from "../texts";
import { fixed } from "./format";

/** Prefix by which the engine names a value that overrides a scenario. */
const SET = "--set ";

/** Returns the fault of a refused value, in the words of its control instead of those of the command line. */
export function faultOfControl(fault: Fault, parameters: readonly ParameterInfo[]): Fault {
  const { file, field, found, allowed } = fault;
  if (!file?.startsWith(SET) || found === undefined || allowed === undefined) return fault;
  const name = file.slice(SET.length);
  const parameter = parameters.find((one) => one.name === name);
  const label = parameter?.label ?? texts.settings.labels[name] ?? field ?? name;
  const unit = parameter?.unit ? ` ${parameter.unit}` : "";
  return { kind: "setting", message: texts.faults.not_allowed(label, `${found}${unit}`, `${allowed}${/\d$/.test(allowed) ? unit : ""}`) };
}

/** Returns the fault of values in the address that the scenario does not accept, in the words of the address. */
export function faultOfAddress(fault: Fault): Fault {
  return { kind: "address", message: `${fault.message.replaceAll(SET, "")}.`, note: texts.faults.own_values };
}

/** Returns the fault of an engine that was lost, after which another engine continues the run. */
export function faultOfResumedRun({ message }: Fault, time_s: number): Fault {
  return { kind: "restarted", message: texts.faults.resumed_run(message, fixed(time_s, 2)) };
}

/** Returns the fault of a run that was lost with its engine and starts again in another engine. */
export function faultOfLostRun({ message }: Fault): Fault {
  return { kind: "restarted", message: texts.faults.lost_run(message) };
}

/** Returns the fault of an exception in a part of the page; the run goes on. */
export function faultOfPage(thrown: unknown): Fault {
  return { kind: "page", message: `${thrown instanceof Error ? thrown.message : String(thrown)}.`, note: texts.faults.run_goes_on };
}

/** Returns the fault if the list of the gallery could not be loaded. */
export function faultOfGallery({ message }: Fault): Fault {
  return { kind: "network", message: texts.faults.no_gallery(message) };
}

/** Returns the fault of a file that is too large, for a scenario or for a file that a scenario names. */
export function faultOfSize({ name, size }: File, most_bytes: number): Fault {
  const megabytes = (bytes: number) => `${Math.ceil(bytes / 1e6)} MB`;
  return { kind: "file", message: texts.faults.too_large(name, megabytes(size), megabytes(most_bytes)) };
}

/** Returns the fault of a hydrodynamic database, or of a table, that was opened without a scenario. */
export function faultOfDatabase(name: string): Fault {
  return { kind: "database", message: name.endsWith(".csv") ? texts.faults.is_table(name) : texts.faults.is_database(name) };
}
