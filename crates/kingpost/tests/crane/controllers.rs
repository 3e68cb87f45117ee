//! Controllers: input shapers against the closed form of a linear oscillator, state feedback against its
//! control law.

use crate::common;

use common::simulation;
use kingpost::Simulation;
use kingpost::elements::CubicSpline;
use kingpost::elements::drives::Oscillation;
use kingpost::scenario::read;
use serde_json::{Value, json};

/// Stiffness of the spring, N/m.
pub const STIFFNESS: f64 = 20.0;
/// Mass of the cage, kg.
pub const MASS: f64 = 2.0;

/// A cage on a spring, pushed by a lever with up to 10 N: the linear pendulum. Damping ratio `zeta`.
pub fn oscillator(zeta: f64, step_s: f64, duration_s: f64, rest: &str) -> String {
    let damping = 2.0 * zeta * libm::sqrt(STIFFNESS * MASS);
    format!(
        "version: 1
title: A cage on a spring
simulation: {{step_s: {step_s}, duration_s: {duration_s}, record_every_s: 0.1}}
bodies:
  cage:
    mass_kg: {MASS}
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: slide, axis: [1, 0, 0], spring: {{stiffness_N_per_m: {STIFFNESS}, rest_m: 0}}, damping_N_s_m: {damping}}}}}
drives:
  push: {{linear_motor: {{joint: slide, force_N: 10, history: lever}}}}
{rest}"
    )
}

/// The present value of a column.
fn value(simulation: &mut Simulation, column: &str) -> f64 {
    let mut readings = simulation.readings(&[column.to_owned()]);
    let mut found = Vec::new();
    simulation.read(&mut readings, &mut found);
    found[0]
}

/// The error of a text with these values.
fn error_of(text: &str, set: &[(&str, Value)]) -> String {
    let set: Vec<(String, Value)> = set.iter().map(|(path, value)| ((*path).to_owned(), value.clone())).collect();
    let built = read(text, "cage.yaml", &set).and_then(|scenario| scenario.setup());
    built.err().map_or_else(|| panic!("{set:?} is allowed"), |error| error.to_string())
}

/// Moves by ramps that are no multiples of a period or of a step.
const MOVES: &str = "operation:
  steps:
    - name: push
      set: [{input: command, to: 0.6, at_s: 0.1, in_s: 0.3731}, {input: command, to: -0.2, at_s: 0.9, in_s: 0.517}, {input: command, to: 0.5, at_s: 1.61}]
";

/// An input as it is held during the step.
fn input(found: &Simulation, name: &str) -> f64 {
    found.inputs().iter().find(|input| input.name == name).expect("an input").value
}

/// An input at the end of the step.
fn at_end(found: &Simulation, name: &str) -> f64 {
    let inputs = found.inputs();
    let place = inputs.iter().position(|input| input.name == name).expect("an input");
    found.state().d[found.state().d.len() - inputs.len() + place]
}

/// Period between two maxima, s.
fn period_s(zeta: f64) -> f64 {
    core::f64::consts::TAU / (libm::sqrt(STIFFNESS / MASS) * libm::sqrt(1.0 - zeta * zeta))
}

fn shaper(kind: &str, period_s: f64, zeta: f64) -> String {
    format!(
        "controllers: {{command: {{input_shaper: {{to: push, shaper: {kind}, period_s: {period_s}, damping_ratio: {zeta}}}}}}}\n"
    )
}

/// The amplitude of the swing about the last command's rest position at the end, m.
fn swing(simulation: &mut Simulation, zeta: f64) -> f64 {
    let w = libm::sqrt(STIFFNESS / MASS);
    let x = value(simulation, "slide.joint_position") - 0.5 * 10.0 / STIFFNESS;
    let v = value(simulation, "slide.joint_velocity");
    libm::hypot(x, (v + zeta * w * x) / (w * libm::sqrt(1.0 - zeta * zeta)))
}

/// Returns the ratio of the swing with a shaper to that without one; the shaper is made for `made_for` times
/// the true period.
fn left(kind: &str, zeta: f64, made_for: f64) -> f64 {
    let [shaped, free] = [kind, "none"].map(|kind| {
        let text = oscillator(zeta, 0.002, 4.5, &(shaper(kind, made_for * period_s(zeta), zeta) + MOVES));
        let mut simulation = simulation(&text);
        simulation.step(2250).expect("it swings");
        swing(&mut simulation, zeta)
    });
    shaped / free
}

