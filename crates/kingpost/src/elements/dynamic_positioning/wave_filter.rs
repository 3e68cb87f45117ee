//! The wave filter: it prevents thruster response to wave-frequency motion.

use crate::elements::StateDeclaration;
use crate::scalar::Scalar;

/// Notches in cascade with a low pass of second order,
///
/// ```text
/// h(s) = prod (s^2 + 2 zeta_n omega_n s + omega_n^2) / (s + omega_n)^2  omega_c^2 / (s^2 + 2 zeta_c omega_c s + omega_c^2)
/// ```
///
/// with h(0) = 1 (Fossen, *Handbook of Marine Craft Hydrodynamics and Motion Control*, 2011, sec. 11.1.2). At its own
/// frequency a notch has the gain zeta_n. Each section has two states for each signal,
///
/// ```text
/// a' = omega b,   b' = omega (u - a - 2 zeta b),   y = u - 2 (1 - zeta_n) b  of a notch, zeta = 1;   y = a  of the low pass
/// ```
#[derive(Clone, Debug, Default)]
pub struct WaveFilter<S = f64> {
    sections: Vec<FilterSection<S>>,
}

/// A section of second order.
#[derive(Clone, Copy, Debug)]
struct FilterSection<S> {
    /// rad/s.
    frequency: S,
    /// Damping ratio of its poles.
    damping_ratio: S,
    /// For a notch, twice the difference between the damping ratios of its poles and its zeros; `None` for the low
    /// pass.
    notch: Option<S>,
}

/// Signals that are filtered side by side: surge, sway, yaw.
pub const SIGNALS: usize = 3;

/// States of a section: two for each signal.
const STATES: usize = 2 * SIGNALS;

impl<S: Scalar> WaveFilter<S> {
    /// Adds a notch at a frequency (rad/s).
    #[must_use]
    pub fn with_notch(mut self, frequency: S, damping_ratio: S) -> Self {
        let notch = Some((S::ONE - damping_ratio) * S::constant(2.0));
        self.sections.push(FilterSection { frequency, damping_ratio: S::ONE, notch });
        self
    }

    /// Adds a low pass at a frequency (rad/s).
    #[must_use]
    pub fn with_low_pass(mut self, frequency: S, damping_ratio: S) -> Self {
        self.sections.push(FilterSection { frequency, damping_ratio, notch: None });
        self
    }

    /// Returns the number of its states.
    pub fn state_count(&self) -> usize {
        STATES * self.sections.len()
    }

    /// Returns the filtered signals.
    pub fn output(&self, input: [S; SIGNALS], states: &[S]) -> [S; SIGNALS] {
        let each = self.sections.iter().zip(states.chunks_exact(STATES));
        each.fold(input, |signal, (section, states)| section.output(signal, states))
    }

    /// Writes the rates of its states.
    pub fn rates(&self, input: [S; SIGNALS], states: &[S], rates: &mut [S]) {
        let mut signal = input;
        let each = self.sections.iter().zip(states.chunks_exact(STATES)).zip(rates.chunks_exact_mut(STATES));
        for ((section, states), rates) in each {
            for (k, u) in signal.iter().enumerate() {
                let (a, b) = (states[2 * k], states[2 * k + 1]);
                rates[2 * k] = section.frequency * b;
                rates[2 * k + 1] = section.frequency * (*u - a - section.damping_ratio * b * S::constant(2.0));
            }
            signal = section.output(signal, states);
        }
    }

    /// Writes the steady states for a constant input, which then passes unchanged.
    pub fn settled_states(&self, input: [S; SIGNALS], states: &mut [S]) {
        for states in states.chunks_exact_mut(STATES).take(self.sections.len()) {
            for (pair, u) in states.chunks_exact_mut(2).zip(input) {
                pair.copy_from_slice(&[u, S::ZERO]);
            }
        }
    }

    /// Returns the declarations of its states: a and b of each section.
    pub fn declared(&self) -> impl Iterator<Item = StateDeclaration> + '_ {
        let of_section = |section: usize| {
            let signals = [("surge", "N"), ("sway", "N"), ("yaw", "N m")].into_iter();
            let pair = move |(signal, unit)| {
                ["a", "b"].map(|part| StateDeclaration::new(format!("filter_{section}.{signal}.{part}"), unit))
            };
            signals.flat_map(pair)
        };
        (1..=self.sections.len()).flat_map(of_section)
    }
}

impl<S: Scalar> FilterSection<S> {
    fn output(&self, input: [S; SIGNALS], states: &[S]) -> [S; SIGNALS] {
        core::array::from_fn(|k| self.notch.map_or(states[2 * k], |share| input[k] - share * states[2 * k + 1]))
    }
}
