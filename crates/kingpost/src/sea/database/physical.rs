//! Physical checks of coefficients: symmetry at zero speed, and radiation that only dissipates energy.

use nalgebra::{Complex, Matrix6};

use super::error::{Checked, unless};
use super::{Database, MODES, RadiationModel, SixBySix};

/// Largest allowed asymmetry `|M_ij - M_ji|`, as a share of the root of the product of both diagonals, each
/// at its maximum: panel methods give only approximate symmetry.
const ASYMMETRY: f64 = 0.05;

/// Largest allowed magnitude of a negative eigenvalue of a symmetric part, after scaling to diagonals of at
/// most 1.
const NEGATIVE: f64 = 0.05;

/// Smallest scale of a diagonal, as a share of the displaced water's inertia: a rolling sphere, for example,
/// has no added inertia.
const SMALL: f64 = 0.01;

/// Largest allowed sum of the memory's terms at zero frequency, which should be 0, as a share of the terms:
/// the rounding of seven digits.
const DRIFT: f64 = 1e-5;

/// Checks A and B by potential theory: J. N. Newman, Marine Hydrodynamics, MIT Press 1977, sections 6.15 and 6.17.
pub(super) fn check_matrices(database: &Database) -> Checked {
    let infinite = core::slice::from_ref(&database.added_mass_infinite);
    let mass = scale(&database.added_mass, infinite, displaced(database));
    check_symmetric("added_mass", &database.added_mass, &mass)?;
    check_symmetric("added_mass_infinite", infinite, &mass)?;
    check_not_negative("added_mass_infinite", infinite, &mass)?;
    let damping = scale(&database.radiation_damping, &[], displaced(database).map(|inertia| inertia * rate(database)));
    check_symmetric("radiation_damping", &database.radiation_damping, &damping)?;
    check_not_negative("radiation_damping", &database.radiation_damping, &damping)
}

/// Returns the maximum of each diagonal, at least a small share of the displaced water's inertia.
fn scale(first: &[SixBySix], second: &[SixBySix], displaced: [f64; 6]) -> [f64; 6] {
    let largest = |i: usize| first.iter().chain(second).map(|matrix| matrix[i][i]).fold(SMALL * displaced[i], f64::max);
    core::array::from_fn(largest)
}

/// Returns the scale of each diagonal of B; smaller values count as no damping.
pub(super) fn damping_scale(database: &Database) -> [f64; 6] {
    displaced(database).map(|inertia| SMALL * inertia * rate(database))
}

/// Returns mass and inertia of the displaced water, approximated by a block of the hull's length and beam.
fn displaced(database: &Database) -> [f64; 6] {
    let (hull, mass) = (&database.hull, database.water.density_kg_m3 * database.hull.volume_m3);
    let about = |extent: f64| mass * extent * extent / 12.0;
    [mass, mass, mass, about(hull.beam_m), about(hull.length_m), about(hull.length_m)]
}

/// Returns a characteristic frequency of the hull, `sqrt(g / V^(1/3))`, rad/s.
fn rate(database: &Database) -> f64 {
    libm::sqrt(database.water.gravity_m_s2 / libm::cbrt(database.hull.volume_m3))
}

fn check_symmetric(field: &str, matrices: &[SixBySix], scale: &[f64; 6]) -> Checked {
    for (k, matrix) in matrices.iter().enumerate() {
        for (i, j) in (0..6).flat_map(|i| (0..i).map(move |j| (i, j))) {
            let (there, back) = (matrix[i][j], matrix[j][i]);
            let close = (there - back).abs() <= ASYMMETRY * libm::sqrt(scale[i] * scale[j]);
            let found = || format!("{there} from {} to {} but {back} back", MODES[j], MODES[i]);
            let allowed = format!("symmetric matrices, to {ASYMMETRY} of the diagonals' largest");
            unless(close, &at(field, k, matrices), found(), &allowed)?;
        }
    }
    Ok(())
}

fn check_not_negative(field: &str, matrices: &[SixBySix], scale: &[f64; 6]) -> Checked {
    for (k, matrix) in matrices.iter().enumerate() {
        let scaled = Matrix6::from_fn(|i, j| 0.5 * (matrix[i][j] + matrix[j][i]) / libm::sqrt(scale[i] * scale[j]));
        let finite = scaled.iter().all(|entry| entry.is_finite());
        let lowest = if finite { scaled.symmetric_eigenvalues().min() } else { f64::NAN };
        let found = format!("an eigenvalue of {lowest:.3} of its symmetric part, over the diagonals' largest");
        unless(lowest >= -NEGATIVE, &at(field, k, matrices), found, &format!("-{NEGATIVE} or more"))?;
    }
    Ok(())
}

fn at(field: &str, k: usize, matrices: &[SixBySix]) -> String {
    if matrices.len() > 1 { format!("{field}.{k}") } else { field.to_owned() }
}

/// Checks that the memory exerts no force on a steady drift, `K(0) = 0`, and does not add energy at any
/// frequency of the database.
pub(super) fn check_radiation(model: &RadiationModel, frequencies_rad_s: &[f64]) -> Checked {
    let (still, parts) = (response(model, 0.0), largest_parts(model));
    for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
        let drag = still[i][j].re;
        let found = format!("a drag of {drag:.3e} in {} on a steady drift", MODES[i]);
        let allowed = "poles and residues that sum to 0 at zero frequency, in every digit";
        unless(drag.abs() <= DRIFT * parts[i][j], &format!("radiation.modes.{j}"), found, allowed)?;
    }
    let responses: Vec<_> = frequencies_rad_s.iter().map(|omega| response(model, *omega)).collect();
    let peak = |i: usize| responses.iter().map(|k| size(k[i][i])).fold(0.0, f64::max);
    let largest: [f64; 6] = core::array::from_fn(|i| if peak(i) > 0.0 { peak(i) } else { 1.0 });
    let real = |k: &[[Complex<f64>; 6]; 6]| k.map(|row| row.map(|entry| entry.re));
    let damping: Vec<SixBySix> = responses.iter().map(real).collect();
    check_not_negative("radiation", &damping, &largest)
}

/// Returns `K_ij(j w)`, with the mode i of the force and the mode j of the motion.
fn response(model: &RadiationModel, omega_rad_s: f64) -> [[Complex<f64>; 6]; 6] {
    let s = Complex::new(0.0, omega_rad_s);
    sum(model, |pole, residue| {
        let own = residue / (s - pole);
        if pole.im == 0.0 { own } else { own + residue.conj() / (s - pole.conj()) }
    })
}

/// Returns the sums of `|r / p|`.
fn largest_parts(model: &RadiationModel) -> [[f64; 6]; 6] {
    sum(model, |pole, residue| Complex::new(2.0 * size(residue) / size(pole), 0.0)).map(|row| row.map(|x| x.re))
}

fn sum(model: &RadiationModel, part: impl Fn(Complex<f64>, Complex<f64>) -> Complex<f64>) -> [[Complex<f64>; 6]; 6] {
    let mut found = [[Complex::new(0.0, 0.0); 6]; 6];
    for (j, mode) in model.modes.iter().enumerate() {
        for (&[re, im], residues) in mode.poles_rad_s.iter().zip(&mode.residues) {
            for (row, &[real, imaginary]) in found.iter_mut().zip(residues) {
                row[j] += part(Complex::new(re, im), Complex::new(real, imaginary));
            }
        }
    }
    found
}

fn size(number: Complex<f64>) -> f64 {
    libm::hypot(number.re, number.im)
}
