//! Reason why a column of the results is not proportional to small waves.

use serde::Serialize;

/// Reason why a column is not proportional to small waves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum NotLinear {
    /// Its derivative at rest does not exist, or differs between both directions.
    NotSmooth,
    /// Near rest it changes with the square of the motions, or of the waves.
    SecondOrder,
    /// It is an integral over the run, or the time.
    OverTime,
    /// It is constant between the samples of its element.
    Sampled,
}
