//! Springs, stops, friction, rotors and brakes in joints, against closed forms.

use crate::common;

use common::values;
use kingpost::elements::drives::{Brake, Motor, PrescribedMotion, Pulse, TimeFunction};
use kingpost::elements::{AnyElement, CoulombFriction, JointSpring, JointStop, StopSide};
use kingpost::model::joint::Prismatic;
use kingpost::model::{BodyDefinition, Joint, JointKind, Model, MotionType};
use kingpost::plant::Form;
use kingpost::simulation::{SchemeName, Settings, Setup, Simulation};
use kingpost::spatial::{Frame, SpatialInertia, Symmetric3, Vector3};
use kingpost::world::World;

const MASS: f64 = 3.0;
const STEP_S: f64 = 1e-4;

/// A mass on a slide along x, at `q` with the speed `v`.
fn slide(mode: MotionType, elements: Vec<AnyElement>, q: f64, v: f64) -> Setup {
    let prismatic = Prismatic::new(Frame::identity(), Vector3::new(1.0, 0.0, 0.0), Vector3::zero());
    let body = BodyDefinition {
        name: "mass".to_owned(),
        parent: None,
        joint: Joint { name: "slide".to_owned(), kind: JointKind::Prismatic(prismatic), mode },
        mass: MASS,
        inertia: SpatialInertia::rigid(MASS, Symmetric3::diagonal([1.0; 3])),
        points: Vec::new(),
    };
    let settings = Settings {
        scheme: SchemeName::RungeKutta4,
        step_s: STEP_S,
        duration_s: 10.0,
        record_every_s: 0.1,
        rate_limit: 1e4,
        form: Form::Recursive,
    };
    Setup {
        model: Model::new(vec![body]),
        world: World::calm(),
        elements,
        watchers: Vec::new(),
        limits: Vec::new(),
        settings,
        q: vec![q],
        v: vec![v],
        wires: Vec::new(),
        fingerprint: 0,
    }
}

/// Continues for a time and checks that energy and heat balance to `tolerance`, J.
fn run(simulation: &mut Simulation, seconds: f64, tolerance: f64) -> (f64, f64) {
    simulation.step((seconds / STEP_S).round() as usize).unwrap();
    let error = values(simulation, "energy_error")[0].abs();
    assert!(error < tolerance, "energy error {error:e}");
    (simulation.state().q[0], simulation.state().v[0])
}

#[test]
fn a_mass_on_a_spring_swings_about_its_rest_as_a_cosine() {
    let (stiffness, rest, start) = (48.0, 0.4, 1.0);
    let spring = Box::new(JointSpring { position: 0, coordinate: 0, stiffness, rest });
    let mut simulation = Simulation::new(slide(MotionType::Free, vec![spring], start, 0.0));
    let (q, v) = run(&mut simulation, 1.3, 1e-11);
    let (w, a) = ((stiffness / MASS).sqrt(), start - rest);
    assert!((q - rest - a * (w * 1.3).cos()).abs() < 1e-12, "{q}");
    assert!((v + a * w * (w * 1.3).sin()).abs() < 1e-12, "{v}");
}

#[test]
fn the_rebound_speed_from_a_stop_is_that_of_hunt_and_crossley() {
    // m d'' = -k d (1 + a d') integrates once: with h(u) = u / a - ln(1 + a u) / a^2 the speed in, u,
    // and the speed out, e u, hold h(u) = h(-e u).
    let (stiffness, dissipation) = (3e4, 0.5);
    for (side, direction) in [(StopSide::Upper, 1.0), (StopSide::Lower, -1.0)] {
        for speed in [0.05, 0.8, 6.0] {
            let stop = JointStop { position: 0, coordinate: 0, side, limit: 0.2 * direction, stiffness, dissipation };
            let setup = slide(MotionType::Free, vec![Box::new(stop)], 0.1 * direction, speed * direction);
            let mut simulation = Simulation::new(setup);
            // To the limit, through the contact of about half a period, and some way back.
            // Entry and exit fall within a step, where the stiffness jumps: k u h^2 / m of speed is lost.
            let energy_tolerance = stiffness * (speed * STEP_S).powi(2);
            let (_, v) = run(&mut simulation, 0.1 / speed + 0.06, energy_tolerance);
            let back = -v * direction;
            let h = |u: f64| u / dissipation - (dissipation * u).ln_1p() / dissipation.powi(2);
            let tolerance = stiffness * speed * STEP_S * STEP_S / MASS;
            let slope = back / (1.0 - dissipation * back);
            assert!((h(speed) - h(-back)).abs() < tolerance * slope.max(speed), "speed {speed}: back {back}");
            let heat = values(&mut simulation, "energy_dissipated")[0];
            let lost = 0.5 * MASS * (speed * speed - back * back);
            assert!((heat - lost).abs() < energy_tolerance, "speed {speed}: {heat} of {lost}");
        }
    }
}

#[test]
fn a_stop_never_pulls() {
    // Drawn out of the stop faster than it can follow, the mass feels nothing.
    let stop =
        JointStop { position: 0, coordinate: 0, side: StopSide::Upper, limit: 0.0, stiffness: 1e4, dissipation: 1.0 };
    let setup = slide(MotionType::Free, vec![Box::new(stop)], 0.01, -2.0);
    let mut simulation = Simulation::new(setup);
    let (_, v) = run(&mut simulation, 0.01, 1e-11);
    assert!((v + 2.0).abs() < 1e-14, "{v}");
}

