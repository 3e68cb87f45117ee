import type { PointInfo } from "./engine";

/** A mooring line or a hawser, from its first end, or its fairlead, to its second, or its anchor. */
export interface LineInfo {
  /** Of its force, as its results have it. */
  name: string;
  first: PointInfo;
  second: PointInfo;
  unstretched_length_m: number;
  axial_stiffness_N: number;
  /** 0 of a spring line. */
  weight_in_water_N_per_m: number;
}

/** A rope without mass, of a body that hangs from a joint away from it: straight, from the joint to the body's centre. */
export interface PendantInfo {
  from: PointInfo;
  to: PointInfo;
}

/** What pulls and has no body of its own. */
export interface Ropes {
  lines: LineInfo[];
  pendants: PendantInfo[];
}

type Vector = [number, number, number];
type Pin = { body: string; position_m: Vector };
type Elastic = { enabled: boolean; unstretched_length_m: number; axial_stiffness_N: number };

interface Resolved {
  bodies?: Record<string, { enabled: boolean; centre_of_mass_m?: Vector; joint: Record<string, { child_position_m?: Vector }> }>;
  forces?: Record<
    string,
    {
      spring_line?: Elastic & { first: Pin; second: Pin };
      catenary_line?: Elastic & { fairlead: Pin; anchor_m: Vector; weight_in_water_N_per_m: number };
    }
  >;
}

/** Joints that a rope turns about where it hangs. */
const HANGING = ["universal", "spherical"];

/** The ropes of a resolved scenario; places are seen from the bodies' centres of mass. */
export function readRopes(resolvedJson: string): Ropes {
  const { bodies = {}, forces = {} } = JSON.parse(resolvedJson) as Resolved;
  const seen = ({ body, position_m }: Pin): PointInfo => ({ body, position_m: less(position_m, bodies[body]?.centre_of_mass_m) });
  const lines = Object.entries(forces).flatMap(([name, { spring_line: spring, catenary_line: catenary }]): LineInfo[] => {
    const line = spring ?? catenary;
    if (!line?.enabled) return [];
    const { unstretched_length_m, axial_stiffness_N } = line;
    const elastic = { name, unstretched_length_m, axial_stiffness_N };
    if (spring) return [{ ...elastic, first: seen(spring.first), second: seen(spring.second), weight_in_water_N_per_m: 0 }];
    const { fairlead, anchor_m, weight_in_water_N_per_m } = catenary!;
    return [{ ...elastic, first: seen(fairlead), second: { body: "world", position_m: anchor_m }, weight_in_water_N_per_m }];
  });
  const pendants = Object.entries(bodies).flatMap(([body, { enabled, joint }]): PendantInfo[] => {
    const hanging = HANGING.map((kind) => joint[kind]).find((one) => one?.child_position_m?.some((part) => part !== 0));
    if (!enabled || !hanging) return [];
    return [{ from: seen({ body, position_m: hanging.child_position_m! }), to: { body, position_m: [0, 0, 0] } }];
  });
  return { lines, pendants };
}

function less(a: Vector, b: Vector = [0, 0, 0]): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}
