//! A link of the recursion: its position, motion, inertia, and the force due to its bias acceleration.
//!
//! The kernels of the outward pass, one per joint. Each is compiled once for a parent that is the root of the branch,
//! whose frame is that of the root axes, and once for other parents.

use super::ball::Ball;
use super::bias_acceleration::LinkMotion;
use crate::model::joint::Floating;
use crate::model::{Carrier, Link, LinkJoint, Moments};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, Quaternion, RigidInertia, SpatialInertia, Twist, Vector3, Wrench};

/// A link, in root axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct MovingLink<S> {
    /// Frame of the link.
    pub in_root: Frame<S>,
    /// Twist about the root's origin per unit rate of the link's joint, if the joint has one axis.
    pub axis: Twist<S>,
    /// Twist and bias acceleration.
    pub motion: LinkMotion<S>,
    /// Inertia about the root's origin; zero if it is not that of a rigid body.
    pub inertia: RigidInertia<S>,
    /// Wrench for the bias acceleration, about the root's origin.
    pub bias: Wrench<S>,
}

/// Pose of a joint on its parent, root axes.
struct Seat<S> {
    /// Axes of the link with the coordinates at zero.
    rotation: Matrix3<S>,
    /// Vector from the parent's origin to the joint, m.
    way: Vector3<S>,
    /// Vector from the root's origin to the joint, m.
    position: Vector3<S>,
}

impl<S: Scalar> Seat<S> {
    /// Returns the seat on the root of the branch.
    #[inline(always)]
    fn on_root(plan: &Link<S>) -> Self {
        let Frame { rotation, position } = plan.placement;
        Self { rotation, way: position, position }
    }

    /// Returns the seat on a parent that is not the root.
    #[inline(always)]
    fn on_link(parent: &MovingLink<S>, plan: &Link<S>) -> Self {
        let Frame { rotation, position } = &parent.in_root;
        let way = *rotation * plan.placement.position;
        Self { rotation: *rotation * plan.placement.rotation, way, position: *position + way }
    }

    /// Returns the twist per unit rate about the link's z.
    #[inline(always)]
    fn hinge(&self) -> Twist<S> {
        let z = self.rotation.column(2);
        Twist { angular: z, linear: self.position.cross(z) }
    }

    /// Returns the twist per unit rate along the link's z.
    #[inline(always)]
    fn slide(&self) -> Twist<S> {
        Twist { angular: Vector3::zero(), linear: self.rotation.column(2) }
    }
}

impl<S: Scalar> MovingLink<S> {
    /// Returns a link at the root's origin and at rest, without inertia: the constant values for a root's
    /// frame, for an inertia that is not that of a rigid body, and for the axis of a joint on the root.
    pub fn still(plan: &Link<S>) -> Self {
        let axis = match (plan.carrier, plan.joint) {
            (Carrier::Root(_), LinkJoint::Revolute) => Seat::on_root(plan).hinge(),
            (Carrier::Root(_), LinkJoint::Prismatic) => Seat::on_root(plan).slide(),
            _ => Twist::zero(),
        };
        Self {
            in_root: Frame::identity(),
            axis,
            motion: LinkMotion::default(),
            inertia: RigidInertia::default(),
            bias: Wrench::zero(),
        }
    }

    /// Updates a link on the world; `in_world` is its frame and that of its branch.
    #[inline]
    pub fn stand(&mut self, plan: &Link<S>, q: &[S], v: &[S], in_world: &mut Frame<S>) {
        if plan.joint == LinkJoint::Floating {
            *in_world = Floating::relative(q);
            self.motion = LinkMotion::floating(Floating::twist(in_world, v));
        } else {
            *in_world = self.stand_on_joint(plan, q, v);
        }
    }

    #[inline(never)]
    fn stand_on_joint(&mut self, plan: &Link<S>, q: &[S], v: &[S]) -> Frame<S> {
        let (world, z) = (LinkMotion::default(), Vector3::new(S::ZERO, S::ZERO, S::ONE));
        let (arm, Frame { rotation, position }) = (plan.to_child, plan.placement);
        let turned = |rotation: Matrix3<S>| Frame { rotation, position: position + rotation * arm };
        match plan.joint {
            LinkJoint::Floating => Frame::identity(),
            LinkJoint::Revolute => {
                self.axis = Twist { angular: z, linear: z.cross(arm) };
                self.motion = world.turned(&(self.axis * v[0]), Vector3::zero(), arm);
                turned(rotation.turned_about_z(q[0].sin_cos()))
            }
            LinkJoint::Prismatic => {
                self.axis = Twist { angular: Vector3::zero(), linear: z };
                self.motion = world.slid(z * v[0], Vector3::zero());
                Frame { rotation, position: position + rotation * (arm + z * q[0]) }
            }
            LinkJoint::Spherical => {
                let own = Ball::new(plan, &self.in_root).twist(v);
                self.motion = world.turned(&own, Vector3::zero(), arm);
                turned(rotation * Quaternion::from_slice(q).to_matrix())
            }
        }
    }

