//! The compound pendulum in a plane (Landau & Lifshitz, Mechanics, 3rd ed., section 11, problem 1).

use super::GRAVITY;
use super::elliptic::{complete_first, jacobi};

/// A rigid body on a level hinge, released at rest.
pub struct Pendulum {
    small_frequency: f64,
    amplitude: f64,
}

impl Pendulum {
    /// With the moment of inertia about the hinge (kg m^2), the mass times the distance of its centre from
    /// the hinge (kg m) and the angle at release from hanging (rad).
    pub fn new(moment_kg_m2: f64, mass_moment_kg_m: f64, amplitude: f64) -> Self {
        Self { small_frequency: (mass_moment_kg_m * GRAVITY / moment_kg_m2).sqrt(), amplitude }
    }

    fn parameter(&self) -> f64 {
        (self.amplitude / 2.0).sin().powi(2)
    }

    /// T = 4 sqrt(I / (m g l)) K(sin^2(amplitude / 2)), s.
    pub fn period_s(&self) -> f64 {
        4.0 * complete_first(self.parameter()) / self.small_frequency
    }

    /// Angle a time after release, rad: sin(angle / 2) = sin(amplitude / 2) cd(w0 t).
    pub fn angle(&self, time_s: f64) -> f64 {
        let [_, cn, dn] = jacobi(self.small_frequency * time_s, self.parameter());
        2.0 * ((self.amplitude / 2.0).sin() * cn / dn).asin()
    }
}
