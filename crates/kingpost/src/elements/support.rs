//! Supports of bodies at rest by an element: it may carry a body, tie it, or keep it in place or afloat.

use crate::model::Attachment;
use crate::spatial::Vector3;

/// A pair of bodies; `None` is the world.
pub type BodyPair = [Option<usize>; 2];

/// A support that does not depend on the positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Support {
    /// One of the two bodies may carry the other.
    Carries(BodyPair),
    /// One of the two bodies may hold the other in surge, sway and yaw.
    Station(BodyPair),
    /// The water keeps the floating body afloat. If that body lies on its side at rest, it has capsized.
    Afloat(usize),
    /// The coordinate does not swing freely: a brake, a drive.
    Coordinate(usize),
    /// The coordinate does not swing freely: a spring pulls it back.
    Spring(usize),
    /// The body does not hang freely: a cylinder, a mooring line.
    Tie(usize),
}

impl Support {
    /// Returns the pair of bodies of which one may carry the other.
    pub fn carries(&self) -> Option<BodyPair> {
        if let Self::Carries(pair) = self { Some(*pair) } else { None }
    }

    /// Returns the pair of bodies of which one may hold the other in place.
    pub fn station(&self) -> Option<BodyPair> {
        if let Self::Station(pair) = self { Some(*pair) } else { None }
    }

    /// Returns the coordinate that a spring pulls back.
    pub fn spring(&self) -> Option<usize> {
        if let Self::Spring(coordinate) = self { Some(*coordinate) } else { None }
    }

    /// Returns the body that the water keeps afloat.
    pub fn afloat(&self) -> Option<usize> {
        if let Self::Afloat(body) = self { Some(*body) } else { None }
    }
}

/// A support in the present positions.
#[derive(Clone, Debug)]
pub enum PresentSupport<S = f64> {
    /// A line that pulls between its ends; a load may hang on it.
    Line([Attachment<S>; 2]),
    /// The two bodies touch.
    Contact(BodyPair),
    /// The water that a lifted object displaces.
    Displaced {
        /// The body of the object.
        body: usize,
        /// Mass of the water, kg.
        mass: S,
        /// Its centre in the world, m.
        centre: Vector3<S>,
    },
}
