/** Texts of the section "What is this?"; text between double asterisks is bold. */
export const about = {
  title: "What is this?",
  acts: "Forces and drives",
  off: (element: string) => `${element}, off`,
  recording: "The recording",
  recording_text:
    "The track under the picture covers everything computed since the start. Drag it, or use its arrow keys, to see any moment again. " +
    "Start, Step or a lever continues the run from there, and everything later is dropped. Export, beside the plots, saves the recording as a file.",
  reading: "How to read it",
  signs:
    "Signs: **roll** is positive with the port side up, **pitch** with the bow down, **yaw** with the bow to port. Rates are about the " +
    "body's own axes. x is forward, y to port, z up.",
  afloat:
    "Afloat: **heel** is roll, positive to starboard; **trim** is pitch, positive by the bow; the draught is that of the hull's origin " +
    "below still water. **Fluid GM** is the metacentric height for heel, at rest with the crane as it stood when the run began or was " +
    "paused, with hanging loads at their suspension points and reduced by slack tanks. The sea in the picture is the incident wave " +
    "that the hull feels; waves that the hull radiates or diffracts are not drawn, and far away the sea is drawn level.",
  picture:
    "The picture: a hull with a bow is drawn as a ship, a long and slim body on a column as its boom; each has the size of the model's " +
    "solid. Their equipment (house, cab, rails, stays, brackets) has no weight and no wind load in the model. **Plain shapes** under " +
    "Show hides it.",
  errors:
    "Energy error: energy gained less the work done, over the largest kinetic energy or work so far; in J while that is " +
    "too small to compare with (less than a thousand rounding errors of the potential energy), as for a ship at rest. Momentum error: angular momentum less its impulse, " +
    "over the largest so far. Both should be tiny, and one alone proves little: leave the method's D matrix out (under Advanced), and " +
    "the energy still balances, but the momentum is wrong at once.",
};