/// Singer & Seering (1990): the residual swing is zero. The error of Runge-Kutta is (w h)^5 / 120 in a step,
/// 4e-11 in a period of 1000 steps.
#[test]
fn a_shaped_command_leaves_no_swing_on_the_linear_pendulum() {
    for zeta in [0.0, 0.07] {
        for kind in ["zv", "zvd"] {
            let found = left(kind, zeta, 1.0);
            assert!(found < 1e-9, "{kind}, damping ratio {zeta}: {found}");
        }
    }
}

/// A shaper made for 1 + e times the period leaves |cos(pi (1 + e) / 2)| of the swing if it is ZV, or the
/// square of this if it is ZVD, for any command. Impulses are split for the period of the shaper: at another
/// period their error is up to (w h)^2 |1 - 1 / (1 + e)^2| / 8, 1e-6, which is 4e-5 of the square.
#[test]
fn the_residual_of_a_shaper_off_its_period_is_the_closed_form() {
    for off in [-0.1, 0.1] {
        let exact = libm::cos(0.5 * core::f64::consts::PI * (1.0 + off)).abs();
        for (kind, exact) in [("zv", exact), ("zvd", exact * exact)] {
            let found = left(kind, 0.0, 1.0 + off);
            assert!((found / exact - 1.0).abs() < 1e-4, "{kind}, off by {off}: {found}, not {exact}");
        }
    }
}

/// Singhose et al. (1994): the residual of an EI shaper is its tolerance at its period, and zero at two
/// periods on both sides.
#[test]
fn the_residual_of_an_ei_shaper_is_its_tolerance_at_its_period_and_zero_at_the_zeros_of_its_band() {
    // Its weights are divided by their sum, which the split of impulses changes by up to (w h)^2 / 8, 5e-6.
    let found = left("ei", 0.0, 1.0);
    assert!((found / 0.05 - 1.0).abs() < 5e-6, "{found}");
    // From the middle impulse, (1 + V) cos(pi r) + 1 - V = 0, to the 2e-6 by which the split of impulses errs there.
    let beside = libm::acos(-(1.0 - 0.05) / (1.0 + 0.05)) / core::f64::consts::PI;
    for made_for in [beside, 2.0 - beside] {
        let found = left("ei", 0.0, made_for);
        assert!(found < 5e-6, "{made_for}: {found}");
    }
}

#[test]
fn a_disabled_shaper_passes_its_command_unchanged() {
    let rows = |rest: &str| {
        let mut simulation = simulation(&oscillator(0.0, 0.01, 3.0, rest));
        let run = simulation.run(|_| true);
        run.status.expect("it runs");
        let place = simulation.channels().iter().find(|channel| channel.variable == "joint_position").expect("a joint");
        run.rows.chunks(run.columns).map(|row| row[place.offset].to_bits()).collect::<Vec<_>>()
    };
    let plain = rows(&MOVES.replace("input: command", "input: push"));
    assert_eq!(plain, rows(&(shaper("none", 2.0, 0.0) + MOVES)));
    let off = shaper("zvd", 2.0, 0.0).replace("{to:", "{enabled: false, to:");
    assert_eq!(plain, rows(&(off + MOVES)));
}

/// A feedback of a cage, sampled every 20 ms, behind a shaper.
const FEEDBACK: &str = "controllers:
  command: {input_shaper: {to: hold, shaper: none, period_s: 2}}
  hold:
    state_feedback:
      reads: [{column: slide.joint_position, reference: 0.1}, {column: slide.joint_velocity}]
      steers: [{to: push, gains: [2, 0.5], lower: -0.3, upper: 0.3}]
      period_s: 0.02
";

