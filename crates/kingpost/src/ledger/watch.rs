//! Warns of a run whose energy does not balance.

use crate::elements::{Extreme, Warning, Watcher, significant};

/// Largest error as a share of the energy in play: beyond it the steps were too long, or the equations are wrong. In
/// the gallery's runs it is at most 1e-5.
const SHARE: f64 = 1e-3;
/// The same as a share of the potential energy, whose zero is arbitrary: a smaller difference is rounding, or too small
/// to matter while little has moved.
const SHARE_OF_POTENTIAL: f64 = 1e-6;

/// Compares the energy error of a run with the energy in play so far.
#[derive(Clone, Debug, Default)]
pub struct EnergyBalance {
    error: Extreme,
    scale: Extreme,
    potential: Extreme,
}

impl Watcher for EnergyBalance {
    fn columns(&self) -> Vec<String> {
        ["energy_error", "energy_scale", "potential_energy"].map(str::to_owned).to_vec()
    }

    fn see(&mut self, time_s: f64, values: &[f64]) {
        let [error, scale, potential] = values else { return };
        self.error.see(time_s, *error);
        self.scale.see(time_s, *scale);
        self.potential.see(time_s, *potential);
    }

    fn warnings(&self) -> Vec<Warning> {
        let [error, scale, potential] = [self.error, self.scale, self.potential].map(|seen| seen.value.abs());
        if error <= SHARE * scale || error <= SHARE_OF_POTENTIAL * potential {
            return Vec::new();
        }
        let text = format!(
            "is off its balance by {} kJ, {} % of the energy in play, {} kJ: the steps are too long for this motion; \
             the results are not to be trusted, try half of simulation.step_s",
            significant(error / 1e3, 3),
            significant(100.0 * error / scale, 3),
            significant(scale / 1e3, 3),
        );
        vec![Warning { time_s: self.error.time_s, name: "energy".to_owned(), text }]
    }
}
