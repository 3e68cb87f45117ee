//! Mooring lines and hawsers.

use kingpost_derive::fields;

use crate::scenario::schema::{NonNegative, Pin, Positive, yes};

/// A weightless line between a point on a body and a point on another body or in the world. It pulls like a spring if
/// it is longer than its unstretched length, and never pushes.
#[fields]
pub struct SpringLine<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// One end: a fairlead, for example.
    pub first: Pin<S>,
    /// The other end: a bollard on the `world`, or on another body.
    pub second: Pin<S>,
    /// Length without tension, m.
    pub unstretched_length_m: Positive<S>,
    /// EA: tension per strain, N.
    pub axial_stiffness_n: Positive<S>,
    /// Damping along the line, s/m: a in T = EA/L0 s (1 + a s') at the stretch s; T is never negative.
    #[serde(default)]
    pub dissipation_s_per_m: NonNegative<S>,
}

/// A mooring line from a fairlead to an anchor: quasi-static, an elastic catenary at every moment. It has no inertia,
/// no drag and no seabed friction.
#[fields]
pub struct CatenaryLine<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The upper end, on a body.
    pub fairlead: Pin<S>,
    /// The lower end in the world, m.
    #[placed(Point)]
    pub anchor_m: [S; 3],
    /// Length without tension, m.
    pub unstretched_length_m: Positive<S>,
    /// Weight in water per unstretched length, N/m.
    pub weight_in_water_n_per_m: Positive<S>,
    /// EA: tension per strain, N.
    pub axial_stiffness_n: Positive<S>,
    /// Whether the line can lie on a flat seabed at the anchor's depth; if not, the line hangs freely.
    #[serde(default = "yes")]
    pub seabed: bool,
}