#[test]
fn a_mass_slowed_by_smoothed_coulomb_friction_has_the_closed_form_velocity() {
    // m v' = -T v / sqrt(v^2 + s^2) integrates to G(v) = G(v0) - T t / m with
    // G(v) = sqrt(v^2 + s^2) + s ln(v / (s + sqrt(v^2 + s^2))).
    let (friction, smoothing, start) = (6.0, 0.05, 2.0);
    let force = Box::new(CoulombFriction { coordinate: 0, friction, smoothing });
    let g = |v: f64| {
        let root = v.hypot(smoothing);
        root + smoothing * (v / (smoothing + root)).ln()
    };
    let mut simulation = Simulation::new(slide(MotionType::Free, vec![force], 0.0, start));
    for seconds in [0.5, 0.95, 1.05] {
        let more = seconds - simulation.time_s();
        let (_, v) = run(&mut simulation, more, 1e-9);
        let expected = g(start) - friction * seconds / MASS;
        assert!((g(v) - expected).abs() < 1e-10, "{seconds} s: {v}");
    }
    let heat = values(&mut simulation, "energy_dissipated")[0];
    let left = values(&mut simulation, "kinetic_energy")[0];
    assert!((heat + left - 0.5 * MASS * start * start).abs() < 1e-9);
}

/// The slide with a rotor of `J n^2` = 5 kg.
fn geared(mode: MotionType, drives: Vec<AnyElement>) -> Setup {
    let mut setup = slide(mode, drives, 0.0, 0.0);
    setup.model.rotor_inertia[0] = 5.0;
    setup
}

#[test]
fn a_rotor_behind_a_gear_is_accelerated_with_the_mass() {
    for form in [Form::Recursive, Form::MovingFrame(kingpost::dynamics::moving_frame::Variation::Restricted)] {
        let motor = Motor { coordinate: 0, effort: 20.0, profile: TimeFunction::constant(), lever: None };
        let mut setup = geared(MotionType::Free, vec![Box::new(motor)]);
        setup.settings.form = form;
        let mut simulation = Simulation::new(setup);
        let (q, v) = run(&mut simulation, 0.8, 1e-10);
        let a = 20.0 / (MASS + 5.0);
        // Exact but for the rounding of 8000 steps.
        assert!((v - a * 0.8).abs() < 1e-11 && (q - 0.5 * a * 0.64).abs() < 1e-11, "{q}, {v}");
        let kinetic = values(&mut simulation, "kinetic_energy")[0];
        assert!((kinetic - 0.5 * (MASS + 5.0) * v * v).abs() < 1e-12, "{kinetic}");
        // The joint carries what accelerates the mass; the rest accelerates the rotor.
        assert!((values(&mut simulation, "joint_force")[0] - MASS * a).abs() < 1e-12);
        assert!((simulation.mass_matrix()[0] - (MASS + 5.0)).abs() < 1e-15);
    }
}

#[test]
fn the_drive_of_a_prescribed_motion_turns_the_rotor_too() {
    let pulse = Pulse { start_s: 0.0, rise_s: 0.2, hold_s: 5.0, reverse_s: 0.0 };
    let motion = PrescribedMotion { coordinate: 0, rate: 1.5, profile: TimeFunction::pulse(pulse) };
    for form in [Form::Recursive, Form::MovingFrame(kingpost::dynamics::moving_frame::Variation::Restricted)] {
        let mut setup = geared(MotionType::Prescribed, vec![Box::new(motion.clone())]);
        setup.settings.form = form;
        let mut simulation = Simulation::new(setup);
        run(&mut simulation, 0.5, 1e-10);
        let work = values(&mut simulation, "work_by_drives")[0];
        assert!((work - 0.5 * (MASS + 5.0) * 1.5 * 1.5).abs() < 1e-10, "{work}");
    }
}

#[test]
fn a_brake_holds_against_less_than_its_capacity_and_makes_heat_only() {
    let friction = CoulombFriction { coordinate: 0, friction: 50.0, smoothing: 0.01 };
    let brake = || -> AnyElement { Box::new(Brake { friction, lever: Some("brake".to_owned()) }) };
    let push = || -> AnyElement {
        Box::new(Motor { coordinate: 0, effort: 30.0, profile: TimeFunction::constant(), lever: None })
    };
    let at = |value: f64| {
        let mut simulation = Simulation::new(slide(MotionType::Free, vec![brake(), push()], 0.0, 0.0));
        simulation.set_input("brake", value).unwrap();
        // The creep sets in over m s / T = 0.6 ms: (h / 0.6 ms)^4 of 0.2 mJ.
        let (_, v) = run(&mut simulation, 1.0, 1e-7);
        (v, values(&mut simulation, "work_by_drives")[0], values(&mut simulation, "energy_dissipated")[0])
    };
    let (released, work, heat) = at(0.0);
    assert!((released - 30.0 / MASS).abs() < 1e-10 && heat == 0.0);
    assert!((work - 0.5 * MASS * released * released).abs() < 1e-9);
    // Set, it creeps at the speed where 50 v / sqrt(v^2 + s^2) is 30: at 3/4 of the smoothing speed.
    let (set, work, heat) = at(1.0);
    assert!((set - 0.0075).abs() < 1e-12, "{set}");
    assert!((work - heat - 0.5 * MASS * set * set).abs() < 1e-7 && heat > 0.1);
    // Half set it slips, under 30 N against 25 N. What the smoothing leaves out at the start adds at
    // most 25 / 5 of the smoothing speed.
    let (slipping, ..) = at(0.5);
    let ahead = slipping - 5.0 / MASS;
    assert!((0.0..0.05).contains(&ahead), "{slipping}");
}
