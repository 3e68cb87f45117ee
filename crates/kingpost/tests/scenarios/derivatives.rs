//! Scenarios over dual numbers: names with and without a derivative.

use crate::common::paper_text::set;

fn refusal(name: &str) -> String {
    set(&[]).setup_along(&[name]).map(drop).expect_err("no derivative").to_string()
}

#[test]
fn a_unit_in_a_path_is_a_factor_of_the_derivative() {
    let names = ["bodies.arm.mass_t", "bodies.ship.joint.floating.initial.orientation_deg.2", "crane_x_m"];
    let setup = set(&[]).setup_along(&names).expect("the numbers are there");
    let arm = setup.model.body("arm").expect("the arm is there");
    assert_eq!(setup.model.bodies[arm].mass.derivative[0], 1000.0);
    // The quaternion of a small turn is half the angle.
    assert!((setup.q[6].derivative[1] - 0.5_f64.to_radians()).abs() < 1e-15);
    assert!(setup.q.iter().all(|q| q.derivative[2] == 0.0));
}

#[test]
fn a_number_without_a_derivative_is_refused_by_name() {
    assert_eq!(
        refusal("motor_1"),
        "motor_1: found no number, allowed: a parameter, or the path of a number, that moves the model continuously"
    );
    for name in ["simulation.step_s", "drives.motor_1.motor.pulse.rise_s", "simulation.seed", "nonsense"] {
        assert!(refusal(name).starts_with(name), "{}", refusal(name));
    }
}
