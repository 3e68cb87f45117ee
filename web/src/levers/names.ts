/**
 * Returns a name for each input that a person reads: without the elements to which it belongs, unless two inputs would
 * then have the same name. "learned.choice.policy.slewing" is "slewing", or "policy slewing" beside "lqr.slewing".
 */
export function namesOf(inputs: readonly { name: string }[]): Map<string, string> {
  const parts = inputs.map(({ name }) => name.split("."));
  const ending = (of: string[], length: number) => of.slice(-length).join(".");
  const shortest = (of: string[]) => {
    let length = 1;
    while (length < of.length && parts.some((other) => other !== of && ending(other, length) === ending(of, length))) length += 1;
    return ending(of, length);
  };
  return new Map(parts.map((of) => [of.join("."), shortest(of).replaceAll(/[._]/g, " ")]));
}
