//! A box barge with invented waves; every coefficient has a formula.

use kingpost::scenario::{Files, Scenario, read_with};
use serde_json::{Value, json};

pub const DENSITY: f64 = 1025.0;
pub const GRAVITY: f64 = 9.80665;
pub const LENGTH: f64 = 20.0;
pub const BEAM: f64 = 10.0;
pub const DRAUGHT: f64 = 2.0;
pub const DEPTH: f64 = 5.0;

/// Added mass at infinite frequency: mode by mode, with coupling of sway and roll, surge and pitch.
pub fn added_mass_infinite() -> [[f64; 6]; 6] {
    let mut a = [[0.0; 6]; 6];
    let diagonal = [6e4, 2e5, 5e5, 4e6, 1.2e7, 6e6];
    (0..6).for_each(|i| a[i][i] = diagonal[i]);
    (a[0][4], a[4][0], a[1][3], a[3][1]) = (-1e5, -1e5, 1.5e5, 1.5e5);
    a
}

/// Strength c of mode i: `K(s) = c s / (s^2 + 2 zeta w s + w^2)`, which is positive real and zero at s = 0.
const STRENGTH: [f64; 6] = [3e4, 9e4, 4e5, 2e6, 8e6, 1e6];
const NATURAL: f64 = 1.4;
const ZETA: f64 = 0.5;

/// K_ii(i w): real part B, imaginary part w (A - A_inf).
pub fn retardation(i: usize, omega: f64) -> [f64; 2] {
    // c i w / (n^2 - w^2 + 2 i zeta n w)
    let (re, im) = (NATURAL * NATURAL - omega * omega, 2.0 * ZETA * NATURAL * omega);
    let scale = STRENGTH[i] * omega / (re * re + im * im);
    [scale * im, scale * re]
}

/// Excitation of long waves: the pressure of the surface on the bottom, `rho g L B e^(-k T)`, in heave,
/// and its slope in surge and sway; no moments.
pub fn excitation(omega: f64, direction: f64) -> [[f64; 2]; 6] {
    let k = omega * omega / GRAVITY;
    let pressure = DENSITY * GRAVITY * LENGTH * BEAM * libm::exp(-k * DRAUGHT);
    let side = pressure * k * DRAUGHT;
    let none = [0.0; 2];
    [[0.0, side * libm::cos(direction)], [0.0, side * libm::sin(direction)], [pressure, 0.0], none, none, none]
}

/// The text of the barge's database.
pub fn database() -> String {
    let omegas: Vec<f64> = (1..=40).map(|i| 0.1 * f64::from(i)).collect();
    let directions: Vec<f64> = (0..12).map(|i| core::f64::consts::TAU * f64::from(i) / 12.0).collect();
    let diagonal = |of: &dyn Fn(usize) -> f64| -> Vec<Vec<f64>> {
        (0..6).map(|i| (0..6).map(|j| if i == j { of(i) } else { 0.0 }).collect()).collect()
    };
    let infinite = added_mass_infinite();
    let added = |omega: f64| -> Vec<Vec<f64>> {
        let more = diagonal(&|i| retardation(i, omega)[1] / omega);
        (0..6).map(|i| (0..6).map(|j| infinite[i][j] + more[i][j]).collect()).collect()
    };
    let waves = |part: usize| -> Vec<Vec<Vec<f64>>> {
        let at = |omega: f64| directions.iter().map(|b| excitation(omega, *b).map(|x| x[part]).to_vec()).collect();
        omegas.iter().map(|omega| at(*omega)).collect()
    };
    let zeros = vec![vec![[0.0; 6]; directions.len()]; omegas.len()];
    let (re, im) = (-ZETA * NATURAL, NATURAL * libm::sqrt(1.0 - ZETA * ZETA));
    let mode = |i: usize| {
        // r = c p / (2 i Im p)
        let residue = [0.5 * STRENGTH[i], -0.5 * STRENGTH[i] * re / im];
        let row: Vec<[f64; 2]> = (0..6).map(|j| if i == j { residue } else { [0.0; 2] }).collect();
        json!({"poles_rad_s": [[re, im]], "residues": [row]})
    };
    let (vertices, triangles) = hull();
    json!({
        "format": "kingpost-hydrodynamics", "version": 1, "title": "An invented barge",
        "provenance": {"tool": "a formula"},
        "water": {"density_kg_m3": DENSITY, "gravity_m_s2": GRAVITY, "depth_m": null},
        "hull": {
            "draught_m": DRAUGHT, "length_m": LENGTH, "beam_m": BEAM,
            "volume_m3": LENGTH * BEAM * DRAUGHT, "centre_of_buoyancy_m": [0.0, 0.0, -0.5 * DRAUGHT],
            "waterplane": {
                "area_m2": LENGTH * BEAM, "first_moments_m3": [0.0, 0.0],
                "second_moments_m4": [BEAM * LENGTH.powi(3) / 12.0, 0.0, LENGTH * BEAM.powi(3) / 12.0],
            },
            "mesh": {"vertices_m": vertices, "triangles": triangles},
        },
        "frequencies_rad_s": omegas, "wave_directions_rad": directions,
        "added_mass": omegas.iter().map(|omega| added(*omega)).collect::<Vec<_>>(),
        "radiation_damping": omegas.iter().map(|w| diagonal(&|i| retardation(i, *w)[0])).collect::<Vec<_>>(),
        "added_mass_infinite": infinite,
        "froude_krylov": {"real": waves(0), "imaginary": waves(1)},
        "diffraction": {"real": zeros, "imaginary": zeros},
        "mean_drift": null,
        "radiation": {"modes": (0..6).map(mode).collect::<Vec<Value>>(), "fit_error": 0.0},
    })
    .to_string()
}

