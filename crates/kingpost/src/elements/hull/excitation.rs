//! Forces of the incident waves on a hull, of first order and their slow drift.

use super::by_heading::ByHeading;
use super::place::SlowFrame;
use crate::scalar::Scalar;
use crate::sea::database::Database;
use crate::sea::waves::WaveField;

/// `F = Re sum X(w, beta - psi) a e^(i (k.x - w t + epsilon))`, about the hull's reference point, in
/// the axes of the slow frame, with its place x and heading psi; a with the ramp of the waves.
///
/// Of second order there are the mean and the slowly varying drift, by Newman's approximation: with
/// D(w, beta) the mean force in a regular wave of unit amplitude, that of two waves is taken as the
/// mean of their own, which makes a double sum over all pairs a product,
///
/// ```text
/// F = sum_i sum_j a_i a_j (D_i + D_j) / 2 cos(q_i - q_j) = Re{ (sum D_i a_i e^(i q_i)) (sum a_j e^(-i q_j)) }
/// ```
///
/// (Newman, *Proc. Int. Symp. on the Dynamics of Marine Vehicles and Structures in Waves*, London
/// 1974, p. 182; Faltinsen, *Sea Loads on Ships and Offshore Structures*, 1990, p. 157). It holds for
/// differences of frequency that are small, as those are that move a moored ship.
#[derive(Clone, Debug)]
pub struct Excitation<S = f64> {
    /// The waves at the slow frame's place, a e^(i q).
    real: Vec<S>,
    imaginary: Vec<S>,
    /// Real and imaginary part of X, mode by mode; then D of surge, sway and yaw, if drift acts.
    transfer: ByHeading<S>,
    drifts: bool,
    /// The last force, and the time and frame that it was computed for.
    last: Option<(f64, SlowFrame<S>)>,
    force: [S; 6],
    drift: [S; 6],
    elevation: S,
}

/// What of the incident waves acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parts {
    /// Their own pressure, to first order; otherwise diffraction alone.
    pub froude_krylov: bool,
    /// The mean and slowly varying drift, from the database's mean drift.
    pub drift: bool,
}

/// Real and imaginary part of six modes.
const FIRST_ORDER: usize = 12;
/// Modes that drift.
const DRIFTING: [usize; 3] = [0, 1, 5];

impl<S: Scalar> Excitation<S> {
    /// From a hull's data, in these waves: every call wants the same. Components outside the data's frequencies make no force.
    pub fn new(database: &Database, field: &WaveField<S>, parts: Parts) -> Self {
        let of_wave = |omega: f64| {
            let covered = if database.covers(omega) { 1.0 } else { 0.0 };
            let x = database.excitation(omega, parts.froude_krylov);
            let d = database.mean_drift(omega);
            move |part: usize| -> Vec<f64> {
                match part.checked_sub(FIRST_ORDER) {
                    None => x.iter().map(|x| covered * x[part / 2][part % 2]).collect(),
                    Some(drifting) => d.iter().map(|d| covered * d[drifting]).collect(),
                }
            }
        };
        let rows: Vec<_> = field.components().map(|wave| of_wave(wave.angular_frequency_rad_s.value())).collect();
        let directions: Vec<f64> = field.components().map(|wave| wave.direction_rad.value()).collect();
        let drifts = parts.drift && database.mean_drift.is_some();
        let count = FIRST_ORDER + if drifts { DRIFTING.len() } else { 0 };
        let transfer = ByHeading::new(count, &directions, |part, wave| rows[wave](part));
        let (real, imaginary) = (vec![S::ZERO; field.len()], vec![S::ZERO; field.len()]);
        let (force, drift, elevation) = ([S::ZERO; 6], [S::ZERO; 6], S::ZERO);
        Self { real, imaginary, transfer, drifts, last: None, force, drift, elevation }
    }

    /// Force (N) and moment (N m) at a time, s.
    pub fn force(&mut self, field: &WaveField<S>, time_s: f64, slow: &SlowFrame<S>) -> [S; 6] {
        self.update(field, time_s, slow);
        self.force
    }

    /// Mean and slowly varying force (N) and moment (N m) at a time, s.
    pub fn drift(&mut self, field: &WaveField<S>, time_s: f64, slow: &SlowFrame<S>) -> [S; 6] {
        self.update(field, time_s, slow);
        self.drift
    }

    /// Elevation of the incident waves at the slow frame's place, m.
    pub fn elevation(&mut self, field: &WaveField<S>, time_s: f64, slow: &SlowFrame<S>) -> S {
        self.update(field, time_s, slow);
        self.elevation
    }

    fn update(&mut self, field: &WaveField<S>, time_s: f64, slow: &SlowFrame<S>) {
        let key = (time_s, *slow);
        if self.last == Some(key) {
            return;
        }
        let waves = field.len();
        field.phasors(slow.position, time_s, &mut self.real, &mut self.imaginary);
        let x = self.transfer.at(slow.heading);
        self.force = core::array::from_fn(|mode| {
            let part = |k: usize| &x[(2 * mode + k) * waves..][..waves];
            dot(part(0), &self.real) - dot(part(1), &self.imaginary)
        });
        let sum = |of: &[S]| of.iter().fold(S::ZERO, |sum, a| sum + *a);
        self.elevation = sum(&self.real);
        if self.drifts {
            let out_of_phase = sum(&self.imaginary);
            for (part, mode) in (FIRST_ORDER..).zip(DRIFTING) {
                let d = &x[part * waves..][..waves];
                self.drift[mode] = dot(d, &self.real) * self.elevation + dot(d, &self.imaginary) * out_of_phase;
            }
        }
        self.last = Some(key);
    }
}

/// A sum in one order, in four strands that a processor can add side by side.
fn dot<S: Scalar>(a: &[S], b: &[S]) -> S {
    let mut strands = [S::ZERO; 4];
    let (a, b) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest = a.remainder().iter().zip(b.remainder()).fold(S::ZERO, |sum, (a, b)| sum + *a * *b);
    for (a, b) in a.zip(b) {
        for k in 0..4 {
            strands[k] += a[k] * b[k];
        }
    }
    (strands[0] + strands[1]) + (strands[2] + strands[3]) + rest
}
