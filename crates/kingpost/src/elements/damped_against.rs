//! The reference of a damped velocity.

use crate::scalar::Scalar;
use crate::spatial::Vector3;
use crate::world::World;

/// The medium relative to which a damped velocity is measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DampedAgainst {
    /// The water at its surface, which a current moves: a hull's own friction and eddies.
    #[default]
    Water,
    /// The earth: what chains on the seabed and the slow drift in waves take from a moored ship.
    Earth,
}

impl DampedAgainst {
    /// Its velocity, world, m/s.
    pub fn velocity<S: Scalar>(self, world: &World<S>) -> Vector3<S> {
        match self {
            Self::Water => world.surface_current(),
            Self::Earth => Vector3::zero(),
        }
    }
}
