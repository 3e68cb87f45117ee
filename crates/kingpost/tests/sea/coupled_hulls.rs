//! Hulls that feel each other through the water: closed forms, symmetry, both forms of the equations, mistakes.

use crate::common;

use common::barge::{BEAM, DENSITY, GRAVITY, LENGTH, added_mass_infinite, excitation, retardation};
use common::barges::{self, Place};
use common::{relative_difference, values};
use kingpost::analysis::WaveGrid;
use kingpost::scenario::Scenario;
use kingpost::simulation::Simulation;
use nalgebra::{Complex, Matrix2, Normed, Vector2};
use serde_json::{Value, json};

const SHARE: f64 = 0.4;
const APART: [Place; 2] = [[0.0, 0.0, 0.0], [3.0, 16.0, 0.0]];
const TOGETHER: [Place; 2] = [[0.0; 3], [0.0; 3]];

fn read(places: &[Place], share: f64, changes: &[(&str, Value)]) -> Scenario {
    let scenario = barges::read(&barges::text(places), barges::database(places, share), changes);
    scenario.unwrap_or_else(|error| panic!("{error}"))
}

fn simulate(scenario: &Scenario) -> Simulation {
    Simulation::new(scenario.setup().unwrap_or_else(|error| panic!("{error}")))
}

fn waves() -> (&'static str, Value) {
    (
        "sea.waves",
        json!({"wind": {"jonswap": {"significant_height_m": 1.5, "peak_period_s": 6, "gamma": 2, "direction_deg": 70}}}),
    )
}

/// A push on the first barge, and the same on the second.
fn pushed(second: f64) -> Vec<(&'static str, Value)> {
    let velocity = |share: f64| json!([0.3 * share, -0.2 * share, 0.4 * share]);
    let turning = |share: f64| json!([0.05 * share, 0.04 * share, -0.03 * share]);
    let mut changes = Vec::new();
    for (name, share) in [
        (
            [
                "bodies.first.joint.floating.initial.velocity_m_s",
                "bodies.first.joint.floating.initial.angular_velocity_rad_s",
            ],
            1.0,
        ),
        (
            [
                "bodies.second.joint.floating.initial.velocity_m_s",
                "bodies.second.joint.floating.initial.angular_velocity_rad_s",
            ],
            second,
        ),
    ] {
        changes.extend([(name[0], velocity(share)), (name[1], turning(share))]);
    }
    changes
}

/// Positions and velocities after a run.
fn after(mut simulation: Simulation, steps: usize) -> (Vec<f64>, Vec<f64>) {
    simulation.step(steps).expect("it runs");
    (simulation.state().q.clone(), simulation.state().v.clone())
}

/// Coefficients between the hulls that are zero change nothing but the order of sums.
#[test]
fn hulls_without_coupling_move_as_each_alone() {
    let changes = [vec![waves()], pushed(-0.5)].concat();
    let coupled = after(simulate(&read(&APART, 0.0, &changes)), 500);
    let alone = barges::read(&barges::text(&APART), barges::heavier_water(1.0), &changes);
    let alone = after(simulate(&alone.unwrap_or_else(|error| panic!("{error}"))), 500);
    // Rounding of 500 steps with some thousand operations.
    assert!(relative_difference(&coupled.0, &alone.0) < 1e-11 && relative_difference(&coupled.1, &alone.1) < 1e-10);
}

/// Two equal hulls at one place move as one whose added mass and memory are `1 + share` times its own: the sum of the blocks.
/// So they do in both forms of the equations, in waves, with a crane and in a current.
#[test]
fn equal_hulls_that_move_alike_have_the_water_of_their_sum() {
    let in_current = ("sea.current_m_s", json!([0.4, -0.2]));
    for more in [vec![], vec![waves()], vec![waves(), in_current]] {
        let changes = [more, pushed(1.0)].concat();
        let alone = barges::read(&barges::text(&TOGETHER), barges::heavier_water(1.0 + SHARE), &changes);
        let (q, v) = after(simulate(&alone.expect("it reads")), 300);
        for form in ["recursive", "moving_frame"] {
            let changes = [changes.clone(), vec![("simulation.form", json!(form))]].concat();
            let (found_q, found_v) = after(simulate(&read(&TOGETHER, SHARE, &changes)), 300);
            let (in_q, in_v) = (relative_difference(&found_q, &q), relative_difference(&found_v, &v));
            // Rounding of 300 steps.
            assert!(in_q < 1e-10 && in_v < 1e-9, "{form}, {changes:?}: {in_q:e} {in_v:e}");
        }
    }
}

