//! Dry friction that holds: an elastic bristle, until it slides.

use super::solid::length;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Coulomb's law with elastic bristles.
#[derive(Clone, Copy, Debug)]
pub struct Friction<S = f64> {
    /// mu.
    pub coefficient: S,
    /// sigma, N/m.
    pub stiffness: S,
}

/// What friction does at a spot, in the solid's axes.
#[derive(Clone, Copy, Debug)]
pub struct Drag<S> {
    /// Against what slides over the solid, N.
    pub force: Vector3<S>,
    /// Of the bristle, m/s.
    pub rate: Vector3<S>,
    /// W.
    pub heat: S,
}

/// A spot that is pressed on and moves along a surface.
#[derive(Clone, Copy, Debug)]
pub struct Rubbing<S> {
    /// mu N, N.
    pub limit: S,
    /// The bristle z, m, and its part along the surface.
    pub bristle: Vector3<S>,
    /// m.
    pub along: Vector3<S>,
    /// v, along the surface, m/s.
    pub slip: Vector3<S>,
    /// Damping over stiffness of the bristle that holds, s.
    pub damping_time: S,
}

/// The least time in which the bristle turns to the way of sliding, s: shorter than any motion of a load, and long enough for
/// steps of 50 ms.
const TURNING_S: f64 = 0.02;

impl<S: Scalar> Friction<S> {
    /// `f = sigma (z + tau v)`, z' = v: it holds.
    pub fn holding(&self, at: &Rubbing<S>) -> Drag<S> {
        let damping = self.stiffness * at.damping_time;
        let force = at.along * self.stiffness + at.slip * damping;
        Drag { force, rate: at.slip, heat: damping * at.slip.norm_squared() }
    }

    /// `f = mu N z / |z|`, `z' = (l v / |v| - z) min(|v| / l, 1/T)` with `l = mu N / sigma`: it slides.
    pub fn sliding(&self, at: &Rubbing<S>) -> Drag<S> {
        let force = at.along * (at.limit / length(at.along));
        let (speed, slack) = (length(at.slip), at.limit / self.stiffness);
        let turning = S::constant(TURNING_S);
        let rate = Vector3(core::array::from_fn(|i| {
            let slowly = || at.slip[i] - at.along[i] * (speed / slack);
            let fast = || (at.slip[i] * (slack / speed) - at.along[i]) / turning;
            (speed * turning).select_less(slack, slowly, fast)
        }));
        Drag { force, rate, heat: force.dot(at.slip) - self.stiffness * at.bristle.dot(rate) }
    }

    /// It holds up to mu N: where no mode says whether it slides.
    pub fn up_to_its_limit(&self, at: &Rubbing<S>) -> Drag<S> {
        let Drag { force, .. } = self.holding(at);
        let size = length(force);
        let share = at.limit.select_less(size, || at.limit / size, || S::ONE);
        let touches = at.limit.select_below(f64::MIN_POSITIVE, || S::ZERO, || S::ONE);
        let (force, rate) = (force * share, at.slip * touches);
        Drag { force, rate, heat: force.dot(at.slip) - self.stiffness * at.bristle.dot(rate) }
    }

    /// The bristle no longer than its limit lets it.
    pub fn within_limit(&self, along: Vector3<S>, limit: S) -> Vector3<S> {
        let (size, most) = (length(along), limit / self.stiffness);
        along * most.select_less(size, || most / size, || S::ONE)
    }
}
