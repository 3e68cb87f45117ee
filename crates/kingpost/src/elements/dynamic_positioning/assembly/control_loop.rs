//! Stability of a controller with its filter and thrusters, for the ship for which the gains are designed.

use crate::scenario::schema;
use core::f64::consts::TAU;
use nalgebra::{Complex, DMatrix};

/// The stability of a controlled ship without disturbance.
pub(crate) enum RootGrowth {
    /// Every root decays: the ship comes to rest.
    None,
    /// The root that grows fastest.
    Of(Complex<f64>),
    /// No roots are found, because the magnitudes of the rates differ too much.
    Unknown,
}

/// Largest number of iterations of the search for roots, which needs a few per root if their magnitudes are comparable.
const MOST_ITERATIONS: usize = 1000;

/// One of surge, sway and yaw.
pub(crate) struct ControlLoop<'a> {
    /// m, K_p, K_d, K_i.
    pub(crate) inertia: f64,
    pub(crate) gains: [f64; 3],
    pub(crate) filter: Option<&'a schema::WaveFilter>,
    /// Time constant of the slowest thruster, s.
    pub(crate) time_constant_s: f64,
}

impl ControlLoop<'_> {
    /// Returns the root that grows fastest, for a free ship, m x'' = T, under the controller.
    pub(crate) fn growth(&self) -> RootGrowth {
        let Some(schur) = self.rates().try_schur(f64::EPSILON, MOST_ITERATIONS) else { return RootGrowth::Unknown };
        let roots = schur.complex_eigenvalues();
        let fastest = roots.iter().copied().max_by(|a, b| a.re.total_cmp(&b.re)).unwrap_or_default();
        if fastest.re > ROUNDING * fastest.im.abs().max(1.0 / self.time_constant_s) {
            RootGrowth::Of(fastest)
        } else {
            RootGrowth::None
        }
    }

    /// Returns the matrix of the rates of x, v, thrust and integral (the last two over m), and the filter's states; the
    /// only remaining unit is s.
    fn rates(&self) -> DMatrix<f64> {
        let sections = self.filter.map(sections).unwrap_or_default();
        let n = 4 + 2 * sections.len();
        let [stiffness, damping, integral] = self.gains.map(|gain| gain / self.inertia);
        let mut a = DMatrix::zeros(n, n);
        (a[(0, 1)], a[(1, 2)], a[(3, 0)]) = (1.0, 1.0, -integral);
        // The input of the next section, as a linear combination of the states.
        let mut signal = DMatrix::zeros(1, n);
        (signal[(0, 0)], signal[(0, 1)]) = (-stiffness, -damping);
        for (k, section) in sections.iter().enumerate() {
            let first = 4 + 2 * k;
            a[(first, first + 1)] = section.frequency;
            let mut row = signal.clone();
            row[(0, first)] -= 1.0;
            row[(0, first + 1)] -= 2.0 * section.damping_ratio;
            a.row_mut(first + 1).copy_from(&(row * section.frequency).row(0));
            match section.notch {
                Some(share) => signal[(0, first + 1)] -= share,
                None => {
                    signal.fill(0.0);
                    signal[(0, first)] = 1.0;
                }
            }
        }
        signal[(0, 3)] += 1.0;
        signal[(0, 2)] -= 1.0;
        a.row_mut(2).copy_from(&(signal / self.time_constant_s).row(0));
        a
    }
}

/// Share of the fastest rate below which a growth rate counts as rounding: a controller without integral has a root at
/// 0.
const ROUNDING: f64 = 1e-6;

/// A section of [`WaveFilter`](crate::elements::dynamic_positioning::WaveFilter) in plain numbers.
struct PlainSection {
    frequency: f64,
    damping_ratio: f64,
    notch: Option<f64>,
}

fn sections(filter: &schema::WaveFilter) -> Vec<PlainSection> {
    let notch = Some(2.0 * (1.0 - filter.notch_damping_ratio.get()));
    let notches = filter.notch_periods_s.iter().map(|period| PlainSection {
        frequency: TAU / period.get(),
        damping_ratio: 1.0,
        notch,
    });
    let low_pass = filter.cutoff_period_s.map(|period| PlainSection {
        frequency: TAU / period.get(),
        damping_ratio: filter.cutoff_damping_ratio.get(),
        notch: None,
    });
    notches.chain(low_pass).collect()
}