#[test]
fn feedback_is_its_law_between_samples_and_within_limits() {
    let mut found = simulation(&oscillator(0.0, 0.01, 4.5, &(FEEDBACK.to_owned() + MOVES)));
    let mut clipped = 0;
    let mut correction = 0.0;
    for step in 0..300 {
        let read = ["position", "velocity"].map(|of| value(&mut found, &format!("slide.joint_{of}")));
        if step % 2 == 0 {
            correction = 2.0 * (read[0] - 0.1) + 0.5 * read[1];
        }
        found.step(1).expect("it runs");
        let command = at_end(&found, "command");
        let action = value(&mut found, "hold.commanded_lever");
        assert_eq!(action.to_bits(), (command - correction).clamp(-0.3, 0.3).to_bits(), "step {step}");
        clipped += usize::from(action.abs() == 0.3);
    }
    assert!((20..250).contains(&clipped), "{clipped} steps at a limit");
}

/// A feedback of position, its integral and its rate: a PID controller, with the same sums in another order.
const PID: &str = "controllers:
  hold:
    state_feedback:
      reads: [{column: slide.joint_position, reference: 0.1}, {column: slide.joint_velocity}]
      steers: [{to: push, gains: [6, 0.5], integral_gains: [1.5, 0], lower: -0.3, upper: 0.3}]
      period_s: 0.02
";

#[test]
fn an_integral_is_the_sum_of_samples_and_is_held_while_the_input_is_at_a_limit() {
    let mut found = simulation(&oscillator(0.05, 0.01, 20.0, PID));
    let (mut integral, mut action, mut waited) = (0.0, 0.0, 0);
    for step in 0..2000 {
        let read = ["position", "velocity"].map(|of| value(&mut found, &format!("slide.joint_{of}")));
        if step % 2 == 0 {
            let proportional = 6.0 * (read[0] - 0.1) + 0.5 * read[1];
            let grown = 1.5 * (read[0] - 0.1) * 0.02;
            let next = -(proportional + integral + grown);
            let pushes_beyond = (next > 0.3 && grown < 0.0) || (next < -0.3 && grown > 0.0);
            waited += usize::from(pushes_beyond);
            integral += if pushes_beyond { 0.0 } else { grown };
            action = (-(proportional + integral)).clamp(-0.3, 0.3);
        }
        found.step(1).expect("it runs");
        let set = value(&mut found, "hold.commanded_lever");
        assert!((set - action).abs() < 1e-13, "step {step}: {set}, not {action}");
    }
    assert!((5..500).contains(&waited), "{waited} samples at a limit");
    // The spring needs 20 * 0.1 N = 0.2 of the lever: without the integral the cage would stay short of it.
    assert!((value(&mut found, "slide.joint_position") - 0.1).abs() < 1e-3);
}

/// A curve through four commands, repeated, with a ramp; the step is 10 ms.
const FUNCTION: &str = "controllers: {command: {drive_function: {to: push, period_s: 0.8, ramp_s: 0.5, time_s: [0, 0.2, 0.4, 0.6], command: [0, 0.6, 0, -0.6]}}}\n";

#[test]
fn a_drive_function_adds_its_curve_to_its_command_within_limits() {
    let mut found = simulation(&oscillator(0.0, 0.01, 4.5, &(FUNCTION.to_owned() + MOVES)));
    let curve = CubicSpline::periodic(vec![0.0, 0.2, 0.4, 0.6], vec![0.0, 0.6, 0.0, -0.6], 0.8);
    let mut at_limit = 0;
    for step in 0..400 {
        found.step(1).expect("it runs");
        let sum = |command: f64, time_s: f64| {
            let x = f64::min(time_s / 0.5, 1.0);
            let ramp = x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
            (command + ramp * curve.at(time_s)).clamp(-1.0, 1.0)
        };
        let [middle, end] = [0.005, 0.01].map(|after| 0.01 * f64::from(step) + after);
        let (held, in_step) = (sum(input(&found, "command"), middle), input(&found, "push"));
        assert!((in_step - held).abs() < 1e-12, "step {step}: {in_step} during it, not {held}");
        let expected = sum(at_end(&found, "command"), end);
        let set = value(&mut found, "command.commanded_lever");
        assert!((set - expected).abs() < 1e-12, "step {step}: {set}, not {expected}");
        at_limit += usize::from(set.abs() == 1.0);
    }
    assert!(at_limit > 0, "0.6 and 0.6 exceed the limit of the lever");
    let off = FUNCTION.replace("{to:", "{enabled: false, to:") + MOVES;
    let mut off = simulation(&oscillator(0.0, 0.01, 4.5, &off));
    let mut plain = simulation(&oscillator(0.0, 0.01, 4.5, &MOVES.replace("input: command", "input: push")));
    off.step(300).expect("it runs");
    plain.step(300).expect("it runs");
    let [off, plain] = [&mut off, &mut plain].map(|run| value(run, "slide.joint_position").to_bits());
    assert_eq!(off, plain);
}

