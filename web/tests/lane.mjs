// Which tests run: by default one proof of each kind; with KINGPOST_LANE=thorough every case of an enumeration.
export const isThorough = process.env.KINGPOST_LANE === "thorough";

/**
 * Scenarios of the gallery that represent kinds of craft: the paper's ship, a crane on a vessel at sea, a crane with
 * many bodies, two hulls, a scenario without a ship, and a device that is not a crane.
 */
export const KINDS = ["paper", "offshore_vessel", "vessel_knuckle_boom", "lift_off_from_barge", "chain", "gyro_wave_energy"];

/** Number of cases that the default lane has left out so far, in this process. */
export let leftOut = 0;

/** Returns tests by their names in the thorough lane, and none in the default lane. */
export function thorough(tests) {
  if (isThorough) return tests;
  leftOut += Object.keys(tests).length;
  return {};
}

/** Returns all cases of an enumeration; in the default lane only those that represent their kind. */
export function cases(all, isTypical) {
  const chosen = isThorough ? all : all.filter(isTypical);
  if (chosen.length === 0) throw new Error("no case stands for the enumeration");
  leftOut += all.length - chosen.length;
  return chosen;
}
