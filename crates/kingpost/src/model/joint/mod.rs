//! Joints, with one file for each kind.
//!
//! A joint leads from the parent's centre of mass to the child's: "translate, rotate, translate". Joints of
//! several axes are an [`AxisList`]: a new one needs one new file with its list of axes. Any other new joint
//! needs one new file and one arm in each `match` of [`JointKind`].

mod axis;
mod axis_list;
mod columns;
mod cylindrical;
mod elastic;
mod fixed;
mod floating;
mod planar;
mod prismatic;
mod revolute;
mod six_axes;
mod spherical;
mod universal;

pub use axis::{AxisMotion, ElementaryAxis};
pub use axis_list::AxisList;
pub use columns::{Columns, MOST_AXES};
pub use fixed::Fixed;
pub use floating::Floating;
pub use prismatic::Prismatic;
pub use revolute::Revolute;
pub use spherical::Spherical;

use crate::scalar::Scalar;
use crate::spatial::{Frame, Twist, Vector3};

/// Way in which the acceleration of a coordinate is determined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionType {
    /// By the equations of motion.
    Free,
    /// The coordinate is held at rest; the holding force does no work.
    Held,
    /// The coordinate is a given function of time; its drive does the work.
    Prescribed,
}

/// A named joint.
#[derive(Clone, Debug)]
pub struct Joint<S = f64> {
    /// Unique name.
    pub name: String,
    /// Its kind.
    pub kind: JointKind<S>,
    /// Mode of a joint with one degree of freedom, or whether a spherical joint is held. Floating joints and
    /// lists of axes contain their modes.
    pub mode: MotionType,
}

/// The kinds of joint.
#[derive(Clone, Copy, Debug)]
pub enum JointKind<S = f64> {
    /// Six degrees of freedom relative to the world.
    Floating(Floating),
    /// Rotation about one axis.
    Revolute(Revolute<S>),
    /// Translation along one axis.
    Prismatic(Prismatic<S>),
    /// Several axes in succession: cylindrical, universal, planar, elastic.
    AxisList(AxisList<S>),
    /// Rotation about a point.
    Spherical(Spherical<S>),
    /// No motion.
    Fixed(Fixed<S>),
}

impl<S: Scalar> Joint<S> {
    /// Returns the names of the joint's coordinates of v.
    pub fn coordinate_names(&self) -> Vec<String> {
        let labelled = |labels: &[&str]| labels.iter().map(|label| format!("{}.{label}", self.name)).collect();
        match &self.kind {
            JointKind::Floating(_) => labelled(&Floating::LABELS),
            JointKind::AxisList(list) => labelled(list.labels()),
            JointKind::Spherical(_) => labelled(&Spherical::<S>::LABELS),
            JointKind::Revolute(_) | JointKind::Prismatic(_) => vec![self.name.clone()],
            JointKind::Fixed(_) => Vec::new(),
        }
    }

    /// Returns the mode of each coordinate of v of the joint.
    pub fn coordinate_modes(&self) -> Vec<MotionType> {
        match &self.kind {
            JointKind::Floating(floating) => floating.modes().to_vec(),
            JointKind::AxisList(list) => list.axes().iter().map(|axis| axis.mode).collect(),
            kind => vec![self.mode; kind.velocity_count()],
        }
    }
}

impl<S: Scalar> JointKind<S> {
    /// Returns the number of entries in q.
    pub fn position_count(&self) -> usize {
        match self {
            JointKind::Floating(_) => 7,
            JointKind::Revolute(_) | JointKind::Prismatic(_) => 1,
            JointKind::AxisList(list) => list.axes().len(),
            JointKind::Spherical(_) => 4,
            JointKind::Fixed(_) => 0,
        }
    }

    /// Returns the number of entries in v.
    pub fn velocity_count(&self) -> usize {
        match self {
            JointKind::Floating(_) => 6,
            JointKind::Revolute(_) | JointKind::Prismatic(_) => 1,
            JointKind::AxisList(list) => list.axes().len(),
            JointKind::Spherical(_) => 3,
            JointKind::Fixed(_) => 0,
        }
    }

    /// Returns the joint relative to a frame in which the present parent frame is `parent`.
    pub fn seen_from(self, parent: &Frame<S>) -> Self {
        match self {
            JointKind::Floating(floating) => JointKind::Floating(floating),
            JointKind::Revolute(revolute) => JointKind::Revolute(revolute.seen_from(parent)),
            JointKind::Prismatic(prismatic) => JointKind::Prismatic(prismatic.seen_from(parent)),
            JointKind::AxisList(list) => JointKind::AxisList(list.seen_from(parent)),
            JointKind::Spherical(ball) => JointKind::Spherical(ball.seen_from(parent)),
            JointKind::Fixed(fixed) => JointKind::Fixed(fixed.seen_from(parent)),
        }
    }

    /// Returns the joint with the child's frame moved to `to`, relative to its present pose; a floating joint
    /// does not change. Only a joint of one axis allows a rotation: other joints have coordinates along the
    /// child's axes.
    pub fn with_child_moved(self, to: &Frame<S>) -> Self {
        let offset = to.position;
        match self {
            JointKind::Floating(floating) => JointKind::Floating(floating),
            JointKind::Revolute(revolute) => JointKind::Revolute(revolute.with_child_moved(to)),
            JointKind::Prismatic(prismatic) => JointKind::Prismatic(prismatic.with_child_moved(to)),
            JointKind::AxisList(list) => JointKind::AxisList(list.with_child_moved(offset)),
            JointKind::Spherical(ball) => JointKind::Spherical(ball.with_child_moved(offset)),
            JointKind::Fixed(fixed) => JointKind::Fixed(fixed.with_child_moved(offset)),
        }
    }