/// The force that moves the cage on `x = a s(t) sin(w t)` is `m x'' + c x' + k x`: a drive function through its values at 40 times
/// errs by 5/384 h^4 f'''' (Hall & Meyer), 1e-4 of the force, and so does the motion.
#[test]
fn the_function_of_inverse_dynamics_moves_the_cage_along_its_path() {
    let (zeta, w, amplitude) = (0.2, 2.0, 0.1);
    let damping = 2.0 * zeta * libm::sqrt(STIFFNESS * MASS);
    let way = |t: f64| {
        let swing = Oscillation { coordinate: 0, amplitude, frequency_rad_s: w, phase_rad: 0.0, ramp_s: 8.0 };
        swing.motion(kingpost::dynamics::Clock { time_s: t, middle_s: t })
    };
    let times: Vec<f64> = (0..=40).map(|k| 0.15 * f64::from(k)).collect();
    let force = |t: f64| {
        let [x, rate, acceleration] = way(t);
        (MASS * acceleration + damping * rate + STIFFNESS * x) / 10.0
    };
    let commands: Vec<f64> = times.iter().map(|t| force(*t)).collect();
    let text = format!(
        "controllers: {{command: {{drive_function: {{to: push, time_s: {times:?}, command: {commands:?}}}}}}}\n"
    );
    let mut found = simulation(&oscillator(zeta, 0.001, 6.0, &text));
    for step in 1..50 {
        found.step(100).expect("it runs");
        let time = 0.1 * f64::from(step);
        let x = value(&mut found, "slide.joint_position");
        assert!((x - way(time)[0]).abs() < 5e-4 * amplitude, "at {time} s: {x}, not {}", way(time)[0]);
    }
}

#[test]
fn mistakes_of_drive_functions_are_reported_with_their_place() {
    let text = oscillator(0.0, 0.01, 1.0, FUNCTION);
    for (field, set, expected) in [
        ("time_s", json!([0.0, 0.2]), "time_s: found 2 times, allowed: at least 3 times"),
        ("command", json!([0.0]), "command: found 1 commands, allowed: 4, one for each time"),
        ("time_s.2", json!(0.2), "time_s.2: found 0.2, allowed: more than 0.2, the time before"),
        ("period_s", json!(0.6), "period_s: found 0.6, allowed: more than 0.6, from the first time to the last"),
        ("to", json!("pull"), "to: found pull, allowed: "),
        ("time_s.0", json!(-1.0), "time_s.0: "),
    ] {
        let found = error_of(&text, &[(&format!("controllers.command.drive_function.{field}"), set)]);
        assert!(found.contains(&format!("controllers.command.drive_function.{expected}")), "{found}\n{expected}");
    }
}

#[test]
fn a_command_passes_all_controllers_in_the_step_in_which_it_is_set() {
    // The operation sets the command at once: the drive has it in the first step, and not a step later for each controller.
    let rest = FEEDBACK.replace("gains: [2, 0.5]", "gains: [0, 0]")
        + "operation: {steps: [{name: push, set: [{input: command, to: 0.2}]}]}\n";
    let mut found = simulation(&oscillator(0.0, 0.01, 1.0, &rest));
    found.step(1).expect("it runs");
    let names: Vec<(String, f64)> = found.inputs().into_iter().map(|input| (input.name, input.value)).collect();
    for name in ["push", "hold", "command"] {
        assert!(names.contains(&(name.to_owned(), 0.2)), "{name}: {names:?}");
    }
}

#[test]
fn a_user_sets_the_first_command_and_no_input_after_it() {
    let mut found = simulation(&oscillator(0.0, 0.01, 1.0, FEEDBACK));
    found.set_input("command", 0.1).expect("the first command");
    for (input, sets) in [("push", "hold"), ("hold", "command")] {
        let error = found.set_input(input, 0.1).expect_err("a controller sets it").to_string();
        assert!(error.contains(input) && error.contains(sets), "{error}");
    }
}

