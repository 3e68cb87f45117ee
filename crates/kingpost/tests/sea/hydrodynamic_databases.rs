//! Errors of impossible databases, and of seas outside a database's range, at the place where they are read.

use crate::common;

use common::barge;
use kingpost::scenario::read_with;
use kingpost::sea::database::Database;
use serde_json::{Value, json};

fn database() -> Value {
    serde_json::from_str(&barge::database()).expect("JSON")
}

fn refused(spoil: impl Fn(&mut Value)) -> String {
    let mut spoilt = database();
    spoil(&mut spoilt);
    Database::read(&spoilt.to_string()).expect_err("it is wrong").to_string()
}

#[test]
fn a_database_cut_off_anywhere_or_of_another_kind_is_refused() {
    let whole = barge::database();
    for part in 0..40 {
        let cut = &whole[..whole.len() * part / 40];
        assert!(Database::read(cut).expect_err("cut off").to_string().contains("a whole hydrodynamic database"));
    }
    for other in ["{}", "[]", "null", "\u{0}", "{\"a\": 1}"] {
        assert!(Database::read(other).is_err());
    }
    let later = refused(|all| all["version"] = json!(2));
    assert_eq!(later, "version: found 2, allowed: 1");
}

#[test]
fn an_added_mass_that_is_not_symmetric_or_negative_is_refused() {
    let skew = refused(|all| all["added_mass_infinite"][0][2] = json!(2e5));
    assert!(skew.starts_with("added_mass_infinite: found 0 from surge to heave but 200000 back"), "{skew}");
    let skew = refused(|all| all["added_mass"][7][3][1] = json!(-9e5));
    assert!(skew.starts_with("added_mass.7: found -900000 from sway to roll but"), "{skew}");
    let negative = refused(|all| all["added_mass_infinite"][2][2] = json!(-2e5));
    assert!(negative.starts_with("added_mass_infinite: found an eigenvalue of -0."), "{negative}");
}

#[test]
fn numerical_noise_about_zero_does_not_count_as_negative_added_mass() {
    let mut round = database();
    round["added_mass_infinite"][5][5] = json!(-1.0);
    assert!(Database::read(&round.to_string()).is_ok());
}

#[test]
fn damping_that_adds_energy_is_refused() {
    let negative = refused(|all| {
        let given = all["radiation_damping"][12][2][2].as_f64().expect("a number");
        all["radiation_damping"][12][2][2] = json!(-given);
    });
    assert!(negative.starts_with("radiation_damping.12: found an eigenvalue of -"), "{negative}");
}

#[test]
fn a_memory_that_adds_energy_or_resists_a_steady_drift_is_refused() {
    let heave = |all: &mut Value, factors: [f64; 2]| {
        for (part, factor) in factors.iter().enumerate() {
            let residue = &mut all["radiation"]["modes"][2]["residues"][0][2][part];
            *residue = json!(factor * residue.as_f64().expect("a number"));
        }
    };
    let giving = refused(|all| heave(all, [-1.0, -1.0]));
    assert!(giving.starts_with("radiation.") && giving.contains("an eigenvalue of -"), "{giving}");
    let dragging = refused(|all| heave(all, [1.3, 1.0]));
    assert!(dragging.starts_with("radiation.modes.2: found a drag of"), "{dragging}");
    assert!(dragging.contains("in heave on a steady drift"), "{dragging}");
    let growing = refused(|all| all["radiation"]["modes"][2]["poles_rad_s"][0][0] = json!(0.1));
    assert!(growing.contains("poles with a negative real part"), "{growing}");
}

#[test]
fn a_mean_drift_of_another_shape_is_refused() {
    let (frequencies, directions) = {
        let all = database();
        let count = |name: &str| all[name].as_array().expect("a list").len();
        (count("frequencies_rad_s"), count("wave_directions_rad"))
    };
    let allowed = format!("3 finite numbers for each of {frequencies} frequencies and {directions} directions");
    let whole = vec![vec![[0.0; 3]; directions]; frequencies];
    let mut short = whole.clone();
    short[frequencies - 1].pop();
    for spoilt in [json!([]), json!([[]]), json!(short)] {
        let error = refused(|all| all["mean_drift"] = spoilt.clone());
        assert_eq!(error, format!("mean_drift: found another shape, allowed: {allowed}"));
    }
    let mut fine = database();
    fine["mean_drift"] = json!(whole);
    assert!(Database::read(&fine.to_string()).is_ok());
}

#[test]
fn a_sea_beyond_the_frequencies_is_refused_on_either_side() {
    // The barge's go from 0.1 to 4 rad/s, its swell is regular.
    let swell = |period_s: f64| {
        let pairs = [
            ("sea.waves.swell.regular.enabled", json!(true)),
            ("sea.waves.swell.regular.height_m", json!(0.2)),
            ("sea.waves.swell.regular.period_s", json!(period_s)),
        ]
        .map(|(name, value)| (name.to_owned(), value));
        read_with(barge::TEXT, "barge.yaml", &pairs, &barge::files()).map(|_| ()).map_err(|error| error.to_string())
    };
    for period_s in [1.5, 100.0] {
        let error = swell(period_s).expect_err("it is beyond");
        assert!(
            error.contains("frequencies from 0.1 to 4 rad/s, with 100.0 % of the waves' energy outside"),
            "{error}"
        );
        assert!(error.contains("forces.water.hydrodynamics.database"), "{error}");
    }
    assert_eq!(swell(8.0), Ok(()));
}
