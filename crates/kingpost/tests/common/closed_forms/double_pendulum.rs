//! The double pendulum of two point masses on massless rods (Landau & Lifshitz, Mechanics, 3rd ed., section
//! 5, problem 1, and section 23, problem 2), by equations written only for this mechanism.

use super::GRAVITY;

/// Two point masses, one below the other; angles are those of the rods from the vertical.
pub struct DoublePendulum {
    /// Masses, upper first, kg.
    pub masses_kg: [f64; 2],
    /// Lengths of the rods, upper first, m.
    pub lengths_m: [f64; 2],
}

impl DoublePendulum {
    /// Angular accelerations of both rods from their angles and rates.
    pub fn acceleration(&self, [t1, t2]: [f64; 2], [w1, w2]: [f64; 2]) -> [f64; 2] {
        let ([m1, m2], [l1, l2]) = (self.masses_kg, self.lengths_m);
        let (sine, cosine) = (t1 - t2).sin_cos();
        let m = [[(m1 + m2) * l1 * l1, m2 * l1 * l2 * cosine], [m2 * l1 * l2 * cosine, m2 * l2 * l2]];
        let f1 = -m2 * l1 * l2 * w2 * w2 * sine - (m1 + m2) * GRAVITY * l1 * t1.sin();
        let f2 = m2 * l1 * l2 * w1 * w1 * sine - m2 * GRAVITY * l2 * t2.sin();
        let determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        [(m[1][1] * f1 - m[0][1] * f2) / determinant, (m[0][0] * f2 - m[1][0] * f1) / determinant]
    }

    /// Energy, J; 0 with both masses at rest at the height of the upper hinge.
    pub fn energy(&self, [t1, t2]: [f64; 2], [w1, w2]: [f64; 2]) -> f64 {
        let ([m1, m2], [l1, l2]) = (self.masses_kg, self.lengths_m);
        let upper = 0.5 * (m1 + m2) * (l1 * w1).powi(2);
        let kinetic = upper + 0.5 * m2 * (l2 * w2).powi(2) + m2 * l1 * l2 * w1 * w2 * (t1 - t2).cos();
        kinetic - (m1 + m2) * GRAVITY * l1 * t1.cos() - m2 * GRAVITY * l2 * t2.cos()
    }

    /// The two small-angle modes, slow first: angular frequency (rad/s) and the lower rod's angle for one
    /// of the upper.
    pub fn small_angle_modes(&self) -> [(f64, f64); 2] {
        let ([m1, m2], [l1, l2]) = (self.masses_kg, self.lengths_m);
        // m1 l1 l2 w^4 - (m1 + m2) g (l1 + l2) w^2 + (m1 + m2) g^2 = 0.
        let (a, b, c) = (m1 * l1 * l2, (m1 + m2) * GRAVITY * (l1 + l2), (m1 + m2) * GRAVITY * GRAVITY);
        let root = (b * b - 4.0 * a * c).sqrt();
        [2.0 * c / (b + root), (b + root) / (2.0 * a)]
            .map(|squared| (squared.sqrt(), squared * l1 / (GRAVITY - squared * l2)))
    }

    /// Angles and rates after a time, from its own equations by the classical Runge-Kutta scheme.
    pub fn integrate(&self, mut angles: [f64; 2], mut rates: [f64; 2], time_s: f64, steps: u32) -> [[f64; 2]; 2] {
        let h = time_s / f64::from(steps);
        let along = |x: [f64; 2], d: [f64; 2], h: f64| [x[0] + h * d[0], x[1] + h * d[1]];
        for _ in 0..steps {
            let (v1, a1) = (rates, self.acceleration(angles, rates));
            let v2 = along(rates, a1, h / 2.0);
            let a2 = self.acceleration(along(angles, v1, h / 2.0), v2);
            let v3 = along(rates, a2, h / 2.0);
            let a3 = self.acceleration(along(angles, v2, h / 2.0), v3);
            let v4 = along(rates, a3, h);
            let a4 = self.acceleration(along(angles, v3, h), v4);
            let mean = |k: [[f64; 2]; 4]| [0, 1].map(|i| (k[0][i] + 2.0 * (k[1][i] + k[2][i]) + k[3][i]) / 6.0);
            angles = along(angles, mean([v1, v2, v3, v4]), h);
            rates = along(rates, mean([a1, a2, a3, a4]), h);
        }
        [angles, rates]
    }
}
