//! Several of the box barges of `barge`, whose coefficients between one another are a share of their own.

use super::barge;
use kingpost::scenario::{Files, Scenario, ScenarioError, read_with};
use serde_json::{Value, json};

/// The place of a barge: x, y (m) and heading (rad).
pub type Place = [f64; 3];

/// A database of barges at these places, named `first`, `second` and `third`: every block between two of them is `share` times
/// that of one. With n barges it is passive for shares from -1 / (n - 1) to 1.
pub fn database(places: &[Place], share: f64) -> String {
    let one: Value = serde_json::from_str(&barge::database()).expect("JSON");
    let count = places.len();
    let factor = |i: usize, j: usize| if i == j { 1.0 } else { share };
    let matrix = |block: &Value| -> Value {
        let entry = |row: usize, column: usize| {
            factor(row / 6, column / 6) * block[row % 6][column % 6].as_f64().expect("a number")
        };
        (0..6 * count).map(|row| (0..6 * count).map(|column| entry(row, column)).collect::<Vec<f64>>()).collect()
    };
    let matrices = |field: &str| -> Value { one[field].as_array().expect("matrices").iter().map(matrix).collect() };
    let mode = |column: usize| {
        let own = &one["radiation"]["modes"][column % 6];
        let residues = |row: &Value| -> Value {
            let of = |i: usize| {
                let part = |k: usize| factor(i / 6, column / 6) * row[i % 6][k].as_f64().expect("a number");
                json!([part(0), part(1)])
            };
            (0..6 * count).map(of).collect()
        };
        let all: Value = own["residues"].as_array().expect("residues").iter().map(residues).collect();
        json!({"poles_rad_s": own["poles_rad_s"], "residues": all})
    };
    let hull = |(place, name): (&Place, &str)| {
        let [x, y, heading] = *place;
        json!({
            "name": name, "place": {"x_m": x, "y_m": y, "heading_rad": heading}, "hull": one["hull"],
            "froude_krylov": one["froude_krylov"], "diffraction": one["diffraction"], "mean_drift": null,
        })
    };
    let hulls: Vec<Value> = places.iter().zip(NAMES).map(hull).collect();
    json!({
        "format": "kingpost-hydrodynamics", "version": 2, "title": "Invented barges",
        "provenance": {"tool": "a formula"}, "water": one["water"], "hulls": hulls,
        "frequencies_rad_s": one["frequencies_rad_s"], "wave_directions_rad": one["wave_directions_rad"],
        "added_mass": matrices("added_mass"), "radiation_damping": matrices("radiation_damping"),
        "added_mass_infinite": matrix(&one["added_mass_infinite"]),
        "radiation": {"modes": (0..6 * count).map(mode).collect::<Vec<Value>>(), "fit_error": 0.0},
    })
    .to_string()
}

/// A database of one barge whose added mass and memory are multiplied by a factor.
pub fn heavier_water(factor: f64) -> String {
    let mut one: Value = serde_json::from_str(&barge::database()).expect("JSON");
    for path in ["added_mass", "radiation_damping", "added_mass_infinite"] {
        scale(&mut one[path], factor);
    }
    for mode in one["radiation"]["modes"].as_array_mut().expect("modes") {
        scale(&mut mode["residues"], factor);
    }
    one.to_string()
}

fn scale(value: &mut Value, factor: f64) {
    match value {
        Value::Array(entries) => entries.iter_mut().for_each(|entry| scale(entry, factor)),
        number => *number = json!(factor * number.as_f64().expect("a number")),
    }
}

pub const NAMES: [&str; 3] = ["first", "second", "third"];

/// The scenario of `barge.yaml` with so many of its barges in it, each with its mast and load, at these places; every file of
/// hydrodynamics has the name of the database.
pub fn text(places: &[Place]) -> String {
    let mut text = "version: 1\ntitle: Barges\nsimulation: {step_s: 0.02, duration_s: 20, record_every_s: 0.1}\n\
                    sea: {density_kg_m3: 1025, waves: {}}\nbodies:\n"
        .to_owned();
    for ([x, y, heading], name) in places.iter().zip(NAMES) {
        text += &format!(
            "  {name}:\n    mass_t: 380\n    centre_of_mass_m: [0, 0, 2]\n    inertia: {{radii_of_gyration: {{radii_m: [3.5, 6, 6]}}}}\n    \
             joint: {{floating: {{initial: {{drawing_frame_m: [{x}, {y}, -2], orientation_rad: [0, 0, {heading}]}}}}}}\n  \
             {name}_mast: {{parent: {name}, mass_t: 20, shape: {{box: {{length_m: 1, width_m: 1, height_m: 4}}}}, \
             joint: {{prismatic: {{axis: [0, 1, 0], position_m: [2, 0, 7], mode: held}}}}}}\n  \
             {name}_load: {{parent: {name}_mast, mass_t: 10, shape: {{sphere: {{radius_m: 0.5}}}}, joint: {{universal: \
             {{first_axis: [1, 0, 0], second_axis: [0, 1, 0], position_m: [0, 0, 2], child_position_m: [0, 0, 1.5]}}}}}}\n"
        );
    }
    text += "forces:\n  gravity: {gravity: {}}\n";
    for (_, name) in places.iter().zip(NAMES) {
        text += &format!(
            "  {name}_water: {{hydrodynamics: {{body: {name}, database: barges.hydro.json, origin_m: [0, 0, 2]}}}}\n"
        );
    }
    text
}

/// Reads a scenario with the text of its database and with changes.
pub fn read(text: &str, database: String, changes: &[(&str, Value)]) -> Result<Scenario, ScenarioError> {
    let changes: Vec<(String, Value)> =
        changes.iter().map(|(path, value)| ((*path).to_owned(), value.clone())).collect();
    read_with(text, "barges.yaml", &changes, &Files::new([("barges.hydro.json".to_owned(), database)]))
}
