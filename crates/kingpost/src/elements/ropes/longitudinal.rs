//! Longitudinal vibration of a rope with a load at its lower end, and the warning of a rope whose inertia is left out.

use super::Rope;
use crate::dynamics::Loads;
use crate::elements::Context;
use crate::elements::watcher::significant;
use crate::scalar::Scalar;
use crate::spatial::Vector3;
use core::f64::consts::{FRAC_PI_2, TAU};

/// Largest share of the mass of a load for which the inertia of its rope is left out without a warning.
const LARGEST_SHARE: f64 = 0.05;

/// An elastic bar with a spring at its upper end and a mass at its lower end: a rope below a crane.
///
/// With the wave number kappa = omega / c, c^2 = EA / m, beta = kappa L, mu = M omega^2 / (EA kappa) and sigma = EA kappa
/// / k_s (Rao, *Vibration of Continuous Systems*, 2007, sec. 9.3: bar with a mass at its end),
///
/// ```text
/// natural frequencies:   (1 - sigma mu) cos beta = (sigma + mu) sin beta
/// tension at the top:    T = EA kappa X (sin beta + mu cos beta) / ((1 - sigma mu) cos beta - (sigma + mu) sin beta)
/// ```
///
/// for the motion X of the upper end of the spring.
///
/// ```
/// use kingpost::elements::ropes::LoadedBar;
/// // An anchor of 280 t with its added mass on a wire of 30 kg/m, EA = 800 MN: it resonates with a swell of 8 s at a
/// // length of 4035 m, without the inertia of the wire at 4632 m.
/// let bar = |length| LoadedBar { length, axial_stiffness: 8e8, mass_per_length: 30.0, top_compliance: 0.0, load: 280e3 };
/// assert!((bar(4035.3).period_s() - 8.0).abs() < 1e-3);
/// assert!((bar(4631.8).massless().period_s() - 8.0).abs() < 1e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadedBar {
    /// L, m.
    pub length: f64,
    /// EA, N.
    pub axial_stiffness: f64,
    /// m, kg/m.
    pub mass_per_length: f64,
    /// 1/k_s, m/N; 0 for a rigid support.
    pub top_compliance: f64,
    /// M, kg.
    pub load: f64,
}

/// Mass per length that counts as none, as a share of the load's mass over the length.
const MASSLESS: f64 = 1e-9;
/// Number of halvings of the interval of the first natural frequency: to rounding.
const HALVINGS: usize = 60;

impl LoadedBar {
    /// Returns the same bar without mass.
    pub fn massless(self) -> Self {
        Self { mass_per_length: MASSLESS * self.load / self.length, ..self }
    }

    /// Returns the longest natural period, s.
    pub fn period_s(&self) -> f64 {
        let celerity = libm::sqrt(self.axial_stiffness / self.mass_per_length);
        // Below the first natural frequency the denominator is positive, and beta is at most pi / 2.
        let (mut low, mut high) = (0.0, FRAC_PI_2 * celerity / self.length);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let [_, denominator] = self.transfer(middle);
            *(if denominator > 0.0 { &mut low } else { &mut high }) = middle;
        }
        TAU / low
    }

    /// Returns the tension at the top per motion of the top at a frequency, N/m; negative beyond the resonance.
    pub fn stiffness_at_top(&self, frequency_rad_s: f64) -> f64 {
        let [numerator, denominator] = self.transfer(frequency_rad_s);
        numerator / denominator
    }

    /// Returns numerator and denominator of the tension at the top.
    fn transfer(&self, frequency_rad_s: f64) -> [f64; 2] {
        let wave_number = frequency_rad_s * libm::sqrt(self.mass_per_length / self.axial_stiffness);
        let impedance = self.axial_stiffness * wave_number;
        let (mu, sigma) = (self.load * frequency_rad_s * frequency_rad_s / impedance, impedance * self.top_compliance);
        let (sin, cos) = libm::sincos(wave_number * self.length);
        [impedance * (sin + mu * cos), (1.0 - sigma * mu) * cos - (sigma + mu) * sin]
    }
}

impl<S: Scalar> Rope<S> {
    /// Returns the warning of a rope whose mass is not small against that of its load: the natural period of the load
    /// on it, and the tension at the median period of the sea.
    pub(super) fn inertia_left_out(&mut self, at: &Context<'_, S>, loads: &Loads<S>) -> Option<String> {
        let mass_per_length = self.weight?.mass_per_length.value();
        let unstretched = self.laid(at).unstretched.value();
        let load = self.path.load()??;
        let ([mass, with_added_mass], of_rope) = (moved_masses(load, at, loads), mass_per_length * unstretched);
        if of_rope <= LARGEST_SHARE * mass {
            return None;
        }
        let bar = LoadedBar {
            length: unstretched,
            axial_stiffness: self.axial_stiffness.value(),
            mass_per_length,
            top_compliance: self.series_compliance.value(),
            load: with_added_mass,
        };
        let share = format!(
            "{}: the rope of {} t has {} % of the mass of its load (warned of beyond {} %), and its inertia and drag are left out",
            self.name,
            significant(of_rope / 1e3, 3),
            significant(100.0 * of_rope / mass, 3),
            100.0 * LARGEST_SHARE
        );
        let hangs_straight = self.path.stations().len() == 2 && self.inextensible.is_none();
        let vibration =
            hangs_straight.then(|| vibration(&bar, at.world.waves.as_ref().and_then(|waves| waves.frequency_at(0.5))));
        Some([Some(share), vibration].into_iter().flatten().collect::<Vec<_>>().join("; "))
    }
}

