//! Joints, one file each.
//!
//! A joint carries the child's centre of mass from the parent's: "translate, rotate, translate".
//! A new joint is one new file and one arm in each `match` of [`JointKind`].

mod fixed;
mod floating;
mod prismatic;
mod revolute;

pub use fixed::Fixed;
pub use floating::Floating;
pub use prismatic::Prismatic;
pub use revolute::Revolute;

use crate::scalar::Scalar;
use crate::spatial::{Frame, Twist, Vector3};

/// How a coordinate comes by its acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// From the equations of motion.
    Free,
    /// It stands still; whatever holds it does no work.
    Held,
    /// It is given as a function of time; the drive behind it does what work that takes.
    Prescribed,
}

/// A named joint.
#[derive(Clone, Debug)]
pub struct Joint<S = f64> {
    /// Unique name.
    pub name: String,
    /// What it lets move.
    pub kind: JointKind<S>,
    /// How a joint of one degree of freedom moves; a floating joint has its own holds.
    pub mode: Mode,
}

/// The kinds of joint.
#[derive(Clone, Copy, Debug)]
pub enum JointKind<S = f64> {
    /// Six degrees of freedom against the world.
    Floating(Floating),
    /// Rotation about one axis.
    Revolute(Revolute<S>),
    /// Translation along one axis.
    Prismatic(Prismatic<S>),
    /// None.
    Fixed(Fixed<S>),
}

impl<S: Scalar> Joint<S> {
    /// Names of the coordinates of v that the joint owns.
    pub fn coordinate_names(&self) -> Vec<String> {
        match self.kind {
            JointKind::Floating(_) => Floating::LABELS.iter().map(|label| format!("{}.{label}", self.name)).collect(),
            JointKind::Revolute(_) | JointKind::Prismatic(_) => vec![self.name.clone()],
            JointKind::Fixed(_) => Vec::new(),
        }
    }

    /// Mode of each of those coordinates.
    pub fn coordinate_modes(&self) -> Vec<Mode> {
        match &self.kind {
            JointKind::Floating(floating) => floating.modes().to_vec(),
            kind => vec![self.mode; kind.velocity_count()],
        }
    }
}

impl<S: Scalar> JointKind<S> {
    /// Entries in q.
    pub fn position_count(&self) -> usize {
        match self {
            JointKind::Floating(_) => 7,
            JointKind::Revolute(_) | JointKind::Prismatic(_) => 1,
            JointKind::Fixed(_) => 0,
        }
    }

    /// Entries in v.
    pub fn velocity_count(&self) -> usize {
        match self {
            JointKind::Floating(_) => 6,
            JointKind::Revolute(_) | JointKind::Prismatic(_) => 1,
            JointKind::Fixed(_) => 0,
        }
    }

    /// The same joint on a parent frame that carries the old one at `parent`.
    pub fn seen_from(self, parent: &Frame<S>) -> Self {
        match self {
            JointKind::Floating(floating) => JointKind::Floating(floating),
            JointKind::Revolute(revolute) => JointKind::Revolute(revolute.seen_from(parent)),
            JointKind::Prismatic(prismatic) => JointKind::Prismatic(prismatic.seen_from(parent)),
            JointKind::Fixed(fixed) => JointKind::Fixed(fixed.seen_from(parent)),
        }
    }

    /// The relative frame connection matrix E(child/parent) of eq. 24; `q` begins at the joint's
    /// own entries.
    #[inline]
    pub fn relative(&self, q: &[S]) -> Frame<S> {
        match self {
            JointKind::Floating(_) => Floating::relative(q),
            JointKind::Revolute(revolute) => revolute.relative(q[0]),
            JointKind::Prismatic(prismatic) => prismatic.relative(q[0]),
            JointKind::Fixed(fixed) => fixed.relative(),
        }
    }

    /// The child's twist per unit rate of a joint with one degree of freedom, in child axes about
    /// the child's centre of mass: a constant. `None` for other joints.
    #[inline]
    pub fn axis_twist(&self) -> Option<&Twist<S>> {
        match self {
            JointKind::Revolute(revolute) => Some(revolute.axis_twist()),
            JointKind::Prismatic(prismatic) => Some(prismatic.axis_twist()),
            JointKind::Floating(_) | JointKind::Fixed(_) => None,
        }
    }

    /// From the joint to the child's centre of mass, child axes, m.
    pub fn to_child(&self) -> Vector3<S> {
        match self {
            JointKind::Floating(_) => Vector3::zero(),
            JointKind::Revolute(revolute) => revolute.to_child(),
            JointKind::Prismatic(prismatic) => prismatic.to_child(),
            JointKind::Fixed(fixed) => fixed.to_child(),
        }
    }

    /// See [`Tree::retract`](super::Tree::retract); slices begin at the joint's own entries.
    #[inline]
    pub fn retract(&self, q: &[S], xi: &[S], out: &mut [S]) {
        match self {
            JointKind::Floating(_) => Floating::retract(q, xi, out),
            JointKind::Revolute(_) | JointKind::Prismatic(_) => out[0] = q[0] + xi[0],
            JointKind::Fixed(_) => {}
        }
    }

    /// See [`Tree::dexp_inverse`](super::Tree::dexp_inverse).
    #[inline]
    pub fn dexp_inverse(&self, xi: &[S], v: &[S], out: &mut [S]) {
        match self {
            JointKind::Floating(_) => Floating::dexp_inverse(xi, v, out),
            JointKind::Revolute(_) | JointKind::Prismatic(_) => out[0] = v[0],
            JointKind::Fixed(_) => {}
        }
    }
}
