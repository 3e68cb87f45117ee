//! Dry friction: an elastic bristle holds until the contact slides.

use super::length::length;
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

/// The friction force at a spot, in the solid's axes.
#[derive(Clone, Copy, Debug)]
pub struct FrictionForce<S> {
    /// Force on the body that slides over the solid, N.
    pub force: Vector3<S>,
    /// Rate of the bristle, m/s.
    pub rate: Vector3<S>,
    /// W.
    pub heat: S,
}

/// A spot that is pressed on a surface and moves along it.
#[derive(Clone, Copy, Debug)]
pub struct Rubbing<S> {
    /// mu N, N.
    pub limit: S,
    /// The bristle z, in the axes of the solid, m.
    pub bristle: Vector3<S>,
    /// Component of z along the surface, m.
    pub along: Vector3<S>,
    /// v, along the surface, m/s.
    pub slip: Vector3<S>,
    /// tau: damping over stiffness of a bristle that holds, s.
    pub damping_time: S,
}

/// The shortest time in which the bristle turns into the direction of sliding, s: shorter than any motion of a load,
/// and long enough for steps of 50 ms.
const TURNING_S: f64 = 0.02;

/// Largest friction, as a share of its limit, at which a spot begins to hold.
pub(super) const RESTS: f64 = 1.0 - 2e-9;

/// Factor on the cosine of the angle between bristle and slip: up to 84 degrees the terms with v act in full; beyond
/// that they fade.
const FADING: f64 = 10.0;

/// tau_0, s: it directs a new bristle, of length 0, along the slip.
const AIMING_S: f64 = 1e-3;

impl<S: Scalar> Friction<S> {
    /// Returns the friction of a spot that holds: `f = sigma (z + tau v)`, z' = v.
    pub fn holding(&self, at: &Rubbing<S>) -> FrictionForce<S> {
        let damping = self.stiffness * at.damping_time;
        let force = at.along * self.stiffness + at.slip * damping;
        FrictionForce { force, rate: at.slip, heat: damping * at.slip.norm_squared() }
    }

    /// Returns the friction of a spot that slides: `f = mu N u / |u|`, `u = z + (tau + tau_0) v`, `z' = (l v / |v| - z)
    /// min(|v| / l, 1/T)` with `l = mu N / sigma`, until z . v = 0. Near that point the terms with v fade. Beyond it,
    /// where no step ends, f and z keep their direction, so that an implicit step across it has a solution.
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

    /// Returns the bristle of a spot that has slid to z . v = 0, and whether the spot then holds. The damping force of
    /// the slip across the bristle limits the bristle's length; if that force exceeds mu N, the spot slides on in that
    /// direction.
    pub fn after_sliding(&self, at: &Rubbing<S>) -> (Vector3<S>, bool) {
        let (speed, limit) = (length(at.slip), at.limit * S::constant(RESTS));
        let damping = self.stiffness * at.damping_time * speed;
        if (damping - limit).all(|beyond| beyond < 0.0) {
            return (self.within_limit(at.along, (limit * limit - damping * damping).sqrt()), true);
        }
        (at.slip * (length(self.within_limit(at.along, limit)) / speed), false)
    }

    /// Returns friction that holds up to mu N, for states without a mode of holding or sliding.
    pub fn up_to_its_limit(&self, at: &Rubbing<S>) -> FrictionForce<S> {
        let FrictionForce { force, .. } = self.holding(at);
        let size = length(force);
        let share = at.limit.select_less(size, || at.limit / size, || S::ONE);
        let touches = at.limit.select_below(f64::MIN_POSITIVE, || S::ZERO, || S::ONE);
        let (force, rate) = (force * share, at.slip * touches);
        FrictionForce { force, rate, heat: force.dot(at.slip) - self.stiffness * at.bristle.dot(rate) }
    }

    /// Returns the bristle, shortened to the length at which its force is `limit`.
    pub fn within_limit(&self, along: Vector3<S>, limit: S) -> Vector3<S> {
        let (size, most) = (length(along), limit / self.stiffness);
        along * most.select_less(size, || most / size, || S::ONE)
    }
}
