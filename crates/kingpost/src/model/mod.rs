//! The mechanical model: bodies in a tree, their joints, inertia, shapes and named points.
//!
//! A [`Model`] is immutable after its construction. The frame of each body is at its centre of mass.
//! Positions q and velocities v are flat arrays; every joint has a range of both.

mod beam;
mod charts;
pub mod joint;
mod links;
mod loops;
mod section;
mod shape;
mod tree;

pub use beam::Beam;
pub use charts::Charts;
pub use joint::{AxisMotion, Joint, JointKind, MotionType};
pub use links::{Carrier, Link, LinkInertia, LinkJoint, Moments};
pub use loops::{Attachment, Constraint, Loop, RotationAxis};
pub use section::Section;
pub use shape::{Axis, Shape};
pub use tree::{Node, Tree};

use crate::scalar::Scalar;
use crate::spatial::{Frame, RigidInertia, SpatialInertia, Vector3};

/// Definition of a body for [`Model::new`].
#[derive(Clone, Debug)]
pub struct BodyDefinition<S = f64> {
    /// Unique name.
    pub name: String,
    /// Index of the parent among the bodies before it; `None` is the world.
    pub parent: Option<usize>,
    /// Joint to the parent.
    pub joint: Joint<S>,
    /// Mass, kg.
    pub mass: S,
    /// 6x6 inertia in body axes about the centre of mass.
    pub inertia: SpatialInertia<S>,
    /// Named points in body axes from the centre of mass, m.
    pub points: Vec<(String, Vector3<S>)>,
}

/// A body of a complete model.
#[derive(Clone, Debug)]
pub struct Body<S = f64> {
    /// Unique name.
    pub name: String,
    /// Mass, kg.
    pub mass: S,
    /// The link that contains the body; `None` if the body is fixed to the world.
    pub link: Option<usize>,
    /// Frame of the body in the link's frame, or in the world if there is no link.
    pub in_link: Frame<S>,
    /// Named points in body axes from the centre of mass, m.
    pub points: Vec<(String, Vector3<S>)>,
}

/// The immutable mechanical model.
///
/// It contains the tree in two forms. In `tree`, node i is body i; the moving frame method, the results and
/// the joint reactions use this form. In `links`, bodies that are fixed to each other are one node, and a
/// joint of several axes becomes several nodes of one axis, with massless links between them; the recursive
/// dynamics uses this form. Its joints are floating, revolute, prismatic or spherical.
#[derive(Clone, Debug)]
pub struct Model<S = f64> {
    /// The bodies, parents first.
    pub bodies: Vec<Body<S>>,
    /// The joint of each body, in the same order.
    pub joints: Vec<Joint<S>>,
    /// One node per body.
    pub tree: Tree<S>,
    /// One node per link.
    pub links: Tree<S>,
    /// Root of each link's branch.
    pub roots: Vec<usize>,
    /// Constants of the links for the recursion, one record per link.
    pub plan: Vec<Link<S>>,
    /// Local coordinates of the links.
    pub charts: Charts,
    /// Length of q.
    pub position_count: usize,
    /// Length of v.
    pub velocity_count: usize,
    /// Mode of each coordinate of v.
    pub modes: Vec<MotionType>,
    /// Inertia of the drive's rotor times the gear ratio squared, for each coordinate of v, kg m^2 or kg; 0
    /// for floating and spherical joints. It acts along the coordinate, in M* and in the kinetic energy. The
    /// rotor's momentum in space is neglected, because its position is not known.
    pub rotor_inertia: Vec<S>,
    /// Closed loops.
    pub loops: Vec<Loop<S>>,
    /// Bodies with added mass in their inertia, and this added mass, in body axes about the centre of mass;
    /// it has no weight.
    pub added_inertias: Vec<(usize, SpatialInertia<S>)>,
}

