//! The uniform cantilever of Euler and Bernoulli (Meirovitch, Fundamentals of Vibrations, section 8.6), and
//! Timoshenko's shear deflection (Timoshenko, Strength of Materials I, section 39).

/// A uniform beam, clamped at one end.
pub struct Cantilever {
    /// m.
    pub length_m: f64,
    /// E I, N m^2.
    pub bending_stiffness: f64,
    /// k G A, N; infinite for a beam that does not shear.
    pub shear_stiffness: f64,
    /// Mass per length, kg/m.
    pub mass_per_length: f64,
}

impl Cantilever {
    /// Deflection of the tip under a force across it there, m: F l^3 / 3 E I + F l / k G A.
    pub fn deflection_by_tip_force(&self, force: f64) -> f64 {
        let l = self.length_m;
        force * l.powi(3) / (3.0 * self.bending_stiffness) + force * l / self.shear_stiffness
    }

    /// Deflection of the tip under a force per length, m: q l^4 / 8 E I + q l^2 / 2 k G A.
    pub fn deflection_by_distributed_force(&self, force_per_length: f64) -> f64 {
        let l = self.length_m;
        force_per_length * l.powi(4) / (8.0 * self.bending_stiffness)
            + force_per_length * l * l / (2.0 * self.shear_stiffness)
    }

    /// Angular frequency of a bending mode, from 1, without shear and rotary inertia, rad/s:
    /// (beta l)^2 sqrt(E I / (m l^4)) with cos(beta l) cosh(beta l) = -1.
    pub fn frequency(&self, mode: u32) -> f64 {
        let root = bending_root(mode);
        root * root * (self.bending_stiffness / (self.mass_per_length * self.length_m.powi(4))).sqrt()
    }
}

/// The root of cos x cosh x = -1 near (mode - 1/2) pi, by bisection of cos x + 1 / cosh x, which
/// does not overflow.
fn bending_root(mode: u32) -> f64 {
    let value = |x: f64| x.cos() + 1.0 / x.cosh();
    let middle = (f64::from(mode) - 0.5) * core::f64::consts::PI;
    let (mut lower, mut upper) = (middle - 0.5, middle + 0.5);
    for _ in 0..60 {
        let x = (lower + upper) / 2.0;
        if (value(x) > 0.0) == (value(lower) > 0.0) { lower = x } else { upper = x }
    }
    (lower + upper) / 2.0
}
