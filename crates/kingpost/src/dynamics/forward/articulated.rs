//! A link with its articulated subtree.

use crate::dynamics::moving_link::MovingLink;
use crate::scalar::Scalar;
use crate::spatial::{SpatialInertia, Twist, Wrench};

/// A link with its articulated subtree, root axes; symbols as in Featherstone, *Rigid Body Dynamics Algorithms*, 2008,
/// table 7.1.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Articulated<S> {
    /// Inertia in addition to the link's own: that transmitted by its joints to other links, and that of parts that are
    /// not rigid bodies.
    more: SpatialInertia<S>,
    /// Whether there is any such inertia.
    pub has_more: bool,
    /// p^A, articulated bias force: the force for the bias acceleration, less the loads.
    pub bias: Wrench<S>,
    /// U, articulated inertia times the joint's axis.
    pub gain: Wrench<S>,
    /// 1/D, reciprocal inertia along the joint's axis, the rotor's included, 1/kg or 1/(kg m^2).
    pub compliance: S,
    /// u, remaining force along the joint's axis, which accelerates it.
    pub drive: S,
    /// Acceleration beyond the bias acceleration and free fall.
    pub response: Twist<S>,
}

impl<S: Scalar> Articulated<S> {
    /// Articulated inertia.
    #[inline]
    pub fn inertia(&self, moving: &MovingLink<S>) -> SpatialInertia<S> {
        if self.has_more { self.more.plus_rigid(&moving.inertia) } else { moving.inertia.to_spatial() }
    }

    /// Adds an inertia to the link's own.
    #[inline]
    pub fn carry(&mut self, inertia: &SpatialInertia<S>) {
        self.more = if self.has_more { self.more + *inertia } else { *inertia };
        self.has_more = true;
    }

    /// A joint that is free along its axis S: `U = I^A S`, `D = S . U + rotor`, `u = tau - S . p^A`; the parent takes
    /// `I^A - U U^T / D` and `p^A + U u / D`. At the end of a branch I^A has ten numbers.
    #[inline]
    pub fn project_articulated_inertia(
        &mut self,
        moving: &MovingLink<S>,
        force: S,
        rotor: S,
        parent: Option<&mut Self>,
    ) {
        if self.has_more {
            let inertia = self.more.plus_rigid(&moving.inertia);
            self.resolve(inertia.times(&moving.axis), &moving.axis, force, rotor);
            self.hand_over(&inertia, parent);
        } else {
            self.resolve(moving.inertia.times(&moving.axis), &moving.axis, force, rotor);
            self.hand_over(&moving.inertia.to_spatial(), parent);
        }
    }

    /// Computes U, 1/D and u.
    #[inline]
    fn resolve(&mut self, gain: Wrench<S>, axis: &Twist<S>, force: S, rotor: S) {
        self.compliance = S::ONE / (gain.dot(axis) + rotor);
        self.drive = force - self.bias.dot(axis);
        self.gain = gain;
    }

    #[inline]
    fn hand_over(&self, inertia: &SpatialInertia<S>, parent: Option<&mut Self>) {
        let Some(parent) = parent else { return };
        parent.carry(&inertia.minus_outer(&self.gain, self.compliance));
        parent.bias += self.bias + self.gain * (self.drive * self.compliance);
    }
}
