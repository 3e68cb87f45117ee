//! What flowing water and waves change of the added mass's terms of velocity.
//!
//! The added mass A stands in the inertia of the hull's body, which moves by Kirchhoff's equations for the body's own twist
//! nu: the water pushes with `-(A nu' + nu x* A nu)`. What is different is added here as a load.

use super::{Hull, SeaAxes, SlowFilter};
use crate::dynamics::Loads;
use crate::elements::Moment;
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, SpatialInertia, Twist, Vector3, Wrench};

/// What velocity the terms of the added mass take that are quadratic in it, and whether Munk's moment in yaw is one of them.
///
/// Of motions with the waves these terms are of second order: one part of a whole that `wave_drift` stands for. By
/// themselves they have a mean as large as the drift, and roll a slender ship by differences of the waves' frequencies as
/// much as the waves do. With the slow velocity there is of second order just what `wave_drift` says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuadraticTerms {
    /// They take the slow velocity: waves act.
    pub of_slow_motion: bool,
    /// `-(v x p)_z`, by which a hull that moves obliquely through still water is turned athwart, is in the yaw moments of a
    /// table of current coefficients.
    pub munk_by_table: bool,
}

impl<S: Scalar> Hull<S> {
    /// The load about the body's centre of mass, in its axes, that makes of Kirchhoff's terms for nu those in the water; in
    /// waves, what changes of the inertia goes to `loads`.
    pub(super) fn in_flowing_water(&self, at: &Moment<'_, S>, axes: &SeaAxes<S>, loads: &mut Loads<S>) -> Wrench<S> {
        let own = at.model.added_inertias.iter().filter(|(body, _)| *body == self.frame.body);
        own.fold(Wrench::zero(), |sum, (_, added)| {
            if self.quadratic_terms.of_slow_motion {
                sum + self.in_waves(added, at, axes, loads)
            } else {
                sum + self.in_current(added, at)
            }
        })
    }

    /// A current u, constant in the world, is seen as `nu_r = nu - R^T u`, and `d(R^T u)/dt = -omega x R^T u`:
    /// `F = -(A (nu' + omega x R^T u) + nu_r x* A nu_r)`. A hull that drifts with the current moves as one in still water.
    fn in_current(&self, added: &SpatialInertia<S>, at: &Moment<'_, S>) -> Wrench<S> {
        let twist = at.links.body_twist(at.model, self.frame.body);
        let stream = at.links.to_body_axes(at.model, self.frame.body, at.world.surface_current());
        let relative = Twist { linear: twist.linear - stream, ..twist };
        let turned = Twist { linear: twist.angular.cross(stream), angular: Vector3::zero() };
        twist.cross_momentum(&added.times(&twist)) - added.times(&turned) - self.cross_momentum(added, &relative)
    }

    /// To first order A belongs to the axes of the sea's loads, w = T nu, and what moves with the waves has no quadratic
    /// terms: `F = -T^T (A (T nu' + T' nu) + Q)`. The inertia becomes `T^T A T`; its Kirchhoff terms are given back. Of the
    /// slow velocity are `Q(nu) = nu x* A nu - A (omega x v)`, since w' is the acceleration in the world.
    fn in_waves(
        &self,
        added: &SpatialInertia<S>,
        at: &Moment<'_, S>,
        axes: &SeaAxes<S>,
        loads: &mut Loads<S>,
    ) -> Wrench<S> {
        let seen = axes.inertia_in_body(added);
        loads.added_inertia.push((self.frame.body, seen - *added));
        let slow = self.slow_twist(at, &axes.mean);
        let turned = Twist { linear: slow.angular.cross(slow.linear), angular: Vector3::zero() };
        let quadratic = self.cross_momentum(added, &slow) - added.times(&turned);
        let twist = at.links.body_twist(at.model, self.frame.body);
        let to_first_order = added.times(&axes.drift(&twist));
        twist.cross_momentum(&seen.times(&twist)) - axes.wrench_to_body(&(to_first_order + quadratic))
    }

    /// `nu x* A nu`, without Munk's moment in yaw where a table has it.
    fn cross_momentum(&self, added: &SpatialInertia<S>, twist: &Twist<S>) -> Wrench<S> {
        let momentum = added.times(twist);
        let mut terms = twist.cross_momentum(&momentum);
        if self.quadratic_terms.munk_by_table {
            terms.moment -= Vector3::new(S::ZERO, S::ZERO, twist.linear.cross(momentum.force)[2]);
        }
        terms
    }

    /// The slow motion of the body's centre of mass through the water, in the axes of the hull on average.
    fn slow_twist(&self, at: &Moment<'_, S>, mean: &Matrix3<S>) -> Twist<S> {
        let [x, y, turning] = SlowFilter::read(at.states).output_rates(self.cutoff_rad_s);
        let angular = mean.transpose_times(Vector3::new(S::ZERO, S::ZERO, turning));
        let drift = mean.transpose_times(Vector3::new(x, y, S::ZERO) - at.world.surface_current());
        Twist { linear: drift - angular.cross(self.frame.origin), angular }
    }
}
