//! What is outside the model and the same for all that acts on it.
//!
//! Elements and views ask the world at a point and a time; none keeps a sea of its own.

use crate::scalar::Scalar;
use crate::sea::waves::WaveField;

/// The sea around the model.
#[derive(Clone, Debug, Default)]
pub struct World<S = f64> {
    /// The incident waves, realised once; `None` in calm water.
    pub waves: Option<WaveField<S>>,
}

impl<S: Scalar> World<S> {
    /// Calm water.
    pub fn calm() -> Self {
        Self { waves: None }
    }
}

impl World {
    /// Elevation of the incident waves at a time, m, at every crossing of the lines x and y, world, m: along the first x
    /// first; 0 in calm water. Waves that a hull makes or turns back are not in it.
    pub fn elevations_m(&self, x: &[f64], y: &[f64], time_s: f64) -> Vec<f64> {
        match &self.waves {
            Some(waves) => waves.elevations_m(x, y, time_s),
            None => vec![0.0; x.len() * y.len()],
        }
    }
}
