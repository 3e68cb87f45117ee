//! Ships on a soft hold, against closed forms.

use crate::common;

use common::{assert_linearised, barge, simulation, values};
use core::f64::consts::TAU;
use kingpost::analysis::Linearizer;
use kingpost::elements::{SoftHold, of_kind};
use kingpost::scenario::{Files, read, read_with};
use kingpost::simulation::Simulation;
use serde_json::{Value, json};

/// A ship of 800 t and a mast of 200 t on it, whose centre is at `mast` on the ship; their common centre of mass is a fifth of
/// the way. Without gravity and water.
fn ship(initial: &str, mast: [f64; 3], hold: &str) -> String {
    format!(
        "version: 1\ntitle: A ship on a soft hold\nsimulation: {{step_s: 0.1, duration_s: 400}}\nbodies:\n  \
         ship:\n    mass_t: 800\n    centre_of_mass_m: [0, 0, 3]\n    inertia: {{tensor: {{moments_kg_m2: [2e7, 4e8, 4e8]}}}}\n    \
         joint: {{floating: {{initial: {{{initial}}}}}}}\n  \
         mast:\n    parent: ship\n    mass_t: 200\n    inertia: {{tensor: {{moments_kg_m2: [1e7, 1e7, 1e6]}}}}\n    \
         joint: {{fixed: {{position_m: [{}, {}, {}]}}}}\n\
         forces:\n  hold: {{soft_hold: {{body: ship{hold}}}}}\n",
        mast[0],
        mast[1],
        3.0 + mast[2]
    )
}

/// Returns the decay of 1 from rest: `e^(-zeta w t) (cos w_d t + zeta w / w_d sin w_d t)`.
fn decay(period_s: f64, zeta: f64, time_s: f64) -> f64 {
    let omega = TAU / period_s;
    let damped = omega * libm::sqrt(1.0 - zeta * zeta);
    let (sin, cos) = libm::sincos(damped * time_s);
    libm::exp(-zeta * omega * time_s) * (cos + zeta * omega / damped * sin)
}

/// The whole ship is an oscillator of the given period and damping, in the axes of the heading that is held; RK4 errs by
/// (omega h)^4 / 120 of a radian.
#[test]
fn surge_sway_and_yaw_swing_with_their_periods_and_damping() {
    let hold = ", natural_periods_s: [100, 130, 80], damping_ratios: [0.1, 0.3, 0.05], target: {x_m: 100, y_m: 50, heading_deg: 30}";
    let (sin, cos) = libm::sincos(30_f64.to_radians());
    for (off, mode, period_s, zeta) in [([2.0, 0.0], 0, 100.0, 0.1), ([0.0, 3.0], 1, 130.0, 0.3)] {
        let place = [100.0 + cos * off[0] - sin * off[1], 50.0 + sin * off[0] + cos * off[1]];
        let initial = format!("position_m: [{}, {}, 3], orientation_deg: [0, 0, 30]", place[0], place[1]);
        let mut ship = simulation(&ship(&initial, [5.0, 2.0, 20.0], hold));
        for _ in 0..3 {
            ship.step(350).unwrap();
            let expected = off[mode] * decay(period_s, zeta, ship.time_s());
            let deviation = values(&mut ship, "hold_deviation");
            assert!((deviation[mode] - expected).abs() < 1e-8, "{deviation:?} {expected}");
            assert!(deviation[1 - mode].abs() < 1e-10 && deviation[2].abs() < 1e-12, "{deviation:?}");
        }
    }
    let initial = "position_m: [100, 50, 3], orientation_deg: [0, 0, 50]";
    let mut ship = simulation(&ship(initial, [0.0, 0.0, 20.0], hold));
    for _ in 0..3 {
        ship.step(350).unwrap();
        let expected = 20_f64.to_radians() * decay(80.0, 0.05, ship.time_s());
        assert!((values(&mut ship, "hold_deviation")[2] - expected).abs() < 1e-8);
    }
}