fn hull() -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let (x, y) = (0.5 * LENGTH, 0.5 * BEAM);
    let corner = |i: usize| {
        let sign = |bit: usize| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
        [sign(0) * x, sign(1) * y, if i >> 2 & 1 == 1 { DEPTH - DRAUGHT } else { -DRAUGHT }]
    };
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let split = |[a, b, c, d]: [usize; 4]| [[a, b, c], [a, c, d]];
    ((0..8).map(corner).collect(), quads.into_iter().flat_map(split).collect())
}

/// The barge with a mast that slides athwartships and a pendulum at its head.
pub const TEXT: &str = include_str!("barge.yaml");

/// The barge in a current, on dynamic positioning; `more` settings of the simulation.
pub fn station(more: &str) -> String {
    let thrusters = "bow: {tunnel: {position_m: [8, 0, 1], max_thrust_kN: 40, time_constant_s: 1}}, \
                     port: {azimuth: {position_m: [-8, 3, 0.5], max_thrust_kN: 40, time_constant_s: 1.5}}, \
                     starboard: {azimuth: {position_m: [-8, -3, 0.5], max_thrust_kN: 40, time_constant_s: 1.5}}";
    let gains = "natural_periods: {surge: {mass_t: 470, period_s: 60}, sway: {mass_t: 620, period_s: 60}, \
                 yaw: {inertia_kg_m2: 2.2e7, period_s: 50}}";
    let dp = format!(
        "  dp: {{dynamic_positioning: {{body: hull, position_m: [2, 0, 2], target: {{x_m: 4, y_m: -3, heading_deg: 20}}, \
         wave_filter: {{notch_periods_s: [6], cutoff_period_s: 12}}, gains: {{{gains}}}, \
         thrusters: {{{thrusters}}}}}}}\n"
    );
    let drag = "  drag: {viscous_damping: {body: hull, position_m: [0, 0, 2], linear_N_s_m: [1e4, 3e4, 1e4], \
                angular_N_m_s: [2e6, 4e6, 2e6]}}\n";
    let sea = "sea:\n  current_m_s: [0.5, -0.6]\n";
    TEXT.replace("sea:\n", sea).replace("step_s: 0.02", &format!("step_s: 0.02{more}")) + drag + &dp
}

/// The scenario of the barge, with values set over it.
pub fn scenario(overrides: &[(&str, Value)]) -> Scenario {
    let pairs: Vec<(String, Value)> =
        overrides.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    read_with(TEXT, "barge.yaml", &pairs, &files()).unwrap_or_else(|error| panic!("{error}"))
}

/// The files that it names.
pub fn files() -> Files {
    Files::new([("barge.hydro.json".to_owned(), database())])
}
