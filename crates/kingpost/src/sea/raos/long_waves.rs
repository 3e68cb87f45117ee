//! Check of the longest waves of a table, in which a ship follows the water's surface: heave is 1, and roll
//! and pitch are the slope of the wave, `k` times its amplitude, across and along the ship.

use super::{MotionResponse, RaoTable};
use core::f64::consts::{FRAC_PI_2, PI};

/// Rotations are in another unit if their ratio to the wave's slope differs by this factor at most from 180 /
/// pi or its inverse.
const NEAR: f64 = 3.0;
const DEGREES: f64 = 180.0 / PI;
/// Heave of a ship, m/m, for which a wave counts as long.
const RIDES: [f64; 2] = [0.75, 1.5];
/// Smallest share of the slope along or across the ship for which a direction is compared: within 60 degrees.
const LEAST_SHARE: f64 = 0.5;

/// Finding that rotations are wrong by about the factor 180 / pi.
#[derive(Clone, Debug, PartialEq)]
pub struct OtherUnit {
    /// Finding, with the numbers.
    pub found: String,
    /// Expected value, and the likely cause.
    pub allowed: String,
    /// Whether there is no other likely cause: both roll and pitch are affected, or pitch is too large.
    pub is_sure: bool,
}

/// Ratio of a rotation to the slope of the longest wave along or across the ship.
struct Ratio {
    mode: &'static str,
    ratio: f64,
    given_rad_m: f64,
    direction_deg: f64,
}

impl RaoTable {
    /// Returns whether roll or pitch in the longest wave, of this wave number 1/m, is in another unit than
    /// the file states; `None` if it is not, or if the longest wave is too short for this check.
    pub fn other_unit(&self, longest_wave_number_per_m: f64) -> Option<OtherUnit> {
        let k = longest_wave_number_per_m;
        let ratios: Vec<Ratio> = [("roll", 3, 0.0), ("pitch", 4, FRAC_PI_2)]
            .into_iter()
            .filter_map(|(mode, index, turn)| self.median_ratio(mode, index, turn, k))
            .collect();
        let is_near = |ratio: f64, factor: f64| (factor / NEAR..=factor * NEAR).contains(&ratio);
        let off = |factor: f64| ratios.iter().filter(move |of| is_near(of.ratio, factor));
        let (large, small) = (off(DEGREES).next(), off(1.0 / DEGREES).next());
        let Ratio { mode, ratio, given_rad_m, direction_deg } = large.or(small)?;
        let is_sure = [DEGREES, 1.0 / DEGREES].iter().any(|factor| off(*factor).count() == 2)
            || off(DEGREES).any(|of| of.mode == "pitch");
        let [said, likely] = if large.is_some() { ["rad", "deg"] } else { ["deg", "rad"] };
        let found = format!(
            "{mode} of {given_rad_m:.3e} rad/m in the longest waves, of {:.4} rad/s going to {direction_deg:.0} deg: {ratio:.3} times \
             the slope of such a wave",
            self.band_rad_s()[0]
        );
        let allowed = format!(
            "about {k:.3e} rad/m ({:.3} deg/m), as a ship has in long waves: are these rotations in {likely} where the file says \
             {said}?",
            k.to_degrees()
        );
        Some(OtherUnit { found, allowed, is_sure })
    }

    /// Returns the median ratio over directions near the transverse axis of the ship (turn 0) or the
    /// longitudinal axis, where heave shows that the wave is long.
    fn median_ratio(&self, mode: &'static str, index: usize, turn: f64, k: f64) -> Option<Ratio> {
        let size = |response: &MotionResponse, mode: usize| libm::hypot(response[mode][0], response[mode][1]);
        let ratio = |(direction, responses): (&f64, &Vec<MotionResponse>)| {
            let (longest, share) = (responses.first()?, libm::sin(direction + turn).abs());
            let is_long = (RIDES[0]..=RIDES[1]).contains(&size(longest, 2)) && share > LEAST_SHARE;
            let given_rad_m = size(longest, index);
            let ratio = given_rad_m / (k * share);
            is_long.then(|| Ratio { mode, ratio, given_rad_m, direction_deg: direction.to_degrees() })
        };
        let mut all: Vec<Ratio> = self.directions_rad.iter().zip(&self.responses).filter_map(ratio).collect();
        all.sort_by(|a, b| a.ratio.total_cmp(&b.ratio));
        let middle = all.len() / 2;
        (middle < all.len()).then(|| all.swap_remove(middle))
    }
}
