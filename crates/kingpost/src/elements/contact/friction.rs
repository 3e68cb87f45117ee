//! Dry friction: it holds by an elastic bristle until it slides.

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
    /// The bristle z, m, along the surface.
    pub bristle: Vector3<S>,
    /// m.
    pub along: Vector3<S>,
    /// v, along the surface, m/s.
    pub slip: Vector3<S>,
    /// Damping over stiffness of a bristle that holds, s.
    pub damping_time: S,
}

/// The shortest time in which the bristle turns into the direction of sliding, s: shorter than any motion of a load,
/// and long enough for steps of 50 ms.
const TURNING_S: f64 = 0.02;

/// Largest friction, as a share of its limit, with which a spot begins to hold.
pub(super) const RESTS: f64 = 1.0 - 2e-9;

/// Factor on the cosine between bristle and slip: the fading terms act in full up to 84 degrees.
const FADING: f64 = 10.0;

/// tau_0, s: it makes a new bristle, of length 0, point along the slip.
const AIMING_S: f64 = 1e-3;

impl<S: Scalar> Friction<S> {
    /// `f = sigma (z + tau v)`, z' = v: it holds.
    pub fn holding(&self, at: &Rubbing<S>) -> FrictionForce<S> {
        let damping = self.stiffness * at.damping_time;
        let force = at.along * self.stiffness + at.slip * damping;
        FrictionForce { force, rate: at.slip, heat: damping * at.slip.norm_squared() }
    }

    /// `f = mu N u / |u|`, `u = z + (tau + tau_0) v`, `z' = (l v / |v| - z) min(|v| / l, 1/T)` with `l = mu N / sigma`:
    /// it slides until z . v = 0. Near that point the terms with v fade. Beyond it, where no step ends, f and z keep
    /// their direction, so that an implicit step across it has a solution.
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

    /// The bristle after it has slid to z . v = 0, and whether it then holds. The damping of the slip across it limits
    /// its length; if that damping exceeds mu N, it slides on in that direction.
    pub fn after_sliding(&self, at: &Rubbing<S>) -> (Vector3<S>, bool) {
        let (speed, limit) = (length(at.slip), at.limit * S::constant(RESTS));
        let damping = self.stiffness * at.damping_time * speed;
        if (damping - limit).all(|beyond| beyond < 0.0) {
            return (self.within_limit(at.along, (limit * limit - damping * damping).sqrt()), true);
        }
        (at.slip * (length(self.within_limit(at.along, limit)) / speed), false)
    }

    /// Friction that holds up to mu N, for use where no mode says whether the spot slides.
    pub fn up_to_its_limit(&self, at: &Rubbing<S>) -> FrictionForce<S> {
        let FrictionForce { force, .. } = self.holding(at);
        let size = length(force);
        let share = at.limit.select_less(size, || at.limit / size, || S::ONE);
        let touches = at.limit.select_below(f64::MIN_POSITIVE, || S::ZERO, || S::ONE);
        let (force, rate) = (force * share, at.slip * touches);
        FrictionForce { force, rate, heat: force.dot(at.slip) - self.stiffness * at.bristle.dot(rate) }
    }

    /// The bristle, shortened to its limit.
    pub fn within_limit(&self, along: Vector3<S>, limit: S) -> Vector3<S> {
        let (size, most) = (length(along), limit / self.stiffness);
        along * most.select_less(size, || most / size, || S::ONE)
    }
}
