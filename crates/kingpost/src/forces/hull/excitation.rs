//! First-order forces of the incident waves on a hull.

use super::by_heading::ByHeading;
use super::place::SlowFrame;
use crate::scalar::Scalar;
use crate::sea::database::Database;
use crate::sea::waves::WaveField;

/// `F = Re sum X(w, beta - psi) a e^(i (k.x - w t + epsilon))`, about the hull's reference point, in
/// the axes of the slow frame, with its place x and heading psi; a with the ramp of the waves.
#[derive(Clone, Debug)]
pub struct Excitation<S = f64> {
    field: WaveField<S>,
    /// The waves at the slow frame's place, a e^(i q).
    real: Vec<S>,
    imaginary: Vec<S>,
    /// Real and imaginary part of X, mode by mode.
    transfer: ByHeading<S>,
    /// The last force, and the time and frame that it was computed for.
    last: Option<(f64, SlowFrame<S>)>,
    force: [S; 6],
    elevation: S,
}

/// Real and imaginary part of six modes.
const PARTS: usize = 12;

impl<S: Scalar> Excitation<S> {
    /// From a hull's data, with the Froude-Krylov part or by diffraction alone. Components outside
    /// the data's frequencies make no force.
    pub fn new(database: &Database, field: WaveField<S>, froude_krylov: bool) -> Self {
        let of_wave = |omega: f64| {
            let covered = if database.covers(omega) { 1.0 } else { 0.0 };
            let x = database.excitation(omega, froude_krylov);
            move |part: usize| x.iter().map(|x| covered * x[part / 2][part % 2]).collect()
        };
        let rows: Vec<_> = field.components().map(|wave| of_wave(wave.angular_frequency_rad_s.value())).collect();
        let directions: Vec<f64> = field.components().map(|wave| wave.direction_rad.value()).collect();
        let transfer = ByHeading::new(PARTS, &directions, |part, wave| rows[wave](part));
        let waves = vec![S::ZERO; field.len()];
        let (force, elevation) = ([S::ZERO; 6], S::ZERO);
        Self { real: waves.clone(), imaginary: waves, field, transfer, last: None, force, elevation }
    }

    /// The waves.
    pub fn field(&self) -> &WaveField<S> {
        &self.field
    }

    /// Force (N) and moment (N m) at a time, s.
    pub fn force(&mut self, time_s: f64, slow: &SlowFrame<S>) -> [S; 6] {
        self.update(time_s, slow);
        self.force
    }

    /// Elevation of the incident waves at the slow frame's place, m.
    pub fn elevation(&mut self, time_s: f64, slow: &SlowFrame<S>) -> S {
        self.update(time_s, slow);
        self.elevation
    }

    fn update(&mut self, time_s: f64, slow: &SlowFrame<S>) {
        let key = (time_s, *slow);
        if self.last == Some(key) {
            return;
        }
        let waves = self.field.len();
        self.field.phasors(slow.position, time_s, &mut self.real, &mut self.imaginary);
        let x = self.transfer.at(slow.heading);
        self.force = core::array::from_fn(|mode| {
            let part = |k: usize| &x[(2 * mode + k) * waves..][..waves];
            dot(part(0), &self.real) - dot(part(1), &self.imaginary)
        });
        self.elevation = self.real.iter().fold(S::ZERO, |sum, a| sum + *a);
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
