//! First-order forces of the incident waves on a hull.

use super::by_heading::ByHeading;
use super::phasors::Phasors;
use super::place::SlowFrame;
use crate::dynamics::Clock;
use crate::scalar::Scalar;
use crate::sea::database::Database;
use crate::sea::waves::WaveField;

/// `F = ramp Re sum a X(w, beta - psi) e^(i (k.x - w t + epsilon))`, about the hull's reference
/// point, in the axes of the slow frame, with its place x and heading psi.
#[derive(Clone, Debug)]
pub struct Excitation<S = f64> {
    field: WaveField<S>,
    phasors: Phasors<S>,
    /// Real and imaginary part of X by component and mode.
    transfer: ByHeading<S>,
    /// The last force, and what it was computed for.
    last: Option<(f64, f64, SlowFrame<S>)>,
    force: [S; 6],
    elevation: S,
}

/// Numbers of X a component.
const PARTS: usize = 12;

impl<S: Scalar> Excitation<S> {
    /// From a hull's data, with the Froude-Krylov part or by diffraction alone. Components outside
    /// the data's frequencies make no force.
    pub fn new(database: &Database, field: WaveField<S>, froude_krylov: bool) -> Self {
        let mut transfer = ByHeading::new(database.wave_directions_rad.len());
        for wave in field.components() {
            let (omega, direction) = (wave.angular_frequency_rad_s.value(), wave.direction_rad.value());
            let x = database.excitation(omega, froude_krylov);
            let covered = if database.covers(omega) { 1.0 } else { 0.0 };
            for part in 0..PARTS {
                let row: Vec<f64> = x.iter().map(|x| covered * x[part / 2][part % 2]).collect();
                transfer.push(direction, &row);
            }
        }
        let phasors = Phasors::new(field.components());
        Self { field, phasors, transfer, last: None, force: [S::ZERO; 6], elevation: S::ZERO }
    }

    /// The waves.
    pub fn field(&self) -> &WaveField<S> {
        &self.field
    }

    /// Force (N) and moment (N m).
    pub fn force(&mut self, clock: Clock, slow: &SlowFrame<S>) -> [S; 6] {
        self.update(clock, slow);
        self.force
    }

    /// Elevation of the incident waves at the slow frame's place, m.
    pub fn elevation(&mut self, clock: Clock, slow: &SlowFrame<S>) -> S {
        self.update(clock, slow);
        self.elevation
    }

    fn update(&mut self, clock: Clock, slow: &SlowFrame<S>) {
        let key = (clock.start_s, clock.time_s, *slow);
        if self.last == Some(key) {
            return;
        }
        let transfer = self.transfer.at(slow.heading);
        let (mut force, mut elevation) = ([S::ZERO; 6], S::ZERO);
        self.phasors.at(clock.start_s, clock.time_s, slow.position, |i, phasor| {
            let x = &transfer[PARTS * i..][..PARTS];
            for (force, x) in force.iter_mut().zip(x.chunks_exact(2)) {
                *force += x[0] * phasor[0] - x[1] * phasor[1];
            }
            elevation += phasor[0];
        });
        let ramp = S::constant(self.field.ramp(clock.time_s));
        self.force = force.map(|force| force * ramp);
        self.elevation = elevation * ramp;
        self.last = Some(key);
    }
}
