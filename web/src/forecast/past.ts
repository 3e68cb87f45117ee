import type { Recording } from "../app/recording/recording";
import type { Columns } from "../engine/columns";
import type { ModelInfo } from "../engine/engine";
import type { Past } from "./messages";

/** Length of the wave record that a forecast uses, s, and its largest number of samples. */
export const PAST_S = 120;
const SAMPLES = 240;

/**
 * Returns the times and positions of a wave sensor before a moment; it is on the longest hull, or on the first body if
 * there is no hull.
 */
export function pastOf({ hulls, bodies }: ModelInfo, columns: Columns, { rows }: Recording, now_s: number): Past {
  const longest = hulls.length > 0 ? hulls.reduce((a, b) => (b.length_m > a.length_m ? b : a)).body : bodies[0].name;
  const [x, y] = ["x", "y"].map((axis) => columns.at(`${longest}.position.${axis}`));
  const [first, last] = [now_s - PAST_S, now_s].map((time_s) => rows.indexAt(time_s));
  const recorded = rows.items.slice(Math.max(0, first), last + 1);
  const every = Math.max(1, Math.ceil(recorded.length / SAMPLES));
  // The samples are counted back from the newest one, which determines the near future most.
  const taken = recorded.filter((_, i) => (recorded.length - 1 - i) % every === 0);
  return {
    time_s: Float64Array.from(taken, ({ time_s }) => time_s),
    x_m: Float64Array.from(taken, ({ row }) => row[x]),
    y_m: Float64Array.from(taken, ({ row }) => row[y]),
  };
}
