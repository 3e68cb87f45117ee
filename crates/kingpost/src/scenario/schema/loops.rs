//! Closed loops: constraints between two bodies in addition to their joints.

use kingpost_derive::fields;

use super::{Name, NonNegative, Positive, yes};
use crate::elements::connection::fields::Connection;
use crate::scenario::leaf::Leaf;

/// A joint that closes a loop, written as constraints between the two bodies that it connects. Give only constraints
/// that the other joints do not already impose: a four-bar linkage in the x-z plane needs x and z.
#[fields]
pub struct Loop<S = f64> {
    /// Whether the loop holds.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The attachment to one body. Constraints are along and about these axes.
    pub first: Attachment<S>,
    /// The attachment to the other body.
    pub second: Attachment<S>,
    /// The constraints, in any order; none may follow from the others.
    pub constraints: Vec<Constraint<S>>,
    /// The largest gap at the start, m, and rad for angles. A smaller gap is closed by the smallest mass-weighted
    /// motion of the free joints; a larger one is an error.
    #[serde(default = "start_gap")]
    pub start_gap_m: NonNegative,
    /// Lets an input release the loop and engage it again; without it, the loop always holds.
    pub connection: Option<Connection<S>>,
}

/// The default of `start_gap_m`.
fn start_gap() -> NonNegative {
    NonNegative::literal(0.1)
}

/// A point with axes on a body, or in the world.
#[fields]
pub struct Attachment<S = f64> {
    /// The body, or `world`.
    pub body: Name,
    /// The point in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Orientation of the axes in the body's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
    #[serde(default)]
    pub orientation_rad: [S; 3],
}

/// One equation between the two attachments.
#[fields]
#[derive(Copy)]
pub enum Constraint<S = f64> {
    /// The second stays at x = 0 in the axes of the first.
    X,
    /// The second stays at y = 0 in the axes of the first.
    Y,
    /// The second stays at z = 0 in the axes of the first.
    Z,
    /// The second does not turn about x of the first.
    Roll,
    /// The second does not turn about y of the first.
    Pitch,
    /// The second does not turn about z of the first.
    Yaw,
    /// The second stays at a distance from the first, as on a massless rod.
    Distance(Distance<S>),
}

/// A distance to keep.
#[fields]
#[derive(Copy)]
pub struct Distance<S = f64> {
    /// Length of the rod, m.
    pub length_m: Positive<S>,
}

impl<S: Leaf> Attachment<S> {
    /// The body; `None` for the world.
    pub fn named_body(&self) -> Option<&Name> {
        (self.body != super::WORLD).then_some(&self.body)
    }
}

impl<S: Leaf> Constraint<S> {
    /// Its name in the file.
    pub fn name(&self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
            Self::Roll => "roll",
            Self::Pitch => "pitch",
            Self::Yaw => "yaw",
            Self::Distance(_) => "distance",
        }
    }
}
