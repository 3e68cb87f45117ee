import type { Run } from "../app/run";
import type { InputInfo } from "../engine/engine";

/** Share of a limit above which a drive counts as at the limit. */
const AT_LIMIT = 0.99;

/** State of a drive: its rate over the largest rate (NaN if unknown), and the limits that it has reached. */
export interface Doing {
  share: number;
  rate: number;
  limits: string[];
}

/** Reads the state of an input's drive from a row. */
export class Drive {
  /** Unit of the drive's rate. */
  readonly unit: string;
  /** Largest rate, from the drive's limit or from the bound of the input; NaN if there is neither. */
  readonly greatest: number;
  private readonly rateAt: number;
  private readonly used: { limit: string; at: number }[];

  constructor(
    { model, channels, columns }: Run,
    { name, unit, upper }: InputInfo,
  ) {
    const facts = model.elements.find((one) => one.name === name && one.group === "drives")?.facts ?? [];
    const own = channels.filter(({ labels }) => labels.length === 1 && labels[0].includes(name));
    const joints = channels.find(({ variable }) => variable === "joint_velocity");
    const joint = joints?.labels[0].indexOf(facts.find(({ label }) => label === "joint")?.value ?? "") ?? -1;
    const rate = own.find((channel) => isRate(channel.units[0]));
    const column = joint >= 0 ? joints!.columns[joint] : rate?.columns[rate.labels[0].indexOf(name)];
    this.rateAt = column === undefined ? -1 : columns.at(column);
    this.unit = (joint >= 0 ? joints!.units[joint] : rate?.units[0]) ?? "";
    const limits = facts.filter((fact) => fact.unit === this.unit).map(({ value }) => Math.abs(Number(value)));
    this.greatest = limits.length > 0 ? Math.max(...limits) : unit === this.unit ? upper : NaN;
    this.used = own
      .filter(({ variable }) => variable.endsWith("_utilisation"))
      .map(({ variable, labels, columns: all }) => ({ limit: limitOf(variable), at: columns.at(all[labels[0].indexOf(name)]) }));
  }

  doing(row: ArrayLike<number>): Doing {
    const rate = this.rateAt < 0 ? NaN : row[this.rateAt];
    const share = Math.min(1, Math.max(-1, rate / this.greatest));
    return { share, rate, limits: this.used.filter(({ at }) => row[at] >= AT_LIMIT).map(({ limit }) => limit) };
  }
}

function isRate(unit: string): boolean {
  return unit === "rad/s" || unit === "m/s";
}

/** Returns the limited quantity of a utilisation, for example `effort` for `drive_effort_utilisation`. */
function limitOf(variable: string): string {
  return variable.split("_").at(-2) ?? variable;
}
