import { texts } from "../texts";

/** A label of a limit in a chart, at a height in pixels. */
export interface BoundLabel {
  name: string;
  y: number;
}

/** Joins labels that would be printed over each other into one that names the first and counts the others. */
export function joined(labels: readonly BoundLabel[], least_px: number): BoundLabel[] {
  const groups: { y: number; names: string[] }[] = [];
  for (const { name, y } of [...labels].sort((a, b) => a.y - b.y)) {
    const last = groups.at(-1);
    if (!last || y - last.y >= least_px) groups.push({ y, names: [name] });
    else if (!last.names.includes(name)) last.names.push(name);
  }
  return groups.map(({ y, names: [first, ...others] }) => ({ y, name: others.length > 0 ? `${first} ${texts.scrubber.more(others.length)}` : first }));
}