impl<S: Scalar> Model<S> {
    /// Builds the model: assigns the coordinates, combines bodies at fixed joints and splits joints of
    /// several axes.
    ///
    /// # Panics
    /// If a parent does not precede its child: the caller must order the bodies.
    pub fn new(descriptions: Vec<BodyDefinition<S>>) -> Self {
        let (mut tree, mut links) = (Tree::default(), Tree::default());
        let (mut bodies, mut joints, mut rigid) = (Vec::<Body<S>>::new(), Vec::new(), Vec::new());
        let (mut positions, mut velocities, mut modes) = (0, 0, Vec::new());
        for (index, description) in descriptions.into_iter().enumerate() {
            assert!(description.parent.is_none_or(|p| p < index), "parents come before their children");
            let BodyDefinition { name, parent, joint, mass, inertia, points } = description;
            let node = Node { parent, kind: joint.kind, mode: joint.mode, positions, velocities, inertia };
            positions += joint.kind.position_count();
            velocities += joint.kind.velocity_count();
            modes.extend(joint.coordinate_modes());
            let (carrier, in_carrier) =
                parent.map_or((None, Frame::identity()), |p| (bodies[p].link, bodies[p].in_link));
            let (link, in_link) = match joint.kind {
                JointKind::Fixed(fixed) => (carrier, in_carrier.times(&fixed.relative())),
                _ => (Some(links.append(&node, carrier, &in_carrier)), Frame::identity()),
            };
            rigid.resize(links.nodes.len(), Some(RigidInertia::default()));
            if let Some(link) = link {
                links.nodes[link].inertia += inertia.to_parent(&in_link);
                let own = RigidInertia::from_spatial(&inertia).map(|own| own.to_parent(&in_link));
                rigid[link] = rigid[link].zip(own).map(|(sum, own)| sum + own);
            }
            tree.nodes.push(node);
            joints.push(joint);
            bodies.push(Body { name, mass, link, in_link, points });
        }
        let mut roots: Vec<usize> = Vec::with_capacity(links.nodes.len());
        for (i, link) in links.nodes.iter().enumerate() {
            roots.push(link.parent.map_or(i, |p| roots[p]));
        }
        let plan = links::compile_links(&mut links, &mut bodies, rigid);
        let charts = Charts::of(&links.nodes);
        let (position_count, velocity_count) = (positions, velocities);
        let (rotor_inertia, loops, added_inertias) = (vec![S::ZERO; velocity_count], Vec::new(), Vec::new());
        Self {
            bodies,
            joints,
            tree,
            links,
            roots,
            plan,
            charts,
            position_count,
            velocity_count,
            modes,
            rotor_inertia,
            loops,
            added_inertias,
        }
    }

    /// Returns the attachment on a body, or in the world, at a pose in the body's frame.
    pub fn attachment(&self, body: Option<usize>, in_body: Frame<S>) -> Attachment<S> {
        Attachment::on(body, in_body).on_link(&self.bodies)
    }

    /// Returns the model with closed loops.
    pub fn with_loops(mut self, loops: Vec<Loop<S>>) -> Self {
        let tied = |tie: Attachment<S>, bodies: &[Body<S>]| tie.on_link(bodies);
        let close = |l: Loop<S>| Loop { first: tied(l.first, &self.bodies), second: tied(l.second, &self.bodies), ..l };
        self.loops = loops.into_iter().map(close).collect();
        self
    }

    /// Returns the model with added mass at infinite frequency in the inertia of a body, in body axes about
    /// the centre of mass. The added mass moves with the body, so the velocity terms are those of Kirchhoff's
    /// equations.
    ///
    /// # Panics
    /// If the body is fixed to the world.
    pub fn with_added_inertia(mut self, body: usize, added: SpatialInertia<S>) -> Self {
        let link = self.bodies[body].link.expect("added inertia is of a body that moves");
        self.tree.nodes[body].inertia += added;
        self.links.nodes[link].inertia += added.to_parent(&self.bodies[body].in_link);
        self.plan[link].inertia = LinkInertia::Full(self.links.nodes[link].inertia);
        self.plan[link].falls = false;
        self.added_inertias.push((body, added));
        self
    }

