import type { LineInfo } from "../engine/ropes";
import type { Vec3 } from "./fit";

/** What the engine says of a line at a moment. */
export interface LineReading {
  /** At the fairlead, N. */
  tension_N: number;
  /** At the anchor, N. */
  end_tension_N: number;
  /** Unstretched length that lies on the seabed, m. */
  grounded_length_m: number;
}

/** Least horizontal pull, as a part of the line's weight: a line that hangs straight down has a shape too. */
const LEAST_PULL = 1e-6;

/**
 * `count` points along a line from its first end to its second: of a catenary in the shape that the engine's tensions
 * give it, of a spring line straight, or with the sag of its slack.
 */
export function shapeOf(line: LineInfo, first: Vec3, second: Vec3, reading: LineReading, count: number): Vec3[] {
  const shares = Array.from({ length: count }, (_, i) => i / (count - 1));
  if (!(line.weight_in_water_N_per_m > 0)) return slackened(line, first, second, shares);
  const profile = shares.map((share) => profileAt(line, reading, line.unstretched_length_m * (1 - share)));
  const top = profile[0];
  const [across, up] = [Math.hypot(first[0] - second[0], first[1] - second[1]), first[2] - second[2]];
  return profile.map(({ x, z }) => {
    // The shape ends where the line does: what rounding leaves is shared out along it.
    const along = top.x > 0 && across > 0 ? x / top.x : 0;
    const off = top.z - up;
    const share = line.unstretched_length_m > 0 && top.x > 0 ? x / top.x : 0;
    return [second[0] + along * (first[0] - second[0]), second[1] + along * (first[1] - second[1]), second[2] + z - share * off];
  });
}

/**
 * Place over the anchor of the point at the unstretched length `s` from it: the elastic catenary (Irvine, Cable
 * Structures, 1981, ch. 1), x = H/w (asinh((Va + w s)/H) - asinh(Va/H)) + H s/EA and z by its energy, with the vertical
 * pull Va at the anchor; of a line on the seabed from where it leaves that.
 */
export function profileAt(line: LineInfo, reading: LineReading, s: number): { x: number; z: number } {
  const { weight_in_water_N_per_m: w, axial_stiffness_N: stiffness, unstretched_length_m: length } = line;
  const { tension_N: tension, end_tension_N: end, grounded_length_m: grounded } = reading;
  const hanging = length - grounded;
  // T^2 is the same H^2 and another V^2 at both ends, and V falls by the weight between them.
  const top = grounded > 0 ? w * hanging : 0.5 * (w * length + (tension ** 2 - end ** 2) / (w * length));
  const bottom = grounded > 0 ? 0 : top - w * length;
  const pull = Math.max(Math.sqrt(Math.max(0, tension ** 2 - top ** 2)), LEAST_PULL * w * length);
  const lying = Math.min(s, grounded);
  const rising = s - lying;
  const at = bottom + w * rising;
  const x = (pull / w) * (Math.asinh(at / pull) - Math.asinh(bottom / pull)) + (pull * rising) / stiffness;
  const z = (Math.hypot(pull, at) - Math.hypot(pull, bottom)) / w + ((at ** 2 - bottom ** 2) / (2 * w)) / stiffness;
  return { x: x + lying * (1 + pull / stiffness), z };
}

/** Of a flat parabola that is longer than its chord d by e the sag is sqrt(3/8 d e). */
function slackened({ unstretched_length_m }: LineInfo, first: Vec3, second: Vec3, shares: number[]): Vec3[] {
  const way = [0, 1, 2].map((k) => second[k] - first[k]);
  const distance = Math.hypot(...way);
  const sag = Math.sqrt(0.375 * distance * Math.max(0, unstretched_length_m - distance));
  return shares.map((share): Vec3 => [
    first[0] + share * way[0],
    first[1] + share * way[1],
    first[2] + share * way[2] - 4 * share * (1 - share) * sag,
  ]);
}