    /// Returns the relative frame connection matrix E(child/parent) of eq. 24; `q` starts at the joint's
    /// entries.
    #[inline]
    pub fn relative(&self, q: &[S]) -> Frame<S> {
        match self {
            JointKind::Floating(_) => Floating::relative(q),
            JointKind::Revolute(revolute) => revolute.relative(q[0]),
            JointKind::Prismatic(prismatic) => prismatic.relative(q[0]),
            JointKind::AxisList(list) => list.relative(q),
            JointKind::Spherical(ball) => ball.relative(q),
            JointKind::Fixed(fixed) => fixed.relative(),
        }
    }

    /// Returns the child's twist per unit rate of a joint with one degree of freedom, in child axes about the
    /// child's centre of mass; it is constant. `None` for other joints.
    #[inline]
    pub fn axis_twist(&self) -> Option<&Twist<S>> {
        match self {
            JointKind::Revolute(revolute) => Some(revolute.axis_twist()),
            JointKind::Prismatic(prismatic) => Some(prismatic.axis_twist()),
            JointKind::Floating(_) | JointKind::AxisList(_) | JointKind::Spherical(_) | JointKind::Fixed(_) => None,
        }
    }

    /// Returns the child's twist per unit rate of each coordinate, in child axes about the child's centre of
    /// mass; `child` is its frame in the world, because the translation of a floating joint is in world axes.
    pub fn columns(&self, q: &[S], child: &Frame<S>) -> Columns<S> {
        match self {
            JointKind::Floating(_) => Floating::columns(child),
            JointKind::Revolute(revolute) => Columns::of(&[*revolute.axis_twist()]),
            JointKind::Prismatic(prismatic) => Columns::of(&[*prismatic.axis_twist()]),
            JointKind::AxisList(list) => list.columns(q),
            JointKind::Spherical(ball) => ball.columns(),
            JointKind::Fixed(_) => Columns::new(0),
        }
    }

    /// Returns the rates of these columns, component by component, at the rates `v` of the joint's
    /// coordinates; `omega` is the child's angular velocity in its own axes, rad/s.
    pub fn column_rates(&self, columns: &Columns<S>, v: &[S], omega: Vector3<S>) -> Columns<S> {
        match self {
            JointKind::Floating(_) => Floating::column_rates(columns, omega),
            JointKind::AxisList(_) => AxisList::column_rates(columns, v),
            JointKind::Revolute(_) | JointKind::Prismatic(_) | JointKind::Spherical(_) | JointKind::Fixed(_) => {
                Columns::new(columns.len())
            }
        }
    }

    /// Returns whether coordinate k of the joint rotates or slides; `None` for floating and spherical joints,
    /// whose rates are not derivatives of positions.
    pub fn axis_motion(&self, k: usize) -> Option<AxisMotion> {
        match self {
            JointKind::Revolute(_) => Some(AxisMotion::Rotation),
            JointKind::Prismatic(_) => Some(AxisMotion::Translation),
            JointKind::AxisList(list) => list.axes().get(k).map(|axis| axis.motion),
            JointKind::Floating(_) | JointKind::Spherical(_) | JointKind::Fixed(_) => None,
        }
    }

    /// Returns whether the child can swing freely in all directions about a point.
    pub fn swings(&self) -> bool {
        let turns = |axis: usize| self.axis_motion(axis) == Some(AxisMotion::Rotation);
        matches!(self, JointKind::Spherical(_)) || (self.velocity_count() == 2 && turns(0) && turns(1))
    }

    /// Returns the index of the unit quaternion among the joint's entries of q, and that of its body rates
    /// among those of v.
    pub fn quaternion(&self) -> Option<(usize, usize)> {
        match self {
            JointKind::Floating(_) => Some((3, 3)),
            JointKind::Spherical(_) => Some((0, 0)),
            _ => None,
        }
    }

    /// Returns the vector from the joint to the child's centre of mass, child axes, m.
    pub fn to_child(&self) -> Vector3<S> {
        match self {
            JointKind::Floating(_) => Vector3::zero(),
            JointKind::Revolute(revolute) => revolute.to_child(),
            JointKind::Prismatic(prismatic) => prismatic.to_child(),
            JointKind::AxisList(list) => list.to_child(),
            JointKind::Spherical(ball) => ball.to_child(),
            JointKind::Fixed(fixed) => fixed.to_child(),
        }
    }

    /// See [`Tree::retract`](super::Tree::retract); slices start at the joint's entries.
    #[inline]
    pub fn retract(&self, q: &[S], xi: &[S], out: &mut [S]) {
        match self {
            JointKind::Floating(_) => Floating::retract(q, xi, out),
            JointKind::Revolute(_) | JointKind::Prismatic(_) => out[0] = q[0] + xi[0],
            JointKind::AxisList(list) => {
                for (i, out) in out[..list.axes().len()].iter_mut().enumerate() {
                    *out = q[i] + xi[i];
                }
            }
            JointKind::Spherical(_) => Spherical::retract(q, xi, out),
            JointKind::Fixed(_) => {}
        }
    }

    /// See [`Tree::dexp_inverse`](super::Tree::dexp_inverse).
    #[inline]
    pub fn dexp_inverse(&self, xi: &[S], v: &[S], out: &mut [S]) {
        match self {
            JointKind::Floating(_) => Floating::dexp_inverse(xi, v, out),
            JointKind::Revolute(_) | JointKind::Prismatic(_) => out[0] = v[0],
            JointKind::AxisList(list) => out[..list.axes().len()].copy_from_slice(&v[..list.axes().len()]),
            JointKind::Spherical(_) => Spherical::dexp_inverse(xi, v, out),
            JointKind::Fixed(_) => {}
        }
    }
}
