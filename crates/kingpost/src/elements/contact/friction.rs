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
pub struct FrictionForce<S> {
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

/// Of its limit, the most that friction which begins to hold has.
pub(super) const RESTS: f64 = 1.0 - 2e-9;

/// Over the cosine between bristle and slip: what fades is all there up to 84 degrees.
const FADING: f64 = 10.0;

/// tau_0, s: a bristle that has just begun, of no length, points along the slip.
const AIMING_S: f64 = 1e-3;

impl<S: Scalar> Friction<S> {
    /// `f = sigma (z + tau v)`, z' = v: it holds.
    pub fn holding(&self, at: &Rubbing<S>) -> FrictionForce<S> {
        let damping = self.stiffness * at.damping_time;
        let force = at.along * self.stiffness + at.slip * damping;
        FrictionForce { force, rate: at.slip, heat: damping * at.slip.norm_squared() }
    }

    /// `f = mu N u / |u|`, `u = z + (tau + tau_0) v`, `z' = (l v / |v| - z) min(|v| / l, 1/T)` with `l = mu N / sigma`: it slides, until
    /// z . v = 0. Towards that, the parts by v fade; beyond, where no step ends, f and z keep their direction, so that an implicit step
    /// over it can be found.
    pub fn sliding(&self, at: &Rubbing<S>) -> FrictionForce<S> {
        let cosine = at.along.dot(at.slip) / (length(at.along) * length(at.slip));
        let onwards = (cosine * S::constant(FADING)).clipped(S::ZERO, S::ONE);
        let against = at.along + at.slip * ((at.damping_time + S::constant(AIMING_S)) * onwards);
        let force = against * (at.limit / length(against));
        let (speed, slack) = (length(at.slip), at.limit / self.stiffness);
        let turning = S::constant(TURNING_S);
        let rate = Vector3(core::array::from_fn(|i| {
            let slowly = || at.slip[i] - at.along[i] * (speed / slack);
            let fast = || (at.slip[i] * (slack / speed) - at.along[i]) / turning;
            (speed * turning).select_less(slack, slowly, fast) * onwards
        }));
        FrictionForce { force, rate, heat: force.dot(at.slip) - self.stiffness * at.bristle.dot(rate) }
    }

    /// What a bristle that has slid to z . v = 0 is from there, and whether it holds: as long as the damping of the slip across it
    /// leaves room for; where that is more than mu N, it slides on that way.
    pub fn after_sliding(&self, at: &Rubbing<S>) -> (Vector3<S>, bool) {
        let (speed, limit) = (length(at.slip), at.limit * S::constant(RESTS));
        let damping = self.stiffness * at.damping_time * speed;
        if (damping - limit).all(|beyond| beyond < 0.0) {
            return (self.within_limit(at.along, (limit * limit - damping * damping).sqrt()), true);
        }
        (at.slip * (length(self.within_limit(at.along, limit)) / speed), false)
    }

    /// It holds up to mu N: where no mode says whether it slides.
    pub fn up_to_its_limit(&self, at: &Rubbing<S>) -> FrictionForce<S> {
        let FrictionForce { force, .. } = self.holding(at);
        let size = length(force);
        let share = at.limit.select_less(size, || at.limit / size, || S::ONE);
        let touches = at.limit.select_below(f64::MIN_POSITIVE, || S::ZERO, || S::ONE);
        let (force, rate) = (force * share, at.slip * touches);
        FrictionForce { force, rate, heat: force.dot(at.slip) - self.stiffness * at.bristle.dot(rate) }
    }

    /// The bristle no longer than its limit lets it.
    pub fn within_limit(&self, along: Vector3<S>, limit: S) -> Vector3<S> {
        let (size, most) = (length(along), limit / self.stiffness);
        along * most.select_less(size, || most / size, || S::ONE)
    }
}
