//! What warns of a run whose energy does not balance.

use crate::elements::{Extreme, Warning, Watcher, significant};

/// Of the energy in play: a run that is off by more was stepped too coarsely, or its equations are wrong. The gallery's runs
/// are off by 1e-5 of it at most.
const SHARE: f64 = 1e-3;
/// Of the potential energy, whose zero is a choice: a difference below it is rounding, or too small to matter while little has
/// moved yet.
const SHARE_OF_POTENTIAL: f64 = 1e-6;

/// Sees how far the energy of a run is off its balance, beside the energy in play so far.
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
