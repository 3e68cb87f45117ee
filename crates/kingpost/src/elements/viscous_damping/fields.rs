//! Fields of viscous damping, and the reference of both dampings.

use kingpost_derive::fields;

use crate::scenario::schema::{Name, NonNegative, yes};

/// Reference against which the velocity is measured in a sea with a current.
#[fields]
#[derive(Copy, Default, Eq)]
pub enum DampedAgainst {
    /// The water at its surface: for friction and eddies of the hull.
    #[default]
    Water,
    /// The earth: for the damping of a moored ship by chains on the seabed and by slow drift in waves. This damping
    /// transfers no force from a current.
    Earth,
}

/// Linear damping: a force against a body's velocity and a moment against its angular velocity, in body axes.
#[fields]
pub struct ViscousDamping<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// Reference against which the velocity is measured.
    #[serde(default)]
    pub relative_to: DampedAgainst,
    /// The point where the force acts and whose velocity is used, in the body's drawing frame, m; without it, the
    /// centre of mass.
    pub position_m: Option<[S; 3]>,
    /// Force per velocity of the point along x, y, z of the body, N s/m.
    #[serde(default)]
    pub linear_n_s_m: [NonNegative<S>; 3],
    /// Moment per roll, pitch, yaw rate, N m s.
    #[serde(default)]
    pub angular_n_m_s: [NonNegative<S>; 3],
    /// A full matrix, added to the two above: rows of force x, y, z (N) and moment x, y, z (N m), columns of velocity
    /// x, y, z (m/s) and roll, pitch, yaw rate (rad/s). The matrix must not add energy to any motion.
    pub matrix: Option<Box<[[S; 6]; 6]>>,
}
