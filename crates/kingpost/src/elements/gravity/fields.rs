//! Fields of gravity.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::NonNegative;

/// Weight of every body, downwards along the world's z axis.
#[fields(default)]
pub struct Gravity<S = f64> {
    /// Whether the element acts.
    pub enabled: bool,
    /// Acceleration of free fall, m/s^2.
    pub acceleration_m_s2: NonNegative<S>,
}

impl<S: Leaf> Default for Gravity<S> {
    fn default() -> Self {
        Self { enabled: true, acceleration_m_s2: NonNegative::literal(9.80665) }
    }
}
