//! Forces: what acts on the bodies from outside.

use serde::{Deserialize, Serialize};

use super::{Hydrodynamics, Name, NonNegative, yes};

/// What acts on the bodies from outside.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Force {
    /// Weight, downwards along the world's z axis.
    Gravity(Gravity),
    /// Damping proportional to a body's own rates.
    ViscousDamping(ViscousDamping),
    /// The water on a hull.
    Hydrodynamics(Hydrodynamics),
}

/// Weight of every body, downwards along the world's z axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Gravity {
    /// Whether it acts.
    pub enabled: bool,
    /// Acceleration of free fall, m/s^2.
    pub acceleration_m_s2: NonNegative,
}

impl Default for Gravity {
    fn default() -> Self {
        Self { enabled: true, acceleration_m_s2: NonNegative::literal(9.80665) }
    }
}

/// A force and a moment against a body's velocity and angular velocity, each in body axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ViscousDamping {
    /// Whether it acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// Force per velocity of the centre of mass along x, y, z of the body, N s/m.
    #[serde(default, rename = "linear_N_s_m")]
    pub linear_n_s_m: [NonNegative; 3],
    /// Moment per roll, pitch, yaw rate, N m s.
    #[serde(default, rename = "angular_N_m_s")]
    pub angular_n_m_s: [NonNegative; 3],
}
