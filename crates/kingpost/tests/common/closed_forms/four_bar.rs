//! The four-bar linkage (Freudenstein, Trans. ASME 77, 1955; Norton, Design of Machinery, 5th ed. 2012,
//! chapters 4 and 6).

/// Lengths of the links between their pins. The ground lies along x; the crank turns about its
/// beginning, the rocker about its end.
pub struct FourBar {
    /// Between the two fixed pins, m.
    pub ground_m: f64,
    /// m.
    pub crank_m: f64,
    /// m.
    pub coupler_m: f64,
    /// m.
    pub rocker_m: f64,
}

impl FourBar {
    /// Angles of coupler and rocker from x (rad) at an angle of the crank, by Freudenstein's equation, and
    /// their rates per rate of the crank (Norton, eqs. 4.10 and 6.18), for the open circuit.
    pub fn follow(&self, crank: f64) -> ([f64; 2], [f64; 2]) {
        let Self { ground_m, crank_m, coupler_m, rocker_m } = *self;
        let (k1, k2) = (ground_m / crank_m, ground_m / rocker_m);
        let squares = crank_m.powi(2) - coupler_m.powi(2) + rocker_m.powi(2) + ground_m.powi(2);
        let k3 = squares / (2.0 * crank_m * rocker_m);
        let (sin, cos) = crank.sin_cos();
        let (a, b, c) = (cos - k1 - k2 * cos + k3, -2.0 * sin, k1 - (k2 + 1.0) * cos + k3);
        let rocker = 2.0 * (-b - (b * b - 4.0 * a * c).sqrt()).atan2(2.0 * a);
        let (x, z) = (ground_m + rocker_m * rocker.cos() - crank_m * cos, rocker_m * rocker.sin() - crank_m * sin);
        let coupler = z.atan2(x);
        let rates = [
            crank_m / coupler_m * (rocker - crank).sin() / (coupler - rocker).sin(),
            crank_m / rocker_m * (crank - coupler).sin() / (rocker - coupler).sin(),
        ];
        ([coupler, rocker], rates)
    }
}
