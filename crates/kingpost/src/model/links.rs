//! Links of the recursion: groups of bodies that are fixed to each other, each in a frame in which its joint
//! is simple.

use super::joint::Floating;
use super::{Body, JointKind, MotionType, Node, Tree};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, RigidInertia, SpatialInertia, Symmetric3, Vector3};

/// Constants of a link for the recursion.
#[derive(Clone, Copy, Debug)]
pub struct Link<S = f64> {
    /// The link's parent.
    pub carrier: Carrier,
    /// The joint to the parent.
    pub joint: LinkJoint,
    /// Whether the translation or the rotation of a floating joint is held.
    pub floating: Floating,
    /// Mode of a joint with one axis, or whether a ball joint is held.
    pub mode: MotionType,
    /// First entry in q.
    pub positions: usize,
    /// First entry in v.
    pub velocities: usize,
    /// Frame of the joint in the parent's frame: the link's axes with the coordinates at zero.
    pub placement: Frame<S>,
    /// Vector from the joint to the origin of the link's frame, link axes, m.
    pub to_child: Vector3<S>,
    /// Inertia.
    pub inertia: LinkInertia<S>,
    /// Mass of the link's bodies, kg, for their weight. An inertia that is not that of a rigid body also
    /// contains added mass.
    pub mass: S,
    /// First moment of this mass: mass times its centre in the link's axes, kg m.
    pub first_moment: Vector3<S>,
    /// Whether the inertia contains only this mass, so that the link falls freely under its weight alone.
    pub falls: bool,
}

/// Parent of a link. Links are numbered from the roots outward.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carrier {
    /// The world: the link is the root of its branch.
    World,
    /// The root of the link's branch.
    Root(usize),
    /// Another link of the branch.
    Branch(usize),
}

/// The joints of links.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkJoint {
    /// Six degrees of freedom relative to the world.
    Floating,
    /// Rotation about the link's z axis.
    Revolute,
    /// Translation along the link's z axis.
    Prismatic,
    /// Rotation about a point.
    Spherical,
}

/// Inertia of a link about its frame's origin, in its axes.
#[derive(Clone, Copy, Debug)]
pub enum LinkInertia<S = f64> {
    /// Rigid, with the frame at the centre of mass: every link except a floating one. A frame between the
    /// axes of a joint has zero inertia.
    Central {
        /// Mass, kg.
        mass: S,
        /// Moments of inertia about the centre of mass.
        moments: Moments<S>,
    },
    /// Rigid, with the frame of the link's first body: a floating link.
    Rigid(RigidInertia<S>),
    /// Not the inertia of a rigid body: with added mass.
    Full(SpatialInertia<S>),
}

impl<S: Scalar> Link<S> {
    /// Returns the link with the mass of its bodies.
    fn laden(self, link: usize, bodies: &[Body<S>]) -> Self {
        let of_link = || bodies.iter().filter(|body| body.link == Some(link));
        let mass = of_link().fold(S::ZERO, |sum, body| sum + body.mass);
        let first_moment = of_link().fold(Vector3::zero(), |sum, body| sum + body.in_link.position * body.mass);
        let falls = match self.inertia {
            LinkInertia::Central { mass: of_inertia, .. } => of_inertia == mass,
            LinkInertia::Rigid(rigid) => rigid.mass == mass && rigid.first_moment == first_moment,
            LinkInertia::Full(_) => false,
        };
        Self { mass, first_moment, falls, ..self }
    }
}

impl<S> Link<S> {
    /// Returns the index of the parent link; `None` is the world.
    #[inline]
    pub fn parent(&self) -> Option<usize> {
        match self.carrier {
            Carrier::World => None,
            Carrier::Root(parent) | Carrier::Branch(parent) => Some(parent),
        }
    }
}

/// Moments of inertia in a link's axes, kg m^2.
#[derive(Clone, Copy, Debug)]
pub enum Moments<S = f64> {
    /// The link's axes are principal axes.
    Principal([S; 3]),
    /// The link's axes are not principal axes.
    General(Symmetric3<S>),
}

impl<S: Scalar> Moments<S> {
    /// Creates the moments; the axes are principal if the off-diagonal entries are exactly zero in every
    /// lane.
    fn new(moments: Symmetric3<S>) -> Self {
        let Symmetric3 { xx, xy, xz, yy, yz, zz } = moments;
        if [xy, xz, yz].iter().all(|product| *product == S::ZERO) {
            Moments::Principal([xx, yy, zz])
        } else {
            Moments::General(moments)
        }
    }

    /// Returns the moments `R J R^T` in other axes; R is the rotation matrix from the link's axes to these
    /// axes.
    #[inline]
    pub fn rotated(&self, r: &Matrix3<S>) -> Symmetric3<S> {
        match self {
            Moments::Principal(moments) => Symmetric3::of_principal(*moments, r),
            Moments::General(moments) => moments.rotated(r),
        }
    }

