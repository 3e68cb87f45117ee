//! Warnings of effects of a current on waves that the loads on a hull neglect.

use super::floating::LoadedHull;
use crate::elements::hull::{HullVelocity, LowFrequencyFrame, WaveExcitation, WaveForceSwitches};
use crate::sea::waves::{WaveComponent, WaveField, group_velocity_m_s};

/// Largest effect of a current on the wave lengths or the mean drift without a warning, as a share.
const LARGEST_CHANGE: f64 = 0.05;
/// Smallest mean tanh(k h) of the waves for which a deep-water formula is valid.
const LEAST_DEEP: f64 = 0.98;

impl LoadedHull<'_> {
    /// Returns warnings of the wave lengths in a current, of drift without the effect of the current, and of
    /// drift damping in shallow water.
    pub(super) fn current_warnings(&self) -> Vec<String> {
        let (Some(waves), Some(excitation)) = (&self.world.waves, &self.hull.excitation) else { return Vec::new() };
        let body = &self.model.bodies[self.hull.frame.body].name;
        let found = match excitation.drift_parts() {
            [_, true] => [self.length_warning(waves), depth_warning(waves)],
            [true, false] => [self.length_warning(waves), self.drift_warning(waves)],
            [false, false] => [self.length_warning(waves), None],
        };
        found.into_iter().flatten().map(|words| format!("{body}: {words}")).collect()
    }

    fn current(&self) -> [f64; 2] {
        let [x, y, _] = self.world.surface_current().0;
        [x, y]
    }

    /// Returns a warning if the current would change the wave lengths. (w - k.U)^2 = g k tanh(k h) with the
    /// frequency w at a fixed point gives, to first order in U, the relative change of the length: U.e over
    /// the group velocity.
    fn length_warning(&self, waves: &WaveField) -> Option<String> {
        let [x, y] = self.current();
        let longer = |wave: &WaveComponent| {
            let (sin, cos) = libm::sincos(wave.direction_rad);
            (x * cos + y * sin) / group_velocity_m_s(wave.angular_frequency_rad_s, waves.water())
        };
        let mean = of_energy(waves, longer);
        let words = || {
            format!(
                "its wave lengths are those without a current: a current of {:.2} m/s would make them {:.1} % {} \
                 at the same periods, on average (warned of beyond {:.0} %)",
                libm::hypot(x, y),
                100.0 * mean.abs(),
                if mean > 0.0 { "longer" } else { "shorter" },
                100.0 * LARGEST_CHANGE
            )
        };
        (mean.abs() > LARGEST_CHANGE).then(words)
    }

    /// Returns a warning if the current would change the mean drift, by Aranha's formula for a hull at rest
    /// in the current.
    fn drift_warning(&self, waves: &WaveField) -> Option<String> {
        let [x, y] = self.current();
        let slow = LowFrequencyFrame::of(&self.frame());
        let [along, across, _] = slow.rotation().transpose_times(self.world.surface_current()).0;
        let parts = WaveForceSwitches { froude_krylov: true, drift: true, drift_damping: true };
        let mut excitation = WaveExcitation::new(self.database, waves, parts);
        let mut mean = |through_water: [f64; 2]| {
            let velocity = HullVelocity { through_water, over_ground: [0.0; 2] };
            let [surge, sway, ..] = excitation.mean_drift(waves, slow.heading, &velocity);
            [surge, sway]
        };
        let (without, with) = (mean([0.0; 2]), mean([-along, -across]));
        let change = libm::hypot(with[0] - without[0], with[1] - without[1]) / libm::hypot(without[0], without[1]);
        let kn = |force: [f64; 2]| format!("surge {:.1} kN, sway {:.1} kN", force[0] / 1000.0, force[1] / 1000.0);
        let words = || {
            format!(
                "its mean drift in the waves is that without a current, {}; a current of {:.2} m/s changes it to {}, by {:.0} %: \
                 wave_drift_damping: true takes this into account (warned of beyond {:.0} %)",
                kn(without),
                libm::hypot(x, y),
                kn(with),
                100.0 * change,
                100.0 * LARGEST_CHANGE
            )
        };
        (change > LARGEST_CHANGE).then(words)
    }
}

fn depth_warning(waves: &WaveField) -> Option<String> {
    let depth_m = waves.water().depth_m?;
    let mean = of_energy(waves, |wave| libm::tanh(wave.wave_number_per_m * depth_m));
    let words = || {
        format!(
            "its wave_drift_damping uses a formula for deep water, and tanh(k h) of its waves is {mean:.3} on average (warned of \
             below {LEAST_DEEP})"
        )
    };
    (mean < LEAST_DEEP).then(words)
}

/// Returns the mean of a number over the waves, weighted by energy.
fn of_energy(waves: &WaveField, number: impl Fn(&WaveComponent) -> f64) -> f64 {
    let energy = |wave: &WaveComponent| wave.amplitude_m * wave.amplitude_m;
    let all: f64 = waves.components().map(energy).sum();
    waves.components().map(|wave| energy(wave) * number(wave)).sum::<f64>() / all
}
