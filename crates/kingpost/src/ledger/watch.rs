//! Warning of a run whose energy does not balance.

use crate::elements::{Exceeded, Extreme, Warning, Watcher, significant};

/// Largest allowed energy error, as a share of the energy in play: a larger error means that the steps were
/// too long or the equations are wrong. In the gallery's runs it is at most 1e-5.
const SHARE: f64 = 1e-3;
/// Rounding error of the potential energy, as a share of it: about a thousand operations, each with an error
/// in the last digit. The zero of the potential energy is arbitrary, so it is used only for this share.
const ROUNDING: f64 = 1e-12;
/// Largest negligible energy error, as the height, m, by which it would lift all moving bodies: it matters
/// while little has moved. For comparison: a loaded rope of 1 cm stretches by this length.
const HEIGHT_M: f64 = 1e-5;

/// Compares the energy error of a run with the largest energy in play so far.
#[derive(Clone, Debug)]
pub struct EnergyBalance {
    weight_n: f64,
    error: Extreme,
    scale: Extreme,
    potential: Extreme,
}

impl EnergyBalance {
    /// Creates the check for moving bodies with this total weight, N; 0 without gravity.
    pub fn new(weight_n: f64) -> Self {
        let (error, scale, potential) = Default::default();
        Self { weight_n, error, scale, potential }
    }
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
        if error <= SHARE * scale || error <= ROUNDING * potential + HEIGHT_M * self.weight_n {
            return Vec::new();
        }
        let text = format!(
            "is off its balance by {} kJ, {} % of the energy in play, {} kJ: the steps are too long for this motion; \
             do not use the results, try half of simulation.step_s",
            significant(error / 1e3, 3),
            significant(100.0 * error / scale, 3),
            significant(scale / 1e3, 3),
        );
        let numbers = Exceeded { value: self.error.value, bound: SHARE * scale, unit: "J" };
        vec![Warning::exceeded("energy_off_balance", self.error.time_s, "energy", numbers, text)]
    }
}
