//! Fields of a forecast of the heave.

use kingpost_derive::fields;

use super::heave::{longest, noise_share, shortest};
use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{Name, NonNegative, Positive, SetsInputs, yes};

/// Predicts the heave of a point, such as the crane's tip, for the next seconds, from the past motion that a sensor measures. A
/// step of an operation waits for a lull with it. Its outputs are `predicted_heave`, `predicted_heave_error` and
/// `predicted_heave_bound` (m) and `forecast_ready`. It sets no input.
#[fields]
pub struct HeaveForecast<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body of the point.
    pub body: Name,
    /// The point, in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// The motion reference unit or inertial unit that measures the motion.
    pub sensor: Name,
    /// Time between two samples, s; at least simulation.step_s.
    pub period_s: Positive,
    /// How far ahead it predicts, s.
    #[serde(default = "horizon")]
    pub horizon_s: Positive,
    /// Peak period of the heave, s, mostly that of the waves: the filters suit a JONSWAP spectrum with it. Without it, they suit a
    /// heave that is spread evenly over its periods, which is foreseen for a shorter time.
    pub peak_period_s: Option<Positive>,
    /// Shortest period of the heave, s; at least four times period_s. The filters amplify heave of other periods.
    #[serde(default = "shortest")]
    pub shortest_period_s: Positive,
    /// Longest period, s; longer than the shortest.
    #[serde(default = "longest")]
    pub longest_period_s: Positive,
    /// Standard deviation of the noise in a measured velocity over that of the velocity.
    #[serde(default = "noise_share")]
    pub noise_share: Positive,
    /// Standard deviations of its error that the bound adds to the predicted heave.
    #[serde(default = "margin::<S>")]
    pub margin: NonNegative<S>,
}

fn horizon() -> Positive {
    Positive::literal(20.0)
}

fn margin<S: Leaf>() -> NonNegative<S> {
    NonNegative::literal(2.0)
}

impl<S> SetsInputs for HeaveForecast<S> {
    fn targets(&self) -> Vec<(String, &str)> {
        Vec::new()
    }
}
