//! Constraints at the present positions: phi, the row of J as a wrench, and J' v.
//!
//! By Newton's third law a constraint exerts a wrench W on the second body, and -W on the first. The row of J
//! is that wrench: `phi' = W . (V_second - V_first)` with both twists about one point in the same axes.
//! Differentiated once more, with W fixed in A except for the rate `W_rel'` due to the motion of B in A,
//!
//! ```text
//! phi'' = W . (V_second' - V_first') - W . (V_first x V_rel) + W_rel' . V_rel
//! ```
//!
//! (Featherstone 2008, section 2.9 for the derivatives of twists and wrenches, ch. 8 for loops).

use crate::dynamics::{LinkKinematics, TemporaryConstraint};
use crate::model::{Attachment, Constraint, Model};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Twist, Vector3, Wrench};

/// One constraint at the present positions.
#[derive(Clone, Copy, Debug)]
pub struct Row<S = f64> {
    /// phi, m or rad (for an angle, its sine).
    pub residual: S,
    /// phi', m/s or rad/s.
    pub rate: S,
    /// J' v: phi'' for zero accelerations of the coordinates, m/s^2 or rad/s^2.
    pub bias_acceleration: S,
    /// W, about the first attachment in its axes.
    pub wrench: Wrench<S>,
    /// -W in the axes of the first link's root, about the root's origin.
    pub on_first: Wrench<S>,
    /// W in the axes of the second link's root, about the root's origin.
    pub on_second: Wrench<S>,
    /// Vector from the first attachment to the second, axes of the first, m.
    pub way: Vector3<S>,
    /// The link of the first attachment; `None` for the world.
    pub first: Option<usize>,
    /// The link of the second attachment; `None` for the world.
    pub second: Option<usize>,
}

impl<S: Scalar> Row<S> {
    /// Returns the row of a constraint between two attachments.
    pub fn new(
        model: &Model<S>,
        links: &LinkKinematics<S>,
        first: &Attachment<S>,
        second: &Attachment<S>,
        constraint: &Constraint<S>,
    ) -> Self {
        Pair::new(model, links, first, second).row(constraint)
    }

    /// Returns W about the second attachment, in the axes of the first.
    pub fn at_second(&self) -> Wrench<S> {
        Wrench { moment: self.wrench.moment - self.way.cross(self.wrench.force), ..self.wrench }
    }
}

/// Writes the rows of all loops.
pub fn update<S: Scalar>(model: &Model<S>, links: &LinkKinematics<S>, rows: &mut Vec<Row<S>>) {
    rows.clear();
    for closed in &model.loops {
        let pair = Pair::new(model, links, &closed.first, &closed.second);
        rows.extend(closed.constraints.iter().map(|(_, constraint)| pair.row(constraint)));
    }
}

/// Returns the pose of the second attachment in the axes of the first.
pub fn relative_pose<S: Scalar>(
    model: &Model<S>,
    links: &LinkKinematics<S>,
    [first, second]: [&Attachment<S>; 2],
) -> Frame<S> {
    Pair::new(model, links, first, second).second_in_first
}

/// Writes constraints between two attachments for an element that holds them, each with its wrench on the second body, about the
/// second attachment in the axes of the first.
pub fn hold<S: Scalar>(
    model: &Model<S>,
    links: &LinkKinematics<S>,
    ends: [&Attachment<S>; 2],
    constraints: &[Constraint<S>],
    held: &mut [TemporaryConstraint<S>],
    at_second: &mut [Wrench<S>],
) {
    let pair = Pair::new(model, links, ends[0], ends[1]);
    for ((constraint, held), at_second) in constraints.iter().zip(held).zip(at_second) {
        let row = pair.row(constraint);
        *at_second = row.at_second();
        (held.residual, held.rate, held.bias_acceleration) = (row.residual, row.rate, row.bias_acceleration);
        let own = [-row.wrench, pair.second_in_first.wrench_to_child(&row.wrench)];
        held.clear();
        for (end, wrench) in ends.into_iter().zip(own) {
            held.wrenches.extend(end.body.map(|body| (body, end.in_body.wrench_to_parent(&wrench))));
        }
    }
}

/// Two attachments in the axes of the first one, A.
struct Pair<S> {
    first: Option<usize>,
    second: Option<usize>,
    /// Frame of A in the axes of the first body's root, or in the world.
    first_in_own_root: Frame<S>,
    /// Frame of A in the axes of the second body's root, or in the world.
    first_in_other_root: Frame<S>,
    /// Frame of B in A.
    second_in_first: Frame<S>,
    /// Twist of the first body about A, in A's axes.
    twist_first: Twist<S>,
    /// Twist of the second body minus that of the first, about A in A's axes.
    relative: Twist<S>,
}

