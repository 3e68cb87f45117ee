//! Joints with several axes in succession.

use super::{AxisMotion, Columns, ElementaryAxis, JointKind, MOST_AXES, MotionType, Prismatic, Revolute};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Twist, Vector3};

/// A joint of up to six elementary axes: `E(child/parent) = placement A1(q1) ... An(qn) [I, s_C]`.
///
/// The columns of its motion are the twists of the axes, transformed to the child: `S_i = Ad((A_{i+1} ... An
/// [I, s_C])^-1) s_i`. Only the last column is constant in child axes; each other one rotates with the axes
/// after it, `S_i' = -(sum_{j>i} S_j q_j') x S_i`.
#[derive(Clone, Copy, Debug)]
pub struct AxisList<S = f64> {
    /// Frame of the joint in the parent's frame: child axes, and the joint's origin, with all q at 0.
    placement: Frame<S>,
    /// Vector from the joint to the child's centre of mass, child axes, m: the paper's s_C.
    to_child: Vector3<S>,
    axes: [ElementaryAxis<S>; MOST_AXES],
    /// One label per axis.
    labels: &'static [&'static str],
}

impl<S: Scalar> AxisList<S> {
    /// Creates a joint of these axes, from the parent to the child.
    ///
    /// # Panics
    /// If there are no axes, more than six, or not one label per axis.
    pub fn new(
        placement: Frame<S>,
        axes: &[ElementaryAxis<S>],
        labels: &'static [&'static str],
        to_child: Vector3<S>,
    ) -> Self {
        assert!(
            (1..=MOST_AXES).contains(&axes.len()) && labels.len() == axes.len(),
            "one to six axes with their labels"
        );
        let axes = core::array::from_fn(|i| axes[i.min(axes.len() - 1)]);
        Self { placement, to_child, axes, labels }
    }

    /// Returns the joint with these modes of its coordinates.
    ///
    /// # Panics
    /// If there are fewer modes than axes.
    pub fn with_modes(mut self, modes: &[MotionType]) -> Self {
        for (axis, mode) in self.axes.iter_mut().zip(&modes[..self.labels.len()]) {
            axis.mode = *mode;
        }
        self
    }

    /// Returns a copy of the joint with the child's frame moved by `offset`, child axes, m.
    pub fn with_child_moved(&self, offset: Vector3<S>) -> Self {
        Self { to_child: self.to_child + offset, ..*self }
    }

    /// The axes, from the parent to the child.
    pub fn axes(&self) -> &[ElementaryAxis<S>] {
        &self.axes[..self.labels.len()]
    }

    /// The name of each coordinate within the joint.
    pub fn labels(&self) -> &'static [&'static str] {
        self.labels
    }

    /// Returns the vector from the joint to the child's centre of mass, child axes, m.
    pub fn to_child(&self) -> Vector3<S> {
        self.to_child
    }

    /// E(child/parent) at the coordinates `q`, rad and m.
    pub fn relative(&self, q: &[S]) -> Frame<S> {
        let after = self.axes().iter().zip(q).fold(self.placement, |frame, (axis, q)| frame.times(&axis.frame(*q)));
        after.times(&Frame::translation(self.to_child))
    }

    /// Returns the child's twist per unit rate of each coordinate, in child axes about its centre of mass.
    pub fn columns(&self, q: &[S]) -> Columns<S> {
        let mut columns = Columns::new(self.labels.len());
        let mut child = Frame::translation(self.to_child);
        for (i, axis) in self.axes().iter().enumerate().rev() {
            columns[i] = child.twist_to_child(&axis.twist());
            child = axis.frame(q[i]).times(&child);
        }
        columns
    }

    /// Rates of the columns at the rates `v` of the coordinates, component by component.
    pub fn column_rates(columns: &Columns<S>, v: &[S]) -> Columns<S> {
        let mut rates = Columns::new(columns.len());
        let mut after = Twist::zero();
        for i in (0..columns.len()).rev() {
            rates[i] = columns[i].cross(&after);
            after = after + columns[i] * v[i];
        }
        rates
    }

    /// Splits the joint into joints of one axis each, with massless frames between them.
    pub fn split(&self) -> impl Iterator<Item = (JointKind<S>, MotionType)> + '_ {
        let last = self.labels.len() - 1;
        self.axes().iter().enumerate().map(move |(i, axis)| {
            let placement = if i == 0 { self.placement } else { Frame::identity() };
            let to_child = if i == last { self.to_child } else { Vector3::zero() };
            let kind = match axis.motion {
                AxisMotion::Rotation => JointKind::Revolute(Revolute::new(placement, axis.direction, to_child)),
                AxisMotion::Translation => JointKind::Prismatic(Prismatic::new(placement, axis.direction, to_child)),
            };
            (kind, axis.mode)
        })
    }

    /// Returns a copy of the joint relative to another parent frame.
    pub fn seen_from(&self, parent: &Frame<S>) -> Self {
        Self { placement: parent.times(&self.placement), ..*self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::{exp, vee};

    /// Rotations and translations alternate, on skew axes.
    fn joint() -> AxisList {
        let unit = |v: [f64; 3]| Vector3(v) * (1.0 / Vector3(v).norm());
        let axes = [
            ElementaryAxis::rotation(unit([1.0, 2.0, -1.0])),
            ElementaryAxis::translation(unit([0.0, 1.0, 1.0])),
            ElementaryAxis::rotation(unit([0.5, -1.0, 0.3])),
            ElementaryAxis::translation(unit([1.0, 0.2, 0.0])),
        ];
        let placement = Frame { rotation: exp(Vector3::new(0.3, 0.1, -0.7)), position: Vector3::new(1.0, 2.0, -0.5) };
        AxisList::new(placement, &axes, &["a", "b", "c", "d"], Vector3::new(0.4, -0.8, 1.1))
    }

    const Q: [f64; 4] = [0.4, -0.9, 1.3, 0.6];
    const V: [f64; 4] = [1.1, -0.7, 0.5, 2.0];

    fn moved(h: f64) -> [f64; 4] {
        core::array::from_fn(|i| Q[i] + h * V[i])
    }

    #[test]
    fn columns_times_rates_are_the_rate_of_the_frame_by_differences() {
        let (joint, h) = (joint(), 1e-6);
        let (before, here, after) = (joint.relative(&moved(-h)), joint.relative(&Q), joint.relative(&moved(h)));
        let linear = here.rotation.transpose_times((after.position - before.position) * (0.5 / h));
        let angular = vee(&(here.rotation.transpose() * (after.rotation - before.rotation).scaled(0.5 / h)));
        let columns = joint.columns(&Q);
        let twist = (0..4).fold(Twist::zero(), |sum, i| sum + columns[i] * V[i]);
        // The error is of second order in h, plus rounding over h.
        assert!((twist.angular - angular).norm() + (twist.linear - linear).norm() < 1e-9);
    }

    #[test]
    fn rates_of_the_columns_are_their_differences() {
        let (joint, h) = (joint(), 1e-6);
        let (before, after) = (joint.columns(&moved(-h)), joint.columns(&moved(h)));
        let rates = AxisList::column_rates(&joint.columns(&Q), &V);
        for i in 0..4 {
            let measured = (after[i] - before[i]) * (0.5 / h);
            let difference = measured - rates[i];
            assert!(difference.angular.norm() + difference.linear.norm() < 1e-9, "column {i}: {difference:?}");
        }
    }

    #[test]
    fn a_split_joint_ends_in_the_same_frame() {
        let joint = joint();
        let parts =
            joint.split().zip(Q).fold(Frame::identity(), |frame, ((kind, _), q)| frame.times(&kind.relative(&[q])));
        let whole = joint.relative(&Q);
        assert!((parts.position - whole.position).norm() < 1e-14);
        let difference = parts.rotation - whole.rotation;
        assert!(difference.0.iter().flatten().all(|x: &f64| x.abs() < 1e-14));
    }
}
