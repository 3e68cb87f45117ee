//! Warns of a hull whose mean attitude differs from the attitude of its coefficients.

use crate::elements::watcher::{Exceeded, Warning, Watcher};
use crate::sea::database::Attitude;

/// Difference in heel or trim from the coefficients' attitude beyond which a run warns, degrees.
pub const LARGEST_LIST_DEG: f64 = 3.0;

/// Watches the mean heel and trim of a hull with linear hydrodynamics: added mass, damping and excitation are valid for
/// one attitude, with any hydrostatics.
///
/// ```
/// use kingpost::elements::Watcher;
/// use kingpost::elements::hull::MeanAttitude;
/// let mut watcher = MeanAttitude::new("hull", None);
/// (0..600).for_each(|second| watcher.see(f64::from(second), &[0.08, 0.0]));
/// assert!(watcher.warnings()[0].text.starts_with("its mean heel was 4.58 deg"));
/// ```
#[derive(Clone, Debug)]
pub struct MeanAttitude {
    body: String,
    attitude_rad: [f64; 2],
    rows: u64,
    sums_rad: [f64; 2],
    last_s: f64,
}

impl MeanAttitude {
    /// Returns the watcher of a body; `attitude` is the attitude of its coefficients, `None` if upright.
    pub fn new(body: &str, attitude: Option<Attitude>) -> Self {
        let Attitude { roll_rad, pitch_rad, .. } = attitude.unwrap_or_default();
        Self { body: body.to_owned(), attitude_rad: [roll_rad, pitch_rad], rows: 0, sums_rad: [0.0; 2], last_s: 0.0 }
    }
}

impl Watcher for MeanAttitude {
    fn columns(&self) -> Vec<String> {
        ["roll", "pitch"].map(|column| format!("{}.{column}", self.body)).to_vec()
    }

    fn see(&mut self, time_s: f64, values: &[f64]) {
        self.rows += 1;
        self.last_s = time_s;
        self.sums_rad.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
    }

    fn warnings(&self) -> Vec<Warning> {
        let of = |(k, what, code): (usize, &str, &'static str)| {
            let [mean, data] = [self.sums_rad[k] / self.rows as f64, self.attitude_rad[k]].map(f64::to_degrees);
            let text = || {
                format!(
                    "its mean {what} was {mean:.2} deg, its hydrodynamic coefficients are for {data:.2} deg (warned of beyond \
                     {LARGEST_LIST_DEG} deg): kingpost hydro --attitude-of computes them for a hull that lists"
                )
            };
            let beyond = self.rows > 0 && (mean - data).abs() > LARGEST_LIST_DEG;
            let numbers = Exceeded { value: mean - data, bound: LARGEST_LIST_DEG, unit: "deg" };
            beyond.then(|| Warning::exceeded(code, self.last_s, &self.body, numbers, text()))
        };
        [(0, "heel", "mean_heel_off_data"), (1, "trim", "mean_trim_off_data")].into_iter().filter_map(of).collect()
    }
}
