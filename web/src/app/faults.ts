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

/** What to say of a hydrodynamic database, or a table, that was opened by itself. */
export function faultOfDatabase(name: string): Fault {
  return {
    kind: "database",
    message: `${name} is a ${name.endsWith(".csv") ? "table" : "hydrodynamic database"}: open it together with the scenario that names it, both files at once.`,
  };
}
