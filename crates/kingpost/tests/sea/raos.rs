//! A ship whose motion in waves is prescribed by its displacement RAOs.

use crate::common;

use common::values;
use core::f64::consts::{PI, TAU};
use kingpost::scenario::{Files, read_with};
use kingpost::sea::raos::RaoTable;
use kingpost::simulation::{InputError, Simulation};

const MODES: [&str; 6] = ["surge_forward", "sway_port", "heave_up", "roll_port_up", "pitch_bow_down", "yaw_bow_port"];

/// Amplitude (m/m, deg/m) and lag (deg) by mode, direction in steps of 30 deg and period; smooth and asymmetric.
fn amplitude(mode: usize, direction: usize, period_s: f64) -> (f64, f64) {
    let (m, d) = (mode as f64, direction as f64);
    (0.3 + 0.1 * m + 0.02 * d + 0.01 * period_s, 10.0 * m - 4.0 * d + 2.0 * period_s)
}

fn csv() -> String {
    let units = |mode: usize| if mode < 3 { "m_per_m" } else { "deg_per_m" };
    let name = |mode: usize| {
        let short = MODES[mode].split('_').next().unwrap();
        format!("{}_{},{short}_lag_deg", MODES[mode], units(mode))
    };
    let mut text =
        format!("# made for a test\ndirection_to_deg,period_s,{}\n", (0..6).map(name).collect::<Vec<_>>().join(","));
    for direction in 0..12 {
        for period in [2.0, 4.0, 8.0, 12.0, 20.0] {
            let cells = (0..6).map(|mode| amplitude(mode, direction, period)).map(|(a, lag)| format!("{a},{lag}"));
            text += &format!("{},{period},{}\n", 30 * direction, cells.collect::<Vec<_>>().join(","));
        }
    }
    text
}

/// Returns the table in OrcaFlex's format, with every convention reversed.
fn orcaflex() -> String {
    let mut text = "%YAML 1.1\n# Type: Model\n---\nVesselTypes:\n  - Name: Ship\n    Length: 80\n    RAOResponseUnits: radians\n    \
                    RAOWaveUnit: amplitude\n    WavesReferredToBy: frequency (Hz)\n    RAOPhaseConvention: leads\n    \
                    RAOPhaseUnitsConvention: radians\n    RAOPhaseRelativeToConvention: trough\n    SurgePositive: aft\n    \
                    SwayPositive: starboard\n    HeavePositive: down\n    RollPositiveStarboard: up\n    PitchPositiveBow: up\n    \
                    YawPositiveBow: starboard\n    Symmetry: None\n    Draughts:\n      - Name: Draught1\n        \
                    DisplacementRAOs:\n          RAOOrigin: [0, 0, 0]\n          PhaseOrigin: [~, ~, ~]\n          RAOs:\n"
        .to_owned();
    let names = ["Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"]
        .map(|mode| format!(", RAO{mode}Amp, RAO{mode}Phase"))
        .concat();
    for direction in 0..12 {
        text +=
            &format!("            - RAODirection: {}\n              RAOPeriodOrFrequency{names}:\n", 30 * direction);
        for period in [2.0, 4.0, 8.0, 12.0, 20.0] {
            let cell = |mode: usize| {
                let (a, lag) = amplitude(mode, direction, period);
                let a = if mode < 3 { a } else { a.to_radians() };
                // Against the trough, and in the other sense: the two half turns cancel.
                format!(", {a}, {}", -lag.to_radians())
            };
            text += &format!("                - [{}{}]\n", 1.0 / period, (0..6).map(cell).collect::<String>());
        }
    }
    text
}

fn scenario(joint: &str, waves: &str) -> String {
    format!(
        "version: 1\ntitle: A ship by its RAOs\nsimulation: {{step_s: 0.05, duration_s: 100}}\nbodies:\n  ship:\n    mass_t: 1000\n    \
         inertia: {{tensor: {{moments_kg_m2: [2e7, 4e8, 4e8]}}}}\n    joint: {{moved_by_waves: {{raos: ship.csv{joint}}}}}\n\
         sea: {{{waves}}}\nforces: {{gravity: {{gravity: {{}}}}}}\n"
    )
}