/// At the common centre of mass of the ship and its mast, 20 m above her own: the force turns neither.
#[test]
fn a_soft_hold_moves_a_ship_neither_up_nor_down_nor_in_roll_and_pitch() {
    let mut ship = simulation(&ship("position_m: [0, 0, 3]", [5.0, 2.0, 20.0], ", target: {x_m: 8, y_m: -6}"));
    ship.step(300).unwrap();
    let [velocity, rates] = ["velocity", "angular_velocity"].map(|of| values(&mut ship, of));
    assert!(velocity[..3].iter().take(2).all(|rate| rate.abs() > 0.05), "{velocity:?}");
    assert!(velocity[2].abs() < 1e-12 && rates[..3].iter().all(|rate| rate.abs() < 1e-12), "{velocity:?} {rates:?}");
}

/// Its moment does work on yaw as an angle, and none on roll and pitch: along the columns of omega = E
/// (roll', pitch', yaw').
#[test]
fn a_heeled_and_trimmed_ship_gets_a_moment_of_yaw_alone() {
    let initial = "position_m: [4, 1, 3], orientation_deg: [12, -8, 25]";
    let [mut held, mut free] = [true, false].map(|enabled| {
        simulation(&ship(initial, [0.0; 3], &format!(", enabled: {enabled}, target: {{x_m: 4, y_m: 1}}")))
    });
    let load = held.moving_frame().f_star - free.moving_frame().f_star;
    let moment = [load[3], load[4], load[5]];
    let ([sin_roll, cos_roll], [sin_pitch, cos_pitch]) =
        ([12_f64, -8.0].map(f64::to_radians)).map(|angle| [libm::sin(angle), libm::cos(angle)]).into();
    let along = |axis: [f64; 3]| axis.iter().zip(moment).map(|(a, m)| a * m).sum::<f64>();
    let expected = values(&mut held, "hold_force")[2];
    assert!(expected < -1e5, "{expected}");
    assert!(along([1.0, 0.0, 0.0]).abs() < 1e-9 * -expected, "{moment:?}");
    assert!(along([0.0, cos_roll, -sin_roll]).abs() < 1e-9 * -expected, "{moment:?}");
    let of_yaw = along([-sin_pitch, sin_roll * cos_pitch, cos_roll * cos_pitch]);
    assert!((of_yaw / expected - 1.0).abs() < 1e-12, "{of_yaw} {expected}");
}

/// 3 m ahead and 4 m to port of the place in axes of a heading of 30 degrees, which the ship is 90 degrees beyond: -4 m ahead
/// along her own, and 3 m to starboard.
#[test]
fn a_soft_hold_reports_offset_and_force_along_the_ships_heading() {
    let (sin, cos) = libm::sincos(30_f64.to_radians());
    let initial =
        format!("position_m: [{}, {}, 3], orientation_deg: [0, 0, 120]", 3.0 * cos - 4.0 * sin, 3.0 * sin + 4.0 * cos);
    let mut ship =
        simulation(&ship(&initial, [0.0; 3], ", natural_periods_s: [100, 100, 80], target: {heading_deg: 30}"));
    let (mass, inertia, omega) = (1e6, 4.01e8, TAU / 100.0);
    let expected = [4.0, -3.0, TAU / 4.0];
    let stiffness = [mass * omega * omega, mass * omega * omega, inertia * 1.5625 * omega * omega];
    let [deviation, force] = ["hold_deviation", "hold_force"].map(|of| values(&mut ship, of));
    for k in 0..3 {
        assert!((deviation[k] - expected[k]).abs() < 1e-12, "{deviation:?}");
        assert!((force[k] / (-stiffness[k] * expected[k]) - 1.0).abs() < 1e-12, "{force:?}");
    }
    let stored = 0.5 * (0..3).map(|k| stiffness[k] * expected[k] * expected[k]).sum::<f64>();
    assert!((values(&mut ship, "potential_energy")[0] / stored - 1.0).abs() < 1e-12);
}

