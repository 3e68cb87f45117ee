//! Velocity terms against dual numbers: q moves along v as q + v e, and the coefficient of e is a rate. Dual
//! numbers do not use R' = R hat(omega), B' or the columns' rates.

use crate::common;

use common::Random;
use kingpost::dynamics::moving_frame::{MovingFrame, Variation};
use kingpost::dynamics::{Kinematics, Loads};
use kingpost::model::joint::{AxisList, Fixed, Floating, Prismatic, Revolute, Spherical};
use kingpost::model::{BodyDefinition, Joint, JointKind, Model, MotionType, Shape};
use kingpost::scalar::{Dual, Scalar};
use kingpost::spatial::{Frame, SpatialInertia, Vector3, exp};
use nalgebra::DVector;

const TREES: u64 = 300;
/// Sums of some hundred products in double precision.
const ROUNDING: f64 = 1e-11;

fn lifted<S: Scalar>(random: &mut Random, scale: f64) -> Vector3<S> {
    Vector3::constant(random.vector(scale).0)
}

fn direction<S: Scalar>(random: &mut Random) -> Vector3<S> {
    Vector3::constant(random.unit().0)
}

/// A joint of every kind, by turns.
fn joint<S: Scalar>(random: &mut Random, i: usize) -> JointKind<S> {
    let placement = Frame { rotation: exp(lifted(random, 2.0)), position: lifted(random, 2.0) };
    let (axis, to_child) = (direction(random), lifted(random, 1.5));
    let across: Vector3<S> = axis.cross(direction(random));
    let across = across * (S::ONE / across.norm());
    match (i, random.below(8)) {
        (0, _) => JointKind::Floating(Floating { hold_translation: false, hold_rotation: false }),
        (_, 0) => JointKind::Revolute(Revolute::new(placement, axis, to_child)),
        (_, 1) => JointKind::Prismatic(Prismatic::new(placement, axis, to_child)),
        (_, 2) => JointKind::Fixed(Fixed::new(placement, to_child)),
        (_, 3) => JointKind::Spherical(Spherical::new(placement, to_child)),
        (_, 4) => JointKind::AxisList(AxisList::cylindrical(placement, axis, to_child)),
        (_, 5) => JointKind::AxisList(AxisList::universal(placement, axis, across, to_child)),
        (_, 6) => JointKind::AxisList(AxisList::planar(placement, axis, across, to_child)),
        _ => JointKind::AxisList(AxisList::elastic(placement, to_child)),
    }
}

/// Rigid, or full: symmetric and positive definite.
fn inertia<S: Scalar>(random: &mut Random, mass: S) -> SpatialInertia<S> {
    if random.chance(0.7) {
        let edges_m = core::array::from_fn(|_| S::constant(random.uniform(0.3, 2.0)));
        return SpatialInertia::rigid(mass, Shape::Box { edges_m }.inertia(mass));
    }
    let a: [[f64; 6]; 6] = core::array::from_fn(|_| core::array::from_fn(|_| random.uniform(-1.0, 1.0)));
    let square = |i: usize, j: usize| (0..6).map(|k| a[i][k] * a[j][k]).sum::<f64>() + f64::from(i == j);
    SpatialInertia::from_rows(&core::array::from_fn(|i| core::array::from_fn(|j| S::constant(square(i, j)))))
}

/// Returns the same tree for the same seed, whatever the scalar.
fn tree<S: Scalar>(seed: u64) -> Model<S> {
    let mut random = Random::new(seed);
    let n = 1 + random.below(8);
    let describe = |i: usize| {
        let parent = (i > 0).then(|| random.below(i));
        let kind = joint(&mut random, i);
        let mass = S::constant(random.uniform(0.5, 5.0));
        let inertia = inertia(&mut random, mass);
        let joint = Joint { name: format!("joint_{i}"), kind, mode: MotionType::Free };
        BodyDefinition { name: format!("body_{i}"), parent, joint, mass, inertia, points: Vec::new() }
    };
    Model::new((0..n).map(describe).collect())
}

/// Rates of {X'} = {x' in the world, omega in body axes} and of [M] {X'} when q moves along v and v stays.
fn rates_by_dual_numbers(seed: u64, q: &[f64], v: &[f64]) -> (DVector<f64>, DVector<f64>) {
    let model = tree::<Dual<1>>(seed);
    let constant = |x: &[f64]| x.iter().map(|x| Dual::constant(*x)).collect::<Vec<Dual<1>>>();
    let along: Vec<Dual<1>> = v.iter().map(|v| Dual { value: 0.0, derivative: [*v] }).collect();
    let mut moving = constant(q);
    model.tree.retract(&constant(q), &along, &mut moving);
    let mut kinematics = Kinematics::new(&model.tree);
    kinematics.update(&model.tree, &moving, &constant(v));
    let (mut x, mut momentum) = (Vec::new(), Vec::new());
    for (i, node) in model.tree.nodes.iter().enumerate() {
        let (turned, twist) = (kinematics.world[i].rotation, kinematics.twist[i]);
        let wrench = node.inertia.times(&twist);
        x.extend([(turned * twist.linear).0, twist.angular.0].concat());
        momentum.extend([(turned * wrench.force).0, wrench.moment.0].concat());
    }
    let rates = |of: Vec<Dual<1>>| DVector::from_iterator(of.len(), of.iter().map(|x| x.derivative[0]));
    (rates(x), rates(momentum))
}

fn assert_alike(found: &DVector<f64>, expected: &DVector<f64>, scale: f64, what: &str) {
    let worst = (found - expected).amax();
    assert!(worst <= ROUNDING * (1.0 + scale), "{what}: {worst:e} of {scale:e}");
}

/// {X''} = [B'] {q'} where {q''} = 0 (eqs. 44, 62).
#[test]
fn b_dot_times_the_rates_is_the_time_derivative_of_the_velocities() {
    for seed in 0..TREES {
        let model = tree::<f64>(seed);
        let (q, v) = Random::new(seed + TREES).state(&model);
        let matrices = MovingFrame::assemble(&model, &q, &v, &Loads::new(&model), Variation::Restricted);
        let (expected, _) = rates_by_dual_numbers(seed, &q, &v);
        let found = &matrices.b_dot * DVector::from_column_slice(&v);
        assert_alike(&found, &expected, expected.amax(), &format!("seed {seed}"));
    }
}

/// [N*] {q'} = [B]^T (d/dt ([M] {X'}) + [D] [M] {X'}) where {q''} = 0 (eq. 60b).
#[test]
fn the_bias_force_agrees_with_the_rate_of_momentum_by_dual_numbers() {
    for seed in 0..TREES {
        let model = tree::<f64>(seed);
        let (q, v) = Random::new(seed + TREES).state(&model);
        let matrices = MovingFrame::assemble(&model, &q, &v, &Loads::new(&model), Variation::Restricted);
        let (_, momentum_rate) = rates_by_dual_numbers(seed, &q, &v);
        let terms = momentum_rate + &matrices.d * (&matrices.m * &matrices.x_dot);
        let expected = matrices.b.transpose() * &terms;
        let scale = matrices.b.amax() * terms.amax();
        assert_alike(&matrices.bias_force(), &expected, scale, &format!("seed {seed}"));
    }
}
