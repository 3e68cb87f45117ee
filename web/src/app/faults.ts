import type { Fault, ParameterInfo } from "../engine/engine";
import { texts } from "../texts";

/** How the reader names where a value comes from that was set over a scenario. */
const SET = "--set ";

/** A refused value in the words of the control that it was set by, not of the command line. */
export function faultOfControl(fault: Fault, parameters: readonly ParameterInfo[]): Fault {
  const { file, field, found, allowed } = fault;
  if (!file?.startsWith(SET) || found === undefined || allowed === undefined) return fault;
  const name = file.slice(SET.length);
  const parameter = parameters.find((one) => one.name === name);
  const label = parameter?.label ?? texts.settings.labels[name] ?? field ?? name;
  const unit = parameter?.unit ? ` ${parameter.unit}` : "";
  return { kind: "setting", message: texts.faults.not_allowed(label, `${found}${unit}`, `${allowed}${/\d$/.test(allowed) ? unit : ""}`) };
}

/** Values of the address that the scenario does not take, in the words of an address. */
export function faultOfAddress(fault: Fault): Fault {
  return { kind: "address", message: `${fault.message.replaceAll(SET, "")}.`, note: texts.faults.own_values };
}

/** A run that was lost with its engine, and begins anew in another. */
export function faultOfLostRun({ message }: Fault): Fault {
  return { kind: "restarted", message: texts.faults.lost_run(message) };
}

/** What a part of the page threw; the run goes on. */
export function faultOfPage(thrown: unknown): Fault {
  return { kind: "page", message: `${thrown instanceof Error ? thrown.message : String(thrown)}.`, note: texts.faults.run_goes_on };
}

/** What to say where the gallery's list did not come. */
export function faultOfGallery({ message }: Fault): Fault {
  return { kind: "network", message: texts.faults.no_gallery(message) };
}

/** A file that is too large to be a scenario or what one names. */
export function faultOfSize({ name, size }: File, most_bytes: number): Fault {
  const megabytes = (bytes: number) => `${Math.ceil(bytes / 1e6)} MB`;
  return { kind: "file", message: texts.faults.too_large(name, megabytes(size), megabytes(most_bytes)) };
}

/** What to say of a hydrodynamic database, or a table, that was opened by itself. */
export function faultOfDatabase(name: string): Fault {
  return { kind: "database", message: name.endsWith(".csv") ? texts.faults.is_table(name) : texts.faults.is_database(name) };
}