/// For a ship that tumbles far from its target, the error of the ledger falls with the scheme's order, 4.
#[test]
fn its_energy_closes_to_the_order_of_the_scheme() {
    let initial = "position_m: [10, -5, 3], orientation_deg: [20, 10, 60], velocity_m_s: [1, 2, 0], \
                   angular_velocity_rad_s: [0.02, 0.015, 0.03]";
    let error = |step_s: f64| {
        let text = ship(initial, [5.0, 2.0, 20.0], "").replace("step_s: 0.1", &format!("step_s: {step_s}"));
        let mut ship = simulation(&text);
        ship.step((60.0 / step_s) as usize).unwrap();
        assert!(values(&mut ship, "energy_dissipated")[0] > 1e5);
        values(&mut ship, "energy_error")[0]
    };
    let (coarse, fine) = (error(0.5), error(0.25));
    let order = (coarse / fine).log2();
    assert!((order - 4.0).abs() < 0.3, "{order} from {coarse} and {fine}");
}

#[test]
fn a_soft_hold_is_linearised_exactly() {
    let initial = "position_m: [10, -5, 3], orientation_deg: [20, 10, 60], velocity_m_s: [1, 2, 0]";
    assert_linearised(&ship(initial, [5.0, 2.0, 20.0], ", target: {heading_deg: -20}"));
}

fn held_barge(hold: Value) -> Simulation {
    barge::scenario(&[("forces.hold", json!({"soft_hold": hold}))]).simulation().expect("it builds")
}

/// Eigenvalues about rest on the water. The mass is that of slow motions: what a decaying swing differs from that at
/// frequency zero by is 1.4 zeta omega / 1.96 of the memory's mass (the next term of K(s) / s), 1 % of 8 % of the whole; added
/// mass couples sway and yaw, 0.15 m apart, by 1e-4 of both; roll and pitch are 30 times as fast, and follow. The waves that
/// the barge makes add B / 2 m omega to the damping ratio, 0.0013 at most.
#[test]
fn a_barge_on_a_soft_hold_swings_with_the_specified_periods() {
    let periods_s = [100.0, 130.0, 80.0];
    let scenario =
        barge::scenario(&[("forces.hold", json!({"soft_hold": {"body": "hull", "natural_periods_s": periods_s}}))]);
    let mut afloat = scenario.simulation().expect("it builds");
    afloat.settle().expect("it rests");
    let linear = Linearizer::new(&scenario).expect("it builds").at(&afloat);
    let roots = linear.a.complex_eigenvalues();
    for period_s in periods_s {
        let (omega, zeta) = (TAU / period_s, 0.2);
        let far = |re: f64, im: f64| libm::hypot(re + zeta * omega, im - omega * libm::sqrt(1.0 - zeta * zeta));
        let nearest = roots.iter().min_by(|a, b| far(a.re, a.im).total_cmp(&far(b.re, b.im))).expect("some");
        let size = libm::hypot(nearest.re, nearest.im);
        assert!((size / omega - 1.0).abs() < 1e-3, "{period_s} s: {} s", TAU / size);
        assert!((-nearest.re / size - zeta).abs() < 2e-3, "{period_s} s: {}", -nearest.re / size);
    }
}

/// Checks the stiffness by the barge's own mass, 410 t with mast and load, and that of the water by formula:
/// A(w) = A_inf + Im K / w, even in the frequency, at 1e-5 rad/s.
#[test]
fn the_stiffness_of_a_soft_hold_includes_the_added_mass() {
    let [full, without, dry] = [(true, true), (false, true), (false, false)].map(|(radiation, added_mass)| {
        let of_water = |field: &str| format!("forces.water.hydrodynamics.{field}");
        let (radiated, added) = (of_water("radiation"), of_water("added_mass"));
        let more = [
            ("forces.hold", json!({"soft_hold": {"body": "hull"}})),
            (radiated.as_str(), json!(radiation)),
            (added.as_str(), json!(added_mass)),
        ];
        let setup = barge::scenario(&more).setup().expect("it builds");
        let [surge, sway, _] = of_kind::<f64, SoftHold>(&setup.elements).next().expect("a hold").stiffness;
        [surge, sway].map(|k| k * 120.0 * 120.0 / (TAU * TAU))
    });
    let a = barge::added_mass_infinite();
    for mode in 0..2 {
        let memory = barge::retardation(mode, 1e-5)[1] / 1e-5;
        assert!((dry[mode] / 4.1e5 - 1.0).abs() < 1e-12, "{}", dry[mode]);
        assert!((without[mode] / (4.1e5 + a[mode][mode]) - 1.0).abs() < 1e-12, "{}", without[mode]);
        assert!((full[mode] / (4.1e5 + a[mode][mode] + memory) - 1.0).abs() < 1e-9, "{}", full[mode]);
    }
}