    /// Returns the moments in the link's axes.
    pub fn in_link(&self) -> Symmetric3<S> {
        match self {
            Moments::Principal(moments) => Symmetric3::diagonal(*moments),
            Moments::General(moments) => *moments,
        }
    }
}

/// Moves the frame of each rigid link, except floating ones, to its centre of mass, rotates the frame of a
/// link with one axis so that this axis is z, and stores the constants of each link. `rigid` contains each
/// link's inertia, summed over its bodies, in ten numbers; `None` if one of the bodies is not rigid.
pub(super) fn compile_links<S: Scalar>(
    links: &mut Tree<S>,
    bodies: &mut [Body<S>],
    mut rigid: Vec<Option<RigidInertia<S>>>,
) -> Vec<Link<S>> {
    for (i, rigid) in rigid.iter_mut().enumerate() {
        let floats = matches!(links.nodes[i].kind, JointKind::Floating(_));
        if let Some(sum) = rigid.filter(|rigid| !floats && rigid.mass.all(|mass| mass > 0.0)) {
            let to_centre = Frame::translation(sum.first_moment * (S::ONE / sum.mass));
            move_link(links, bodies, i, rigid, &to_centre);
        }
        let axis = match &links.nodes[i].kind {
            JointKind::Revolute(revolute) => revolute.axis(),
            JointKind::Prismatic(prismatic) => prismatic.axis(),
            _ => continue,
        };
        let onto_axis = Frame { rotation: Matrix3::with_z(axis), position: Vector3::zero() };
        move_link(links, bodies, i, rigid, &onto_axis);
    }
    let nodes = &links.nodes;
    let carrier = |node: &Node<S>| match node.parent {
        None => Carrier::World,
        Some(p) if nodes[p].parent.is_none() => Carrier::Root(p),
        Some(p) => Carrier::Branch(p),
    };
    nodes
        .iter()
        .zip(rigid)
        .map(|(node, rigid)| lower(node, carrier(node), rigid.as_ref()))
        .enumerate()
        .map(|(i, link)| link.laden(i, bodies))
        .collect()
}

/// Returns the constants of a link whose frame is final.
fn lower<S: Scalar>(node: &Node<S>, carrier: Carrier, rigid: Option<&RigidInertia<S>>) -> Link<S> {
    let (joint, placement) = match &node.kind {
        JointKind::Floating(_) => (LinkJoint::Floating, Frame::identity()),
        JointKind::Revolute(revolute) => (LinkJoint::Revolute, *revolute.placement()),
        JointKind::Prismatic(prismatic) => (LinkJoint::Prismatic, *prismatic.placement()),
        JointKind::Spherical(ball) => (LinkJoint::Spherical, *ball.placement()),
        JointKind::AxisList(_) | JointKind::Fixed(_) => unreachable!("these are split and fused"),
    };
    let floating = if let JointKind::Floating(floating) = node.kind { floating } else { Floating::default() };
    let inertia = match rigid {
        Some(rigid) if joint == LinkJoint::Floating => LinkInertia::Rigid(*rigid),
        Some(rigid) if rigid.mass.all(|mass| mass > 0.0) || *rigid == RigidInertia::default() => {
            LinkInertia::Central { mass: rigid.mass, moments: Moments::new(rigid.moments) }
        }
        _ => LinkInertia::Full(node.inertia),
    };
    let Node { mode, positions, velocities, .. } = *node;
    let (to_child, mass, first_moment, falls) = (node.kind.to_child(), S::ZERO, Vector3::zero(), false);
    Link {
        carrier,
        joint,
        floating,
        mode,
        positions,
        velocities,
        placement,
        to_child,
        inertia,
        mass,
        first_moment,
        falls,
    }
}

/// Moves a link's frame to `to`, relative to its present pose; bodies and joints do not move.
fn move_link<S: Scalar>(
    links: &mut Tree<S>,
    bodies: &mut [Body<S>],
    link: usize,
    rigid: &mut Option<RigidInertia<S>>,
    to: &Frame<S>,
) {
    let back = to.inverse();
    *rigid = rigid.map(|rigid| rigid.to_parent(&back));
    let node = &mut links.nodes[link];
    node.kind = node.kind.with_child_moved(to);
    node.inertia = node.inertia.to_parent(&back);
    for child in links.nodes.iter_mut().filter(|node| node.parent == Some(link)) {
        child.kind = child.kind.seen_from(&back);
    }
    for body in bodies.iter_mut().filter(|body| body.link == Some(link)) {
        body.in_link = back.times(&body.in_link);
    }
}
