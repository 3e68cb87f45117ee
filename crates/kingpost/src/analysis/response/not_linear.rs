//! Why a column of the results does not follow small waves in proportion.

use serde::Serialize;

/// Why a column does not follow small waves in proportion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum NotLinear {
    /// It has no slope at rest, or another one to either side.
    NotSmooth,
    /// At rest it changes with the square of the motions, or of the waves.
    SecondOrder,
    /// It is an integral over the run, or its time.
    OverTime,
    /// It is held between the samples of its element.
    Sampled,
}
