//! The sea that a plant is in.

use super::Plant;
use crate::scalar::Scalar;

impl<S: Scalar> Plant<S> {
    /// Another sea of the same frequencies and directions, for the exact derivatives too.
    pub fn set_waves(&mut self, amplitudes_m: &[f64], phases_rad: &[f64]) {
        let constant = |numbers: &[f64]| numbers.iter().map(|number| S::constant(*number)).collect::<Vec<S>>();
        if let Some(waves) = &mut self.world.waves {
            waves.set_realisation(&constant(amplitudes_m), &constant(phases_rad));
        }
        if let Some(exact) = &mut self.exact {
            exact.tangent.set_waves(amplitudes_m, phases_rad);
        }
    }

    /// Whether an element keeps the waves as they were when it was made.
    pub fn keeps_waves(&self) -> bool {
        self.elements.iter().any(|element| element.keeps_waves())
    }
}
