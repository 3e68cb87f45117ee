// Which tests run: by default one proof of each kind; with KINGPOST_LANE=thorough every case of an enumeration.
export const isThorough = process.env.KINGPOST_LANE === "thorough";

/** How many cases the default lane has left out so far, in this process. */
export let leftOut = 0;

/** Tests by their names, for the thorough lane alone. */
export function thorough(tests) {
  if (isThorough) return tests;
  leftOut += Object.keys(tests).length;
  return {};
}

/** All cases of an enumeration; by default those that stand for their kind. */
export function cases(all, isTypical) {
  const chosen = isThorough ? all : all.filter(isTypical);
  if (chosen.length === 0) throw new Error("no case stands for the enumeration");
  leftOut += all.length - chosen.length;
  return chosen;
}
