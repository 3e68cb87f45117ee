//! Fields of quadratic damping.

use crate::elements::viscous_damping::fields::DampedAgainst;
use kingpost_derive::fields;

use crate::scenario::schema::{Name, NonNegative, yes};

/// A force -c |v| v and a moment -c |omega| omega, component by component in body axes.
#[fields]
pub struct QuadraticDamping<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// Reference against which the velocity is measured.
    #[serde(default)]
    pub relative_to: DampedAgainst,
    /// The point where the force acts and whose velocity is used, in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Force per square of velocity along x, y, z of the body, N s^2/m^2.
    #[serde(default)]
    pub linear_n_s2_m2: [NonNegative<S>; 3],
    /// Moment per square of the roll, pitch, yaw rate, N m s^2.
    #[serde(default)]
    pub angular_n_m_s2: [NonNegative<S>; 3],
}
