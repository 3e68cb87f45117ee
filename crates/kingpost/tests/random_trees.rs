//! Runs of random trees with every kind of joint: energy and momentum are accounted for, and both
//! forms of the equations make the same run.

mod common;

use common::{Random, relative_difference};
use kingpost::drives::{Drive, Motor, PrescribedMotion, Profile};
use kingpost::dynamics::moving_frame::Variation;
use kingpost::forces::{CoulombFriction, Force, Gravity, JointDamping, JointSpring, JointStop, StopSide};
use kingpost::model::{Mode, Model};
use kingpost::plant::Form;
use kingpost::simulation::{SchemeName, Settings, Setup, Simulation};

const TREES: u64 = 60;
const STEP_S: f64 = 2e-4;
const STEPS: usize = 50;

/// Friction, a spring or a stop on a coordinate that is an angle or an extension.
fn axis_forces(random: &mut Random, model: &Model, coordinate: usize) -> Vec<Force> {
    let Some((_, position)) = model.axis_coordinate(coordinate) else { return Vec::new() };
    let mut some = |upper: f64| random.uniform(0.1, upper);
    match coordinate % 4 {
        0 => vec![Force::CoulombFriction(CoulombFriction { coordinate, friction: some(2.0), smoothing: some(0.5) })],
        1 => vec![Force::JointSpring(JointSpring { position, coordinate, stiffness: some(9.0), rest: some(1.0) })],
        2 => [StopSide::Lower, StopSide::Upper]
            .map(|side| {
                let (limit, stiffness, dissipation) = (some(0.2), some(90.0), some(0.5));
                Force::JointStop(JointStop { position, coordinate, side, limit, stiffness, dissipation })
            })
            .to_vec(),
        _ => Vec::new(),
    }
}

/// Gravity, friction and motors on everything that is free; prescribed coordinates at steady rates.
fn setup(seed: u64, form: Form) -> Setup {
    let mut random = Random::new(seed);
    let model = random.model();
    let (q, v) = random.state(&model);
    let mut forces = vec![Force::Gravity(Gravity { acceleration: 9.81 })];
    let mut drives = Vec::new();
    for (coordinate, mode) in model.modes.iter().enumerate() {
        let (effort, damping, profile) = (random.uniform(-5.0, 5.0), random.uniform(0.0, 1.0), Profile::constant());
        match mode {
            Mode::Free => {
                forces.push(Force::JointDamping(JointDamping { coordinate, damping }));
                forces.extend(axis_forces(&mut random, &model, coordinate));
                drives.push(Drive::Motor(Motor { coordinate, effort, profile, input: None }));
            }
            Mode::Prescribed => {
                drives.push(Drive::Prescribed(PrescribedMotion { coordinate, rate: v[coordinate], profile }));
            }
            Mode::Held => {}
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
    Setup { model, forces, drives, inputs: Vec::new(), settings, q, v }
}

fn channel(simulation: &mut Simulation, variable: &str) -> f64 {
    let values = common::values(simulation, variable);
    values.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn energy_and_momentum_balance_in_random_trees() {
    for seed in 0..TREES {
        let mut simulation = Simulation::new(setup(seed, Form::Recursive));
        simulation.step(STEPS).unwrap();
        let energy = channel(&mut simulation, "kinetic_energy") + channel(&mut simulation, "potential_energy");
        for (error, quantity) in [("linear_momentum_error", "linear_momentum"), ("momentum_error", "angular_momentum")]
        {
            let scale = channel(&mut simulation, quantity).max(1.0);
            let error = channel(&mut simulation, error);
            assert!(error < 1e-9 * scale, "seed {seed}, {quantity}: {error:e} of {scale:e}");
        }
        let error = channel(&mut simulation, "energy_error");
        assert!(error < 1e-9 * energy, "seed {seed}: {error:e} of {energy:e}");
    }
}

#[test]
fn both_forms_make_the_same_run_of_a_random_tree() {
    for seed in 0..TREES / 4 {
        let run = |form| {
            let mut simulation = Simulation::new(setup(seed, form));
            simulation.step(10).unwrap();
            let state = simulation.state();
            [state.q.clone(), state.v.clone(), state.s.clone()]
        };
        let (recursive, matrices) = (run(Form::Recursive), run(Form::MovingFrame(Variation::Restricted)));
        for (recursive, matrices) in recursive.iter().zip(&matrices) {
            let difference = relative_difference(recursive, matrices);
            assert!(difference < 1e-9, "seed {seed}: {difference:e}");
        }
    }
}