/// Returns the mass that moves with a body, kg: of the bodies alone, and with the added mass of the water in the vertical
/// direction.
fn moved_masses<S: Scalar>(body: usize, at: &Context<'_, S>, loads: &Loads<S>) -> [f64; 2] {
    let carried = at.model.carried(body);
    let mass: f64 = carried.iter().map(|&body| at.model.bodies[body].mass.value()).sum();
    let added = loads.added_inertia.iter().filter(|(body, _)| carried.contains(body)).map(|(body, inertia)| {
        let up = at.links.to_body_axes(at.model, *body, Vector3::new(S::ZERO, S::ZERO, S::ONE));
        up.dot(inertia.linear * up).value()
    });
    [mass, mass + added.sum::<f64>()]
}

/// Returns what the inertia of the bar changes.
fn vibration(bar: &LoadedBar, median_rad_s: Option<f64>) -> String {
    let massless = bar.massless();
    let periods = format!(
        "with its inertia the load has a vertical natural period of {} s, without {} s",
        significant(bar.period_s(), 3),
        significant(massless.period_s(), 3)
    );
    let tension = median_rad_s.map(|median| {
        let [with, without] = [bar, &massless].map(|bar| bar.stiffness_at_top(median).abs() / 1e3);
        format!(
            ", and at the sea's median period of {} s the dynamic tension at the top is {} kN per metre of motion of the top, without {} kN",
            significant(TAU / median, 3),
            significant(with, 3),
            significant(without, 3)
        )
    });
    periods + tension.as_deref().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wire(length: f64, load: f64) -> LoadedBar {
        LoadedBar { length, axial_stiffness: 8e8, mass_per_length: 30.0, top_compliance: 0.0, load }
    }

    #[test]
    fn a_bar_without_a_load_has_the_frequency_of_a_quarter_wave() {
        let (bar, celerity) = (wire(1000.0, 0.0), libm::sqrt(8e8 / 30.0));
        assert!((bar.period_s() / (4.0 * 1000.0 / celerity) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_light_bar_is_a_spring_with_a_third_of_its_mass() {
        // Rayleigh's rule: the error is of second order in m L / M.
        let bar = LoadedBar { mass_per_length: 1.0, ..wire(100.0, 1e6) };
        let rule = TAU * libm::sqrt((1e6 + 100.0 / 3.0) * 100.0 / 8e8);
        assert!((bar.period_s() / rule - 1.0).abs() < 1e-8);
    }

    #[test]
    fn a_soft_support_adds_its_compliance() {
        let bar = LoadedBar { top_compliance: 1e-5, ..wire(100.0, 1e6) }.massless();
        let rule = TAU * libm::sqrt(1e6 * (100.0 / 8e8 + 1e-5));
        assert!((bar.period_s() / rule - 1.0).abs() < 1e-7);
        let (omega, stiffness) = (0.3, 1.0 / (100.0 / 8e8 + 1e-5));
        let expected = stiffness * 1e6 * omega * omega / (stiffness - 1e6 * omega * omega);
        assert!((bar.stiffness_at_top(omega) / expected - 1.0).abs() < 1e-6);
    }

    #[test]
    fn the_tension_is_that_of_many_lumped_masses() {
        // From the load upward: T grows by m omega^2 u per length, u falls by T / EA. Halves of the masses lie at the ends
        // of each part, so the error is of second order: (kappa dx)^2 / 12, below 1e-6 here.
        const PARTS: usize = 1000;
        for (bar, omega) in [(wire(1500.0, 280e3), 0.785), (wire(3000.0, 280e3), 0.785), (wire(3000.0, 50e3), 1.3)] {
            let part = bar.length / PARTS as f64;
            let (mut motion, mut tension) = (1.0, bar.load * omega * omega);
            for _ in 0..PARTS {
                let half = 0.5 * bar.mass_per_length * part * omega * omega;
                tension += half * motion;
                motion -= tension * part / bar.axial_stiffness;
                tension += half * motion;
            }
            assert!((bar.stiffness_at_top(omega) / (tension / motion) - 1.0).abs() < 1e-4, "{bar:?}");
        }
    }
}
