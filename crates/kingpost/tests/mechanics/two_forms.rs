//! The moving frame form against the recursive form: two ways to the same equations of motion.

use crate::common;

use common::relative_difference;
use common::trees::for_all;
use kingpost::dynamics::moving_frame::{MovingFrame, Variation};
use kingpost::dynamics::{Kinematics, LinkKinematics, Loads, energy, forward, inverse::InverseDynamics};
use kingpost::model::{LinkJoint, Model, MotionType};
use kingpost::spatial::{Twist, Vector3, Wrench};
use proptest::prelude::*;

const STATES: u32 = 1000;

/// Generalized forces that the accelerations `v_dot` take, by the recursive Newton-Euler algorithm.
fn inverse_dynamics(model: &Model, q: &[f64], v: &[f64], v_dot: &[f64], loads: &Loads) -> Vec<f64> {
    let (mut bodies, mut inverse) = (Kinematics::new(&model.tree), InverseDynamics::new(model));
    let mut force = vec![0.0; v.len()];
    bodies.update(&model.tree, q, v);
    inverse.update(model, &bodies, v, v_dot, loads);
    inverse.generalized_force(model, &bodies, v_dot, &mut force);
    force
}

fn free_part(model: &Model, all: &[f64]) -> Vec<f64> {
    model.free_coordinates().into_iter().map(|i| all[i]).collect()
}

/// Returns the loads without external wrenches, forces or prescribed accelerations; the added inertia is
/// kept.
fn only_inertia(model: &Model, loads: &Loads) -> Loads {
    let Loads { added_inertia, added_inertia_between, .. } = loads.clone();
    Loads { added_inertia, added_inertia_between, ..Loads::new(model) }
}

#[test]
fn accelerations_agree_over_random_trees_and_states() {
    for_all(STATES, |tree| {
        let model = tree.model();
        let ((q, v), loads) = (tree.state(&model), tree.loads(&model));
        let matrices = MovingFrame::assemble(&model, &q, &v, &loads, Variation::Restricted);
        let expected = matrices.acceleration().expect("M* is positive definite");

        let mut links = LinkKinematics::new(&model);
        links.update(&model, &q, &v);
        let (mut work, mut v_dot) = (forward::Workspace::new(&model), vec![0.0; v.len()]);
        forward::forward_dynamics(&model, &links, &loads, &mut work, &mut v_dot);
        let difference = relative_difference(&free_part(&model, &v_dot), expected.as_slice());
        prop_assert!(difference < 1e-9, "{difference:e}");
        Ok(())
    });
}

/// Every load with the weight of all bodies as a field, and as a wrench on each body.
fn weighed_twice(model: &Model, q: &[f64], v: &[f64], loads: &Loads) -> [Loads; 2] {
    let (mut as_field, mut as_wrenches) = (loads.clone(), loads.clone());
    let gravity = Vector3::new(1.5, -2.0, -9.8);
    as_field.add_gravity(gravity);
    let mut bodies = Kinematics::new(&model.tree);
    bodies.update(&model.tree, q, v);
    for (i, (body, frame)) in model.bodies.iter().zip(&bodies.world).enumerate() {
        let force = frame.rotation.transpose_times(gravity * body.mass);
        as_wrenches.wrenches.push((i, Wrench { moment: Vector3::zero(), force }));
    }
    [as_field, as_wrenches]
}

#[test]
fn weight_as_a_field_is_weight_on_every_body_in_both_forms_and_in_inverse_dynamics() {
    for_all(200, |tree| {
        let model = tree.model();
        let ((q, v), loads) = (tree.state(&model), tree.loads(&model));
        let of = |loads: &Loads| {
            let matrices = MovingFrame::assemble(&model, &q, &v, loads, Variation::Restricted);
            let (mut links, mut work) = (LinkKinematics::new(&model), forward::Workspace::new(&model));
            let mut v_dot = vec![0.0; v.len()];
            links.update(&model, &q, &v);
            forward::forward_dynamics(&model, &links, loads, &mut work, &mut v_dot);
            let forces = inverse_dynamics(&model, &q, &v, &v_dot, loads);
            let (mut of_links, mut of_joints) = (Vec::new(), Vec::new());
            for i in 0..model.plan.len() {
                let (twist, wrench) = (work.acceleration(&links, i), work.joint_wrench(&links, i));
                of_links.extend([twist.angular.0, twist.linear.0].concat());
                of_joints.extend([wrench.moment.0, wrench.force.0].concat());
            }
            (v_dot, matrices.f_star, forces, of_links, of_joints)
        };
        let [field, wrenches] = weighed_twice(&model, &q, &v, &loads);
        let ((a, f, tau, x, p), (b, g, sigma, y, r)) = (of(&field), of(&wrenches));
        // The recursion's own difference from M*^-1, where the branches hang on little mass.
        prop_assert!(relative_difference(&a, &b) < 1e-9);
        prop_assert!(relative_difference(f.as_slice(), g.as_slice()) < 1e-12);
        prop_assert!(relative_difference(&tau, &sigma) < 1e-9);
        prop_assert!(relative_difference(&x, &y) < 1e-9 && relative_difference(&p, &r) < 1e-9);
        Ok(())
    });
}

