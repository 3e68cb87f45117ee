//! Forces of the incident waves on a hull: first order and slow drift.

use super::by_heading::ByHeading;
use super::drift_damping::{RATES, rates};
use super::place::LowFrequencyFrame;
use crate::scalar::Scalar;
use crate::sea::database::Database;
use crate::sea::waves::{WaveField, wave_number};

/// `F = Re sum X(w, beta - psi) a e^(i (k.x - w t + epsilon))`, about the hull's reference point, in the axes of the
/// slow frame, with its position x and heading psi; a contains the ramp of the waves.
///
/// Second-order forces are the mean and slowly varying drift, by Newman's approximation: with D(w, beta) the mean force
/// in a regular wave of unit amplitude, the force of a pair of waves is approximated by the mean of their two values of
/// D, which turns the double sum over all pairs into a product,
///
/// ```text
/// F = sum_i sum_j a_i a_j (D_i + D_j) / 2 cos(q_i - q_j) = Re{ (sum D_i a_i e^(i q_i)) (sum a_j e^(-i q_j)) }
/// ```
///
/// (Newman, *Proc. Int. Symp. on the Dynamics of Marine Vehicles and Structures in Waves*, London 1974, p. 182;
/// Faltinsen, *Sea Loads on Ships and Offshore Structures*, 1990, p. 157). The approximation is valid for small
/// difference frequencies, such as the natural frequencies of a moored ship.
#[derive(Clone, Debug)]
pub struct WaveExcitation<S = f64> {
    /// The waves at the slow frame's position, a e^(i q).
    real: Vec<S>,
    imaginary: Vec<S>,
    /// a e^(i q) of each wave, projected on the sum over all waves: the weight of the wave's D in the drift.
    with_all: Vec<S>,
    /// Real and imaginary part of X, mode by mode; then D of surge, sway and yaw, if drift acts, and its change with
    /// velocity.
    transfer: ByHeading<S>,
    drifts: bool,
    /// Whether `transfer` also contains the [`rates`] of change of D with the hull's velocity.
    by_velocity: bool,
    /// Wave realisation, time and frame of the last computed force.
    last: Option<(u64, f64, LowFrequencyFrame<S>)>,
    force: [S; 6],
    drift: [S; 6],
    /// Rates of change of the drift with velocity.
    rates: [S; RATES],
    elevation: S,
}

/// The velocity of a hull along the axes of the slow frame, m/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HullVelocity<S = f64> {
    /// Relative to the water.
    pub through_water: [S; 2],
    /// Relative to the earth.
    pub over_ground: [S; 2],
}

/// Switches for the forces of the incident waves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WaveForceSwitches {
    /// Whether the first-order Froude-Krylov force acts; otherwise only diffraction.
    pub froude_krylov: bool,
    /// Whether the mean and slowly varying drift acts, from the database's mean drift.
    pub drift: bool,
    /// Whether the drift changes with the velocity of the hull, by Aranha's formula.
    pub drift_damping: bool,
}

/// Real and imaginary part of six modes.
const FIRST_ORDER: usize = 12;
/// Modes with drift forces.
const DRIFTING: [usize; 3] = [0, 1, 5];

impl<S: Scalar> WaveExcitation<S> {
    /// Returns the excitation from a hull's data, in these waves; every later call must have the same waves. Wave
    /// components outside the data's frequencies exert no force.
    pub fn new(database: &Database, field: &WaveField<S>, parts: WaveForceSwitches) -> Self {
        let drifts = parts.drift && database.mean_drift.is_some();
        let by_velocity = drifts && parts.drift_damping;
        let of_wave = |omega: f64| {
            let covered = if database.covers(omega) { 1.0 } else { 0.0 };
            let x = database.excitation(omega, parts.froude_krylov);
            let d = database.mean_drift(omega);
            let by_velocity =
                if by_velocity { rates(database, omega, wave_number(omega, field.water())) } else { Vec::new() };
            move |part: usize| -> Vec<f64> {
                match part.checked_sub(FIRST_ORDER) {
                    None => x.iter().map(|x| covered * x[part / 2][part % 2]).collect(),
                    Some(drifting) if drifting < DRIFTING.len() => d.iter().map(|d| covered * d[drifting]).collect(),
                    Some(rate) => by_velocity.iter().map(|d| covered * d[rate - DRIFTING.len()]).collect(),
                }
            }
        };
        let rows: Vec<_> = field.components().map(|wave| of_wave(wave.angular_frequency_rad_s.value())).collect();
        let directions: Vec<f64> = field.components().map(|wave| wave.direction_rad.value()).collect();
        let count = FIRST_ORDER + if drifts { DRIFTING.len() } else { 0 } + if by_velocity { RATES } else { 0 };
        let transfer = ByHeading::new(count, &directions, |part, wave| rows[wave](part));
        let [real, imaginary, with_all] = core::array::from_fn(|_| vec![S::ZERO; field.len()]);
        let (force, drift, rates, elevation) = ([S::ZERO; 6], [S::ZERO; 6], [S::ZERO; RATES], S::ZERO);
        Self { real, imaginary, with_all, transfer, drifts, by_velocity, last: None, force, drift, rates, elevation }
    }

