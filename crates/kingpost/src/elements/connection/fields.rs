//! Fields of a loop that can be released and engaged.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::Positive;

/// Lets an input with the loop's name release the loop and engage it again, in [0, 1]: it is released from 0.5 up, and to engage
/// below 0.5. It engages at once or as soon as its ends are within the tolerance, with an impact whose energy becomes heat.
#[fields]
pub struct Connection<S = f64> {
    /// Whether it begins released: its input then begins at 1, and its gap at the start is not closed.
    #[serde(default)]
    pub begins_released: bool,
    /// Where it engages.
    #[serde(default)]
    pub engages: Engagement<S>,
}

/// The place where a connection engages.
#[fields]
pub enum Engagement<S = f64> {
    /// Only where its ends fit. A misfit within the tolerance remains while it is engaged.
    Within(MisfitTolerance<S>),
    /// Wherever its ends are, as a lock or a clamp.
    WhereItIs,
}

/// The largest misfit of the ends, along and about the constrained axes.
#[fields(default)]
pub struct MisfitTolerance<S = f64> {
    /// Distance of the second end from the first, m.
    pub distance_m: Positive<S>,
    /// Angle between the two, rad.
    pub angle_rad: Positive<S>,
}

impl<S> Connection<S> {
    /// Whether the gap of the loop at the start is to be closed.
    pub fn begins_closed(&self) -> bool {
        !self.begins_released && !matches!(self.engages, Engagement::WhereItIs)
    }
}

impl<S: Leaf> Default for MisfitTolerance<S> {
    fn default() -> Self {
        Self { distance_m: Positive::literal(0.05), angle_rad: Positive::literal(0.05) }
    }
}

impl<S: Leaf> Default for Engagement<S> {
    fn default() -> Self {
        Self::Within(MisfitTolerance::default())
    }
}
