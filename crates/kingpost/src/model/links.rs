//! Bodies that are fixed to one another, fused into links for the recursion.

use super::{Body, JointKind, Tree};
use crate::scalar::Scalar;
use crate::spatial::{Frame, RigidInertia, Symmetric3, Vector3};

/// The inertia of a link about its frame's origin, in its axes, as the recursion takes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LinkInertia<S = f64> {
    /// None: a frame between the axes of a joint.
    Massless,
    /// Rigid, with the frame at its centre of mass: every link but a floating one.
    Central {
        /// kg.
        mass: S,
        /// Moments of inertia about the centre of mass, kg m^2.
        moments: Symmetric3<S>,
    },
    /// Rigid: a floating link, whose frame is where its first body's is.
    Rigid(RigidInertia<S>),
    /// No rigid body's: the node's full 6x6 inertia.
    Full,
}

/// Moves the frame of each rigid link to its centre of mass, except where it floats, and says what
/// inertia each has; `rigid` holds the sums over the bodies in ten numbers, `None` where one of
/// them is not rigid.
pub(super) fn centred<S: Scalar>(
    links: &mut Tree<S>,
    bodies: &mut [Body<S>],
    rigid: Vec<Option<RigidInertia<S>>>,
) -> Vec<LinkInertia<S>> {
    let mut inertias = Vec::with_capacity(rigid.len());
    for (i, rigid) in rigid.into_iter().enumerate() {
        let floats = matches!(links.nodes[i].kind, JointKind::Floating(_));
        inertias.push(match rigid {
            None => LinkInertia::Full,
            Some(rigid) if floats => LinkInertia::Rigid(rigid),
            Some(rigid) if rigid.mass.all(|mass| mass > 0.0) => {
                let to_centre = rigid.first_moment * (S::ONE / rigid.mass);
                move_link(links, bodies, i, to_centre);
                let central = rigid.to_parent(&Frame::translation(-to_centre));
                LinkInertia::Central { mass: rigid.mass, moments: central.moments }
            }
            Some(rigid) if rigid == RigidInertia::default() => LinkInertia::Massless,
            Some(_) => LinkInertia::Full,
        });
    }
    inertias
}

/// Moves a link's frame by `offset`, its own axes; bodies and joints stay where they are.
fn move_link<S: Scalar>(links: &mut Tree<S>, bodies: &mut [Body<S>], link: usize, offset: Vector3<S>) {
    let back = Frame::translation(-offset);
    let node = &mut links.nodes[link];
    node.kind = node.kind.with_child_moved(offset);
    node.inertia = node.inertia.to_parent(&back);
    for child in links.nodes.iter_mut().filter(|node| node.parent == Some(link)) {
        child.kind = child.kind.seen_from(&back);
    }
    for body in bodies.iter_mut().filter(|body| body.link == Some(link)) {
        body.in_link = back.times(&body.in_link);
    }
}