    /// Returns force (N) and moment (N m) at a time, s.
    pub fn force(&mut self, field: &WaveField<S>, time_s: f64, slow: &LowFrequencyFrame<S>) -> [S; 6] {
        self.update(field, time_s, slow);
        self.force
    }

    /// Returns mean and slowly varying force (N) and moment (N m) at a time, s, on a hull with this velocity.
    pub fn drift(
        &mut self,
        field: &WaveField<S>,
        time_s: f64,
        slow: &LowFrequencyFrame<S>,
        velocity: &HullVelocity<S>,
    ) -> [S; 6] {
        self.update(field, time_s, slow);
        let mut drift = self.drift;
        if self.by_velocity {
            add_by_velocity(&mut drift, &self.rates, velocity);
        }
        drift
    }

    /// Returns the mean drift over all times after the ramp, at a heading (rad) and a velocity.
    pub fn mean_drift(&mut self, field: &WaveField<S>, heading: S, velocity: &HullVelocity<S>) -> [S; 6] {
        let squares: Vec<S> = field.components().map(|wave| wave.amplitude_m * wave.amplitude_m).collect();
        self.transfer.turn_to(heading);
        let mean = |part: usize| self.transfer.sum(part, &squares);
        let mut drift = [S::ZERO; 6];
        if self.drifts {
            (FIRST_ORDER..).zip(DRIFTING).for_each(|(part, mode)| drift[mode] = mean(part));
        }
        if self.by_velocity {
            let rates = core::array::from_fn(|rate| mean(FIRST_ORDER + DRIFTING.len() + rate));
            add_by_velocity(&mut drift, &rates, velocity);
        }
        drift
    }

    /// Whether mean and slowly varying forces act, and whether they change with the hull's velocity.
    pub fn drift_parts(&self) -> [bool; 2] {
        [self.drifts, self.by_velocity]
    }

    /// Returns the elevation of the incident waves at the slow frame's position, m.
    pub fn elevation(&mut self, field: &WaveField<S>, time_s: f64, slow: &LowFrequencyFrame<S>) -> S {
        self.update(field, time_s, slow);
        self.elevation
    }

    fn update(&mut self, field: &WaveField<S>, time_s: f64, slow: &LowFrequencyFrame<S>) {
        let key = (field.realisation(), time_s, *slow);
        if self.last == Some(key) {
            return;
        }
        field.phasors(slow.position, time_s, &mut self.real, &mut self.imaginary);
        let Self { transfer, real, imaginary, with_all, .. } = self;
        transfer.turn_to(slow.heading);
        self.force = core::array::from_fn(|mode| transfer.sum(2 * mode, real) - transfer.sum(2 * mode + 1, imaginary));
        let sum = |of: &[S]| of.iter().fold(S::ZERO, |sum, a| sum + *a);
        self.elevation = sum(real);
        if self.drifts {
            let out_of_phase = sum(imaginary);
            for ((with_all, real), imaginary) in with_all.iter_mut().zip(&*real).zip(&*imaginary) {
                *with_all = *real * self.elevation + *imaginary * out_of_phase;
            }
            for (part, mode) in (FIRST_ORDER..).zip(DRIFTING) {
                self.drift[mode] = transfer.sum(part, with_all);
            }
            if self.by_velocity {
                self.rates = core::array::from_fn(|rate| transfer.sum(FIRST_ORDER + DRIFTING.len() + rate, with_all));
            }
        }
        self.last = Some(key);
    }
}

/// Adds the change of surge and sway with velocity.
fn add_by_velocity<S: Scalar>(drift: &mut [S; 6], rates: &[S; RATES], velocity: &HullVelocity<S>) {
    let ([x, y], [u, v]) = (velocity.through_water, velocity.over_ground);
    for (drift, rates) in drift.iter_mut().zip(rates.as_chunks::<4>().0) {
        *drift += rates[0] * x + rates[1] * y + rates[2] * u + rates[3] * v;
    }
}
