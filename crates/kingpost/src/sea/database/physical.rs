//! Physical checks of coefficients: symmetry at zero speed, and radiation that only dissipates energy.

use nalgebra::{Complex, DMatrix};

use super::error::{Checked, unless};
use super::{Database, MODES, Matrix, Memory};

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

/// Matrices of one kind over the modes of one hull, or over those of several.
struct Matrices<'a> {
    field: &'a str,
    all: &'a [Matrix],
    /// Scale of each diagonal.
    scale: Vec<f64>,
    modes: &'a [String],
}

/// Added mass and damping over the modes of one hull, or over those of several.
pub(super) struct Coefficients<'a> {
    /// Added mass by frequency.
    pub added_mass: &'a [Matrix],
    /// Damping by frequency.
    pub damping: &'a [Matrix],
    /// Added mass at infinite frequency.
    pub infinite: &'a Matrix,
    /// Names of the modes.
    pub modes: &'a [String],
}

/// Checks A and B by potential theory: J. N. Newman, Marine Hydrodynamics, MIT Press 1977, sections 6.15 and 6.17. `hulls` are
/// those whose modes follow one another in the matrices.
pub(super) fn check_matrices(given: &Coefficients<'_>, hulls: &[&Database]) -> Checked {
    let (field, infinite) = ("added_mass_infinite", core::slice::from_ref(given.infinite));
    let mass = scale(given.added_mass, infinite, &of_all(hulls, displaced));
    let of = |field, all, scale: &[f64]| Matrices { field, all, scale: scale.to_vec(), modes: given.modes };
    of("added_mass", given.added_mass, &mass).check_symmetric()?;
    of(field, infinite, &mass).check_symmetric()?;
    of(field, infinite, &mass).check_not_negative()?;
    let displaced = of_all(hulls, |hull| displaced(hull).map(|inertia| inertia * rate(hull)));
    let damping = of("radiation_damping", given.damping, &scale(given.damping, &[], &displaced));
    damping.check_symmetric()?;
    damping.check_not_negative()
}

fn of_all(hulls: &[&Database], of: impl Fn(&Database) -> [f64; 6]) -> Vec<f64> {
    hulls.iter().flat_map(|hull| of(hull)).collect()
}

/// Returns the maximum of each diagonal, at least a small share of the displaced water's inertia.
fn scale(first: &[Matrix], second: &[Matrix], displaced: &[f64]) -> Vec<f64> {
    let largest = |(i, displaced): (usize, &f64)| {
        first.iter().chain(second).map(|matrix| matrix[i][i]).fold(SMALL * displaced, f64::max)
    };
    displaced.iter().enumerate().map(largest).collect()
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

impl Matrices<'_> {
    fn check_symmetric(&self) -> Checked {
        for (k, matrix) in self.all.iter().enumerate() {
            for (i, j) in (0..matrix.len()).flat_map(|i| (0..i).map(move |j| (i, j))) {
                let (there, back) = (matrix[i][j], matrix[j][i]);
                let close = (there - back).abs() <= ASYMMETRY * libm::sqrt(self.scale[i] * self.scale[j]);
                let found = || format!("{there} from {} to {} but {back} back", self.modes[j], self.modes[i]);
                let allowed = format!("symmetric matrices, to {ASYMMETRY} of the diagonals' largest");
                unless(close, &at(self.field, k, self.all), found(), &allowed)?;
            }
        }
        Ok(())
    }

    fn check_not_negative(&self) -> Checked {
        for (k, matrix) in self.all.iter().enumerate() {
            let entry = |i: usize, j: usize| 0.5 * (matrix[i][j] + matrix[j][i]);
            let scaled = DMatrix::from_fn(matrix.len(), matrix.len(), |i, j| {
                entry(i, j) / libm::sqrt(self.scale[i] * self.scale[j])
            });
            let finite = scaled.iter().all(|entry| entry.is_finite());
            let lowest = if finite { scaled.symmetric_eigenvalues().min() } else { f64::NAN };
            let found = format!("an eigenvalue of {lowest:.3} of its symmetric part, over the diagonals' largest");
            unless(lowest >= -NEGATIVE, &at(self.field, k, self.all), found, &format!("-{NEGATIVE} or more"))?;
        }
        Ok(())
    }
}

fn at(field: &str, k: usize, matrices: &[Matrix]) -> String {
    if matrices.len() > 1 { format!("{field}.{k}") } else { field.to_owned() }
}

/// Checks that the memory exerts no force on a steady drift, `K(0) = 0`, and does not add energy at any
/// frequency of the database.
pub(super) fn check_radiation(memory: &Memory, frequencies_rad_s: &[f64], modes: &[String]) -> Checked {
    let (still, parts) = (response(memory, 0.0), largest_parts(memory));
    let count = memory.len();
    for (i, j) in (0..count).flat_map(|i| (0..count).map(move |j| (i, j))) {
        let drag = still[(i, j)].re;
        let found = format!("a drag of {drag:.3e} in {} on a steady drift", modes[i]);
        let allowed = "poles and residues that sum to 0 at zero frequency, in every digit";
        unless(drag.abs() <= DRIFT * parts[(i, j)].re, &format!("radiation.modes.{j}"), found, allowed)?;
    }
    let responses: Vec<_> = frequencies_rad_s.iter().map(|omega| response(memory, *omega)).collect();
    let peak = |i: usize| responses.iter().map(|k| size(k[(i, i)])).fold(0.0, f64::max);
    let scale: Vec<f64> = (0..count).map(|i| if peak(i) > 0.0 { peak(i) } else { 1.0 }).collect();
    let real = |k: &DMatrix<Complex<f64>>| (0..count).map(|i| (0..count).map(|j| k[(i, j)].re).collect()).collect();
    let all: Vec<Matrix> = responses.iter().map(real).collect();
    Matrices { field: "radiation", all: &all, scale, modes }.check_not_negative()
}

/// Returns `K_ij(j w)`, with the mode i of the force and the mode j of the motion.
fn response(memory: &Memory, omega_rad_s: f64) -> DMatrix<Complex<f64>> {
    let s = Complex::new(0.0, omega_rad_s);
    sum(memory, |pole, residue| {
        let own = residue / (s - pole);
        if pole.im == 0.0 { own } else { own + residue.conj() / (s - pole.conj()) }
    })
}

/// Returns the sums of `|r / p|`.
fn largest_parts(memory: &Memory) -> DMatrix<Complex<f64>> {
    sum(memory, |pole, residue| Complex::new(2.0 * size(residue) / size(pole), 0.0))
}

fn sum(memory: &Memory, part: impl Fn(Complex<f64>, Complex<f64>) -> Complex<f64>) -> DMatrix<Complex<f64>> {
    let mut found = DMatrix::zeros(memory.len(), memory.len());
    for (j, mode) in memory.iter().enumerate() {
        for (&[re, im], residues) in mode.poles_rad_s.iter().zip(&mode.residues) {
            for (i, &[real, imaginary]) in residues.iter().enumerate() {
                found[(i, j)] += part(Complex::new(re, im), Complex::new(real, imaginary));
            }
        }
    }
    found
}

fn size(number: Complex<f64>) -> f64 {
    libm::hypot(number.re, number.im)
}

/// Returns the names of the modes of one hull.
pub(super) fn modes_of_one() -> Vec<String> {
    MODES.map(str::to_owned).to_vec()
}
