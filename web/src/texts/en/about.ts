/** What the fold "What is this?" says; what stands between double asterisks is strong. */
export const about = {
  title: "What is this?",
  acts: "What acts",
  off: (element: string) => `${element}, off`,
  recording: "The recording",
  recording_text:
    "The track under the picture has all that was computed since the start. Drag it, or use its arrow keys, to see any moment again. " +
    "From there the run goes on with Start, with Step or with a lever, and what came after is dropped. Export, beside the plots, keeps it as a file.",
  reading: "How to read it",
  signs:
    "Signs: **roll** is positive with the port side up, **pitch** with the bow down, **yaw** with the bow to port. Rates are about the " +
    "body's own axes. x is forward, y to port, z up.",
  afloat:
    "Afloat: **heel** is roll, positive to starboard; **trim** is pitch, positive by the bow; the draught is that of the hull's origin " +
    "below still water. **Fluid GM** is the metacentric height for heel, at rest with the crane as it stood when the run began or was " +
    "paused, with hanging loads at their suspension points and reduced by slack tanks. The sea in the picture is the incident wave " +
    "that the hull feels; the waves that the hull makes or turns back are not drawn, and far off the sea is drawn level.",
  picture:
    "The picture: a hull with a bow is drawn as a ship, a long and slim body on a column as its boom; each is as large as the model's " +
    "solid. What stands on them (house, cab, rails, stays, brackets) has no weight and no wind in the model. **Plain shapes** under " +
    "Show leaves it out.",
  errors:
    "Energy error: energy gained less the work done, over the largest energy in play so far, of motion and of work; in J while that is " +
    "less than a thousand roundings of the potential energy, as of a ship at rest. Momentum error: angular momentum less its impulse, " +
    "over the largest so far. Both should be tiny, and one alone proves little: leave the method's D matrix out (under Advanced), and " +
    "the energy still closes while the momentum goes wrong at once.",
};
