//! Tanks with a free surface.

use serde::{Deserialize, Serialize};

use super::{Fraction, Name, Positive, yes};
use crate::scenario::leaf::Leaf;

/// The free surface of a liquid in a box whose sides are along the body's axes. The liquid is part of the body: of its
/// `mass_kg`, `centre_of_mass_m` and inertia, as if it were frozen with the body upright; this adds what its surface,
/// level at once, moves. So its natural period in the tank must be well below the body's in roll and pitch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "SlackTank", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct SlackTank<S = f64> {
    /// Whether the surface is free; if not, the liquid stays as if it were frozen.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// Centre of the box in the body's drawing frame, m. A free surface turns the body by the same moment wherever it is.
    pub position_m: [S; 3],
    /// Along the body's x axis, inside, m.
    pub length_m: Positive<S>,
    /// Along the body's y axis, inside, m.
    pub breadth_m: Positive<S>,
    /// Along the body's z axis, inside, m.
    pub height_m: Positive<S>,
    /// Share of the volume that is liquid. An empty tank, 0, and a full one, 1, have no free surface.
    pub filling: Fraction<S>,
    /// Density of the liquid, kg/m^3; without it, that of the sea.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub density_kg_m3: Option<Positive<S>>,
}
