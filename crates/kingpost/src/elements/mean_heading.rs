//! Warns of a ship in waves whose mean heading changes from the initial one.

use super::HOLD_IT;
use super::watcher::{Exceeded, Extreme, Warning, Watcher, significant};
use core::f64::consts::{PI, TAU};

/// Largest change of the mean heading from the start, degrees.
const LARGEST_TURN_DEG: f64 = 5.0;
/// Time constant of the running average, s: it reduces yaw in waves of 15 s to 2 %, and follows a slow turn within two
/// minutes.
const TIME_CONSTANT_S: f64 = 100.0;

/// Watches the mean heading m of a body in waves, `m' = (psi - m) / T` with the yaw psi without jumps at full turns. In
/// linear theory no moment restores the heading of a free ship, and a ship that has turned meets waves from an
/// unintended direction.
///
/// ```
/// use kingpost::elements::{MeanHeading, Watcher};
/// let mut heading = MeanHeading::new("hull");
/// (0..3600).for_each(|second| heading.see(f64::from(second), &[0.0001 * f64::from(second)]));
/// assert!(heading.warnings()[0].text.starts_with("its mean heading turned by 20.05 deg until 3599 s"));
/// ```
#[derive(Clone, Debug)]
pub struct MeanHeading {
    body: String,
    /// Yaw without jumps and its mean, rad, and their time, s.
    last: Option<[f64; 3]>,
    start_rad: f64,
    turn_deg: Extreme,
    beyond_s: Option<f64>,
}

impl MeanHeading {
    /// Returns the watcher of this body.
    pub fn new(body: &str) -> Self {
        let (last, start_rad, turn_deg, beyond_s) = (None, 0.0, Extreme::default(), None);
        Self { body: body.to_owned(), last, start_rad, turn_deg, beyond_s }
    }
}

impl Watcher for MeanHeading {
    fn columns(&self) -> Vec<String> {
        vec![format!("{}.yaw", self.body)]
    }

    /// Updates the mean heading; yaw is taken as constant between two rows.
    fn see(&mut self, time_s: f64, values: &[f64]) {
        let Some([before, mean, then_s]) = self.last else {
            (self.start_rad, self.last) = (values[0], Some([values[0], values[0], time_s]));
            return;
        };
        let step = values[0] - before;
        let yaw = before + step - TAU * libm::floor((step + PI) / TAU);
        let mean = mean - (yaw - mean) * libm::expm1(-(time_s - then_s) / TIME_CONSTANT_S);
        self.last = Some([yaw, mean, time_s]);
        let turn_deg = (mean - self.start_rad).to_degrees();
        self.turn_deg.see(time_s, turn_deg);
        if turn_deg.abs() > LARGEST_TURN_DEG {
            self.beyond_s = self.beyond_s.or(Some(time_s));
        }
    }

    fn warnings(&self) -> Vec<Warning> {
        let Extreme { value, time_s } = self.turn_deg;
        let warning = |beyond_s: f64| {
            let text = format!(
                "its mean heading turned by {value:.2} deg until {} s, beyond {LARGEST_TURN_DEG} deg first at {} s: the loads \
                 of the waves were those at the heading of each time; to keep the heading, {HOLD_IT}",
                significant(time_s, 6),
                significant(beyond_s, 6)
            );
            let numbers = Exceeded { value, bound: LARGEST_TURN_DEG, unit: "deg" };
            Warning::exceeded("heading_turned", beyond_s, &self.body, numbers, text)
        };
        self.beyond_s.map(warning).into_iter().collect()
    }
}