    /// Returns the number of constraints of all loops.
    pub fn constraint_count(&self) -> usize {
        self.loops.iter().map(|closed| closed.constraints.len()).sum()
    }

    /// Names of all loops' constraints, in order: `drag_link.x`, ...
    pub fn constraint_names(&self) -> Vec<String> {
        let of = |l: &Loop<S>| l.constraints.iter().map(|(name, _)| format!("{}.{name}", l.name)).collect::<Vec<_>>();
        self.loops.iter().flat_map(of).collect()
    }

    /// Returns the index of the body with this name.
    pub fn body(&self, name: &str) -> Option<usize> {
        self.bodies.iter().position(|b| b.name == name)
    }

    /// Returns a body and all bodies below it in the tree, itself first.
    pub fn carried(&self, body: usize) -> Vec<usize> {
        let mut is_carried = vec![false; self.bodies.len()];
        is_carried[body] = true;
        // Parents precede their children.
        for (child, node) in self.tree.nodes.iter().enumerate().skip(body + 1) {
            is_carried[child] = node.parent.is_some_and(|parent| is_carried[parent]);
        }
        (body..is_carried.len()).filter(|&body| is_carried[body]).collect()
    }

    /// Returns the index of the joint with this name, which is also the index of its body.
    pub fn joint(&self, name: &str) -> Option<usize> {
        self.joints.iter().position(|j| j.name == name)
    }

    /// Returns the index in v of the coordinate with this name.
    pub fn coordinate(&self, name: &str) -> Option<usize> {
        self.coordinate_names().iter().position(|n| n == name)
    }

    /// Returns the body whose joint has a coordinate of v, and the index of the coordinate within the joint.
    pub fn owner(&self, coordinate: usize) -> Option<(usize, usize)> {
        let place = |node: &Node<S>| {
            let k = coordinate.checked_sub(node.velocities)?;
            (k < node.kind.velocity_count()).then_some(k)
        };
        self.tree.nodes.iter().enumerate().find_map(|(body, node)| Some((body, place(node)?)))
    }

    /// Returns whether a coordinate of v rotates or slides, and its index in q; `None` for coordinates of
    /// floating and spherical joints.
    pub fn axis_coordinate(&self, coordinate: usize) -> Option<(AxisMotion, usize)> {
        let (body, k) = self.owner(coordinate)?;
        let node = &self.tree.nodes[body];
        Some((node.kind.axis_motion(k)?, node.positions + k))
    }

    /// Names of all coordinates of v, in order: `ship.x`, ..., `slew`.
    pub fn coordinate_names(&self) -> Vec<String> {
        self.joints.iter().flat_map(Joint::coordinate_names).collect()
    }

    /// Returns whether each coordinate of v is a rotation, rad; otherwise it is a length, m.
    pub fn turning_coordinates(&self) -> Vec<bool> {
        let of = |kind: &JointKind<S>| match kind {
            JointKind::Floating(_) => vec![false, false, false, true, true, true],
            kind => (0..kind.velocity_count()).map(|k| kind.axis_motion(k) != Some(AxisMotion::Translation)).collect(),
        };
        self.tree.nodes.iter().flat_map(|node| of(&node.kind)).collect()
    }

    /// Returns the indices in q at which unit quaternions start.
    pub fn quaternions(&self) -> impl Iterator<Item = usize> + '_ {
        self.tree.nodes.iter().filter_map(|node| Some(node.positions + node.kind.quaternion()?.0))
    }

    /// Returns the indices in v of the free coordinates: the rows of M*, N* and F*.
    pub fn free_coordinates(&self) -> Vec<usize> {
        (0..self.velocity_count).filter(|&i| self.modes[i] == MotionType::Free).collect()
    }
}
