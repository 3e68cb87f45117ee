/** One drawn line: what it is called, which colour it has everywhere, which column it comes from. */
export interface Quantity {
  key: "pitch" | "yaw" | "roll";
  label: string;
  /** Column name without its leading body. */
  column: string;
}

export interface PlotKind {
  key: "rates" | "angles";
  title: string;
  quantities: Quantity[];
  units: Record<Unit, string>;
  /** Angles jump from +180 to -180 degrees: no line is drawn there. */
  wraps: boolean;
}

export type Unit = "deg" | "rad";

export const PLOTS: PlotKind[] = [
  {
    key: "rates",
    title: "Rates",
    quantities: [
      { key: "pitch", label: "Pitch", column: "angular_velocity.y" },
      { key: "yaw", label: "Yaw", column: "angular_velocity.z" },
      { key: "roll", label: "Roll", column: "angular_velocity.x" },
    ],
    units: { deg: "°/s", rad: "rad/s" },
    wraps: false,
  },
  {
    key: "angles",
    title: "Angles",
    quantities: [
      { key: "pitch", label: "Pitch", column: "pitch" },
      { key: "yaw", label: "Yaw", column: "yaw" },
      { key: "roll", label: "Roll", column: "roll" },
    ],
    units: { deg: "°", rad: "rad" },
    wraps: true,
  },
];

export const PER_RADIAN: Record<Unit, number> = { deg: 180 / Math.PI, rad: 1 };
export const DECIMALS: Record<Unit, number> = { deg: 2, rad: 5 };