fn build(text: &str, raos: String) -> Result<Simulation, String> {
    let files = Files::new([("ship.csv".to_owned(), raos)]);
    let scenario = read_with(text, "test.yaml", &[], &files).map_err(|error| error.to_string())?;
    scenario.simulation().map_err(|error| error.to_string())
}

const REGULAR: &str = "waves: {swell: {regular: {height_m: 3, period_s: 8, direction_deg: 120}}}";

/// a |X| cos(w t - k.x - lag) at the ship's position and heading, its rate and its acceleration; the mean
/// position and heading do not change.
#[test]
fn a_ship_in_a_regular_wave_moves_by_its_raos() {
    let place = ", position_m: [30, -20, 1], heading_deg: 30";
    let mut ship = build(&scenario(place, REGULAR), csv()).unwrap();
    let omega = TAU / 8.0;
    let k = omega * omega / 9.80665;
    let (sin, cos) = libm::sincos(2.0 * PI / 3.0);
    for _ in 0..40 {
        let time_s = ship.time_s();
        let phase = omega * time_s - k * (30.0 * cos - 20.0 * sin);
        let world = values(&mut ship, "acceleration");
        let (sin_heading, cos_heading) = libm::sincos(PI / 6.0);
        let acceleration = [
            cos_heading * world[0] + sin_heading * world[1],
            cos_heading * world[1] - sin_heading * world[0],
            world[2],
        ];
        for (coordinate, mode) in [0, 1, 2, 5, 4, 3].into_iter().enumerate() {
            // 120 - 30 degrees against the ship: direction 3 of the table.
            let (size, lag) = amplitude(mode, 3, 8.0);
            let size = 1.5 * if mode < 3 { size } else { size.to_radians() };
            let angle = phase - lag.to_radians();
            let (sin, cos) = libm::sincos(angle);
            // Positions are stepped from exact rates by RK4: (w h)^4 / 2880 of the size.
            assert!((ship.state().q[coordinate] - size * cos).abs() < 1e-8 * size, "{coordinate} at {time_s}");
            if let Some(acceleration) = acceleration.get(coordinate) {
                assert!((acceleration + omega * omega * size * cos).abs() < 1e-12 * size);
            }
            assert!((ship.state().v[coordinate] + omega * size * sin).abs() < 1e-8 * size);
        }
        ship.step(7).unwrap();
    }
    let position = values(&mut ship, "position");
    assert!((position[0] - 30.0).abs() < 3.0 && (position[1] + 20.0).abs() < 3.0);
}

/// The work of the prescribed motion is the ship's energy, through the ramp and in a random sea.
#[test]
fn the_work_of_a_prescribed_wave_motion_is_in_the_ledger() {
    let sea = "ramp_s: 10, waves: {wind: {jonswap: {significant_height_m: 2, peak_period_s: 9, direction_deg: 40}}}";
    let mut ship = build(&scenario(", origin_m: [2, 0, -1]", sea), csv()).unwrap();
    assert!(ship.state().v.iter().chain(&ship.state().q).all(|x| *x == 0.0));
    ship.step(600).unwrap();
    let size = values(&mut ship, "kinetic_energy")[0];
    assert!(size > 1e4 && values(&mut ship, "energy_error")[0].abs() < 1e-4 * size);
}

#[test]
fn both_file_formats_give_the_same_raos() {
    let (ours, theirs) = (RaoTable::read(&csv()).unwrap(), RaoTable::read(&orcaflex()).unwrap());
    assert_eq!((theirs.symmetric, theirs.origin_m), (Some(false), [0.0; 3]));
    for direction in 0..24 {
        for omega in [0.4, 0.6, 0.9, 1.2] {
            let direction = TAU * f64::from(direction) / 24.0;
            let (a, b) = (ours.at(omega, direction), theirs.at(omega, direction));
            for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
                assert!((a - b).abs() < 1e-12, "{a} {b}");
            }
        }
    }
}

/// A quarter of a period after the crest the water crosses zero downwards, and a quarter before it upwards.
#[test]
fn phases_may_refer_to_crest_trough_or_crossings() {
    let against = |word: &str| RaoTable::read(&orcaflex().replace("trough", word)).unwrap().at(0.7, 1.3);
    let of_crest = against("crest");
    // cos and sin of how far behind the crest.
    for (word, [cos, sin]) in
        [("zero down-crossing", [0.0, 1.0]), ("trough", [-1.0, 0.0]), ("zero up-crossing", [0.0, -1.0])]
    {
        for ([re, im], [re_of_crest, im_of_crest]) in against(word).into_iter().zip(of_crest) {
            assert!((re - (cos * re_of_crest - sin * im_of_crest)).abs() < 1e-12, "{word}");
            assert!((im - (sin * re_of_crest + cos * im_of_crest)).abs() < 1e-12, "{word}");
        }
    }
}

