/**
 * Returns a name for each input that a person reads: that of the input alone, unless two inputs would then have the same
 * name; then with its first element, and if that does not tell them apart, the whole name. "learned.choice.policy.slewing"
 * is "slewing", or "slewing (learned)" beside "regulator.choice.lqr.slewing".
 */
export function namesOf(inputs: readonly { name: string }[]): Map<string, string> {
  const parts = inputs.map(({ name }) => name.split("."));
  const read = (words: string) => words.replaceAll(/[._]/g, " ");
  const short = (of: string[]) => of.at(-1)!;
  const withFirst = (of: string[]) => (of.length > 1 ? `${of.at(-1)} (${of[0]})` : of[0]);
  const isOne = (of: string[], name: (of: string[]) => string) => parts.every((other) => other === of || name(other) !== name(of));
  const nameOf = (of: string[]) => [short, withFirst].find((name) => isOne(of, name))?.(of) ?? of.join(".");
  return new Map(parts.map((of) => [of.join("."), read(nameOf(of))]));
}
