//! Inconsistent data: excitation and damping, a waterplane and its mesh, RAOs in the wrong unit; and hulls
//! that the water cannot carry.

use crate::common;

use common::barge::{self, BEAM, DEPTH, DRAUGHT, GRAVITY, LENGTH};
use core::f64::consts::PI;
use kingpost::scenario::{Files, read_with};
use kingpost::sea::database::Database;
use kingpost::sea::waves::{Water, wave_number};
use serde_json::{Value, json};
use std::fs;

const GALLERY: [&str; 4] = ["barge", "crane_barge", "offshore_vessel", "sphere"];

fn gallery(name: &str) -> Value {
    let path = format!("{}/../../scenarios/hydro/{name}.hydro.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&fs::read_to_string(path).expect("it is there")).expect("JSON")
}

fn spoilt(spoil: impl Fn(&mut Value)) -> Result<Database, String> {
    let mut database = gallery("barge");
    spoil(&mut database);
    Database::read(&database.to_string()).map_err(|error| error.to_string())
}

/// Multiplies every number in a tree.
fn scale(tree: &mut Value, factor: f64) {
    match tree {
        Value::Array(all) => all.iter_mut().for_each(|one| scale(one, factor)),
        Value::Number(number) => *tree = json!(factor * number.as_f64().expect("a number")),
        _ => {}
    }
}

fn scale_excitation(all: &mut Value, factor: f64) {
    for part in ["froude_krylov", "diffraction"] {
        ["real", "imaginary"].iter().for_each(|which| scale(&mut all[part][*which], factor));
    }
}

/// Over infinite depth `B = w^3 / (4 pi rho g^3) Int |X|^2 db` (Newman, Marine Hydrodynamics, section 6.18, with c_g = g / 2w):
/// heave's excitation does not depend on direction, surge's goes as its cosine, so that the integrals are 2 pi and pi.
#[test]
fn haskinds_relation_gives_the_damping_of_its_closed_form() {
    let database = Database::read(&barge::database()).expect("it is fine");
    let implied = database.haskind_damping();
    for (omega, implied) in database.frequencies_rad_s.iter().zip(implied) {
        let Some(implied) = implied else { continue };
        let [[_, surge], _, [heave, _], ..] = barge::excitation(*omega, 0.0);
        let factor = omega.powi(3) / (4.0 * PI * barge::DENSITY * GRAVITY.powi(3));
        for (mode, expected) in [(0, factor * PI * surge * surge), (2, factor * 2.0 * PI * heave * heave)] {
            assert!((implied[mode] / expected - 1.0).abs() < 1e-12, "{omega} rad/s, mode {mode}");
        }
    }
}

/// Where water is shallow the group velocity is `w / k` (1/2 + k h / sinh 2 k h), which is sqrt(g h) in the limit.
#[test]
fn haskinds_relation_takes_the_group_velocity_of_the_depth() {
    let mut all: Value = serde_json::from_str(&barge::database()).expect("JSON");
    all["water"]["depth_m"] = json!(3.0);
    let database = Database::read(&all.to_string()).expect("it is fine");
    let omega = database.frequencies_rad_s[0];
    let water = Water { density_kg_m3: barge::DENSITY, gravity_m_s2: GRAVITY, depth_m: Some(3.0) };
    let (k, heave) = (wave_number(omega, &water), barge::excitation(omega, 0.0)[2][0]);
    let group = omega / k * (0.5 + k * 3.0 / libm::sinh(2.0 * k * 3.0));
    let expected = k / (8.0 * PI * barge::DENSITY * GRAVITY * group) * 2.0 * PI * heave * heave;
    let found = database.haskind_damping()[0].expect("long waves are resolved")[2];
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    // Long waves: sqrt(g h) (1 - (k h)^2 / 2), up to the next order.
    let ratio = group / libm::sqrt(3.0 * GRAVITY);
    assert!((ratio - 1.0 + 0.5 * (3.0 * k).powi(2)).abs() < (3.0 * k).powi(4), "{ratio}");
}

/// Panels keep the relation to some percent; the median of a mode that makes waves is far within a factor of 2.
#[test]
fn databases_of_the_gallery_give_no_warning() {
    for name in GALLERY {
        let database = Database::read(&gallery(name).to_string()).expect(name);
        assert_eq!(database.doubts(), Vec::<String>::new(), "{name}");
        assert!(database.haskind_damping().iter().any(Option::is_some), "{name}");
    }
}

#[test]
fn an_excitation_a_thousand_times_too_large_or_too_small_is_refused() {
    for factor in [1e3, 1e-3] {
        let error = spoilt(|all| scale_excitation(all, factor)).expect_err("it is wrong");
        assert!(error.starts_with("froude_krylov + diffraction: found"), "{error}");
    }
    // Without long waves the damping alone contradicts.
    let beyond_long_waves = |all: &mut Value, factor: f64| {
        // k L above 0.4, L = 20 m.
        let frequencies = all["frequencies_rad_s"].as_array().expect("a list");
        let long = frequencies.iter().filter(|omega| omega.as_f64().expect("a number") < 0.45).count();
        for field in ["frequencies_rad_s", "added_mass", "radiation_damping"] {
            all[field].as_array_mut().expect("a list").drain(..long);
        }
        for (part, which) in [
            ("froude_krylov", "real"),
            ("froude_krylov", "imaginary"),
            ("diffraction", "real"),
            ("diffraction", "imaginary"),
        ] {
            all[part][which].as_array_mut().expect("a list").drain(..long);
        }
        all.as_object_mut().expect("an object").remove("mean_drift");
        scale_excitation(all, factor);
    };
    assert_eq!(spoilt(|all| beyond_long_waves(all, 1.0)).expect("it is fine").doubts(), Vec::<String>::new());
    for factor in [1e3, 1e-3] {
        let error = spoilt(|all| beyond_long_waves(all, factor)).expect_err("it is wrong");
        assert!(
            error.contains("times the amplitude that follows from radiation_damping by Haskind's relation"),
            "{error}"
        );
    }
}

#[test]
fn a_damping_a_million_times_too_small_is_refused() {
    let error = spoilt(|all| {
        scale(&mut all["radiation_damping"], 1e-6);
        all.as_object_mut().expect("an object").remove("radiation");
    });
    let error = error.expect_err("it is wrong");
    assert!(error.contains("e2 times") || error.contains("e3 times"), "{error}");
}

#[test]
fn an_excitation_twice_or_half_of_haskinds_gives_a_warning_with_its_mode() {
    for factor in [2.5, 0.4] {
        let doubts = spoilt(|all| scale_excitation(all, factor)).expect("panels may be that coarse").doubts();
        assert_eq!(doubts.len(), 1, "{doubts:?}");
        assert!(doubts[0].starts_with("its excitation is ") && doubts[0].contains("heave "), "{doubts:?}");
        assert!(doubts[0].contains("by Haskind's relation (warned of outside 0.5 to 2)"), "{doubts:?}");
    }
}

/// Viscous roll damping is many times that of waves; a file can contain both.
#[test]
fn viscous_roll_damping_in_a_database_gives_a_warning_and_is_not_refused() {
    let database = spoilt(|all| {
        for matrix in all["radiation_damping"].as_array_mut().expect("a list") {
            matrix[3][3] = json!(matrix[3][3].as_f64().expect("a number") + 1e9);
        }
    });
    let doubts = database.expect("viscosity is no error").doubts();
    assert_eq!(doubts.len(), 1, "{doubts:?}");
    assert!(doubts[0].starts_with("its excitation is roll 0.") && doubts[0].contains("a damping that holds viscosity"));
}

#[test]
fn a_waterplane_that_differs_from_the_mesh_gives_a_warning_or_is_refused() {
    let with = |field: [&str; 2], factor: f64| {
        spoilt(|all| {
            let [outer, inner] = field;
            let place = if outer == "hull" { &mut all[outer][inner] } else { &mut all["hull"][outer][inner] };
            scale(place, factor);
        })
    };
    for (field, name) in
        [(["waterplane", "area_m2"], "hull.waterplane.area_m2"), (["hull", "volume_m3"], "hull.volume_m3")]
    {
        let error = with(field, 10.0).expect_err("ten times");
        assert!(
            error.starts_with(&format!("{name}: found ")) && error.contains("10.000 times that of its own mesh"),
            "{error}"
        );
        let doubts = with(field, 1.25).expect("a quarter").doubts();
        assert!(doubts.iter().any(|words| words.starts_with(&format!("{name} is "))), "{doubts:?}");
    }
}

/// A ship that follows the surface of long waves over this depth: heave 1, roll `k sin b`, pitch `k cos b`,
/// in this unit.
fn riding(unit: &str, factor: [f64; 2], depth_m: Option<f64>) -> String {
    let water = Water { depth_m, ..Water::default() };
    let mut text = format!(
        "direction_to_deg,frequency_rad_s,surge_forward_m_per_m,surge_lag_deg,sway_port_m_per_m,sway_lag_deg,heave_up_m_per_m,\
         heave_lag_deg,roll_port_up_{unit}_per_m,roll_lag_deg,pitch_bow_down_{unit}_per_m,pitch_lag_deg,yaw_bow_port_{unit}_per_m,\
         yaw_lag_deg\n"
    );
    for direction in (0..360).step_by(30) {
        let (sin, cos) = libm::sincos(f64::from(direction).to_radians());
        for omega in [0.3, 0.6, 0.9, 1.2] {
            let k = wave_number(omega, &water);
            let (roll, pitch) = (factor[0] * k * sin, factor[1] * k * cos);
            text += &format!("{direction},{omega},{cos},90,{sin},90,1,0,{roll},90,{pitch},90,0,0\n");
        }
    }
    text
}

fn moved(raos: String, depth_m: Option<f64>) -> Result<Vec<String>, String> {
    let depth = depth_m.map(|depth_m| format!("depth_m: {depth_m}, ")).unwrap_or_default();
    let text = format!(
        "version: 1\ntitle: By RAOs\nsimulation: {{step_s: 0.05, duration_s: 1}}\nbodies:\n  ship:\n    mass_t: 1000\n    \
         inertia: {{tensor: {{moments_kg_m2: [2e7, 4e8, 4e8]}}}}\n    joint: {{moved_by_waves: {{raos: ship.csv}}}}\n\
         sea: {{{depth}waves: {{swell: {{regular: {{height_m: 1, period_s: 8}}}}}}}}\nforces: {{gravity: {{gravity: {{}}}}}}\n"
    );
    let files = Files::new([("ship.csv".to_owned(), raos)]);
    let scenario = read_with(&text, "test.yaml", &[], &files).map_err(|error| error.to_string())?;
    Ok(scenario.describe().expect("it builds").warnings)
}

/// In long waves roll is the slope of the wave across the ship and pitch that along it, k times the amplitude (Faltinsen, *Sea
/// Loads on Ships and Offshore Structures*, 1990, chapter 3): numbers in degrees are 57.3 times that.
#[test]
fn raos_in_radians_that_are_declared_as_degrees_are_refused_and_the_other_way_round() {
    let degrees = 180.0 / PI;
    for depth_m in [None, Some(20.0)] {
        assert_eq!(moved(riding("rad", [1.0; 2], depth_m), depth_m), Ok(vec![]));
        assert_eq!(moved(riding("deg", [degrees; 2], depth_m), depth_m), Ok(vec![]));
        let error = moved(riding("deg", [1.0; 2], depth_m), depth_m).expect_err("rad under deg");
        assert!(error.contains("bodies.ship.joint.moved_by_waves.raos: found roll of "), "{error}");
        assert!(error.contains("are these rotations in rad where the file says deg?"), "{error}");
        let error = moved(riding("rad", [degrees; 2], depth_m), depth_m).expect_err("deg under rad");
        assert!(error.contains("are these rotations in deg where the file says rad?"), "{error}");
    }
}

#[test]
fn a_similar_unit_error_in_roll_alone_gives_a_warning() {
    let degrees = 180.0 / PI;
    let warnings = moved(riding("deg", [1.0, degrees], None), None).expect("a stiff ship may roll so");
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    assert!(warnings[0].starts_with("ship: ship.csv: roll of ") && warnings[0].contains("rad where the file says deg"));
    // One that rolls near its own period, ten times the slope, is no case of units.
    assert_eq!(moved(riding("rad", [10.0, 1.0], None), None), Ok(vec![]));
}

fn mass_t(mass_t: f64, more: &[(&str, Value)]) -> Result<Vec<String>, String> {
    let overrides = [("bodies.hull.mass_t", json!(mass_t))];
    let overrides: Vec<_> =
        overrides.iter().chain(more).map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    let scenario =
        read_with(barge::TEXT, "barge.yaml", &overrides, &barge::files()).map_err(|error| error.to_string())?;
    Ok(scenario.describe().expect("it builds").warnings)
}

/// The whole hull displaces rho L B D; the mast and the load weigh 30 t.
#[test]
fn a_run_does_not_begin_with_a_hull_that_cannot_float() {
    let most_t = barge::DENSITY * LENGTH * BEAM * DEPTH / 1000.0;
    for hydrostatics in ["linear", "mesh"] {
        let settings = [("forces.water.hydrodynamics.hydrostatics", json!(hydrostatics))];
        assert!(mass_t(most_t - 31.0, &settings).is_ok());
        let error = mass_t(most_t - 29.0, &settings).expect_err("it sinks");
        assert!(
            error.contains("forces.water.hydrodynamics: found a hull that cannot float: 1026.000 t displace"),
            "{error}"
        );
        assert!(error.contains("check the mass of hull and of all that it carries"), "{error}");
        // Also where a run would look for its equilibrium, which is not a matter of moorings.
        let begin = [settings[0].clone(), ("simulation.begin_at_equilibrium", json!(true))];
        let error = mass_t(5.0 * 380.0, &begin).expect_err("it sinks");
        assert!(error.contains("cannot float") && !error.contains("hold it"), "{error}");
    }
    let dry = [("forces.water.hydrodynamics.hydrostatics", json!("none"))];
    assert!(mass_t(5000.0, &dry).is_ok(), "nothing of the water is to carry it");
}

#[test]
fn a_hull_far_heavier_than_its_data_gives_a_warning() {
    let data_t = barge::DENSITY * LENGTH * BEAM * DRAUGHT / 1000.0;
    let of_mass = |mass_t_of_all: f64| {
        let all = mass_t(mass_t_of_all - 30.0, &[]).expect("it floats");
        all.into_iter().filter(|words| words.contains("its database is of")).collect::<Vec<_>>()
    };
    assert_eq!(of_mass(1.2 * data_t), Vec::<String>::new());
    let heavy = of_mass(2.0 * data_t);
    assert_eq!(heavy.len(), 1, "{heavy:?}");
    assert!(
        heavy[0].starts_with("hull: 820.000 t with what its joints carry, its database is of 410.000 t"),
        "{heavy:?}"
    );
}