#[test]
fn mistakes_are_reported_with_their_place_and_the_existing_names() {
    let text = oscillator(0.0, 0.01, 1.0, FEEDBACK);
    let hold = "controllers.hold.state_feedback";
    for (set, expected) in [
        (
            ("controllers.command.input_shaper.to", json!("pull")),
            "controllers.command.input_shaper.to: found pull, allowed: ",
        ),
        (
            ("controllers.command.input_shaper.to", json!("push")),
            "controllers.hold.state_feedback.steers.0.to: found push, which command sets, allowed: one controller to each input",
        ),
        (
            ("controllers.command.input_shaper.to", json!("command")),
            "controllers.command.input_shaper.to: found command, allowed: an input that does not lead back to it",
        ),
        (
            ("controllers.command.input_shaper.period_s", json!(0.02)),
            "controllers.command.input_shaper.period_s: found 0.02, allowed: more than two steps",
        ),
        (
            ("controllers.command.input_shaper.period_s", json!(1e9)),
            "controllers.command.input_shaper.period_s: found 1000000000, allowed: more than two steps",
        ),
        (
            ("controllers.command.input_shaper.damping_ratio", json!(1.0)),
            "controllers.command.input_shaper.damping_ratio: found 1, allowed: a number from 0 to below 1",
        ),
        (
            ("controllers.command.input_shaper.damping_ratio", json!(-0.1)),
            "controllers.command.input_shaper.damping_ratio: found -0.1, allowed: ",
        ),
        (
            (&*format!("{hold}.reads.0.column"), json!("slide.joint_positon")),
            "reads.0.column: found slide.joint_positon, allowed: one of slide.joint_position",
        ),
        (
            (&*format!("{hold}.reads.1.follows"), json!("push")),
            "reads.1.follows: found push, in 1, allowed: an input in m/s, as slide.joint_velocity",
        ),
        ((&*format!("{hold}.reads.1.follows"), json!("pull")), "reads.1.follows: found pull, allowed: push"),
        (
            (&*format!("{hold}.steers.0.gains"), json!([1.0])),
            "steers.0.gains: found 1 gains, allowed: 2, one for each column in reads",
        ),
        (
            (&*format!("{hold}.steers.0.integral_gains"), json!([1.0, 2.0, 3.0])),
            "steers.0.integral_gains: found 3 gains, allowed: 2, one for each column in reads",
        ),
        ((&*format!("{hold}.steers.0.upper"), json!(1.5)), "steers.0.upper: found 1.5, allowed: -1 to 1 1"),
        ((&*format!("{hold}.steers.0.lower"), json!(0.4)), "steers.0.lower: found a range of"),
        (
            (&*format!("{hold}.period_s"), json!(0.015)),
            "period_s: found 0.015, allowed: a whole number of steps of 0.01 s",
        ),
        ((&*format!("{hold}.reads"), json!([])), "reads: found none, allowed: at least one"),
    ] {
        let found = error_of(&text, &[set]);
        assert!(found.contains(expected), "{found}\n{expected}");
    }
    let wired = text.clone()
        + "sensors: {mru: {motion_reference_unit: {body: cage, period_s: 0.1}}}\nwires: {one: {from: mru.measured_roll, to: push}}\n";
    let found = error_of(&wired, &[]);
    assert!(
        found.contains("wires.one.to: found push, which hold sets, allowed: an input that no controller sets"),
        "{found}"
    );
    let moved = text + "operation: {steps: [{name: push, set: [{input: push, to: 0.2}]}]}\n";
    let found = error_of(&moved, &[]);
    assert!(
        found.contains("operation.steps.0.set.0.input: found push, allowed: an input that no controller sets"),
        "{found}"
    );
}

#[test]
fn a_gain_that_is_nan_is_refused() {
    let found = error_of(&oscillator(0.0, 0.01, 1.0, &FEEDBACK.replace("gains: [2, 0.5]", "gains: [.nan, 0.5]")), &[]);
    assert!(found.contains("controllers.hold.state_feedback.steers.0.gains.0"), "{found}");
}