/// Heave of two even barges with their loads held is that of two equations: `Z = -w^2 (m + A) - i w B + C` on the diagonal, the
/// share of `-w^2 A - i w B` beside it. The second barge is turned, and stands elsewhere in the waves.
#[test]
fn heave_of_two_barges_in_waves_is_its_closed_form() {
    let places = [[0.0, 0.0, 0.0], [12.0, -16.0, 0.7]];
    let held = ["first_load", "second_load"].map(|load| format!("bodies.{load}.joint.universal"));
    let masts = ["bodies.first_mast.joint.prismatic.position_m", "bodies.second_mast.joint.prismatic.position_m"];
    let axes: Vec<String> =
        held.iter().flat_map(|of| [format!("{of}.first.mode"), format!("{of}.second.mode")]).collect();
    let mut changes: Vec<(&str, Value)> = masts.iter().map(|name| (*name, json!([0.0, 0.0, 7.0]))).collect();
    changes.extend(axes.iter().map(|name| (name.as_str(), json!("held"))));
    let scenario = read(&places, SHARE, &changes);
    let (omegas, directions) = ([0.4, 0.9, 1.5, 2.2], [0.3, 2.1]);
    let grid = WaveGrid { directions_rad: directions.to_vec(), frequencies_rad_s: omegas.to_vec() };
    let found = scenario.wave_response(&simulate(&scenario), &grid).expect("a response");
    let rows = found.real.len() / (directions.len() * omegas.len());
    let heave = |name: &str| 3 * found.places.iter().position(|place| place == name).expect("a place") + 2;
    let rows_of = [heave("first"), heave("second")];
    for (d, &direction) in directions.iter().enumerate() {
        for (k, &omega) in omegas.iter().enumerate() {
            let [b, more] = retardation(2, omega);
            let added = added_mass_infinite()[2][2] + more / omega;
            let water = Complex::new(-omega * omega * added, -omega * b);
            let own = water + DENSITY * GRAVITY * LENGTH * BEAM - omega * omega * 410e3;
            let impedance = Matrix2::new(own, water * SHARE, water * SHARE, own);
            let wave_number = omega * omega / GRAVITY;
            let force = places.map(|[x, y, _]| {
                let along = x * libm::cos(direction) + y * libm::sin(direction);
                let (sin, cos) = libm::sincos(wave_number * along);
                Complex::new(cos, sin) * excitation(omega, 0.0)[2][0]
            });
            let expected = impedance.lu().solve(&Vector2::from(force)).expect("no singular impedance");
            for (row, expected) in rows_of.into_iter().zip(expected.iter()) {
                let at = (d * omegas.len() + k) * rows + row;
                let found = Complex::new(found.real[at], found.imaginary[at]);
                assert!((found - expected).norm() < 1e-6 * expected.norm(), "{omega}: {found} {expected}");
            }
        }
    }
}

/// Both forms of the equations move hulls alike that are turned, list with their loads and carry cranes.
#[test]
fn hulls_move_alike_in_both_forms() {
    let places = [[0.0, 0.0, 0.2], [5.0, 17.0, -0.9], [25.0, -4.0, 2.0]];
    let changes = [vec![waves()], pushed(-0.7)].concat();
    let runs = ["recursive", "moving_frame"].map(|form| {
        let form = vec![("simulation.form", json!(form))];
        let mut simulation = simulate(&read(&places, 0.3, &[changes.clone(), form].concat()));
        simulation.step(150).expect("it runs");
        (simulation.state().q.clone(), simulation.acceleration(None).expect("accelerations"))
    });
    // Rounding of 150 steps.
    assert!(relative_difference(&runs[0].0, &runs[1].0) < 1e-11);
    assert!(relative_difference(&runs[0].1, &runs[1].1) < 1e-9);
}

/// Without waves the water only takes energy, whatever pushes three hulls that feel each other, near the least share that is
/// passive; the ledger closes.
#[test]
fn three_hulls_lose_energy_to_the_water_and_the_ledger_closes() {
    let places = [[0.0, 0.0, 0.0], [0.0, 16.0, 0.0], [30.0, 8.0, 1.0]];
    let mut simulation = simulate(&read(&places, -0.45, &pushed(-1.0)));
    let total = |simulation: &mut Simulation| {
        let of = |simulation: &mut Simulation, variable: &str| values(simulation, variable).iter().sum::<f64>();
        // The kinetic energy contains that of each hull's own added mass.
        of(simulation, "kinetic_energy")
            + of(simulation, "potential_energy")
            + of(simulation, "interaction_kinetic_energy")
    };
    let start = total(&mut simulation);
    let moving: f64 = values(&mut simulation, "kinetic_energy").iter().sum();
    for _ in 0..10 {
        simulation.step(100).expect("it runs");
        let lost = start - total(&mut simulation);
        assert!(lost > 0.0, "{lost:e} J of {moving:e} J");
        // The scheme is of fourth order, with 60 steps in the shortest period.
        let error: f64 = values(&mut simulation, "energy_error").iter().sum();
        assert!(error.abs() < 1e-5 * moving, "{error:e} J of {moving:e} J");
    }
    assert!(start - total(&mut simulation) > 0.3 * moving, "radiation takes most of the motion");
}

#[test]
fn a_linearisation_is_exact_with_coupled_hulls() {
    let scenario = read(&APART, SHARE, &pushed(-1.0));
    common::assert_derivatives_of(&scenario);
}

fn error(text: &str, database: String, changes: &[(&str, Value)]) -> String {
    let found = barges::read(text, database, changes).and_then(|scenario| scenario.simulation());
    found.err().map(|error| error.to_string()).unwrap_or_else(|| panic!("no error of {changes:?}"))
}

