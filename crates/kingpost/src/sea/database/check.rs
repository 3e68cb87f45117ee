//! Checks that apply to every database.

use super::error::{Checked, unless};
use super::physical::Coefficients;
use super::{Attitude, Database, ExcitationTable, Matrix, Memory, MemoryOfMode, SixBySix, physical, plausible};

/// Largest deviation of a direction from the regular grid, rad: the rounding of seven digits.
const GRID_TOLERANCE_RAD: f64 = 1e-5;

pub(super) fn check(database: &Database) -> Checked {
    check_format(&database.format, database.version, 1)?;
    check_hull(database)?;
    let matrices = |all: &[SixBySix]| -> Vec<Matrix> { all.iter().map(to_matrix).collect() };
    let (added_mass, damping) = (matrices(&database.added_mass), matrices(&database.radiation_damping));
    let (infinite, modes) = (to_matrix(&database.added_mass_infinite), physical::modes_of_one());
    let given = Coefficients { added_mass: &added_mass, damping: &damping, infinite: &infinite, modes: &modes };
    physical::check_matrices(&given, &[database])?;
    plausible::check(database)?;
    database.radiation.as_ref().map_or(Ok(()), |model| {
        let memory: Memory = model.modes.iter().map(MemoryOfMode::from).collect();
        check_memory(&memory, &database.frequencies_rad_s, &modes)
    })
}

pub(super) fn check_format(format: &str, version: u32, expected: u32) -> Checked {
    unless(format == "kingpost-hydrodynamics", "format", format, "kingpost-hydrodynamics")?;
    unless(version == expected, "version", version, &expected.to_string())
}

/// Checks everything of one hull but the physics of its matrices.
pub(super) fn check_hull(database: &Database) -> Checked {
    check_water_and_hull(database)?;
    check_drift_loading(database)?;
    check_grids(database)?;
    check_matrices(database)?;
    check_excitation("froude_krylov", database, &database.froude_krylov)?;
    check_excitation("diffraction", database, &database.diffraction)?;
    check_mean_drift(database)
}

pub(super) fn check_memory(memory: &Memory, frequencies_rad_s: &[f64], modes: &[String]) -> Checked {
    check_radiation(memory)?;
    physical::check_radiation(memory, frequencies_rad_s, modes)
}

fn to_matrix(rows: &SixBySix) -> Matrix {
    rows.iter().map(|row| row.to_vec()).collect()
}

fn check_water_and_hull(database: &Database) -> Checked {
    let (water, hull) = (&database.water, &database.hull);
    let positive = |field: &str, x: f64| unless(x.is_finite() && x > 0.0, field, x, "a number greater than 0");
    positive("water.density_kg_m3", water.density_kg_m3)?;
    positive("water.gravity_m_s2", water.gravity_m_s2)?;
    positive("water.depth_m", water.depth_m.unwrap_or(1.0))?;
    positive("hull.draught_m", hull.draught_m)?;
    positive("hull.length_m", hull.length_m)?;
    positive("hull.beam_m", hull.beam_m)?;
    positive("hull.volume_m3", hull.volume_m3)?;
    positive("hull.waterplane.area_m2", hull.waterplane.area_m2)?;
    let Some(Attitude { roll_rad, pitch_rad, height_m }) = hull.attitude else { return Ok(()) };
    let below = |x: f64, limit: f64| x.abs() < limit;
    unless(below(roll_rad, core::f64::consts::PI), "hull.attitude.roll_rad", roll_rad, "an angle within half a turn")?;
    let quarter = core::f64::consts::FRAC_PI_2;
    unless(below(pitch_rad, quarter), "hull.attitude.pitch_rad", pitch_rad, "an angle within a quarter of a turn")?;
    unless(height_m.is_finite(), "hull.attitude.height_m", height_m, "a finite number")
}

fn check_drift_loading(database: &Database) -> Checked {
    let Some(loading) = &database.mean_drift_loading else { return Ok(()) };
    let [roll, pitch, yaw] = loading.radii_of_gyration_m;
    let numbers = [
        ("mass_kg", loading.mass_kg),
        ("keel_to_gravity_m", loading.keel_to_gravity_m),
        ("radii_of_gyration_m.0", roll),
        ("radii_of_gyration_m.1", pitch),
        ("radii_of_gyration_m.2", yaw),
    ];
    let positive = |(field, x): (&str, f64)| {
        unless(x.is_finite() && x > 0.0, &format!("mean_drift_loading.{field}"), x, "a number greater than 0")
    };
    numbers.into_iter().try_for_each(positive)
}