#[test]
fn lists_of_coordinates_move_a_state_as_its_joints_do_one_by_one() {
    for_all(200, |tree| {
        let model = tree.model();
        let (q, v) = tree.state(&model);
        let xi: Vec<f64> = tree.numbers(3).vector(1.0).0.into_iter().cycle().take(v.len()).collect();
        let (mut moved, mut at_once) = (vec![0.0; q.len()], vec![0.0; q.len()]);
        let (mut rates, mut rates_at_once) = (vec![0.0; v.len()], vec![0.0; v.len()]);
        model.tree.retract(&q, &xi, &mut moved);
        model.tree.dexp_inverse(&xi, &v, &mut rates);
        model.charts.retract(&q, &xi, &mut at_once);
        model.charts.dexp_inverse(&xi, &v, &mut rates_at_once);
        prop_assert_eq!((moved, rates), (at_once, rates_at_once));
        Ok(())
    });
}

#[test]
fn links_on_one_axis_have_it_as_their_z() {
    for_all(200, |tree| {
        let model = tree.model();
        let (q, v) = tree.state(&model);
        let mut links = LinkKinematics::new(&model);
        links.update(&model, &q, &v);
        for (i, plan) in model.plan.iter().enumerate() {
            let (z, axis) = (links.in_root(i).rotation.column(2), links.axis(i));
            match plan.joint {
                LinkJoint::Revolute => prop_assert!((axis.angular - z).norm() < 1e-15),
                LinkJoint::Prismatic => prop_assert!((axis.linear - z).norm() < 1e-15),
                LinkJoint::Floating | LinkJoint::Spherical => prop_assert_eq!(*axis, Twist::zero()),
            }
        }
        Ok(())
    });
}

/// The entries whose coordinates have this mode; zero elsewhere.
fn only(model: &Model, wanted: MotionType, values: &[f64]) -> Vec<f64> {
    values.iter().zip(&model.modes).map(|(x, mode)| if *mode == wanted { *x } else { 0.0 }).collect()
}

fn largest<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    values.into_iter().fold(0.0, |m, x| m.max(x.abs()))
}

fn largest_difference<'a>(a: &[f64], b: impl IntoIterator<Item = &'a f64>) -> f64 {
    a.iter().zip(b).fold(0.0, |m, (a, b)| m.max((a - b).abs()))
}

#[test]
fn mass_matrix_agrees_with_inverse_dynamics_column_by_column() {
    for_all(STATES, |tree| {
        let model = tree.model();
        let ((q, v), loads) = (tree.state(&model), tree.loads(&model));
        let (still, inertia) = (vec![0.0; v.len()], only_inertia(&model, &loads));
        let matrices = MovingFrame::assemble(&model, &q, &v, &loads, Variation::Restricted);
        let scale = largest(&matrices.m_star);
        for (column, &i) in matrices.free.iter().enumerate() {
            let mut unit = still.clone();
            unit[i] = 1.0;
            let force = free_part(&model, &inverse_dynamics(&model, &q, &still, &unit, &inertia));
            let worst = largest_difference(&force, matrices.m_star.column(column).iter());
            prop_assert!(worst < 1e-10 * scale, "column {column}: {worst:e} of {scale:e}");
        }
        Ok(())
    });
}

#[test]
fn bias_force_agrees_with_inverse_dynamics() {
    for_all(STATES, |tree| {
        let model = tree.model();
        let ((q, v), loads) = (tree.state(&model), tree.loads(&model));
        let (still, inertia) = (vec![0.0; v.len()], only_inertia(&model, &loads));
        let rates = only(&model, MotionType::Free, &v);
        let bias = free_part(&model, &inverse_dynamics(&model, &q, &rates, &still, &inertia));
        let matrices = MovingFrame::assemble(&model, &q, &rates, &inertia, Variation::Restricted);
        let expected = matrices.bias_force();
        // A bias that cancels to nothing is measured against a thousandth of inertia times rate
        // squared, which is what its terms are made of.
        let terms = matrices.m_star.amax() * matrices.free_velocity.amax().powi(2);
        let scale = largest(bias.iter().chain(expected.iter())).max(1e-3 * terms);
        let worst = largest_difference(&bias, expected.iter());
        prop_assert!(worst < 1e-10 * scale, "{worst:e} of {scale:e}");
        Ok(())
    });
}