#[test]
fn refuses_a_database_whose_hulls_are_not_those_of_the_scenario() {
    let (text, several) = (barges::text(&APART), barges::database(&APART, SHARE));
    let of = |changes: &[(&str, Value)]| error(&text, several.clone(), changes);
    let second = "forces.second_water.hydrodynamics";
    let hull = format!("{second}.hull");
    for (field, value, expected) in [
        (hull.as_str(), json!("ship"), "found ship, allowed: one of first, second"),
        (&hull, json!("first"), "found first, as forces.first_water, allowed: each hull of a database once"),
        (&format!("{second}.enabled"), json!(false), "a database of first, second, of which second is disabled"),
        (&format!("{second}.radiation"), json!(false), "found false, allowed: true, as in forces.first_water"),
        (&format!("{second}.added_mass"), json!(false), "found false, allowed: true, as in forces.first_water"),
        (&format!("{second}.excitation"), json!(false), "found false, allowed: true, as in forces.first_water"),
        ("bodies.second.joint.floating.hold_rotation", json!(true), "whose joint second is held"),
    ] {
        let found = of(&[(field, value)]);
        assert!(found.contains(expected), "{field}: {found}");
    }
    let on_one = [(hull.as_str(), json!("second")), ("forces.second_water.hydrodynamics.body", json!("first"))];
    assert!(
        of(&on_one).contains("first, the body of forces.first_water, allowed: a body for each hull"),
        "{}",
        of(&on_one)
    );
    let third = barges::database(&[APART[0], APART[1], [50.0, 0.0, 0.0]], SHARE);
    assert!(error(&text, third, &[]).contains("of which third has no hydrodynamics here"));
    let renamed = several.replace("\"second\"", "\"boat\"");
    let found = error(&text, renamed, &[]);
    assert!(found.contains("no hull, and no hull named second, in a database of several"), "{found}");
    let one = barges::heavier_water(1.0);
    let found = error(&text, one, &[(hull.as_str(), json!("second"))]);
    assert!(found.contains("second, with a database of one hull"), "{found}");
}

#[test]
fn refuses_a_file_of_several_hulls_that_is_damaged() {
    let text = barges::text(&APART);
    let whole: Value = serde_json::from_str(&barges::database(&APART, SHARE)).expect("JSON");
    let spoilt = |change: &dyn Fn(&mut Value)| {
        let mut spoilt = whole.clone();
        change(&mut spoilt);
        error(&text, spoilt.to_string(), &[])
    };
    for (change, expected) in [
        (
            &(|file: &mut Value| file["hulls"][1]["name"] = json!("first")) as &dyn Fn(&mut Value),
            "hulls.1.name: first, allowed",
        ),
        (&|file| file["hulls"][0]["place"]["x_m"] = json!("here"), "expected a number"),
        (&|file| file["added_mass"] = json!([[[1.0]]]), "added_mass: another shape"),
        (&|file| file["added_mass_infinite"][2][8] = json!(9e6), "from heave of first to heave of second"),
        (&|file| file["radiation_damping"][9][2][8] = json!(9e6), "radiation_damping.9"),
        (&|file| file["hulls"][0]["hull"]["draught_m"] = json!(-1), "hulls.first.hull.draught_m"),
        (&|file| drop(file["hulls"].as_array_mut().map(|hulls| hulls.pop())), "two hulls or more"),
        (&|file| drop(file["radiation"]["modes"].as_array_mut().map(|modes| modes.pop())), "radiation.modes"),
        (&|file| file["unknown"] = json!(1), "unknown field `unknown`"),
        (&|file| file["hulls"][1]["name"] = json!("Barge 2"), "hulls.1.name: Barge 2, allowed"),
        (&|file| file["frequencies_rad_s"][3] = json!(0.01), "barges.hydro.json: frequencies_rad_s"),
    ] {
        let found = spoilt(change);
        assert!(found.contains(expected), "{expected}: {found}");
    }
    let whole = whole.to_string();
    let found = error(&text, whole[..whole.len() / 2].to_owned(), &[]);
    assert!(found.contains("a whole hydrodynamic database") && !found.contains("unknown field"), "{found}");
    let generating = barges::database(&APART, 1.3);
    let found = error(&text, generating, &[]);
    assert!(found.contains("an eigenvalue of"), "{found}");
}

/// A run warns of hulls away from the place of their data, and not of a missing interaction.
#[test]
fn warns_of_hulls_away_from_the_place_of_their_database() {
    let warned = |places: &[Place]| {
        let scenario = barges::read(&barges::text(places), barges::database(&APART, SHARE), &[]);
        let run = simulate(&scenario.expect("it reads")).run(|_| true);
        run.warnings.iter().map(|warning| warning.code.to_owned()).collect::<Vec<_>>()
    };
    assert!(warned(&APART).is_empty(), "{:?}", warned(&APART));
    // The gap is 6 m wide: a quarter of it is 1.5 m, a sixteenth of the length 1.25 m.
    let codes = warned(&[APART[0], [3.0, 17.4, 0.15]]);
    assert_eq!(codes, ["hull_off_data_place", "hull_off_data_heading"]);
}
