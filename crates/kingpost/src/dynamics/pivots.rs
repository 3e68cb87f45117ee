//! Check that every coordinate moves some mass.

use super::ball::Ball;
use super::{LinkKinematics, Loads, forward};
use crate::model::{LinkJoint, Model, MotionType};
use crate::spatial::{SpatialInertia, Twist};

/// Largest pivot of M* that counts as rounding, as a share of the coordinate's inertia with a locked branch.
const SMALLEST_SHARE: f64 = 1e-13;

/// Returns a coordinate of v without articulated inertia, found in time linear in the number of links; of
/// several on a branch the outermost, because it affects the others. `None` if M* is positive definite.
pub fn massless_coordinate(model: &Model, links: &LinkKinematics, v: &[f64]) -> Option<usize> {
    let (loads, mut work) = (Loads::new(model), forward::Workspace::new(model));
    let mut v_dot = vec![0.0; v.len()];
    forward::forward_dynamics(model, links, &loads, &mut work, &mut v_dot);
    let locked = locked_inertias(model, links);
    for (i, plan) in model.plan.iter().enumerate().rev() {
        let (free, at) = (work.articulated_inertia(links, i), plan.velocities);
        let directions = match plan.joint {
            LinkJoint::Floating => unit_twists().to_vec(),
            LinkJoint::Spherical => Ball::new(plan, links.in_root(i)).axes().to_vec(),
            LinkJoint::Revolute | LinkJoint::Prismatic => vec![*links.axis(i)],
        };
        // The coordinates of a floating joint start with the translation, its twists with the rotation.
        let coordinate = |k: usize| at + if directions.len() == 6 { (k + 3) % 6 } else { k };
        let moving = (0..directions.len()).filter(|&k| model.modes[coordinate(k)] == MotionType::Free);
        let moving: Vec<usize> = moving.collect();
        let free_directions: Vec<(Twist, f64)> =
            moving.iter().map(|&k| (directions[k], model.rotor_inertia[coordinate(k)])).collect();
        if let Some(k) = first_small_pivot(&free, &locked[i], &free_directions) {
            return Some(coordinate(moving[k]));
        }
    }
    None
}

/// Returns the inertia of each link with its subtree and locked joints, root axes.
fn locked_inertias(model: &Model, links: &LinkKinematics) -> Vec<SpatialInertia> {
    let nodes = &model.links.nodes;
    let mut locked: Vec<SpatialInertia> =
        nodes.iter().enumerate().map(|(i, node)| node.inertia.to_parent(links.in_root(i))).collect();
    for i in (0..nodes.len()).rev() {
        if let Some(parent) = nodes[i].parent {
            let own = locked[i];
            locked[parent] += own;
        }
    }
    locked
}

/// Returns unit twists: rotation about x, y, z, then translation along them.
fn unit_twists() -> [Twist; 6] {
    core::array::from_fn(|k| {
        let mut twist = Twist::zero();
        let part = if k < 3 { &mut twist.angular } else { &mut twist.linear };
        part[k % 3] = 1.0;
        twist
    })
}

/// Returns the first small Cholesky pivot of the inertia in some directions with their rotors, relative to
/// the locked diagonal.
fn first_small_pivot(free: &SpatialInertia, locked: &SpatialInertia, directions: &[(Twist, f64)]) -> Option<usize> {
    let n = directions.len();
    let mut l = vec![0.0; n * n];
    for i in 0..n {
        let (direction, rotor) = directions[i];
        let scale = locked.quadratic(&direction) + rotor;
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| l[i * n + k] * l[j * n + k]).sum();
            let rest = free.times(&direction).dot(&directions[j].0) - sum;
            if i != j {
                l[i * n + j] = rest / l[j * n + j];
                continue;
            }
            let rest = rest + rotor;
            if rest.is_finite() && scale > 0.0 && rest > SMALLEST_SHARE * scale {
                l[i * n + i] = rest.sqrt();
            } else {
                return Some(i);
            }
        }
    }
    None
}
