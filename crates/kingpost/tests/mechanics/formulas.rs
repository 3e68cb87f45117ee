//! Formulas of the blocks of B and B': equal to the matrices in value, and with the form in the paper.

use crate::common;

use common::{Random, paper_setup};
use kingpost::Simulation;
use kingpost::dynamics::Loads;
use kingpost::dynamics::moving_frame::{Instant, MovingFrame, Naming, SymbolicMatrix, Symbols, Variation};
use kingpost::model::Model;

const MODELS: u64 = 300;

/// Rounding of sums of products of a few matrices, over the largest entry.
const ROUNDING: f64 = 1e-12;

fn hold_to_matrices(model: &Model, q: &[f64], v: &[f64], loads: &Loads, what: &str) {
    let matrices = MovingFrame::assemble(model, q, v, loads, Variation::Restricted);
    let (symbols, at) = (Symbols::new(model, Naming::Numbers), Instant { q, v, matrices: &matrices });
    for (name, formulas, expected) in [("B", symbols.b(), &matrices.b), ("B'", symbols.b_dot(), &matrices.b_dot)] {
        let difference = (formulas.value(&symbols, at) - expected).amax() / expected.amax().max(1.0);
        assert!(difference < ROUNDING, "{what}: {name} differs by {difference:e}");
    }
}

#[test]
fn the_formulas_of_b_and_its_rate_have_the_values_of_the_matrices() {
    for seed in 0..MODELS {
        let mut random = Random::new(seed);
        let model = random.model();
        let ((q, v), loads) = (random.state(&model), random.loads(&model));
        hold_to_matrices(&model, &q, &v, &loads, &format!("seed {seed}"));
    }
}

/// Random vectors are not along an axis; here the vectors whose zero terms the formulas omit are along an
/// axis.
#[test]
fn formulas_without_the_zero_terms_of_axes_have_the_correct_values() {
    for mut simulation in [paper_simulation(), common::simulation(&common::everything("recursive"))] {
        simulation.step(200).expect("a run of a fifth of a second");
        let (state, model) = (simulation.state(), simulation.model());
        hold_to_matrices(model, &state.q, &state.v, &Loads::new(model), "a scenario");
    }
}

fn paper_simulation() -> Simulation {
    common::paper(&[("motor_2", true.into()), ("load", true.into()), ("hold_centre", false.into())])
}

fn formulas(model: &Model, naming: Naming) -> impl Fn(&str) -> SymbolicMatrix {
    let all = Symbols::new(model, naming).matrices();
    move |name| all.iter().find(|matrix| matrix.name == name).expect("a matrix of this name").clone()
}

/// The paper's ship, tower and arm.
fn paper() -> Model {
    paper_setup(&[]).model
}

#[test]
fn the_papers_b_has_the_corrected_blocks_of_eq_46() {
    let b = formulas(&paper(), Naming::Numbers)("B");
    assert_eq!(b.rows[4], r"\dot{x}_C^{(3)}");
    assert_eq!(
        b.columns,
        [r"\dot{x}_C^{(1)}", r"\omega^{(1)}", r"\dot{q}_{\mathrm{slew}}", r"\dot{q}_{\mathrm{luff}}"]
    );
    let row = |i: usize| b.blocks[i].iter().map(String::as_str).collect::<Vec<_>>();
    assert_eq!(row(0), ["I", "0", "0", "0"]);
    assert_eq!(row(1), ["0", "I", "0", "0"]);
    assert_eq!(row(2), ["I", "R^{(1)} S(s_{C(2/1)})^T", "0", "0"]);
    assert_eq!(row(3), ["0", "(R^{(2/1)})^T", "e_z", "0"]);
    assert_eq!(
        row(4),
        [
            "I",
            r"R^{(1)} \left( R^{(3/1)} S(s_{C_{3}})^T (R^{(3/1)})^T + R^{(2/1)} S(s_{J_{2}})^T (R^{(2/1)})^T + S(s_{C(2/1)})^T \right)",
            r"R^{(1)} R^{(2/1)} \left( R^{(3/2)} S(s_{C_{3}})^T (R^{(3/2)})^T + S(s_{J_{2}})^T \right) e_z",
            r"R^{(1)} R^{(2/1)} R^{(3/2)} S(s_{C_{3}})^T e_y",
        ]
    );
    assert_eq!(row(5), ["0", "(R^{(3/1)})^T", "(R^{(3/2)})^T e_z", "e_y"]);
}

#[test]
fn f_contains_the_motors_with_their_reactions_as_in_eq_59() {
    let f = formulas(&paper(), Naming::Names)("F");
    let moments: Vec<&str> = f.blocks.iter().skip(1).step_by(2).map(|row| row[0].as_str()).collect();
    let (ship, tower, arm) = (r"\mathrm{ship}", r"\mathrm{tower}", r"\mathrm{arm}");
    let (slew, luff) = (r"\tau_{\mathrm{slew}}", r"\tau_{\mathrm{luff}}");
    let expected = [
        format!("M^{{({ship})}} - {slew} R^{{({tower}/{ship})}} e_z"),
        format!("M^{{({tower})}} + {slew} e_z - {luff} R^{{({arm}/{tower})}} e_y"),
        format!("M^{{({arm})}} + {luff} e_y"),
    ];
    assert_eq!(moments, expected);
}
