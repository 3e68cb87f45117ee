//! Motions of one coordinate or one body with known closed forms.

use crate::common;

use common::closed_forms::{GRAVITY, Pendulum};
use kingpost::elements::drives::{Motor, PrescribedMotion, Pulse, Servo, TimeFunction};
use kingpost::elements::hull::HullFrame;
use kingpost::elements::{AnyElement, DampedAgainst, Gravity, JointDamping, ViscousDamping};
use kingpost::model::joint::{Floating, Prismatic, Revolute};
use kingpost::model::{BodyDefinition, Joint, JointKind, Model, MotionType};
use kingpost::plant::Form;
use kingpost::simulation::{SchemeName, Settings, Setup, Simulation};
use kingpost::spatial::{Frame, SpatialInertia, Symmetric3, Vector3};
use kingpost::world::World;

fn body(name: &str, parent: Option<usize>, kind: JointKind, mass: f64, moments: [f64; 3]) -> BodyDefinition {
    let joint = Joint { name: name.to_owned(), kind, mode: MotionType::Free };
    let inertia = SpatialInertia::rigid(mass, Symmetric3::diagonal(moments));
    BodyDefinition { name: name.to_owned(), parent, joint, mass, inertia, points: Vec::new() }
}

fn simulation(
    bodies: Vec<BodyDefinition>,
    mut elements: Vec<AnyElement>,
    drives: Vec<AnyElement>,
    step_s: f64,
    (q, v): (Vec<f64>, Vec<f64>),
) -> Simulation {
    let settings = Settings {
        scheme: SchemeName::RungeKutta4,
        step_s,
        duration_s: 10.0,
        record_every_s: step_s,
        rate_limit: 1e4,
        form: Form::Recursive,
    };
    elements.extend(drives);
    let world = World::calm().with_gravity(GRAVITY);
    Simulation::new(Setup {
        model: Model::new(bodies),
        world,
        elements,
        watchers: Vec::new(),
        limits: Vec::new(),
        wires: Vec::new(),
        settings,
        q,
        v,
        fingerprint: 0,
    })
}

fn hinge(axis: [f64; 3], to_child: [f64; 3]) -> JointKind {
    JointKind::Revolute(Revolute::new(Frame::identity(), Vector3(axis), Vector3(to_child)))
}

fn slide(axis: [f64; 3]) -> JointKind {
    JointKind::Prismatic(Prismatic::new(Frame::identity(), Vector3(axis), Vector3::zero()))
}

fn floating() -> JointKind {
    JointKind::Floating(Floating::default())
}

/// Error channels of the ledger must be small beside `scale`.
fn assert_ledger_closes(simulation: &mut Simulation, scale: f64) {
    let mut row = Vec::new();
    simulation.write_row(&mut row);
    for channel in simulation.channels().iter().filter(|c| c.variable.ends_with("_error")) {
        let error = row[channel.offset..][..channel.len].iter().fold(0.0_f64, |most, error| most.max(error.abs()));
        assert!(error < 1e-9 * scale, "{}: {error:e}", channel.variable);
    }
}

#[test]
fn a_thrown_body_flies_on_a_parabola_and_precesses_by_eulers_equations() {
    // Symmetric body: omega_x + i omega_y turns in the body at (I_z - I_x) / I_x omega_z
    // (Landau & Lifshitz, Mechanics, 36.6).
    let moments = [2.0, 2.0, 3.0];
    let start = (vec![0.0, 0.0, 10.0, 1.0, 0.0, 0.0, 0.0], vec![3.0, -1.0, 20.0, 0.4, 0.0, 5.0]);
    let gravity = Box::new(Gravity);
    let mut simulation =
        simulation(vec![body("top", None, floating(), 4.0, moments)], vec![gravity], vec![], 0.005, start);
    simulation.step(400).unwrap();
    let (t, state) = (2.0, simulation.state());
    let expected = [3.0 * t, -t, 10.0 + 20.0 * t - 0.5 * GRAVITY * t * t];
    assert!((0..3).all(|i| (state.q[i] - expected[i]).abs() < 1e-11));
    let phase: f64 = (3.0 - 2.0) / 2.0 * 5.0 * t;
    let rates = [0.4 * phase.cos(), 0.4 * phase.sin(), 5.0];
    // RK4: (2.5 h)^5 / 120 a step, 400 steps.
    assert!((0..3).all(|i| (state.v[3 + i] - rates[i]).abs() < 1e-9), "{:?} {rates:?}", &state.v[3..]);
    assert_ledger_closes(&mut simulation, 1e3);
}

#[test]
fn a_compound_pendulum_swings_with_the_elliptic_period() {
    let (mass, length, moment, amplitude) = (2.0, 1.5, 0.7, 1.2);
    let exact = Pendulum::new(moment + mass * length * length, mass * length, amplitude);
    let period = exact.period_s();
    let joint = hinge([0.0, 1.0, 0.0], [0.0, 0.0, -length]);
    let gravity = Box::new(Gravity);
    let bodies = vec![body("bob", None, joint, mass, [moment; 3])];
    let mut simulation = simulation(bodies, vec![gravity], vec![], period / 2000.0, (vec![amplitude], vec![0.0]));
    for part in 1..=8 {
        simulation.step(250).unwrap();
        let error = simulation.state().q[0] - exact.angle(f64::from(part) * period / 8.0);
        assert!(error.abs() < 1e-9, "after {part} eighths of a period: {error:e}");
    }
    assert!((simulation.state().q[0] - amplitude).abs() < 1e-9);
    // The world's reaction in the hinge enters both momentum balances.
    assert_ledger_closes(&mut simulation, 100.0);
}

