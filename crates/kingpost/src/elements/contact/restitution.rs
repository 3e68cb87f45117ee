//! Dissipation coefficient of a contact from its coefficient of restitution.

use crate::scalar::Scalar;

/// Number of bisection steps: enough to reach rounding error.
const HALVINGS: usize = 60;

/// Below this x the series is more accurate than the difference of logarithms.
const SMALL: f64 = 1e-3;

/// Returns the dissipation a of `F = k d (1 + a d')`, s/m, for which a body that arrives at `speed`, m/s, rebounds at e
/// times that speed.
///
/// With x = a v, integration of `m v dv / (1 + a v) = -k d dd` over one impact gives `x (1 + e) = ln((1 + x) / (1 - e
/// x))`: exact without other forces, for any mass and stiffness (Hunt & Crossley, *J. Appl. Mech.* 42, 1975, 440;
/// solved for a as by Marhefka & Orin, *IEEE Trans. Syst. Man Cybern. A* 29, 1999, 566). For small losses x = 3/2 (1 -
/// e) (2 - e).
///
/// ```
/// use kingpost::elements::contact::dissipation;
/// let x: f64 = dissipation(0.5, 1.0);
/// assert!((x * 1.5 - ((1.0 + x) / (1.0 - 0.5 * x)).ln()).abs() < 1e-14);
/// assert_eq!(dissipation(1.0, 1.0), 0.0);
/// ```
pub fn dissipation<S: Scalar>(restitution: S, speed: S) -> S {
    let [found] = S::from_values([restitution], &|[e]| [scaled(e)]);
    let loss = S::ONE - restitution;
    let small = loss * (S::ONE + loss) * S::constant(1.5);
    // One more Newton step carries the derivatives of restitution and speed.
    let next = found - residual(found, restitution) / slope(found, restitution);
    found.select_below(SMALL, || small, || next) / speed
}

fn residual<S: Scalar>(x: S, e: S) -> S {
    x * (S::ONE + e) - x.ln_1p() + (-(e * x)).ln_1p()
}

fn slope<S: Scalar>(x: S, e: S) -> S {
    S::ONE + e - S::ONE / (S::ONE + x) - e / (S::ONE - e * x)
}

/// Solves for x by bisection: the residual is largest at (1 - e) / e and falls from there to minus infinity at the
/// pole.
fn scaled(e: f64) -> f64 {
    if e >= 1.0 {
        return 0.0;
    }
    let (mut low, mut high) = ((1.0 - e) / e, 1.0 / e);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if residual(middle, e) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}
