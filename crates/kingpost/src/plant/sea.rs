//! Sea in which a plant moves.

use super::Plant;
use crate::scalar::Scalar;

impl<S: Scalar> Plant<S> {
    /// Replaces the amplitudes and phases of the waves, also for the exact derivatives.
    pub fn set_waves(&mut self, amplitudes_m: &[f64], phases_rad: &[f64]) {
        let constant = |numbers: &[f64]| numbers.iter().map(|number| S::constant(*number)).collect::<Vec<S>>();
        if let Some(waves) = &mut self.world.waves {
            waves.set_realisation(&constant(amplitudes_m), &constant(phases_rad));
        }
        if let Some(exact) = &mut self.exact {
            exact.tangent.set_waves(amplitudes_m, phases_rad);
        }
    }

    /// Returns whether an element depends on the waves with which it was built.
    pub fn keeps_waves(&self) -> bool {
        self.elements.iter().any(|element| element.given_positions(&self.world, 0.0).is_some())
    }
}
