//! The current: steady, the same everywhere at one depth.

use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A current that may decay towards the bottom.
#[derive(Clone, Copy, Debug)]
pub struct Current<S = f64> {
    /// Velocity at the surface, world, m/s.
    pub surface: Vector3<S>,
    /// n of U(z) = U ((h + z) / h)^n over the depth h; `None` where it is the same at all depths.
    pub exponent: Option<S>,
}

impl<S: Scalar> Current<S> {
    /// Water that stands.
    pub fn none() -> Self {
        Self { surface: Vector3::zero(), exponent: None }
    }

    /// The velocity whose square is the mean of that of the current over the draught T, world, m/s: its square is, of that
    /// at the surface, h / T (1 - (1 - T / h)^(2 n + 1)) / (2 n + 1).
    pub fn over(&self, draught: Option<S>, depth: Option<S>) -> Vector3<S> {
        let (Some(exponent), Some(draught), Some(depth)) = (self.exponent, draught, depth) else { return self.surface };
        let power = S::constant(2.0) * exponent + S::ONE;
        let over_part = || (power * (-draught / depth).ln_1p()).exp_m1();
        let left = (depth - draught).select_below(f64::MIN_POSITIVE, || -S::ONE, over_part);
        self.surface * (-left * depth / draught / power).sqrt()
    }
}
