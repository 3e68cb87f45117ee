//! Discrete linear processes and the stationary gains of their Kalman filters.

use crate::scalar::Scalar;
use crate::spatial::exponential;
use nalgebra::{DMatrix, DVector};

/// Number of doublings: the last one gives the covariance after 2^40 samples.
const DOUBLINGS: usize = 40;

/// Standard deviation of the part of an oscillation that its model does not explain, over that of the oscillation.
const UNEXPLAINED: f64 = 0.1;
/// Damping ratio of an oscillation: the width of its spectrum.
const DAMPING_RATIO: f64 = 0.3;
/// Random walk of the error of a gyroscope, rad/s per root second.
pub const RATE_WANDERS: f64 = 1e-6;

/// A linear process over one sample: `x <- A x + n`, with the covariance Q of the noise n.
#[derive(Clone, Debug)]
pub struct Process {
    /// A.
    pub transition: DMatrix<f64>,
    /// Q.
    pub noise: DMatrix<f64>,
}

impl Process {
    /// Returns the process of `x' = F x` with the standard deviations of the noise that a sample adds to each state.
    pub fn new(rates: DMatrix<f64>, period_s: f64, deviations: &[f64]) -> Self {
        let squares = deviations.iter().map(|x| x * x);
        let noise = DMatrix::from_diagonal(&DVector::from_iterator(deviations.len(), squares));
        Self { transition: exponential(rates * period_s), noise }
    }

    /// Returns a chain of states, in which the rate of state k is its factor times state k + 1.
    pub fn chain(factors: &[f64], period_s: f64, deviations: &[f64]) -> Self {
        let size = factors.len() + 1;
        let rates = DMatrix::from_fn(size, size, |i, j| if j == i + 1 { factors[i] } else { 0.0 });
        Self::new(rates, period_s, deviations)
    }

    /// Returns the process of an angle's error, where the angle is the integral of a gyroscope's rate with this noise,
    /// and of the rate's error.
    pub fn of_angle(rate_noise: f64, period_s: f64) -> Self {
        Self::chain(&[-1.0], period_s, &[rate_noise * period_s, RATE_WANDERS * libm::sqrt(period_s)])
    }

    /// Returns the process of an oscillation x about zero with a peak period and a standard deviation. Its states are
    /// the integral of x, then x: with the frequency w0
    ///
    /// ```text
    /// x'' + 2 zeta w0 x' + w0^2 x = noise'
    /// ```
    ///
    /// as in Fossen's wave filter (*Handbook of Marine Craft Hydrodynamics and Motion Control*, 2nd ed., 2021, sec.
    /// 13.3).
    pub fn oscillation(middle_period_s: f64, deviation: f64, period_s: f64) -> Self {
        let frequency = core::f64::consts::TAU / middle_period_s;
        let (spring, damper) = (frequency * frequency, 2.0 * DAMPING_RATIO * frequency);
        let rates = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -spring, -damper]);
        Self::new(rates, period_s, &[0.0, libm::sqrt(2.0 * damper) * deviation * libm::sqrt(period_s)])
    }

    /// Returns the gain for the pseudo-measurement that the first state equals an [oscillation](Self::oscillation) of
    /// this standard deviation about zero: for the states of this process, then for the two states of the oscillation.
    pub fn gain_about_zero(&self, oscillation: &Self, deviation: f64) -> DVector<f64> {
        self.beside(oscillation).gain(&difference(self.size() + 2), UNEXPLAINED * deviation)
    }

    /// Returns the number of its states.
    pub fn size(&self) -> usize {
        self.noise.nrows()
    }

    /// Returns both processes as one, this one first.
    pub fn beside(&self, other: &Self) -> Self {
        let (one, all) = (self.size(), self.size() + other.size());
        let both = |first: &DMatrix<f64>, second: &DMatrix<f64>| {
            let mut both = DMatrix::zeros(all, all);
            both.view_mut((0, 0), first.shape()).copy_from(first);
            both.view_mut((one, one), second.shape()).copy_from(second);
            both
        };
        Self { transition: both(&self.transition, &other.transition), noise: both(&self.noise, &other.noise) }
    }

    /// Returns the process over this number of samples, by repeated squaring. Not finite for too large a number.
    pub fn after(&self, samples: f64) -> Self {
        let (mut left, mut power) = (samples, self.clone());
        let mut all: Option<Self> = None;
        while left >= 1.0 {
            if left % 2.0 >= 1.0 {
                all = Some(all.map_or_else(|| power.clone(), |all| all.then(&power)));
            }
            power = power.then(&power);
            if !power.noise.norm().is_finite() {
                return power;
            }
            left = libm::floor(0.5 * left);
        }
        all.unwrap_or(power)
    }

    /// Returns this process followed by another.
    fn then(&self, next: &Self) -> Self {
        let turned = &next.transition * &self.noise * next.transition.transpose();
        Self { transition: &next.transition * &self.transition, noise: turned + &next.noise }
    }

    /// Returns the stationary gain K = P h / (h^T P h + r^2) of a Kalman filter for the measurement h^T x + r n, with n
    /// of variance 1: P solves the algebraic Riccati equation
    ///
    /// ```text
    /// P = A P A^T - A P h (h^T P h + r^2)^-1 h^T P A^T + Q
    /// ```
    ///
    /// by doubling (Anderson & Moore, *Optimal Filtering*, 1979, sec. 6.7): after k doublings P is the covariance after
    /// 2^k samples.
    pub fn gain(&self, measured: &DVector<f64>, deviation: f64) -> DVector<f64> {
        let size = self.size();
        let (mut a, mut p) = (self.transition.transpose(), self.noise.clone());
        let mut g = measured * measured.transpose() / (deviation * deviation);
        for _ in 0..DOUBLINGS {
            let Some(inverse) = (DMatrix::identity(size, size) + &g * &p).try_inverse() else { break };
            let through = &a * &inverse;
            let more = a.transpose() * &p * &inverse * &a;
            g = &g + &through * &g * a.transpose();
            a = through * a;
            let settled = more.norm() <= f64::EPSILON * p.norm();
            p += more;
            p = (&p + p.transpose()) * 0.5;
            if settled {
                break;
            }
        }
        let seen = &p * measured;
        let variance = measured.dot(&seen) + deviation * deviation;
        seen / variance
    }
}