/// Without a target the ship is held at its initial position; at equilibrium, heeled and trimmed, the held
/// point is there.
#[test]
fn a_ship_is_held_where_it_starts_and_rests_there() {
    let mut moved = held_barge(json!({"body": "hull"}));
    assert!(values(&mut moved, "hold_deviation").iter().all(|off| off.abs() < 1e-12));
    moved.settle().expect("it rests");
    assert!(values(&mut moved, "hold_deviation").iter().all(|off| off.abs() < 1e-9));
    let mut elsewhere = held_barge(json!({"body": "hull", "target": {"x_m": 7, "y_m": -2, "heading_deg": 200}}));
    elsewhere.settle().expect("it rests");
    let place = values(&mut elsewhere, "position");
    // The drawing frame's origin is on the keel: at the target but for heel and trim, some 0.1 m.
    assert!((place[0] - 7.0).abs() < 0.2 && (place[1] + 2.0).abs() < 0.2, "{place:?}");
    assert!((values(&mut elsewhere, "yaw")[0] - (200_f64 - 360.0).to_radians()).abs() < 1e-6);
}

#[test]
fn an_invalid_soft_hold_is_refused_at_its_field() {
    let told = |text: &str| read(text, "test.yaml", &[]).expect_err("it is refused").to_string();
    let text = ship("position_m: [0, 0, 3]", [0.0, 0.0, 5.0], "");
    let words = told(&text.replace("body: ship", "body: mast"));
    assert!(words.contains("forces.hold.soft_hold.body: found mast, whose joint is fixed, allowed: a body"), "{words}");
    let words = told(&text.replace("body: ship", "body: boat"));
    assert!(words.contains("forces.hold.soft_hold.body: found boat"), "{words}");
    let words = told(&text.replace("body: ship", "body: ship, natural_periods_s: [120, 0, 120]"));
    assert!(words.contains("natural_periods_s") && words.contains("greater than 0"), "{words}");
    let raos = "direction_to_deg,period_s,surge_forward_m_per_m,surge_lag_deg,sway_port_m_per_m,sway_lag_deg,heave_up_m_per_m,\
                heave_lag_deg,roll_port_up_deg_per_m,roll_lag_deg,pitch_bow_down_deg_per_m,pitch_lag_deg,\
                yaw_bow_port_deg_per_m,yaw_lag_deg\n";
    let row = |at: &str| format!("{at},0,0,0,0,1,0,0,0,0,0,0,0\n");
    let raos = raos.to_owned() + &["0,8", "0,12", "180,8", "180,12"].map(row).concat();
    let files = Files::new([("ship.csv".to_owned(), raos)]);
    let waves = [("bodies.hull.joint".to_owned(), json!({"moved_by_waves": {"raos": "ship.csv", "symmetric": true}}))];
    let hold = [("forces.hold".to_owned(), json!({"soft_hold": {"body": "hull"}}))];
    let text = barge::TEXT
        .replace("  water: {hydrodynamics: {body: hull, database: barge.hydro.json, origin_m: [0, 0, 2]}}", "");
    let words = read_with(&text, "barge.yaml", &[waves, hold].concat(), &files).expect_err("refused").to_string();
    assert!(words.contains("hull, whose joint is moved_by_waves"), "{words}");
}