/// Phases against the wave d ahead of the origin are those against the wave at the origin less k d.
#[test]
fn phases_may_refer_to_the_wave_at_another_point() {
    let ahead = orcaflex().replace("PhaseOrigin: [~, ~, ~]", "PhaseOrigin: [25, 0, 0]");
    assert_eq!(RaoTable::read(&ahead).unwrap().phase_origin_m, [25.0, 0.0, 0.0]);
    let start = |raos: String, place: &str| {
        let waves = REGULAR.replace("120", "0");
        build(&scenario(place, &waves), raos).unwrap().state().q.clone()
    };
    let (of_point, of_origin) = (start(ahead, ""), start(orcaflex(), ", position_m: [25, 0, 0]"));
    assert_eq!(of_point, of_origin);
}

/// Surge, heave and pitch are equal in the mirrored wave; sway, roll and yaw change sign.
#[test]
fn half_a_circle_of_directions_is_enough_for_a_symmetric_ship() {
    let half: String = csv()
        .lines()
        .filter(|line| !["210,", "240,", "270,", "300,", "330,"].iter().any(|d| line.starts_with(d)))
        .map(|line| format!("{line}\n"))
        .collect();
    let table = RaoTable::read(&half).unwrap();
    assert!(table.whole_circle(None).unwrap_err().to_string().contains("nothing from 180.0 to 360.0 deg"));
    let table = table.whole_circle(Some(true)).unwrap();
    let (port, starboard) = (table.at(0.7, 1.3), table.at(0.7, -1.3));
    for mode in 0..6_usize {
        let sign = if mode.is_multiple_of(2) { 1.0 } else { -1.0 };
        assert!((0..2).all(|part| (port[mode][part] - sign * starboard[mode][part]).abs() < 1e-12));
    }
}

#[test]
fn files_with_missing_conventions_are_refused() {
    let refused = |raos: String, message: &str| {
        let error = build(&scenario("", REGULAR), raos).map(drop).unwrap_err();
        assert!(error.contains("bodies.ship.joint.moved_by_waves.raos") && error.contains(message), "{error}");
    };
    refused(
        csv().replace("pitch_bow_down", "pitch"),
        "pitch_bow_down_deg_per_m or pitch_bow_down_rad_per_m or pitch_bow_up",
    );
    refused(csv().replace("heave_lag_deg", "heave_phase"), "heave_lag_deg or heave_lead_deg");
    refused(csv().replace("\n60,8,", "\n60,x,"), "period_s: x");
    refused(csv().replace("\n60,8,", "\n60,9,"), "direction 60.000000 deg");
    refused(csv().lines().take(37).map(|line| format!("{line}\n")).collect(), "nothing from");
    refused(orcaflex().replace("    RAOPhaseConvention: leads\n", ""), "RAOPhaseConvention: nothing");
    refused(
        orcaflex().replace("trough", "zero crossing"),
        "found ship.csv: RAOPhaseRelativeToConvention: zero crossing, allowed: crest or zero down-crossing or trough or",
    );
    refused(orcaflex().replace("RAOWaveUnit: amplitude", "RAOWaveUnit: max wave slope"), "allowed: amplitude");
    refused(orcaflex().replace("RAOOrigin: [0, 0, 0]", "RAOOrigin: [~, ~, ~]"), "RAOOrigin");
    let long = REGULAR.replace("period_s: 8", "period_s: 25");
    let error = build(&scenario("", &long), csv()).map(drop).unwrap_err();
    assert!(error.contains("100.0 % of the waves' energy outside"), "{error}");
}

#[test]
fn the_sea_of_a_ship_moved_by_waves_cannot_be_replaced() {
    let mut ship = build(&scenario("", REGULAR), csv()).unwrap();
    assert_eq!(ship.set_waves(&[1.5], &[1.0]), Err(InputError::MovedByWaves));
}
