//! Tanks with a free surface.

use kingpost_derive::fields;

use crate::scenario::schema::{Fraction, Name, Positive, yes};

/// The free surface of a liquid in a box whose sides are along the body's axes. The body's `mass_kg`,
/// `centre_of_mass_m` and inertia must contain the liquid, as if it were frozen with the body upright. This force adds
/// the effect of the liquid's shift. The surface is taken as always level, so the liquid's natural period must be well
/// below the natural periods of the body in roll and pitch.
#[fields]
pub struct SlackTank<S = f64> {
    /// Whether the surface is free; if not, the liquid stays as if it were frozen.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// Centre of the box in the body's drawing frame, m. The moment of a free surface does not depend on this position.
    pub position_m: [S; 3],
    /// Inner length along the body's x axis, m.
    pub length_m: Positive<S>,
    /// Inner breadth along the body's y axis, m.
    pub breadth_m: Positive<S>,
    /// Inner height along the body's z axis, m.
    pub height_m: Positive<S>,
    /// Share of the volume that is liquid. An empty tank, 0, and a full one, 1, have no free surface.
    pub filling: Fraction<S>,
    /// Density of the liquid, kg/m^3; without it, the sea's density.
    pub density_kg_m3: Option<Positive<S>>,
}
