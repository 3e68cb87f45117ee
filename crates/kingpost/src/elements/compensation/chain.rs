//! A chain of driven joints and its Jacobian, from joint rates to the velocity of a point.

use super::lever::share;
use super::predictor::solve;
use crate::elements::Context;
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::{Twist, Vector3};

/// The joints between a ship and a point that drives move.
#[derive(Clone, Debug)]
pub struct DrivenChain<S = f64> {
    /// Each joint with its drive.
    pub joints: Vec<DrivenJoint<S>>,
    /// Speed of the point below which a direction is damped, m/s: drives at full speed give less in that direction.
    pub damped_below: S,
}

/// A joint of one axis and the drive that sets its speed.
#[derive(Clone, Debug)]
pub struct DrivenJoint<S = f64> {
    /// The drive.
    pub drive: String,
    /// The link of the joint.
    pub link: usize,
    /// Its index in v.
    pub coordinate: usize,
    /// Set-point of the drive in the scenario, rad/s or m/s: the controller's command replaces it.
    pub set_point: S,
    /// The speed limit of the drive.
    pub limit: S,
}

impl<S: Scalar> DrivenChain<S> {
    /// Returns the velocity of a point, and its body's angular velocity, per rate of each joint, world axes.
    pub fn jacobian(&self, at: &Context<'_, S>, point: &Attachment<S>) -> Vec<Twist<S>> {
        let place = at.links.attachment_frame(at.model, point).position;
        self.joints.iter().map(|joint| joint_twist(at, joint.link, place)).collect()
    }

    /// Returns the velocity that the joints' present rates give, from the columns of the Jacobian.
    pub fn driven(&self, at: &Context<'_, S>, columns: &[Twist<S>]) -> Twist<S> {
        let rates = self.joints.iter().map(|joint| at.v[joint.coordinate]);
        rates.zip(columns).fold(Twist::zero(), |sum, (rate, column)| sum + *column * rate)
    }

    /// Returns the rates x' that give a velocity w by the rows J of the joints. J_s = J diag(limits) scales each rate
    /// by its limit, so that angles and lengths are comparable:
    ///
    /// ```text
    /// x' = diag(limits) J_s^T (J_s J_s^T + lambda^2 I)^-1 w,    lambda^2 = max(0, d^2 - s^2)
    /// ```
    ///
    /// Damped least squares (Nakamura & Hanafusa, "Inverse kinematic solutions with singularity robustness for robot
    /// manipulator control", *J. Dyn. Sys., Meas., Control* 108, 1986, pp. 163-171; a damping that sets in near the
    /// singularity: Chiaverini, *IEEE Trans. Robotics Automation* 13, 1997, pp. 398-410). d is `damped_below`; s
    /// approximates the smallest of the n singular values: the product of all over their root mean square to the power
    /// n - 1. A direction then gets at most the share |w| / d of the limits, and 0 if the joints cannot move the point
    /// in it.
    pub fn rates(&self, rows: &[Vec<S>], wanted: &[S]) -> Vec<S> {
        let (m, n) = (rows.len(), self.joints.len());
        let scaled = |i: usize, j: usize| rows[i][j] * self.joints[j].limit;
        let product = |i: usize, k: usize| (0..n).fold(S::ZERO, |sum, j| sum + scaled(i, j) * scaled(k, j));
        let mut square: Vec<Vec<S>> = (0..m).map(|i| (0..m).map(|k| product(i, k)).collect()).collect();
        let trace = (0..m).fold(S::ZERO, |sum, i| sum + square[i][i]);
        let mean = trace * S::constant(1.0 / m as f64) + S::constant(f64::MIN_POSITIVE);
        let smallest = (1..m).fold(determinant(&square), |product, _| product / mean);
        let lacks = self.damped_below * self.damped_below - smallest;
        let damping = lacks.select_below(0.0, || S::ZERO, || lacks);
        (0..m).for_each(|i| square[i][i] += damping);
        let pulls = solve(square, wanted.to_vec());
        let rate = |j: usize| (0..m).fold(S::ZERO, |sum, i| sum + scaled(i, j) * pulls[i]) * self.joints[j].limit;
        (0..n).map(rate).collect()
    }

    /// Returns the largest ratio of a rate to its limit.
    pub fn utilisation(&self, rates: &[S]) -> S {
        let shares = self.joints.iter().zip(rates).map(|(joint, rate)| share(*rate, joint.limit));
        shares.fold(S::ZERO, |most, share| most.select_less(share, || share, || most))
    }

    /// Returns the rates, all scaled by the same factor so that each is within its limit: the direction stays.
    pub fn within_limits(&self, rates: &[S]) -> Vec<S> {
        let most = self.utilisation(rates);
        let share = S::ONE / most.select_below(1.0, || S::ONE, || most);
        rates.iter().map(|rate| *rate * share).collect()
    }
}

/// Returns the velocity of a point at `place` in the world, fixed to a link, and the link's angular velocity, per rate
/// of the link's joint, world axes.
pub fn joint_twist<S: Scalar>(at: &Context<'_, S>, link: usize, place: Vector3<S>) -> Twist<S> {
    let root = at.links.root_in_world(at.model.roots[link]);
    let axis = at.links.axis(link);
    let arm = root.rotation.transpose_times(place - root.position);
    let linear = axis.linear + axis.angular.cross(arm);
    Twist { angular: root.rotation * axis.angular, linear: root.rotation * linear }
}

/// Returns the determinant of a symmetric matrix of at most three rows, given by its lower triangle.
fn determinant<S: Scalar>(a: &[Vec<S>]) -> S {
    match a {
        [] => S::ONE,
        [one] => one[0],
        [one, two] => one[0] * two[1] - two[0] * two[0],
        [one, two, three, ..] => {
            let columns = [[one[0], two[0], three[0]], [two[0], two[1], three[1]], [three[0], three[1], three[2]]];
            let [x, y, z] = columns.map(Vector3);
            x.dot(y.cross(z))
        }
    }
}