#[test]
fn generalized_force_agrees_with_inverse_dynamics() {
    for_all(STATES, |tree| {
        let model = tree.model();
        let ((q, v), loads) = (tree.state(&model), tree.loads(&model));
        let matrices = MovingFrame::assemble(&model, &q, &v, &loads, Variation::Restricted);
        let given = only(&model, MotionType::Prescribed, &loads.acceleration);
        let needed = free_part(&model, &inverse_dynamics(&model, &q, &v, &given, &loads));
        let expected: Vec<f64> = free_part(&model, &loads.force)
            .iter()
            .zip(&needed)
            .zip(matrices.bias_force().iter())
            .map(|((force, needed), bias)| force - needed + bias)
            .collect();
        let scale = largest(needed.iter().chain(matrices.f_star.iter()));
        let worst = largest_difference(&expected, matrices.f_star.iter());
        prop_assert!(worst < 1e-10 * scale, "{worst:e} of {scale:e}");
        Ok(())
    });
}

#[test]
fn mass_matrix_gives_the_kinetic_energy() {
    for_all(200, |tree| {
        let model = tree.model();
        let (q, v) = tree.state(&model);
        let v: Vec<f64> =
            v.iter().zip(&model.modes).map(|(x, m)| if *m == MotionType::Free { *x } else { 0.0 }).collect();
        let matrices = MovingFrame::assemble(&model, &q, &v, &Loads::new(&model), Variation::Restricted);
        let from_matrix = 0.5 * (matrices.free_velocity.transpose() * &matrices.m_star * &matrices.free_velocity)[0];
        for tree in [&model.tree, &model.links] {
            let mut kinematics = Kinematics::new(tree);
            kinematics.update(tree, &q, &v);
            let energy = energy::kinetic_energy(tree, &kinematics) + energy::rotor_energy(&model, &v);
            // Bodies fixed to the world are in the tree only, and do not move.
            prop_assert!((energy - from_matrix).abs() <= 1e-12 * energy, "{energy} {from_matrix}");
        }
        Ok(())
    });
}

#[test]
fn b_matrix_gives_the_rates_of_the_recursive_kinematics() {
    for_all(200, |tree| {
        let model = tree.model();
        let (q, v) = tree.state(&model);
        let matrices = MovingFrame::assemble(&model, &q, &v, &Loads::new(&model), Variation::Restricted);
        let mut bodies = Kinematics::new(&model.tree);
        bodies.update(&model.tree, &q, &v);
        for (i, twist) in bodies.twist.iter().enumerate() {
            let (angular, linear) = matrices.omega(i);
            let difference = (angular - twist.angular).norm() + (linear - twist.linear).norm();
            prop_assert!(difference < 1e-11, "body {i}: {difference:e}");
        }
        Ok(())
    });
}

#[test]
fn rate_of_b_agrees_with_central_differences_of_b() {
    let step = 1e-5;
    for_all(200, |tree| {
        let model = tree.model();
        let ((q, v), loads) = (tree.state(&model), Loads::new(&model));
        let b_at = |sign: f64| {
            let xi: Vec<f64> = v.iter().map(|rate| sign * step * rate).collect();
            let mut moved = vec![0.0; q.len()];
            model.tree.retract(&q, &xi, &mut moved);
            MovingFrame::assemble(&model, &moved, &v, &loads, Variation::Restricted).b
        };
        let measured = (b_at(1.0) - b_at(-1.0)) / (2.0 * step);
        let exact = MovingFrame::assemble(&model, &q, &v, &loads, Variation::Restricted).b_dot;
        let scale = exact.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
        let worst = (measured - exact).iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        // Second order in the step: |B'''| step^2 / 6, with rates up to some 10 rad/s.
        prop_assert!(worst < 1e-6 * scale, "{worst:e} of {scale:e}");
        Ok(())
    });
}

#[test]
fn fused_links_and_separate_bodies_have_the_same_momentum() {
    for_all(200, |tree| {
        let model = tree.model();
        let (q, v) = tree.state(&model);
        let centre = tree.numbers(3).vector(3.0);
        let of = |tree| {
            let mut kinematics = Kinematics::new(tree);
            kinematics.update(tree, &q, &v);
            energy::momentum(tree, &kinematics, centre)
        };
        let ((p, l), (linked_p, linked_l)) = (of(&model.tree), of(&model.links));
        prop_assert!((p - linked_p).norm() < 1e-11 * (1.0 + p.norm()));
        prop_assert!((l - linked_l).norm() < 1e-11 * (1.0 + l.norm()));
        Ok(())
    });
}
