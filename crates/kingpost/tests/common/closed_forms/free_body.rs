//! The free rigid body with three different moments of inertia: Euler's equations solved by Jacobi's
//! elliptic functions (Landau & Lifshitz, Mechanics, 3rd ed., section 37; for the flip of a body
//! about its intermediate axis Rios, Murakami & Impelluso 2017, J. Appl. Mech. 83(11)).

use super::elliptic::{complete_first, first, jacobi};

/// A free rigid body with moments of inertia Ixx < Iyy < Izz, turning with given rates at time 0.
pub struct FreeBody {
    moments: [f64; 3],
    /// Amplitudes of the rates, with the signs of the branch that the body is on.
    amplitudes: [f64; 3],
    /// Axis about which the rate keeps its sign: 0 or 2.
    around: usize,
    frequency: f64,
    parameter: f64,
    phase: f64,
}

impl FreeBody {
    /// The body with moments of inertia (kg m^2) in rising order and its rates at time 0 (rad/s).
    pub fn new(moments: [f64; 3], rates: [f64; 3]) -> Self {
        let [i1, i2, i3] = moments;
        assert!(i1 < i2 && i2 < i3, "moments of inertia in rising order");
        let twice_energy: f64 = (0..3).map(|i| moments[i] * rates[i] * rates[i]).sum();
        let momentum_squared: f64 = (0..3).map(|i| (moments[i] * rates[i]).powi(2)).sum();
        // Of the two the one that is larger belongs to the axis about which the body keeps turning.
        let below = twice_energy * i3 - momentum_squared;
        let above = momentum_squared - twice_energy * i1;
        let about_largest = momentum_squared > twice_energy * i2;
        let around = if about_largest { 2 } else { 0 };
        let sign = if rates[around] < 0.0 { -1.0 } else { 1.0 };
        let middle = if about_largest { below / (i2 * (i3 - i2)) } else { above / (i2 * (i2 - i1)) };
        let mut amplitudes =
            [(below / (i1 * (i3 - i1))).sqrt(), sign * middle.sqrt(), (above / (i3 * (i3 - i1))).sqrt()];
        amplitudes[around] *= sign;
        let (frequency, parameter) = if about_largest {
            (((i3 - i2) * above / (i1 * i2 * i3)).sqrt(), (i2 - i1) * below / ((i3 - i2) * above))
        } else {
            (((i2 - i1) * below / (i1 * i2 * i3)).sqrt(), (i3 - i2) * above / ((i2 - i1) * below))
        };
        let swings = 2 - around;
        let angle = f64::atan2(rates[1] / amplitudes[1], rates[swings] / amplitudes[swings]);
        Self { moments, amplitudes, around, frequency, parameter, phase: first(angle, parameter) }
    }

    /// Rates about x, y, z of the body at a time, rad/s.
    pub fn rates(&self, time_s: f64) -> [f64; 3] {
        let [sn, cn, dn] = jacobi(self.frequency * time_s + self.phase, self.parameter);
        let [a, b, c] = self.amplitudes;
        if self.around == 2 { [a * cn, b * sn, c * dn] } else { [a * dn, b * sn, c * cn] }
    }

    /// Time after which the rates return, s: of a body that starts about its intermediate axis, the
    /// time of two flips.
    pub fn period_s(&self) -> f64 {
        4.0 * complete_first(self.parameter) / self.frequency
    }

    /// Angle by which the body has turned about its angular momentum after a period, rad, up to whole
    /// turns: the integral of psi' = M (I1 w1^2 + I2 w2^2) / (I1^2 w1^2 + I2^2 w2^2) (Landau & Lifshitz
    /// 37.17), by the trapezoidal rule, which converges faster than any power for a periodic function.
    pub fn turn_in_a_period(&self) -> f64 {
        const POINTS: u32 = 512;
        let [i1, i2, _] = self.moments;
        let rate = |point: u32| {
            let [w1, w2, w3] = self.rates(self.period_s() * f64::from(point) / f64::from(POINTS));
            let momentum = [w1, w2, w3].iter().zip(self.moments).map(|(w, i)| (i * w).powi(2)).sum::<f64>().sqrt();
            momentum * (i1 * w1 * w1 + i2 * w2 * w2) / ((i1 * w1).powi(2) + (i2 * w2).powi(2))
        };
        (0..POINTS).map(rate).sum::<f64>() * self.period_s() / f64::from(POINTS)
    }
}
