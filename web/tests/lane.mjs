// Which tests run: by default one proof of each kind; with KINGPOST_LANE=thorough every case of an enumeration.
export const isThorough = process.env.KINGPOST_LANE === "thorough";

/**
 * Scenarios of the gallery that stand for their kinds of craft: a ship of the paper, a crane on a vessel at sea, a crane of many bodies,
 * two hulls, no ship at all, a device that is no crane.
 */
export const KINDS = ["paper", "offshore_vessel", "vessel_knuckle_boom", "lift_off_from_barge", "chain", "gyro_wave_energy"];

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
