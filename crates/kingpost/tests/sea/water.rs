//! Hulls in the water: statics, energy, waves, memory.

use crate::common;

use common::barge::{self, BEAM, DENSITY, GRAVITY, LENGTH, scenario};
use kingpost::results::Channel;
use kingpost::scenario::Files;
use kingpost::simulation::{Run, Simulation};
use serde_json::{Value, json};

const ON: Value = Value::Bool(true);
const OFF: Value = Value::Bool(false);
const RADIATION: &str = "forces.water.hydrodynamics.radiation";
const HYDROSTATICS: &str = "forces.water.hydrodynamics.hydrostatics";
const BEGIN: &str = "simulation.begin_at_equilibrium";
const MAST: &str = "bodies.mast.joint.prismatic.position_m";
const SWELL: &str = "sea.waves.swell.regular.enabled";

/// Returns the values of one entry of a channel over a run.
fn column(channels: &[Channel], run: &Run, variable: &str, entry: usize) -> Vec<f64> {
    let channel = channels.iter().find(|channel| channel.variable == variable).expect("a channel");
    run.rows.chunks_exact(run.columns).map(|row| row[channel.offset + entry]).collect()
}

fn run(simulation: &mut Simulation) -> Run {
    let run = simulation.run(|_| true);
    run.status.as_ref().unwrap_or_else(|error| panic!("{error}"));
    run
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| value.abs().max(most))
}

/// A barge that rolls, pitches and drifts, with a swinging load.
const MOTION: [(&str, &str); 2] = [
    ("bodies.hull.joint.floating.initial.orientation_rad", "[0.05, 0.02, 0.4]"),
    ("bodies.hull.joint.floating.initial.velocity_m_s", "[0.5, -0.3, 0.2]"),
];

