//! What flowing water and waves change of the added mass's terms of velocity.
//!
//! The added mass A stands in the inertia of the hull's body, which moves by Kirchhoff's equations for the body's own twist
//! nu: the water pushes with `-(A nu' + nu x* A nu)`. What is different is added here as a load.

use super::{Hull, SlowFilter};
use crate::dynamics::Moment;
use crate::scalar::Scalar;
use crate::spatial::{SpatialInertia, Twist, Vector3, Wrench};

/// Where Munk's moment in yaw, `-(v x p)_z` with the water's momentum p = A v, is taken from.
///
/// A hull that moves obliquely through still water is turned athwart by it. It is a product of two velocities. In waves,
/// first-order loads that act at the moving centre have the mean moment `-(v x p)_z` about a fixed point, as large as that of
/// the drift, and Kirchhoff's equations alone have none. Without Munk's moment the two cancel, and of second order there is
/// just what `wave_drift` says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MunkMoment {
    /// The velocity as it is: no waves act.
    Whole,
    /// The slow velocity: what goes with the waves is of second order, and belongs to the mean drift.
    Slow,
    /// It is in the yaw moments of a table of current coefficients.
    InCoefficients,
}

impl<S: Scalar> Hull<S> {
    /// The load about the body's centre of mass, in its axes, that makes of Kirchhoff's terms for nu those in the water.
    ///
    /// A current u, constant in the world, is seen as `nu_r = nu - R^T u`, and `d(R^T u)/dt = -omega x R^T u`:
    /// `F = -(A (nu' + omega x R^T u) + nu_r x* A nu_r)`. A hull that drifts with the current moves as one in still water.
    pub(super) fn in_flowing_water(&self, at: &Moment<'_, S>) -> Wrench<S> {
        let own = at.model.added_inertias.iter().filter(|(body, _)| *body == self.frame.body);
        let twist = at.links.body_twist(at.model, self.frame.body);
        let stream = at.links.to_body_axes(at.model, self.frame.body, self.current);
        let relative = Twist { linear: twist.linear - stream, ..twist };
        let turned = Twist { linear: twist.angular.cross(stream), angular: Vector3::zero() };
        own.fold(Wrench::zero(), |mut sum, (_, added)| {
            sum += twist.cross_momentum(&added.times(&twist));
            sum += -relative.cross_momentum(&added.times(&relative));
            sum += -added.times(&turned);
            sum.moment += self.munk_instead(added, &relative, at);
            sum
        })
    }

    /// Munk's moment as it is to be, less that of the whole velocity.
    fn munk_instead(&self, added: &SpatialInertia<S>, relative: &Twist<S>, at: &Moment<'_, S>) -> Vector3<S> {
        let wanted = match self.munk_moment {
            MunkMoment::Whole => return Vector3::zero(),
            MunkMoment::Slow => munk_moment(added, &self.slow_twist(at)),
            MunkMoment::InCoefficients => S::ZERO,
        };
        Vector3::new(S::ZERO, S::ZERO, wanted - munk_moment(added, relative))
    }

    /// The slow motion of the body's centre of mass through the water, in level axes of the slow heading.
    fn slow_twist(&self, at: &Moment<'_, S>) -> Twist<S> {
        let filter = SlowFilter::read(&at.held[self.first_held..]);
        let [x, y, turning] = filter.rates(self.cutoff_rad_s);
        let drift = Vector3::new(x, y, S::ZERO) - self.current;
        let angular = Vector3::new(S::ZERO, S::ZERO, turning);
        let linear = filter.frame().rotation().transpose_times(drift) - angular.cross(self.frame.origin);
        Twist { linear, angular }
    }
}

/// `-(v x p)_z` of the horizontal velocity.
fn munk_moment<S: Scalar>(added: &SpatialInertia<S>, twist: &Twist<S>) -> S {
    let momentum = added.times(twist).force;
    twist.linear[1] * momentum[0] - twist.linear[0] * momentum[1]
}
