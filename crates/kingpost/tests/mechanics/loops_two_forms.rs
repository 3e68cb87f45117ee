//! Closed loops: the multipliers over the recursion against the bordered system of the moving frame
//! form, on random trees with random loops, and both against differences of the constraints.

use crate::common;

use common::{Random, relative_difference};
use kingpost::dynamics::forward::{Workspace, forward_dynamics};
use kingpost::dynamics::loops::LoopSolver;
use kingpost::dynamics::moving_frame::{MovingFrame, Variation};
use kingpost::dynamics::{Kinematics, LinkKinematics, Loads, inverse::InverseDynamics};
use kingpost::model::{Attachment, Constraint, Loop, Model, RotationAxis};

const STATES: u64 = 500;

/// Everything that a state of a model with loops is computed with.
struct Case {
    model: Model,
    loads: Loads,
    links: LinkKinematics,
    work: Workspace,
    solver: LoopSolver,
    q: Vec<f64>,
    v: Vec<f64>,
    v_dot: Vec<f64>,
    /// Accelerations of the open tree.
    open: Vec<f64>,
}

impl Case {
    /// A random tree with one to three random loops that do not depend on one another; they need
    /// not be closed, for the accelerations are defined all the same.
    fn new(seed: u64) -> Self {
        let mut random = Random::new(seed);
        loop {
            let model = random.model();
            let loops = (0..1 + random.below(3)).map(|k| random_loop(&mut random, &model, k)).collect();
            let model = model.with_loops(loops);
            let ((q, v), loads) = (random.state(&model), random.loads(&model));
            let (links, work) = (LinkKinematics::new(&model), Workspace::new(&model));
            let (solver, v_dot, open) = (LoopSolver::new(&model, 0), vec![0.0; v.len()], vec![0.0; v.len()]);
            let mut case = Self { model, loads, links, work, solver, q, v, v_dot, open };
            case.solver.begin();
            case.accelerate();
            // Far from dependent ones too, so that rounding stays small beside the tolerance.
            if case.solver.factor().pivots().iter().all(|pivot| *pivot > 1e-4) {
                return case;
            }
        }
    }

    fn accelerate(&mut self) {
        self.links.update(&self.model, &self.q, &self.v);
        forward_dynamics(&self.model, &self.links, &self.loads, &mut self.work, &mut self.v_dot);
        self.open.copy_from_slice(&self.v_dot);
        self.solver.accelerate(&self.model, &self.links, &self.loads, &mut self.work, &mut self.v_dot);
    }

    fn matrices(&self) -> MovingFrame {
        MovingFrame::assemble(&self.model, &self.q, &self.v, &self.loads, Variation::Restricted)
    }

    /// phi and phi' after the state has moved by `share` of v.
    fn residuals(&self, share: f64, v: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let xi: Vec<f64> = v.iter().map(|rate| share * rate).collect();
        let mut q = self.q.clone();
        self.model.tree.retract(&self.q, &xi, &mut q);
        let (mut links, mut solver) = (LinkKinematics::new(&self.model), self.solver.clone());
        links.update(&self.model, &q, v);
        solver.update_rows(&self.model, &links);
        solver.rows().iter().map(|row| (row.residual, row.rate)).unzip()
    }
}

fn random_loop(random: &mut Random, model: &Model, k: usize) -> Loop {
    let attachment = |random: &mut Random| {
        let body = random.chance(0.85).then(|| random.below(model.bodies.len()));
        Attachment::on(body, random.frame())
    };
    let (first, second) = (attachment(random), attachment(random));
    let all = [RotationAxis::Roll, RotationAxis::Pitch, RotationAxis::Yaw];
    let turns: Vec<RotationAxis> = all.into_iter().filter(|_| random.chance(0.3)).collect();
    let mut constraints: Vec<Constraint> = turns.iter().map(|turn| Constraint::rotation(*turn, &turns)).collect();
    constraints.extend((0..3).filter(|_| random.chance(0.4)).map(Constraint::Offset));
    if constraints.is_empty() {
        constraints.push(Constraint::Distance(random.uniform(0.5, 2.0)));
    }
    let constraints = constraints.into_iter().enumerate().map(|(i, constraint)| (format!("c_{i}"), constraint));
    Loop { name: format!("loop_{k}"), first, second, constraints: constraints.collect() }
}