fn moving(more: &[(&'static str, Value)]) -> Vec<(&'static str, Value)> {
    let given = MOTION.iter().map(|(name, value)| (*name, serde_json::from_str(value).expect("a list")));
    given.chain(more.iter().cloned()).collect()
}

#[test]
fn energy_closes_with_the_added_mass_and_without_memory() {
    for hydrostatics in ["linear", "mesh"] {
        let error = |step_s: f64| {
            let overrides = moving(&[
                (RADIATION, OFF),
                (HYDROSTATICS, json!(hydrostatics)),
                ("simulation.step_s", json!(step_s)),
                ("bodies.load.joint.universal.first.initial_angle_rad", json!(0.3)),
            ]);
            let mut simulation = Simulation::new(scenario(&overrides).setup().expect("it builds"));
            let run = run(&mut simulation);
            let of = |variable: &str| column(simulation.channels(), &run, variable, 0);
            let energies = of("kinetic_energy");
            assert!(largest(&of("water_kinetic_energy")) > 0.2 * largest(&energies), "the water has its part");
            largest(&of("energy_error")) / largest(&energies)
        };
        // Runge-Kutta's order 4: half the step leaves a sixteenth; the mesh is smooth but at its edges.
        let (coarse, fine) = (error(0.04), error(0.02));
        assert!(fine < 1e-6, "{hydrostatics}: {fine:e}");
        assert!(coarse / fine > 12.0, "{hydrostatics}: {coarse:e} -> {fine:e}");
    }
}

#[test]
fn the_water_and_the_ship_keep_their_momentum_along_the_water_plane() {
    let mut simulation = Simulation::new(scenario(&moving(&[(RADIATION, OFF)])).setup().expect("it builds"));
    let run = run(&mut simulation);
    for axis in [0, 1] {
        let momentum = column(simulation.channels(), &run, "linear_momentum", axis);
        let change = momentum.iter().map(|p| p - momentum[0]).fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!(change < 1e-9 * largest(&momentum), "{axis}: {change:e}");
    }
    // And what buoyancy turns is in the balance.
    let error = column(simulation.channels(), &run, "momentum_error", 0);
    let size = largest(&column(simulation.channels(), &run, "angular_momentum", 0));
    assert!(largest(&error) < 1e-6 * size, "{:e} of {size:e}", largest(&error));
}

#[test]
fn the_heel_of_a_barge_by_a_load_moved_athwartships_is_the_static_heel() {
    // Wall-sided and upright: W (KB + BM sec-form) balances when the centres are above one another.
    // Of a box: sin(phi) (GM + BM tan^2(phi) / 2) = moment cos(phi) / W, the hanging load at its sheave.
    let shift = 5.0;
    let weights = [(380e3, 2.0), (20e3, 7.0), (10e3, 9.0)];
    let total: f64 = weights.iter().map(|(mass, _)| mass).sum();
    let centre = weights.iter().map(|(mass, height)| mass * height).sum::<f64>() / total;
    let draught = total / (DENSITY * LENGTH * BEAM);
    let bm = BEAM * BEAM / (12.0 * draught);
    let gm = 0.5 * draught + bm - centre;
    let arm = 30e3 * shift / total;
    let mut phi = 0.0_f64;
    for _ in 0..50 {
        let (sin, cos, tan) = (phi.sin(), phi.cos(), phi.tan());
        let off = sin * (gm + 0.5 * bm * tan * tan) - arm * cos;
        phi -= off / (cos * (gm + bm * tan * tan) + bm * tan / cos + arm * sin).max(1e-3);
    }
    let overrides =
        [("shift_m", json!(shift)), (MAST, json!([0.0, 0.0, 7.0])), (HYDROSTATICS, json!("mesh")), (BEGIN, ON)];
    let mut simulation = Simulation::new(scenario(&overrides).setup().expect("it builds"));
    let mut row = Vec::new();
    simulation.write_row(&mut row);
    let at = |variable: &str| simulation.channels().iter().find(|c| c.variable == variable).expect("a channel").offset;
    // Mast to port: the starboard side comes up.
    let roll = row[at("roll")];
    assert!((-roll / phi - 1.0).abs() < 1e-4, "roll {roll}, heel {phi}");
    assert!(phi > 0.05 && phi.tan() < (barge::DEPTH - draught) / (0.5 * BEAM), "the deck stays dry");
}

#[test]
fn linear_and_mesh_hydrostatics_agree_at_small_angles() {
    let place = |hydrostatics: &str| {
        let overrides =
            [("shift_m", json!(0.5)), (MAST, json!([0.0, 0.0, 7.0])), (HYDROSTATICS, json!(hydrostatics)), (BEGIN, ON)];
        scenario(&overrides).setup().expect("it builds").q
    };
    let (linear, mesh) = (place("linear"), place("mesh"));
    // The draught by weight is exact in both; heel differs by the third order of the angle.
    let roll = 2.0 * mesh[4];
    assert!((linear[2] - mesh[2]).abs() < roll * roll, "{} {}", linear[2], mesh[2]);
    assert!((linear[4] / mesh[4] - 1.0).abs() < 10.0 * roll * roll, "{} {}", linear[4], mesh[4]);
    let draught = 410e3 / (DENSITY * LENGTH * BEAM);
    assert!((linear[2] - (2.0 - draught)).abs() < 1e-3, "{}", linear[2]);
}

/// The barge has always moved in this way relative to the water, so there is no transient.
#[test]
fn a_steady_drift_in_calm_water_leaves_no_drag() {
    let overrides = [
        ("bodies.load.enabled", OFF),
        // Along its axis: aslant, potential flow would turn it (Munk).
        ("bodies.hull.joint.floating.initial.velocity_m_s", json!([1.0, 0.0, 0.0])),
        (MAST, json!([0.0, 0.0, 7.0])),
        (BEGIN, ON),
        ("simulation.duration_s", json!(300.0)),
        ("simulation.record_every_s", json!(1.0)),
    ];
    let mut simulation = Simulation::new(scenario(&overrides).setup().expect("it builds"));
    let run = run(&mut simulation);
    for speed in column(simulation.channels(), &run, "velocity", 0) {
        assert!((speed - 1.0).abs() < 1e-9, "{speed}");
    }
}

/// A line of 2e5 N/m pulls the barge by 2 m and becomes slack. After the waves from the pull have radiated
/// away, the speed stays constant.
#[test]
fn a_hull_that_was_pulled_radiates_waves_and_then_drifts_without_drag() {
    let line = json!({"spring_line": {
        "first": {"body": "hull", "position_m": [0, 0, 2]}, "second": {"body": "world", "position_m": [500, 0, 0]},
        "unstretched_length_m": 498, "axial_stiffness_N": 2e5 * 498.0,
    }});
    let overrides = [
        ("bodies.load.enabled", OFF),
        ("forces.line", line),
        (MAST, json!([0.0, 0.0, 7.0])),
        ("simulation.duration_s", json!(300.0)),
        ("simulation.record_every_s", json!(1.0)),
    ];
    let scenario = scenario(&overrides);
    let mut simulation = Simulation::new(scenario.setup().expect("it builds"));
    let run = run(&mut simulation);
    let speeds = column(simulation.channels(), &run, "velocity", 0);
    let (then, end) = (speeds[200], speeds[300]);
    assert!((end / then - 1.0).abs() < 1e-6, "{then} -> {end}");
    // Of the 4e5 J in the line the waves took a part, but not the most.
    let kinetic = 0.5 * (410e3 + barge::added_mass_infinite()[0][0]) * end * end;
    assert!(kinetic < 0.99 * 4e5 && kinetic > 0.5 * 4e5, "{kinetic} J");
}

#[test]
fn a_regular_wave_gives_the_heave_of_the_transfer_function() {
    // One degree of freedom: (C - w^2 (m + A) - i w B) xi = X a, in heave over the reference point.
    let period = 6.0;
    let omega = core::f64::consts::TAU / period;
    let overrides = [
        (SWELL, ON),
        ("sea.waves.swell.regular.height_m", json!(0.2)),
        ("bodies.load.enabled", OFF),
        ("bodies.hull.joint.floating.hold_rotation", ON),
        // Waves that begin at once would push it into a drift, and it would meet them at another period.
        ("sea.ramp_s", json!(60.0)),
        (MAST, json!([0.0, 0.0, 7.0])),
        (BEGIN, ON),
        ("simulation.duration_s", json!(180.0)),
        ("simulation.record_every_s", json!(0.02)),
    ];
    let mut simulation = Simulation::new(scenario(&overrides).setup().expect("it builds"));
    let run = run(&mut simulation);
    let of = |variable: &str, entry| column(simulation.channels(), &run, variable, entry);
    let (times, heave, wave) = (of("time", 0), of("position", 2), of("wave_elevation", 0));
    let phasor = |values: &[f64]| {
        // Over the last ten periods.
        let from = values.len() - 1 - (10.0 * period / 0.02) as usize;
        let (mut re, mut im) = (0.0, 0.0);
        for (value, time) in values[from..].iter().zip(&times[from..]).skip(1) {
            re += value * libm::cos(omega * time);
            im += value * libm::sin(omega * time);
        }
        let n = 0.5 * (values.len() - 1 - from) as f64;
        [re / n, im / n]
    };
    let [b, reactance] = barge::retardation(2, omega);
    let mass = 400e3 + barge::added_mass_infinite()[2][2];
    let stiffness = DENSITY * GRAVITY * LENGTH * BEAM;
    let (re, im) = (stiffness - omega * omega * mass - omega * reactance, -omega * b);
    let x = barge::excitation(omega, 0.0)[2][0];
    let scale = x / (re * re + im * im);
    let (rao_re, rao_im) = (scale * re, -scale * im);
    let [z_re, z_im] = phasor(&heave);
    let [w_re, w_im] = phasor(&wave);
    // z = H w
    let (expected_re, expected_im) = (rao_re * w_re - rao_im * w_im, rao_re * w_im + rao_im * w_re);
    let size = libm::hypot(expected_re, expected_im);
    let off = libm::hypot(z_re - expected_re, z_im - expected_im) / size;
    assert!(off < 0.01, "{off}: {z_re} {z_im}, expected {expected_re} {expected_im}");
    assert!((libm::hypot(w_re, w_im) - 0.1).abs() < 2e-4, "the wave has its amplitude");
}

#[test]
fn radiated_waves_of_random_motions_never_return_more_energy_than_they_took() {
    // Positive real: the work of the radiation force from rest is never positive.
    let text = barge::database();
    let database = kingpost::sea::database::Database::read(&text).expect("a database");
    let radiation = kingpost::elements::hull::Radiation::new(&database.radiation.expect("a model"));
    let noise = kingpost::sea::waves::Noise::new(3);
    for motion in 0..20 {
        let n = radiation.state_count();
        let (mut states, mut work, h) = (vec![0.0; n], 0.0, 0.005);
        let velocity = |mode: usize, time: f64| {
            (0..4)
                .map(|k| {
                    let at = |part: u64| noise.uniform(motion, 100 * mode as u64 + 10 * part + k);
                    at(0) * libm::sin(5.0 * at(1) * time + 6.0 * at(2))
                })
                .sum::<f64>()
        };
        for step in 0..6000 {
            let time = h * f64::from(step);
            let nu: [f64; 6] = core::array::from_fn(|mode| velocity(mode, time + 0.5 * h));
            let mut rates = vec![0.0; n];
            radiation.rates(&nu, &states, &mut rates);
            let middle: Vec<f64> = states.iter().zip(&rates).map(|(z, rate)| z + 0.5 * h * rate).collect();
            radiation.rates(&nu, &middle, &mut rates);
            states.iter_mut().zip(&rates).for_each(|(z, rate)| *z += h * rate);
            let force = radiation.force(&middle);
            work += h * force.iter().zip(&nu).map(|(f, v)| f * v).sum::<f64>();
            assert!(work < 1e-9 * 4e5, "motion {motion} at {time} s: {work} J");
        }
        assert!(work < -1e3, "motion {motion} made waves: {work} J");
    }
}

#[test]
fn both_forms_of_the_equations_give_a_hull_the_same_motion() {
    let end = |form: &str| {
        let overrides = moving(&[("simulation.form", json!(form)), (SWELL, ON), ("simulation.duration_s", json!(2.0))]);
        let mut simulation = Simulation::new(scenario(&overrides).setup().expect("it builds"));
        simulation.step(100).expect("it runs");
        simulation.state().q.clone()
    };
    for (recursive, matrices) in end("recursive").iter().zip(end("moving_frame")) {
        assert!((recursive - matrices).abs() < 1e-9, "{recursive} {matrices}");
    }
}

#[test]
fn a_run_in_waves_continues_bitwise_identically_from_a_snapshot() {
    let overrides = moving(&[("sea.waves.wind_sea.jonswap.enabled", ON)]);
    let mut simulation = Simulation::new(scenario(&overrides).setup().expect("it builds"));
    simulation.step(100).expect("it runs");
    let snapshot = simulation.snapshot();
    simulation.step(100).expect("it runs");
    let end = simulation.state().clone();
    let mut other = Simulation::new(scenario(&overrides).setup().expect("it builds"));
    other.restore(&snapshot).expect("it is of this run");
    other.step(100).expect("it runs");
    assert_eq!(*other.state(), end);
    assert!(end.v.iter().any(|v| v.abs() > 1e-3));
}

#[test]
fn an_equilibrium_has_the_derivatives_of_its_loads() {
    // The run begins in waves and with the mast under way: the equilibrium knows neither.
    let under_way = json!({"speed_m_s": 0.2, "history": "pulse", "pulse": {"rise_s": 1, "hold_s": 2, "reverse_s": 0}});
    let overrides = [
        ("shift_m", json!(1.0)),
        (HYDROSTATICS, json!("mesh")),
        (BEGIN, ON),
        (SWELL, ON),
        ("bodies.mast.joint.prismatic.mode", json!({"prescribed": under_way})),
    ];
    let names = ["shift_m", "mass", "bodies.hull.mass_kg"];
    let base = scenario(&overrides);
    let exact = base.setup_along(&names).expect("it builds");
    for (k, (name, value)) in names.into_iter().zip([1.0, 1e4, 3.8e5]).enumerate() {
        let step = 1e-4 * value;
        let at = |value: f64| {
            let moved: Vec<_> = overrides.iter().cloned().chain([(name, json!(value))]).collect();
            scenario(&moved).setup().expect("it builds").q
        };
        let (up, down) = (at(value + step), at(value - step));
        // Surge, sway and yaw have no equilibrium: where they end is the iteration's own, but the common centre of
        // mass goes nowhere, and a load of 10 t, a shift of 20 t or twice the mass moves the hull by less than its draught.
        for i in [0, 1] {
            assert!(exact.q[i].derivative[k].abs() * value < 2.0, "{name} {i}: {}", exact.q[i].derivative[k]);
        }
        for (i, q) in exact.q.iter().enumerate().filter(|(i, _)| ![0, 1, 6].contains(i)) {
            let difference = (up[i] - down[i]) / (2.0 * step);
            // The second order of the difference, and what Newton's iteration leaves of q.
            let allowed = 1e-5 * difference.abs() + 1e-8 / step;
            let found = q.derivative[k];
            assert!((found - difference).abs() < allowed, "{name} {i}: {found} {difference}");
        }
    }
}

#[test]
fn runs_in_one_sea_in_lanes_are_bitwise_identical_to_single_runs() {
    use kingpost::batch;
    let variant = |shift: f64| {
        let pairs = [("shift_m", json!(shift)), ("sea.waves.wind_sea.jonswap.enabled", ON), (BEGIN, ON)];
        let pairs = pairs.into_iter().map(|(name, value)| (name.to_owned(), value));
        pairs.chain([("simulation.duration_s".to_owned(), json!(4.0))]).collect::<Vec<_>>()
    };
    let variants: Vec<_> = [0.0, 0.5, 1.0, 1.5, 2.0].map(variant).into();
    let batch = batch::run(barge::TEXT, "barge.yaml", &barge::files(), &variants, 2, |_| true).expect("they build");
    for (variant, found) in variants.iter().zip(&batch.runs) {
        let pairs: Vec<(&str, Value)> = variant.iter().map(|(name, value)| (name.as_str(), value.clone())).collect();
        let mut alone = Simulation::new(scenario(&pairs).setup().expect("it builds"));
        assert_eq!(run(&mut alone).rows, found.rows);
    }
}

/// The share of the energy of the barge's wind sea below w, at gamma = 1, is `e^(-(5/4) (w_p / w)^4)`.
#[test]
fn a_cut_of_a_spectrum_is_described_and_one_of_nothing_is_refused() {
    let jonswap = "sea.waves.wind_sea.jonswap";
    let read = |cuts: &[(&str, f64)]| {
        let mut pairs = vec![(format!("{jonswap}.enabled"), ON)];
        pairs.extend(cuts.iter().map(|(end, w)| (format!("{jonswap}.realisation.{end}"), json!(w))));
        kingpost::scenario::read_with(barge::TEXT, "barge.yaml", &pairs, &barge::files())
    };
    let whole = read(&[]).and_then(|whole| whole.describe()).expect("it builds");
    assert_eq!(whole.sea.expect("a sea").cut_spectra, []);
    let cut = read(&[("highest_rad_s", 1.5)]).and_then(|cut| cut.describe()).expect("it builds");
    let [spectrum] = &cut.sea.expect("a sea").cut_spectra[..] else { panic!("one is cut") };
    let share = 1.0 - (-1.25 * (core::f64::consts::TAU / 6.0 / 1.5).powi(4)).exp();
    assert_eq!(spectrum.name, "wind_sea");
    assert!((spectrum.energy_cut_off - share).abs() < 1e-6, "{spectrum:?} {share}");
    assert!((spectrum.significant_height_m - 2.0).abs() < 1e-6, "{spectrum:?}");
    let none = read(&[("lowest_rad_s", 2.0), ("highest_rad_s", 1.5)]).expect_err("an empty band").to_string();
    let expected = "realisation.highest_rad_s: found 1.5, allowed: a number above lowest_rad_s, which is 2";
    assert!(none.contains(&format!("{jonswap}.{expected}")), "{none}");
    let negative = read(&[("lowest_rad_s", -1.0)]).expect_err("a frequency").to_string();
    assert!(negative.contains(&format!("{jonswap}.realisation.lowest_rad_s: found -1")), "{negative}");
}

#[test]
fn missing_data_of_a_database_are_reported_at_the_field() {
    let error = |overrides: &[(&str, Value)]| {
        let pairs: Vec<(String, Value)> = overrides.iter().map(|(n, v)| ((*n).to_owned(), v.clone())).collect();
        let read = kingpost::scenario::read_with(barge::TEXT, "barge.yaml", &pairs, &barge::files());
        read.expect_err("it is wrong").to_string()
    };
    let field = "forces.water.hydrodynamics.database";
    let other = error(&[(field, json!("ship.hydro.json"))]);
    assert!(other.contains("found no file ship.hydro.json"), "{other}");
    let lake = error(&[("sea.density_kg_m3", json!(1000.0))]);
    assert!(lake.contains(field) && lake.contains("found a density of 1025 kg/m^3"), "{lake}");
    for depth in [50.0, 1e300] {
        // The barge's data are for deep water; no depth is near to none, nor none to a depth.
        let shallow = error(&[("sea.depth_m", json!(depth))]);
        assert!(shallow.contains("found a depth of inf m"), "{shallow}");
        let pool = barge::database().replace("\"depth_m\":null", &format!("\"depth_m\":{depth:e}"));
        let pool = Files::new([("barge.hydro.json".to_owned(), pool)]);
        let deep = kingpost::scenario::read_with(barge::TEXT, "barge.yaml", &[], &pool).expect_err("another depth");
        assert!(deep.to_string().contains("allowed: that of the sea, inf m"), "{deep}");
    }
    let ripples = error(&[
        (SWELL, ON),
        ("sea.waves.swell.regular.height_m", json!(0.1)),
        ("sea.waves.swell.regular.period_s", json!(1.0)),
    ]);
    assert!(ripples.contains("100.0 % of the waves' energy outside"), "{ripples}");
    let weightless = error(&[("forces.gravity.gravity.enabled", OFF)]);
    assert!(weightless.contains("found water on a hull, but no gravity"), "{weightless}");
    let crane = error(&[("forces.water.hydrodynamics.body", json!("mast"))]);
    assert!(crane.contains("a floating joint"), "{crane}");
}
