//! The heavy symmetric top on a fixed point (Lagrange's top; Goldstein, Poole & Safko, Classical
//! Mechanics, 3rd ed., section 5.7), and the spherical pendulum, which is the top without spin.

use super::GRAVITY;
use super::elliptic::{complete_first, complete_third, jacobi};

/// A heavy symmetric top. Its axis leans by theta from the vertical; u = cos theta, upwards. It starts
/// at a turning point of theta.
///
/// With phi' = (b - a u) / (1 - u^2), theta obeys u'^2 = (1 - u^2)(alpha - beta u) - (b - a u)^2, a cubic
/// with roots u1 <= u <= u2 < u3, so that u = u1 + (u2 - u1) sn^2.
pub struct HeavyTop {
    a: f64,
    b: f64,
    beta: f64,
    roots: [f64; 3],
}

impl HeavyTop {
    /// The top with moments of inertia about the fixed point, across and along its axis (kg m^2), and its
    /// mass times the distance of its centre (kg m); it starts with theta (rad) at rest, the rate phi'
    /// about the vertical and the spin about its own axis, of the whole motion (rad/s).
    pub fn new([across, along]: [f64; 2], mass_moment: f64, theta: f64, phi_rate: f64, spin: f64) -> Self {
        let (u, sine_squared) = (theta.cos(), theta.sin().powi(2));
        let a = along * spin / across;
        let b = phi_rate * sine_squared + a * u;
        let beta = 2.0 * mass_moment * GRAVITY / across;
        let alpha = phi_rate * phi_rate * sine_squared + beta * u;
        // beta u^3 - (alpha + a^2) u^2 + (2 a b - beta) u + alpha - b^2, divided by (u - u0).
        let linear = beta * u - (alpha + a * a);
        let constant = linear * u + 2.0 * a * b - beta;
        let root = (linear * linear - 4.0 * beta * constant).sqrt();
        let (smaller, larger) = ((-linear - root) / (2.0 * beta), (-linear + root) / (2.0 * beta));
        Self { a, b, beta, roots: [u.min(smaller), u.max(smaller), larger] }
    }

    /// A spherical pendulum: a point mass on a rod of this length (m), theta from the upward vertical.
    pub fn spherical_pendulum(length_m: f64, theta: f64, phi_rate: f64) -> Self {
        Self::new([length_m * length_m, 0.0], length_m, theta, phi_rate, 0.0)
    }

    /// Rates phi' (rad/s) of the two regular precessions with theta constant, the slow one first:
    /// I1 cos(theta) phi'^2 - I3 w3 phi' + m g l = 0 (Goldstein 5.77).
    pub fn regular_precession([across, along]: [f64; 2], mass_moment: f64, theta: f64, spin: f64) -> [f64; 2] {
        let (a, b, c) = (across * theta.cos(), along * spin, mass_moment * GRAVITY);
        let root = (b * b - 4.0 * a * c).sqrt();
        [2.0 * c / (b + root), (b + root) / (2.0 * a)]
    }

    /// Rate (rad/s) of a spherical pendulum that goes round a cone: phi'^2 = -g / (l cos theta), theta
    /// from the upward vertical.
    pub fn conical_rate(length_m: f64, theta: f64) -> f64 {
        (-GRAVITY / (length_m * theta.cos())).sqrt()
    }

    fn frequency(&self) -> f64 {
        (self.beta * (self.roots[2] - self.roots[0])).sqrt() / 2.0
    }

    fn parameter(&self) -> f64 {
        let [u1, u2, u3] = self.roots;
        (u2 - u1) / (u3 - u1)
    }

    /// Time from one lowest (or highest) point to the next, s.
    pub fn nutation_period_s(&self) -> f64 {
        2.0 * complete_first(self.parameter()) / self.frequency()
    }

    /// Angle about the vertical from one lowest (or highest) point to the next, rad: the integral of phi',
    /// by partial fractions two integrals of the third kind.
    pub fn precession_in_a_nutation(&self) -> f64 {
        let ([u1, u2, _], m) = (self.roots, self.parameter());
        let down = (self.b - self.a) / (1.0 - u1) * complete_third((u2 - u1) / (1.0 - u1), m);
        let up = (self.b + self.a) / (1.0 + u1) * complete_third(-(u2 - u1) / (1.0 + u1), m);
        (down + up) / self.frequency()
    }

    /// Lowest and highest u = cos theta.
    pub fn limits(&self) -> [f64; 2] {
        [self.roots[0], self.roots[1]]
    }

    /// u = cos theta a time after a lowest point.
    pub fn height(&self, since_lowest_s: f64) -> f64 {
        let [u1, u2, _] = self.roots;
        let [sn, _, _] = jacobi(self.frequency() * since_lowest_s, self.parameter());
        u1 + (u2 - u1) * sn * sn
    }
}