/// Returns the root of an attachment's branch, and the attachment in this root's frame.
fn seen_from_root<S: Scalar>(
    model: &Model<S>,
    links: &LinkKinematics<S>,
    attachment: &Attachment<S>,
) -> (Option<usize>, Frame<S>) {
    match attachment.link {
        Some(link) => (Some(model.roots[link]), links.in_root(link).times(&attachment.in_link)),
        None => (None, attachment.in_link),
    }
}

/// Returns the frame `from` in the frame `to`, both given in the world. The positions are subtracted first,
/// because two ships can be close together and far from the origin.
fn between<S: Scalar>(to: &Frame<S>, from: &Frame<S>) -> Frame<S> {
    let turned = to.rotation.transpose();
    Frame { rotation: turned * from.rotation, position: turned * (from.position - to.position) }
}

impl<S: Scalar> Pair<S> {
    fn new(model: &Model<S>, links: &LinkKinematics<S>, a: &Attachment<S>, b: &Attachment<S>) -> Self {
        let (first_root, first) = seen_from_root(model, links, a);
        let (second_root, second) = seen_from_root(model, links, b);
        let root = |root: Option<usize>| root.map_or(Frame::identity(), |r| *links.root_in_world(r));
        let first_in_other_root = if first_root == second_root {
            first
        } else {
            between(&root(second_root), &root(first_root)).times(&first)
        };
        let twist = |attachment: &Attachment<S>, frame: &Frame<S>| {
            attachment.link.map_or(Twist::zero(), |link| frame.twist_to_child(links.twist(link)))
        };
        let twist_first = twist(a, &first);
        Self {
            first: a.link,
            second: b.link,
            first_in_own_root: first,
            first_in_other_root,
            second_in_first: between(&first_in_other_root, &second),
            twist_first,
            relative: twist(b, &first_in_other_root) - twist_first,
        }
    }

    fn row(&self, constraint: &Constraint<S>) -> Row<S> {
        let (residual, wrench, wrench_rate) = match *constraint {
            Constraint::Offset(axis) => self.offset(axis),
            Constraint::Perpendicular { first, second } => self.perpendicular(first, second),
            Constraint::Distance(length) => self.distance(length),
        };
        let carried = self.twist_first.cross(&self.relative);
        Row {
            residual,
            rate: wrench.dot(&self.relative),
            bias_acceleration: wrench_rate.dot(&self.relative) - wrench.dot(&carried),
            wrench,
            on_first: -self.first_in_own_root.wrench_to_parent(&wrench),
            on_second: self.first_in_other_root.wrench_to_parent(&wrench),
            way: self.second_in_first.position,
            first: self.first,
            second: self.second,
        }
    }

    /// Returns d and its rate, in A's axes.
    fn way(&self) -> (Vector3<S>, Vector3<S>) {
        let d = self.second_in_first.position;
        (d, self.relative.linear + self.relative.angular.cross(d))
    }

    /// Returns phi, W and the rate of W in A, of `d_i = 0`: a force along A's axis, through B.
    fn offset(&self, axis: usize) -> (S, Wrench<S>, Wrench<S>) {
        let ((d, d_dot), e) = (self.way(), unit(axis));
        let wrench = Wrench { moment: d.cross(e), force: e };
        (d[axis], wrench, Wrench { moment: d_dot.cross(e), force: Vector3::zero() })
    }

    /// Returns phi, W and the rate of W in A, of `abs(d) = l`: a force along d. If d is zero, the force has
    /// no direction.
    fn distance(&self, length: S) -> (S, Wrench<S>, Wrench<S>) {
        let (d, d_dot) = self.way();
        let now = d.norm();
        let reciprocal = now.select_below(SHORTEST, || S::ZERO, || S::ONE / now);
        let n = d * reciprocal;
        let n_dot = (d_dot - n * n.dot(d_dot)) * reciprocal;
        let force = |force| Wrench { moment: Vector3::zero(), force };
        (now - length, force(n), force(n_dot))
    }

    /// Returns phi, W and the rate of W in A, of `+-a . b = 0`, for axes a of A and b of B: a moment along b x a.
    fn perpendicular(&self, first: usize, second: usize) -> (S, Wrench<S>, Wrench<S>) {
        let sign = if (first + 3 - second) % 3 == 1 { S::ONE } else { -S::ONE };
        let (a, b) = (unit(first) * sign, self.second_in_first.rotation.column(second));
        let b_dot = self.relative.angular.cross(b);
        let moment = |moment| Wrench { moment, force: Vector3::zero() };
        (a.dot(b), moment(b.cross(a)), moment(b_dot.cross(a)))
    }
}

/// Smallest length of a rod that has a direction, m.
const SHORTEST: f64 = 1e-9;

fn unit<S: Scalar>(axis: usize) -> Vector3<S> {
    Vector3(core::array::from_fn(|i| if i == axis { S::ONE } else { S::ZERO }))
}