fn check_grids(database: &Database) -> Checked {
    let grid = &database.frequencies_rad_s;
    let increasing = grid.first().is_some_and(|x| *x > 0.0) && grid.windows(2).all(|w| w[0] < w[1]);
    let allowed = "at least two finite frequencies, increasing, greater than 0";
    let shown = || format!("{} frequencies", grid.len());
    unless(grid.len() > 1 && increasing && grid.iter().all(|x| x.is_finite()), "frequencies_rad_s", shown(), allowed)?;
    let directions = &database.wave_directions_rad;
    let step = core::f64::consts::TAU / directions.len() as f64;
    let off = |(k, x): (usize, &f64)| !x.is_finite() || (x - step * k as f64).abs() > GRID_TOLERANCE_RAD;
    let wrong = directions.iter().enumerate().find(|entry| off(*entry)).map(|(_, x)| *x);
    let found = wrong.map_or_else(|| format!("{} directions", directions.len()), |x| x.to_string());
    let allowed = "at least four directions, 0 first, evenly over the full circle";
    unless(directions.len() >= 4 && wrong.is_none(), "wave_directions_rad", found, allowed)
}

fn check_matrices(database: &Database) -> Checked {
    let count = database.frequencies_rad_s.len();
    let allowed = format!("one matrix of finite numbers for each of the {count} frequencies");
    for (field, matrices) in [("added_mass", &database.added_mass), ("radiation_damping", &database.radiation_damping)]
    {
        let fine = matrices.len() == count && matrices.iter().all(is_finite);
        unless(fine, field, format!("{} matrices", matrices.len()), &allowed)?;
    }
    let infinite = &database.added_mass_infinite;
    unless(is_finite(infinite), "added_mass_infinite", "a number that is not finite", "finite numbers")
}

fn is_finite(matrix: &SixBySix) -> bool {
    matrix.iter().flatten().all(|x| x.is_finite())
}

fn check_excitation(field: &str, database: &Database, given: &ExcitationTable) -> Checked {
    check_waves(&format!("{field}.real"), database, &given.real)?;
    check_waves(&format!("{field}.imaginary"), database, &given.imaginary)
}

fn check_mean_drift(database: &Database) -> Checked {
    database.mean_drift.as_ref().map_or(Ok(()), |drift| check_waves("mean_drift", database, drift))
}

/// Checks that there are values for each frequency and direction.
fn check_waves<const N: usize>(field: &str, database: &Database, given: &[Vec<[f64; N]>]) -> Checked {
    let (frequencies, directions) = (database.frequencies_rad_s.len(), database.wave_directions_rad.len());
    let fits = given.len() == frequencies
        && given.iter().all(|row| row.len() == directions && row.iter().flatten().all(|x| x.is_finite()));
    let allowed = format!("{N} finite numbers for each of {frequencies} frequencies and {directions} directions");
    unless(fits, field, "another shape", &allowed)
}

fn check_radiation(memory: &Memory) -> Checked {
    for (k, mode) in memory.iter().enumerate() {
        let field = format!("radiation.modes.{k}");
        let (poles, residues) = (mode.poles_rad_s.len(), mode.residues.len());
        unless(poles == residues, &field, format!("{poles} poles and {residues} rows of residues"), "as many of both")?;
        let stable = mode.poles_rad_s.iter().find(|[re, im]| !(*re < 0.0 && *im >= 0.0 && im.is_finite()));
        let found = stable.map_or(String::new(), |[re, im]| format!("the pole {re} + {im} i"));
        unless(
            stable.is_none(),
            &field,
            found,
            "poles with a negative real part, of a conjugate pair the one with a positive imaginary part",
        )?;
        let finite = mode.residues.iter().flatten().flatten().all(|x| x.is_finite());
        unless(finite, &field, "a residue that is not finite", "finite numbers")?;
    }
    Ok(())
}
