//! The ledger: the expected energy and momentum, integrated together with the motion by the same scheme.
//!
//! | entry of s | begins at | rate |
//! | --- | --- | --- |
//! | initial energy | K + U at the start | 0 |
//! | work by drives, by the outside | 0 | their power, W |
//! | energy dissipated | 0 | heat, W |
//! | linear momentum | P at the start | forces from outside, N |
//! | angular momentum | L at the start | moments from outside about the centre, N m |
//!
//! The actual energy and momentum of the bodies follow from the state; the differences are errors of the scheme or of
//! the equations.

mod watch;

pub use watch::EnergyBalance;

use crate::dynamics::{LinkKinematics, Loads};
use crate::model::{JointKind, Model, MotionType, Node, Tree};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Vector3, Wrench};

/// Entry of s: energy at the start, J.
pub const INITIAL_ENERGY: usize = 0;
/// Entry of s: work of motors, servos and prescribed motions, J.
pub const WORK_BY_DRIVES: usize = 1;
/// Entry of s: work of external forces without potential energy, J.
pub const WORK_BY_OUTSIDE: usize = 2;
/// Entry of s: dissipated energy (heat), J.
pub const ENERGY_DISSIPATED: usize = 3;
/// First of three entries of s: linear momentum from the impulse of external forces, kg m/s, world.
pub const LINEAR_MOMENTUM: usize = 4;
/// First of three entries of s: angular momentum from the impulse of external moments, N m s, world.
pub const ANGULAR_MOMENTUM: usize = 7;
/// Number of entries.
pub const COUNT: usize = 10;

/// Returns the reference point of angular momentum: the centre of the first body whose centre of mass is
/// fixed, otherwise the world's origin (m, world). It does not move.
pub fn reference_point<S: Scalar>(model: &Model<S>, q: &[S]) -> Vector3<S> {
    let held = |kind: &JointKind<S>| matches!(kind, JointKind::Floating(floating) if floating.hold_translation);
    let node = model.tree.nodes.iter().find(|node| held(&node.kind));
    node.map_or(Vector3::zero(), |node| Vector3::from_slice(&q[node.positions..]))
}

/// The load that a joint transmits to its child.
pub struct JointLoad<S = f64> {
    /// Frame of the wrench, in the world.
    pub frame: Frame<S>,
    /// The wrench about that frame's origin, in its axes.
    pub wrench: Wrench<S>,
}

/// Data for the rates of the ledger.
pub struct Entries<'a, S = f64> {
    /// The mechanical model.
    pub model: &'a Model<S>,
    /// Tree for which the accelerations were solved: `model.links`, or `model.tree`.
    pub tree: &'a Tree<S>,
    /// Whether the tree contains bodies that are fixed to the world.
    pub has_fixed: bool,
    /// Kinematics of the tree's links.
    pub links: &'a LinkKinematics<S>,
    /// Velocities.
    pub v: &'a [S],
    /// The loads.
    pub loads: &'a Loads<S>,
    /// Reference point of angular momentum, m, world.
    pub centre: Vector3<S>,
}

impl<S: Scalar> Entries<'_, S> {
    /// Writes the rates. `joint` returns the load in the joint of a node of the tree; `along` returns the
    /// force that moves one of its coordinates, with the rotor, in N or N m.
    pub fn rates(&self, joint: impl Fn(usize) -> JointLoad<S>, along: impl Fn(usize, usize) -> S, s_dot: &mut [S]) {
        let (mut force, mut moment) = (Vector3::zero(), Vector3::zero());
        let mut add = |at: Vector3<S>, f: Vector3<S>, m: Vector3<S>| {
            force += f;
            moment += m + (at - self.centre).cross(f);
        };
        // Loads on a body that is fixed to the world act on the world and do not change the momentum.
        let moves = |body: usize| self.model.bodies[body].link.is_some();
        for (body, wrench) in self.loads.wrenches.iter().filter(|(body, _)| moves(*body)) {
            let Frame { rotation, position } = self.links.body_frame(self.model, *body);
            add(position, rotation * wrench.force, rotation * wrench.moment);
        }
        for (i, body) in self.model.bodies.iter().enumerate().filter(|(i, _)| moves(*i)) {
            if let Some(weight) = self.loads.weight(body.mass) {
                add(self.links.body_frame(self.model, i).position, weight, Vector3::zero());
            }
        }
        let mut prescribed_power = S::ZERO;
        for (i, node) in self.tree.nodes.iter().enumerate() {
            let on_the_world = node.parent.is_none_or(|p| self.has_fixed && !moves(p));
            if on_the_world && (!self.has_fixed || moves(i)) {
                let carried = joint(i);
                let Wrench { force, moment } = self.reaction_of_the_world(node, &carried);
                let Frame { rotation, position } = carried.frame;
                add(position, rotation * force, rotation * moment);
            }
            for at in (node.velocities..).take(node.kind.velocity_count()) {
                if self.model.modes[at] == MotionType::Prescribed {
                    prescribed_power += (along(i, at) - self.loads.force[at]) * self.v[at];
                }
            }
        }
        let power = &self.loads.power;
        s_dot[INITIAL_ENERGY] = S::ZERO;
        s_dot[WORK_BY_DRIVES] = power.drives + prescribed_power;
        s_dot[WORK_BY_OUTSIDE] = power.outside;
        s_dot[ENERGY_DISSIPATED] = power.dissipated;
        force.write_to(&mut s_dot[LINEAR_MOMENTUM..]);
        moment.write_to(&mut s_dot[ANGULAR_MOMENTUM..]);
    }

    /// Returns the load in a joint to the world. A floating joint transmits none along its free directions:
    /// rounding errors of the recursion must not appear as a load.
    fn reaction_of_the_world(&self, node: &Node<S>, carried: &JointLoad<S>) -> Wrench<S> {
        let JointKind::Floating(floating) = node.kind else { return carried.wrench };
        let applied = &self.loads.force[node.velocities..];
        let force = carried.frame.rotation.transpose_times(Vector3::from_slice(applied));
        Wrench {
            moment: if floating.hold_rotation { carried.wrench.moment } else { Vector3::from_slice(&applied[3..]) },
            force: if floating.hold_translation { carried.wrench.force } else { force },
        }
    }
}
