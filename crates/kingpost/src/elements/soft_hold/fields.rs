//! A soft hold: it keeps a ship near its position without a model of the mooring.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{Name, NonNegative, Positive, StationTarget, yes};

/// Springs and dampers in surge, sway and yaw that keep a ship near its position, like soft springs in a wave basin.
/// They have no force in heave and no moment in roll and pitch. They act at the centre of mass, in the initial
/// position, of the ship with all that it carries, so that they do not excite roll.
///
/// Stiffness is `m (2 pi / T)^2`, damping `2 zeta m 2 pi / T` where m is the mass of the ship with all that it carries
/// (for yaw the moment of inertia) plus the added mass at zero frequency.
#[fields]
pub struct SoftHold<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The ship; its joint is floating.
    pub body: Name,
    /// T of surge, sway and yaw, s. At ten times the longest wave period of interest, the springs do not affect the
    /// wave-frequency motions.
    #[serde(default = "natural_periods::<S>")]
    pub natural_periods_s: [Positive<S>; 3],
    /// zeta of surge, sway and yaw: damping over critical damping.
    #[serde(default = "damping_ratios::<S>")]
    pub damping_ratios: [NonNegative<S>; 3],
    /// Position at which the origin of the body's drawing frame is held, and the heading; without it, those at the
    /// start.
    #[placed(Station)]
    pub target: Option<StationTarget<S>>,
}

/// The default of `natural_periods_s`: it changes surge, sway and yaw in waves of 12 s by 1 %.
fn natural_periods<S: Leaf>() -> [Positive<S>; 3] {
    [120.0; 3].map(Positive::literal)
}

/// The default of `damping_ratios`: a motion decays to a quarter in one period, and surge, sway and yaw in waves of 12
/// s change by 0.1 %.
fn damping_ratios<S: Leaf>() -> [NonNegative<S>; 3] {
    [0.2; 3].map(NonNegative::literal)
}
