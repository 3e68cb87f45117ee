//! Runs of random trees with every kind of joint: energy and momentum balance, and both forms of the
//! equations give the same run.

use crate::common;

use common::trees::{Kind, Tree, for_all, smallest_failure};
use common::{Random, relative_difference};
use kingpost::dynamics::moving_frame::Variation;
use kingpost::elements::drives::{Motor, PrescribedMotion, TimeFunction};
use kingpost::elements::{AnyElement, CoulombFriction, Gravity, JointDamping, JointSpring, JointStop, StopSide};
use kingpost::model::{Model, MotionType};
use kingpost::plant::Form;
use kingpost::simulation::{SchemeName, Settings, Setup, Simulation};
use kingpost::world::World;
use proptest::prelude::*;
use proptest::test_runner::TestError;

const TREES: u32 = 60;
const STEP_S: f64 = 2e-4;
const STEPS: usize = 50;

/// Friction, a spring or a stop on a coordinate that is an angle or an extension.
fn axis_forces(random: &mut Random, model: &Model, coordinate: usize) -> Vec<AnyElement> {
    let Some((_, position)) = model.axis_coordinate(coordinate) else { return Vec::new() };
    let mut some = |upper: f64| random.uniform(0.1, upper);
    match coordinate % 4 {
        0 => vec![Box::new(CoulombFriction { coordinate, friction: some(2.0), smoothing: some(0.5) })],
        1 => vec![Box::new(JointSpring { position, coordinate, stiffness: some(9.0), rest: some(1.0) })],
        2 => [StopSide::Lower, StopSide::Upper]
            .map(|side| -> AnyElement {
                let (limit, stiffness, dissipation) = (some(0.2), some(90.0), some(0.5));
                Box::new(JointStop { position, coordinate, side, limit, stiffness, dissipation })
            })
            .to_vec(),
        _ => Vec::new(),
    }
}

/// Gravity, friction and motors on everything that is free; prescribed coordinates at steady rates.
fn setup(tree: &Tree, form: Form) -> Setup {
    let model = tree.model();
    let (q, v) = tree.state(&model);
    let mut elements: Vec<AnyElement> = vec![Box::new(Gravity)];
    for (coordinate, mode) in model.modes.iter().enumerate() {
        let (body, _) = model.owner(coordinate).expect("every coordinate is of a joint");
        let mut random = tree.0[body].random(coordinate as u64 + 10);
        let (effort, damping, profile) =
            (random.uniform(-5.0, 5.0), random.uniform(0.0, 1.0), TimeFunction::constant());
        match mode {
            MotionType::Free => {
                elements.push(Box::new(JointDamping { coordinate, damping }));
                elements.extend(axis_forces(&mut random, &model, coordinate));
                elements.push(Box::new(Motor { coordinate, effort, profile, lever: None }));
            }
            MotionType::Prescribed => {
                elements.push(Box::new(PrescribedMotion { coordinate, rate: v[coordinate], profile }));
            }
            MotionType::Held => {}
        }
    }
    let settings = Settings {
        scheme: SchemeName::RungeKutta4,
        step_s: STEP_S,
        duration_s: 1.0,
        record_every_s: STEP_S,
        rate_limit: 1e6,
        form,
    };
    Setup {
        model,
        world: World::calm().with_gravity(9.81),
        elements,
        watchers: Vec::new(),
        limits: Vec::new(),
        wires: Vec::new(),
        settings,
        q,
        v,
        fingerprint: 0,
    }
}

fn channel(simulation: &mut Simulation, variable: &str) -> f64 {
    let values = common::values(simulation, variable);
    values.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn energy_and_momentum_balance_in_random_trees() {
    for_all(TREES, |tree| {
        let mut simulation = Simulation::new(setup(tree, Form::Recursive));
        simulation.step(STEPS)?;
        let energy = channel(&mut simulation, "kinetic_energy") + channel(&mut simulation, "potential_energy");
        for (error, quantity) in [("linear_momentum_error", "linear_momentum"), ("momentum_error", "angular_momentum")]
        {
            let scale = channel(&mut simulation, quantity).max(1.0);
            let error = channel(&mut simulation, error);
            prop_assert!(error < 1e-9 * scale, "{quantity}: {error:e} of {scale:e}");
        }
        let error = channel(&mut simulation, "energy_error");
        prop_assert!(error < 1e-9 * energy, "{error:e} of {energy:e}");
        Ok(())
    });
}

#[test]
fn both_forms_make_the_same_run_of_a_random_tree() {
    for_all(TREES / 4, |tree| {
        let run = |form| -> Result<[Vec<f64>; 3], TestCaseError> {
            let mut simulation = Simulation::new(setup(tree, form));
            simulation.step(10)?;
            let state = simulation.state();
            Ok([state.q.clone(), state.v.clone(), state.s.clone()])
        };
        let (recursive, matrices) = (run(Form::Recursive)?, run(Form::MovingFrame(Variation::Restricted))?);
        for (recursive, matrices) in recursive.iter().zip(&matrices) {
            let difference = relative_difference(recursive, matrices);
            prop_assert!(difference < 1e-9, "{difference:e}");
        }
        Ok(())
    });
}

/// Two bodies of which one hangs on the other by a ball joint are the fewest with the property that
/// is denied here.
#[test]
fn a_failure_shrinks_to_the_smallest_tree_that_shows_it() {
    let a_ball_on_a_body = |tree: &Tree| {
        let bodies = tree.0.iter().enumerate();
        bodies.filter(|(i, body)| *i > 0 && body.parent.is_some()).any(|(_, body)| matches!(body.kind, Kind::Spherical))
    };
    let failure = smallest_failure(TREES, |tree| {
        prop_assert!(!a_ball_on_a_body(tree));
        Ok(())
    });
    let Err(TestError::Fail(_, tree)) = failure else { panic!("no random tree has one") };
    let kinds: Vec<Kind> = tree.0.iter().map(|body| body.kind).collect();
    assert!(matches!(kinds[..], [Kind::Fixed, Kind::Spherical]), "{kinds:?}");
    assert!(tree.0.iter().all(|body| body.modes.iter().all(|mode| *mode == MotionType::Free) && !body.full_inertia));
}