    /// Updates a link on the root of its branch.
    #[inline]
    pub fn mount_on_root(&mut self, plan: &Link<S>, root: &Self, q: &[S], v: &[S]) {
        match plan.joint {
            LinkJoint::Floating => {}
            LinkJoint::Revolute => self.hinge(plan, &root.motion, &Seat::on_root(plan), q, v),
            LinkJoint::Prismatic => self.slide(plan, &root.motion, &Seat::on_root(plan), q, v),
            LinkJoint::Spherical => self.ball(plan, &root.motion, &Seat::on_root(plan), q, v),
        }
    }

    /// Updates a link whose parent is not the root.
    #[inline]
    pub fn mount(&mut self, plan: &Link<S>, parent: &Self, q: &[S], v: &[S]) {
        match plan.joint {
            LinkJoint::Floating => {}
            LinkJoint::Revolute => {
                let seat = Seat::on_link(parent, plan);
                self.axis = seat.hinge();
                self.hinge(plan, &parent.motion, &seat, q, v);
            }
            LinkJoint::Prismatic => {
                let seat = Seat::on_link(parent, plan);
                self.axis = seat.slide();
                self.slide(plan, &parent.motion, &seat, q, v);
            }
            LinkJoint::Spherical => self.ball(plan, &parent.motion, &Seat::on_link(parent, plan), q, v),
        }
    }

    /// Updates a link on a revolute joint: `R = R_seat Rz(angle)`.
    #[inline(always)]
    fn hinge(&mut self, plan: &Link<S>, parent: &LinkMotion<S>, seat: &Seat<S>, q: &[S], v: &[S]) {
        let rotation = seat.rotation.turned_about_z(q[plan.positions].sin_cos());
        let arm = rotation * plan.to_child;
        self.in_root = Frame { rotation, position: seat.position + arm };
        self.motion = parent.turned(&(self.axis * v[plan.velocities]), seat.way, arm);
    }

    /// Updates a link on a prismatic joint: `R = R_seat`.
    #[inline(always)]
    fn slide(&mut self, plan: &Link<S>, parent: &LinkMotion<S>, seat: &Seat<S>, q: &[S], v: &[S]) {
        let z = self.axis.linear;
        let arm = seat.rotation * plan.to_child + z * q[plan.positions];
        self.in_root = Frame { rotation: seat.rotation, position: seat.position + arm };
        self.motion = parent.slid(z * v[plan.velocities], seat.way + arm);
    }

    /// Updates a link on a ball joint: `R = R_seat R(q)`.
    #[inline(never)]
    fn ball(&mut self, plan: &Link<S>, parent: &LinkMotion<S>, seat: &Seat<S>, q: &[S], v: &[S]) {
        let rotation = seat.rotation * Quaternion::from_slice(&q[plan.positions..]).to_matrix();
        let arm = rotation * plan.to_child;
        self.in_root = Frame { rotation, position: seat.position + arm };
        let own = Ball::new(plan, &self.in_root).twist(&v[plan.velocities..]);
        self.motion = parent.turned(&own, seat.way, arm);
    }

    /// Computes the inertia of a link with its frame at the centre of mass, in root axes, and the force for
    /// its bias acceleration by Newton and Euler: `f = m a, n = J alpha + omega x J omega`.
    #[inline]
    pub fn take_central(&mut self, mass: S, moments: &Moments<S>) {
        let LinkMotion { twist, bias_acceleration } = &self.motion;
        let (centre, moments) = (self.in_root.position, moments.rotated(&self.in_root.rotation));
        let force = bias_acceleration.linear * mass;
        let about_centre = moments * bias_acceleration.angular + twist.angular.cross(moments * twist.angular);
        self.bias = Wrench { moment: about_centre + centre.cross(force), force };
        self.inertia = RigidInertia::of_centre(mass, centre, &moments);
    }

    /// Computes the inertia of a floating link, which rotates at a constant rate about the origin of its
    /// frame, and the force for its bias acceleration.
    #[inline]
    pub fn take_rigid(&mut self, rigid: &RigidInertia<S>) {
        let LinkMotion { twist, bias_acceleration } = &self.motion;
        let moment = twist.angular.cross(rigid.moments * twist.angular);
        self.bias = Wrench { moment, force: bias_acceleration.gradient * rigid.first_moment };
        self.inertia = *rigid;
    }

    /// Computes the force for the bias acceleration of an inertia that is not that of a rigid body; returns
    /// the inertia in root axes.
    #[inline(never)]
    pub fn take_full(&mut self, full: &SpatialInertia<S>) -> SpatialInertia<S> {
        let full = full.to_parent(&self.in_root);
        self.bias = self.kirchhoff(&full);
        full
    }

    /// Computes the force for the bias acceleration of an inertia in root axes by Kirchhoff's equations, `I a
    /// + v x* I v`.
    #[inline]
    pub fn kirchhoff(&self, inertia: &SpatialInertia<S>) -> Wrench<S> {
        inertia.times(&self.spatial_bias_acceleration())
            + self.motion.twist.cross_momentum(&inertia.times(&self.motion.twist))
    }

    /// Returns the rate of the twist about the root's origin for zero accelerations of all coordinates.
    #[inline]
    pub fn spatial_bias_acceleration(&self) -> Twist<S> {
        self.motion.spatial_bias_acceleration(self.in_root.position)
    }
}
