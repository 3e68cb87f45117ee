//! Closed loops: constraints between two bodies of the tree in addition to their joints.
//!
//! A mechanism with a loop is cut open into a tree, and the joint that was cut is written as constraints between its
//! two bodies. With A the attachment on the first body and B on the second, d the vector from A to B in A's axes and Q
//! = R_A^T R_B the axes of B in those of A, each constraint is one equation phi = 0:
//!
//! | constraint | phi | carries, at B |
//! | --- | --- | --- |
//! | x, y, z | d_i | a force along A's axis i |
//! | roll, pitch, yaw | +-Q_ij, i and j different | a moment about B's axis j cross A's axis i |
//! | distance | abs(d) - l | a force along d |

use super::Body;
use crate::scalar::Scalar;
use crate::spatial::Frame;

/// A point with axes, on a body or in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attachment<S = f64> {
    /// The body; `None` is the world.
    pub body: Option<usize>,
    /// Pose of the attachment in the body's frame, or in the world.
    pub in_body: Frame<S>,
    /// The link that contains the body; `None` if the body is fixed to the world.
    pub link: Option<usize>,
    /// Pose of the attachment in the link's frame, or in the world.
    pub in_link: Frame<S>,
}

/// One equation between two attachments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Constraint<S = f64> {
    /// The offset of the second attachment along this axis (0, 1, 2) of the first one is zero.
    Offset(usize),
    /// An axis of the first attachment and a different axis of the second one are perpendicular: phi is their
    /// scalar product, with the sign for which a small positive rotation about the third axis is positive.
    Perpendicular {
        /// Axis of the first attachment: 0, 1 or 2.
        first: usize,
        /// Axis of the second, different from `first`.
        second: usize,
    },
    /// The distance of the attachments has this value, m: a massless rod.
    Distance(S),
}

/// A rotation that a loop can constrain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RotationAxis {
    /// About x.
    Roll,
    /// About y.
    Pitch,
    /// About z.
    Yaw,
}

/// A closed loop, cut open at a joint that constraints represent.
#[derive(Clone, Debug)]
pub struct Loop<S = f64> {
    /// Unique name.
    pub name: String,
    /// Attachment on the first body: its axes are those of the constraints.
    pub first: Attachment<S>,
    /// Attachment on the second body.
    pub second: Attachment<S>,
    /// Equations of the loop, each with its name in the scenario.
    pub constraints: Vec<(String, Constraint<S>)>,
}

impl<S: Scalar> Attachment<S> {
    /// Creates an attachment on a body, or in the world.
    pub fn on(body: Option<usize>, in_body: Frame<S>) -> Self {
        Self { body, in_body, link: None, in_link: in_body }
    }

    /// Returns the attachment with its link, after the bodies have their links.
    pub(super) fn on_link(self, bodies: &[Body<S>]) -> Self {
        let Some(body) = self.body.map(|body| &bodies[body]) else { return self };
        Self { link: body.link, in_link: body.in_link.times(&self.in_body), ..self }
    }
}

impl<S: Scalar> Constraint<S> {
    /// Returns the constraint of one rotation; `all` are the constrained rotations. Two constrained rotations
    /// leave a hinge about the third axis: B's hinge axis stays perpendicular to A's other two, at any angle
    /// of the hinge. Otherwise phi is that of the intrinsic z-y-x angles: B's y on A's z for roll, B's x on
    /// A's z for pitch, B's x on A's y for yaw.
    pub fn rotation(turn: RotationAxis, all: &[RotationAxis]) -> Self {
        let third = |axis: usize| 3 - turn as usize - axis;
        let free: Vec<usize> = (0..3).filter(|axis| !all.iter().any(|turn| *turn as usize == *axis)).collect();
        let second = match (free.as_slice(), turn) {
            ([hinge], _) => *hinge,
            (_, RotationAxis::Roll) => 1,
            (_, RotationAxis::Pitch | RotationAxis::Yaw) => 0,
        };
        Self::Perpendicular { first: third(second), second }
    }

    /// Returns the unit of the constraint's equation.
    pub fn unit(&self) -> &'static str {
        match self {
            Self::Offset(_) | Self::Distance(_) => "m",
            Self::Perpendicular { .. } => "rad",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axes(turn: RotationAxis, all: &[RotationAxis]) -> (usize, usize) {
        match Constraint::<f64>::rotation(turn, all) {
            Constraint::Perpendicular { first, second } => (first, second),
            _ => unreachable!("a rotation is about axes"),
        }
    }

    #[test]
    fn two_rotations_leave_a_hinge_whose_axis_stays_perpendicular_to_the_other_two() {
        use RotationAxis::{Pitch, Roll, Yaw};
        assert_eq!([Roll, Yaw].map(|turn| axes(turn, &[Roll, Yaw])), [(2, 1), (0, 1)]);
        assert_eq!([Roll, Pitch].map(|turn| axes(turn, &[Roll, Pitch])), [(1, 2), (0, 2)]);
        assert_eq!([Pitch, Yaw].map(|turn| axes(turn, &[Pitch, Yaw])), [(2, 0), (1, 0)]);
        let all = [Roll, Pitch, Yaw];
        assert_eq!(all.map(|turn| axes(turn, &all)), [(2, 1), (2, 0), (1, 0)]);
    }
}