/// Returns the measurement vector of the first state.
pub fn first(size: usize) -> DVector<f64> {
    DVector::from_fn(size, |i, _| if i == 0 { 1.0 } else { 0.0 })
}

/// Returns the measurement vector of the first state less the last.
fn difference(size: usize) -> DVector<f64> {
    let mut measured = first(size);
    measured[size - 1] = -1.0;
    measured
}

/// Transition matrix of an oscillation and its integral over one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillating([[f64; 2]; 2]);

impl Oscillating {
    /// Returns the transition matrix of an [oscillation](Process::oscillation) and its integral over one sample.
    pub fn of(oscillation: &Process) -> Self {
        Self([0, 1].map(|i| [0, 1].map(|j| oscillation.transition[(i, j)])))
    }

    /// Returns the integral and the oscillation one sample later.
    pub fn onward<S: Scalar>(&self, [integral, itself]: [S; 2]) -> [S; 2] {
        self.0.map(|row| S::constant(row[0]) * integral + S::constant(row[1]) * itself)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Alpha-beta filter of a position with random jumps of the velocity, by its tracking index L = s_a T^2 / r
    /// (Kalata, *IEEE Trans. Aerospace and Electronic Systems* 20, 1984, p. 174).
    #[test]
    fn the_gains_of_position_and_velocity_are_those_of_the_tracking_index() {
        for index in [1e-4, 0.01, 0.5, 3.0] {
            let (period, deviation) = (0.5, 2.0);
            let acceleration = index * deviation / (period * period);
            let entry = DVector::from_row_slice(&[0.5 * period * period, period]) * acceleration;
            let transition = DMatrix::from_row_slice(2, 2, &[1.0, period, 0.0, 1.0]);
            let process = Process { transition, noise: &entry * entry.transpose() };
            let gain = process.gain(&first(2), deviation);
            let r = (4.0 + index - (8.0 * index + index * index).sqrt()) / 4.0;
            let (alpha, beta) = (1.0 - r * r, 2.0 * (2.0 - (1.0 - r * r)) - 4.0 * r);
            assert!((gain[0] - alpha).abs() < 1e-9 && (gain[1] * period - beta).abs() < 1e-9, "{index}: {gain}");
        }
    }

    #[test]
    fn a_step_of_13_samples_equals_13_steps_of_one_sample() {
        let chain = Process::new(DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -0.5, -0.1]), 0.3, &[0.1, 0.2]);
        let one_by_one = (1..13).fold(chain.clone(), |all, _| all.then(&chain));
        let at_once = chain.after(13.0);
        assert!((&at_once.transition - &one_by_one.transition).norm() < 1e-14 * one_by_one.transition.norm());
        assert!((&at_once.noise - &one_by_one.noise).norm() < 1e-13 * one_by_one.noise.norm());
    }
}