fn free_part(model: &Model, all: &[f64]) -> Vec<f64> {
    model.free_coordinates().into_iter().map(|i| all[i]).collect()
}

#[test]
fn accelerations_and_multipliers_agree_over_random_trees_and_loops() {
    for seed in 0..STATES {
        let case = Case::new(seed);
        let matrices = case.matrices();
        let (expected, multipliers) = matrices.solve().expect("the constraints are independent");
        // Rounding grows with the condition of M*: what it costs the open tree, loops may cost too.
        let open = matrices.m_star.cholesky().expect("M* is positive definite");
        let open = open.solve(&(&matrices.f_star - &matrices.n_star * &matrices.free_velocity));
        let found_open = free_part(&case.model, &case.open);
        let tolerance = 1e-9_f64.max(10.0 * relative_difference(&found_open, open.as_slice()));
        // Where the loops leave no freedom, accelerations cancel against those of the open tree.
        let with_open = |closed: &[f64]| [closed, &found_open].concat();
        let found = with_open(&free_part(&case.model, &case.v_dot));
        let difference = relative_difference(&found, &with_open(expected.as_slice()));
        assert!(difference < tolerance, "seed {seed}: {difference:e}");
        let difference = relative_difference(case.solver.multipliers(), multipliers.as_slice());
        assert!(difference < tolerance, "seed {seed}: multipliers {difference:e}");
    }
}

#[test]
fn rows_of_j_agree_with_central_differences_of_the_constraints() {
    // Along each coordinate, with error h^2 / 6 times a third derivative of order one.
    let step = 1e-5;
    for seed in 0..40 {
        let case = Case::new(seed);
        let j = case.matrices().j;
        for (column, i) in case.model.free_coordinates().into_iter().enumerate() {
            let mut unit = vec![0.0; case.v.len()];
            unit[i] = 1.0;
            let (rates, [(after, _), (before, _)]) =
                (case.residuals(0.0, &unit).1, [step, -step].map(|h| case.residuals(h, &unit)));
            for row in 0..j.nrows() {
                let difference = (after[row] - before[row]) / (2.0 * step);
                assert!((j[(row, column)] - difference).abs() < 1e-8, "seed {seed}: {row}, {column}");
                assert!((j[(row, column)] - rates[row]).abs() < 1e-11, "seed {seed}: {row}, {column}");
            }
        }
    }
}

#[test]
fn the_second_derivative_of_the_constraints_agrees_with_differences_of_the_first() {
    // phi' along the motion that has no acceleration: q'' = 0 for all coordinates of v.
    let step = 1e-5;
    for seed in 0..40 {
        let mut case = Case::new(seed);
        case.loads.acceleration.fill(0.0);
        let rate = case.matrices().j_dot_v;
        let [after, before] = [step, -step].map(|h| case.residuals(h, &case.v).1);
        for (row, rate) in rate.iter().enumerate() {
            let difference = (after[row] - before[row]) / (2.0 * step);
            assert!((rate - difference).abs() < 1e-6 * rate.abs().max(10.0), "seed {seed}: {rate} {difference}");
        }
    }
}

#[test]
fn joint_loads_include_the_forces_of_loops() {
    for seed in 0..100 {
        let mut case = Case::new(seed);
        case.solver.apply(&case.model, &case.links, &mut case.loads);
        let (mut bodies, mut inverse) = (Kinematics::new(&case.model.tree), InverseDynamics::new(&case.model));
        bodies.update(&case.model.tree, &case.q, &case.v);
        inverse.update(&case.model, &bodies, &case.v, &case.v_dot, &case.loads);
        let mut force = vec![0.0; case.v.len()];
        inverse.generalized_force(&case.model, &bodies, &case.v_dot, &mut force);
        let (found, given) = (free_part(&case.model, &force), free_part(&case.model, &case.loads.force));
        let scale = inverse.joint_wrench.iter().fold(1.0_f64, |m, w| m.max(w.force.norm()).max(w.moment.norm()));
        let worst = found.iter().zip(&given).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
        assert!(worst < 1e-9 * scale, "seed {seed}: {worst:e} of {scale:e}");
    }
}
