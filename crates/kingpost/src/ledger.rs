//! The ledger: what energy and momentum should be, integrated beside the motion by the same scheme.
//!
//! | entry of s | begins at | rate |
//! | --- | --- | --- |
//! | initial energy | K + U at the start | 0 |
//! | work by drives, by the outside | 0 | their power, W |
//! | energy dissipated | 0 | heat, W |
//! | linear momentum | P at the start | forces from outside, N |
//! | angular momentum | L at the start | moments from outside about the centre, N m |
//!
//! What the bodies really have is computed from the state; the differences are the errors of the
//! scheme, or of the equations.

use crate::dynamics::{Kinematics, Loads};
use crate::model::{JointKind, Mode, Model, Tree};
use crate::spatial::{Vector3, Wrench};

/// Entry of s: energy at the start, J.
pub const INITIAL_ENERGY: usize = 0;
/// Entry of s: work of motors, servos and prescribed motions, J.
pub const WORK_BY_DRIVES: usize = 1;
/// Entry of s: work of everything outside that has no potential energy, J.
pub const WORK_BY_OUTSIDE: usize = 2;
/// Entry of s: heat, J.
pub const ENERGY_DISSIPATED: usize = 3;
/// First of three entries of s: linear momentum by its balance, kg m/s, world.
pub const LINEAR_MOMENTUM: usize = 4;
/// First of three entries of s: angular momentum by its balance, N m s, world.
pub const ANGULAR_MOMENTUM: usize = 7;
/// Number of entries.
pub const COUNT: usize = 10;

/// The point that angular momentum is about: the centre of the first body that is held in place by
/// its centre of mass, else the world's origin (m, world).
pub fn reference_point(model: &Model, q: &[f64]) -> Vector3 {
    let held = |kind: &JointKind| matches!(kind, JointKind::Floating(floating) if floating.hold_translation);
    let node = model.tree.nodes.iter().find(|node| held(&node.kind));
    node.map_or(Vector3::zero(), |node| Vector3::from_slice(&q[node.positions..]))
}

/// One form of the tree, with what its joints carry.
pub struct JointWrenches<'a, F: Fn(usize) -> Wrench> {
    /// The tree.
    pub tree: &'a Tree,
    /// Its kinematics.
    pub kinematics: &'a Kinematics,
    /// The wrench that the joint of a node carries to it, node axes.
    pub wrench: F,
}

/// Writes the rates of the ledger's entries.
pub fn rates<F: Fn(usize) -> Wrench>(
    model: &Model,
    links: &Kinematics,
    v: &[f64],
    loads: &Loads,
    joints: &JointWrenches<'_, F>,
    centre: Vector3,
    s_dot: &mut [f64],
) {
    let (mut force, mut moment) = (Vector3::zero(), Vector3::zero());
    let mut add = |frame: &crate::spatial::Frame, wrench: &Wrench| {
        let f = frame.rotation * wrench.force;
        force += f;
        moment += frame.rotation * wrench.moment + (frame.position - centre).cross(f);
    };
    for (body, wrench) in loads.wrench.iter().enumerate() {
        if *wrench != Wrench::zero() {
            add(&links.body_frame(model, body), wrench);
        }
    }
    let mut prescribed_power = 0.0;
    for (i, node) in joints.tree.nodes.iter().enumerate() {
        if node.parent.is_none() {
            add(&joints.kinematics.world[i], &reaction_of_the_world(joints, i, loads));
        }
        if let (Mode::Prescribed, Some(axis)) = (node.mode, node.kind.axis_twist()) {
            let applied = loads.force[node.velocities];
            prescribed_power += ((joints.wrench)(i).dot(axis) - applied) * v[node.velocities];
        }
    }
    s_dot[INITIAL_ENERGY] = 0.0;
    s_dot[WORK_BY_DRIVES] = loads.power.drives + prescribed_power;
    s_dot[WORK_BY_OUTSIDE] = loads.power.outside;
    s_dot[ENERGY_DISSIPATED] = loads.power.dissipated;
    force.write_to(&mut s_dot[LINEAR_MOMENTUM..]);
    moment.write_to(&mut s_dot[ANGULAR_MOMENTUM..]);
}

/// What a joint to the world carries. Along the free directions of a floating joint nothing can be
/// carried, and the rounding of the recursion must not appear as a load.
fn reaction_of_the_world<F: Fn(usize) -> Wrench>(joints: &JointWrenches<'_, F>, i: usize, loads: &Loads) -> Wrench {
    let node = &joints.tree.nodes[i];
    let JointKind::Floating(floating) = node.kind else { return (joints.wrench)(i) };
    let applied = &loads.force[node.velocities..];
    let rotation = &joints.kinematics.world[i].rotation;
    let held = if floating.hold_translation || floating.hold_rotation { (joints.wrench)(i) } else { Wrench::zero() };
    let force = rotation.transpose_times(Vector3::from_slice(applied));
    Wrench {
        moment: if floating.hold_rotation { held.moment } else { Vector3::from_slice(&applied[3..]) },
        force: if floating.hold_translation { held.force } else { force },
    }
}