#[test]
fn a_rate_with_viscous_damping_decays_exponentially() {
    let start = (vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], vec![0.0, 2.0, 0.0, 0.0, 0.0, 3.0]);
    let still = (start.0.clone(), vec![0.0, 2.0, 0.0, 0.0, 0.0, 0.0]);
    let (linear, angular) = (Vector3::new(0.0, 4.0, 0.0), Vector3::new(0.0, 0.0, 5.0));
    let damped = |start| {
        let place = HullFrame { body: 0, origin: Vector3::zero() };
        let damping = ViscousDamping { place, relative_to: DampedAgainst::Water, linear, angular, matrix: None };
        let damping = Box::new(damping);
        simulation(vec![body("ship", None, floating(), 8.0, [2.0; 3])], vec![damping], vec![], 0.005, start)
    };
    let mut turning = damped(start);
    turning.step(200).unwrap();
    assert!((turning.state().v[5] - 3.0 * (-5.0_f64 / 2.0).exp()).abs() < 1e-9);
    assert_ledger_closes(&mut turning, 100.0);

    let mut moving = damped(still);
    moving.step(200).unwrap();
    assert!((moving.state().v[1] - 2.0 * (-0.5_f64).exp()).abs() < 1e-10);
    assert_ledger_closes(&mut moving, 100.0);
}

#[test]
fn a_slide_under_a_constant_force_with_friction_reaches_its_terminal_speed() {
    let (mass, force, damping) = (5.0, 20.0, 4.0);
    let motor = Box::new(Motor { coordinate: 0, effort: force, profile: TimeFunction::constant(), lever: None });
    let friction = Box::new(JointDamping { coordinate: 0, damping });
    let bodies = vec![body("cart", None, slide([1.0, 0.0, 0.0]), mass, [1.0; 3])];
    let mut simulation = simulation(bodies, vec![friction], vec![motor], 0.005, (vec![0.0], vec![0.0]));
    simulation.step(400).unwrap();
    let expected = force / damping * (1.0 - (-damping * 2.0 / mass).exp());
    assert!((simulation.state().v[0] - expected).abs() < 1e-10);
    assert_ledger_closes(&mut simulation, 100.0);
}

#[test]
fn an_arm_on_a_servo_droops_by_its_weight_over_the_stiffness() {
    // Horizontal arm: k (target - q) = m g l cos(q) at rest; positive about y lowers an arm along x.
    let (mass, length, stiffness) = (10.0, 2.0, 5e4);
    let servo = |limit: f64| -> AnyElement {
        Box::new(Servo { position: 0, coordinate: 0, target: 0.0, stiffness, damping: 4e3, limit, offset: None })
    };
    let arm = || vec![body("arm", None, hinge([0.0, 1.0, 0.0], [length, 0.0, 0.0]), mass, [1.0; 3])];
    let gravity = || -> Vec<AnyElement> { vec![Box::new(Gravity)] };
    let mut held = simulation(arm(), gravity(), vec![servo(1e4)], 0.002, (vec![0.0], vec![0.0]));
    held.step(2000).unwrap();
    let droop = held.state().q[0];
    let balance = stiffness * droop - mass * GRAVITY * length * droop.cos();
    assert!(droop > 0.0 && balance.abs() < 1e-6, "{droop}: {balance}");

    // The limit is below the weight's moment of 196 N m: the arm falls.
    let mut falling = simulation(arm(), gravity(), vec![servo(100.0)], 0.002, (vec![0.0], vec![0.0]));
    falling.step(400).unwrap();
    assert!(falling.state().q[0] > 0.5);
}

#[test]
fn a_prescribed_joint_follows_its_rate_and_its_drive_does_the_work() {
    // A hinge on a slide: the prescribed slew shakes the slide, and what it takes is accounted for.
    let pulse = TimeFunction::pulse(Pulse { start_s: 0.0, rise_s: 0.2, hold_s: 0.3, reverse_s: 0.0 });
    let motion = PrescribedMotion { coordinate: 1, rate: 2.0, profile: pulse };
    let mut arm = body("arm", Some(0), hinge([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]), 3.0, [0.5; 3]);
    arm.joint.mode = MotionType::Prescribed;
    let bodies = vec![body("cart", None, slide([0.0, 1.0, 0.0]), 5.0, [1.0; 3]), arm];
    let mut simulation = simulation(bodies, vec![], vec![Box::new(motion)], 0.005, (vec![0.0; 2], vec![0.0; 2]));
    simulation.step(80).unwrap();
    assert!((simulation.state().v[1] - 2.0).abs() < 1e-12);
    assert!((simulation.state().q[1] - (0.2 + 0.4)).abs() < 1e-12);
    // Along the slide nothing acts from outside: (M + m) y' + m d/dt(sin(angle)) = 0.
    let (y_dot, angle) = (simulation.state().v[0], simulation.state().q[1]);
    let momentum = 8.0 * y_dot + 3.0 * 2.0 * angle.cos();
    assert!(momentum.abs() < 1e-8, "{momentum:e}");
    assert_ledger_closes(&mut simulation, 100.0);
}
