//! Gangways between two vessels.

use kingpost_derive::fields;

use crate::scenario::schema::{Pin, Positive, yes};

/// A telescopic gangway from its pedestal on one body to its landing point on another: stroke, luff and slew in the results, and
/// a warning when the run leaves its operating range. It exerts no force: its own weight and actuators are left out.
#[fields]
pub struct Gangway<S = f64> {
    /// Whether the gangway is measured.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The point of the pedestal about which the gangway slews and luffs.
    pub pedestal: Pin<S>,
    /// The point on which its tip lands.
    pub landing: Pin<S>,
    /// Direction of the gangway at slew 0 in the axes of the pedestal's body: angle from its x axis to its y axis, rad.
    #[serde(default)]
    pub heading_rad: S,
    /// Length from the pedestal to the tip at stroke 0, m.
    pub length_m: Positive<S>,
    /// Smallest and largest stroke of the telescope, m; negative when it is shorter than `length_m`.
    pub stroke_limits_m: [S; 2],
    /// Smallest and largest luff angle, up from the plane of the pedestal's x and y axes, rad.
    pub luff_limits_rad: [S; 2],
    /// Smallest and largest slew angle from `heading_rad`, counter-clockwise, rad.
    pub slew_limits_rad: [S; 2],
}
