//! The reference of a damped velocity.

use crate::scalar::Scalar;
use crate::spatial::Vector3;
use crate::world::World;

/// The medium relative to which a damped velocity is measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DampedAgainst {
    /// The water at its surface, which moves with the current: friction and eddies of a hull.
    #[default]
    Water,
    /// The earth: damping of a moored ship by chains on the seabed and by slow drift in waves.
    Earth,
}

impl DampedAgainst {
    /// Returns the velocity of the medium, world, m/s.
    pub fn velocity<S: Scalar>(self, world: &World<S>) -> Vector3<S> {
        match self {
            Self::Water => world.surface_current(),
            Self::Earth => Vector3::zero(),
        }
    }
}
