//! A hull with the offshore vessel's database.

use kingpost::scenario::{Files, Scenario, ScenarioError, read_with};
use kingpost::sea::database::Database;
use serde_json::{Value, json};

/// The database of the gallery.
pub(super) const DATABASE: &str = include_str!("../../../../scenarios/hydro/offshore_vessel.hydro.json");

/// A scenario whose hull, `hull`, is the vessel's: its buoyancy carries exactly its mass, at even keel.
pub(super) fn read(text: &str, more: &[(&str, Value)]) -> Result<Scenario, ScenarioError> {
    let database = Database::read(DATABASE).expect("it reads");
    let along = database.hull.centre_of_buoyancy_m[0];
    let mut overrides = vec![
        ("bodies.hull.mass_kg".to_owned(), json!(1025.0 * database.hull.volume_m3)),
        ("bodies.hull.centre_of_mass_m".to_owned(), json!([along, 0.0, 7.0])),
        ("bodies.hull.joint.floating.initial.position_m".to_owned(), json!([along, 0.0, 1.5])),
    ];
    overrides.extend(more.iter().map(|(name, value)| ((*name).to_owned(), value.clone())));
    let files = Files::new([("vessel.hydro.json".to_owned(), DATABASE.to_owned())]);
    read_with(text, "vessel.yaml", &overrides, &files)
}
