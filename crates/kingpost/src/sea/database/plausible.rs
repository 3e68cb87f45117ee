//! Consistency of a database: excitation against damping, and waterplane and volume against the mesh.

use super::error::{Checked, unless};
use super::physical::damping_scale;
use super::{Database, MODES};
use crate::sea::hull::{FloatingPosition, HullMesh, WettedHull};
use crate::sea::waves::{self, group_velocity_m_s, wave_number};
use core::f64::consts::{PI, TAU};

/// Largest allowed ratio of the excitation to that of Haskind's relation, as amplitudes; beyond it a database
/// is refused.
const MOST_EXCITATION: f64 = 10.0;
/// Largest ratio of the excitation without a warning: coarse panels and irregular frequencies stay below it.
const DOUBTFUL_EXCITATION: f64 = 2.0;
/// Smallest damping of a mode that is compared, as a share of its maximum.
const NOTICEABLE: f64 = 0.1;
/// Number of harmonics around the circle that are reserved against aliasing.
const SPARE_HARMONICS: f64 = 4.0;

/// Largest allowed factor between the waterplane or volume and that of the mesh; beyond it a database is
/// refused.
const MOST_OF_MESH: f64 = 2.0;
/// Largest difference of the waterplane or volume from that of the mesh without a warning, as a share.
const DOUBTFUL_OF_MESH: f64 = 0.1;

/// Largest error of the fit of the memory without a warning, as a share of its peak: the target of `kingpost
/// hydro`.
const DOUBTFUL_FIT: f64 = 0.02;

/// Largest `k L` for which waves count as long.
const LONG: f64 = 0.4;
/// Largest allowed ratio of the heave excitation in a long wave to that from the water's level and
/// acceleration; beyond it a database is refused.
const MOST_HEAVE: f64 = 3.0;

/// Refuses data whose errors are larger than those of any panel model.
pub(super) fn check(database: &Database) -> Checked {
    for (field, found, of_mesh) in sizes(database).into_iter().flatten() {
        let ratio = found / of_mesh;
        let fits = (1.0 / MOST_OF_MESH..=MOST_OF_MESH).contains(&ratio);
        let allowed = format!("about {of_mesh:.2}, that of hull.mesh at the stated draught");
        unless(fits, field, format!("{found:.2}, {ratio:.3} times that of its own mesh"), &allowed)?;
    }
    check_heave(database)?;
    for (mode, ratio) in excitation_ratios(database) {
        // Added damping, for viscosity or a mooring, can be many times the wave damping, but not in heave and
        // pitch.
        let is_too_small = ratio < 1.0 / MOST_EXCITATION && matches!(mode, 2 | 4);
        let found = format!(
            "in {}, at the median, {ratio:.3e} times the amplitude that follows from radiation_damping by Haskind's relation",
            MODES[mode]
        );
        let allowed = "about once: check the units and scale of forces and damping";
        unless(ratio <= MOST_EXCITATION && !is_too_small, "froude_krylov + diffraction", found, allowed)?;
    }
    Ok(())
}

impl Database {
    /// Returns doubts about the data, which a user should know before using them.
    pub fn doubts(&self) -> Vec<String> {
        let of_mesh = sizes(self).into_iter().flatten().filter_map(|(field, found, of_mesh)| {
            let doubtful = (found / of_mesh - 1.0).abs() > DOUBTFUL_OF_MESH;
            doubtful.then(|| {
                format!(
                    "{field} is {found:.2}, {:.3} times that of its own mesh, {of_mesh:.2} (warned of beyond {:.0} %)",
                    found / of_mesh,
                    100.0 * DOUBTFUL_OF_MESH
                )
            })
        });
        let ratios: Vec<(usize, f64)> = excitation_ratios(self).collect();
        let words = |counts: &dyn Fn(f64) -> bool, cause: &str| {
            let modes = ratios.iter().filter(|(_, ratio)| counts(*ratio));
            let modes: Vec<String> = modes.map(|(mode, ratio)| format!("{} {ratio:.3}", MODES[*mode])).collect();
            let modes = Some(modes.join(", ")).filter(|modes| !modes.is_empty())?;
            Some(format!(
                "its excitation is {modes} times, at the median, what its radiation damping asks for by Haskind's relation (warned \
                 of outside {} to {DOUBTFUL_EXCITATION}): {cause}",
                1.0 / DOUBTFUL_EXCITATION
            ))
        };
        let large = words(&|ratio| ratio > DOUBTFUL_EXCITATION, "coarse panels, irregular frequencies, or units");
        let small = words(
            &|ratio| ratio < 1.0 / DOUBTFUL_EXCITATION,
            "a damping that holds viscosity or a mooring too, coarse panels, irregular frequencies, or units",
        );
        let fit = self.radiation.as_ref().map(|radiation| radiation.fit_error).filter(|error| *error > DOUBTFUL_FIT);
        let fit = fit.map(|error| {
            format!(
                "the memory of its radiated waves is fitted to {:.2} % of its peak only (warned of above {:.0} %): responses near \
                 a resonance can be off by a multiple of that",
                100.0 * error,
                100.0 * DOUBTFUL_FIT
            )
        });
        let told = self.provenance.get("warnings").and_then(|told| told.as_array()).into_iter().flatten();
        let told = told.filter_map(|warning| warning.as_str().map(str::to_owned));
        of_mesh.chain(large).chain(small).chain(fit).chain(told).collect()
    }

    /// Returns the diagonal of the damping that follows from the excitation, by frequency and mode; `None` at
    /// frequencies whose waves are too short for the grid of directions.
    ///
    /// `B_ii = k / (8 pi rho g c_g) Int |X_i|^2 db` over the circle, with the group velocity c_g: Haskind's
    /// relation at zero speed (J. N. Newman, The exciting forces on fixed bodies in waves, J. Ship Research
    /// 6(3), 1962; *Marine Hydrodynamics*, MIT Press 1977, sections 6.17 and 6.18, where c_g = g / (2 w) over
    /// infinite depth). `|X_i|^2` has harmonics around the circle up to about `2 k R`, where R is the radius
    /// of the hull in plan, or its distance from what else scatters; the trapezoidal rule over m directions integrates harmonics below m exactly.
    pub fn haskind_damping(&self) -> Vec<Option<[f64; 6]>> {
        let water = waves_water(self);
        let radius = self.reach_m.max(0.5 * libm::hypot(self.hull.length_m, self.hull.beam_m));
        let directions = self.wave_directions_rad.len() as f64;
        let at = |(n, omega): (usize, &f64)| {
            let k = wave_number(*omega, &water);
            let group = group_velocity_m_s(*omega, &water);
            let factor = k / (8.0 * PI * water.density_kg_m3 * water.gravity_m_s2 * group) * TAU / directions;
            let resolved = 2.0 * k * radius <= directions - SPARE_HARMONICS;
            resolved.then(|| self.squares_at(n).map(|sum| factor * sum))
        };
        self.frequencies_rad_s.iter().enumerate().map(at).collect()
    }

    /// Returns the sums of `|X_i|^2` over the directions.
    fn squares_at(&self, n: usize) -> [f64; 6] {
        let (own, scattered) = (&self.froude_krylov, &self.diffraction);
        let square = |direction: usize, mode: usize| {
            let re = own.real[n][direction][mode] + scattered.real[n][direction][mode];
            let im = own.imaginary[n][direction][mode] + scattered.imaginary[n][direction][mode];
            re * re + im * im
        };
        core::array::from_fn(|mode| (0..self.wave_directions_rad.len()).map(|d| square(d, mode)).sum())
    }
}

fn waves_water(database: &Database) -> waves::Water {
    let super::DatabaseWater { density_kg_m3, gravity_m_s2, depth_m } = database.water;
    waves::Water { density_kg_m3, gravity_m_s2, depth_m }
}

/// Returns field, value and the value from the mesh, for the waterplane and the volume below it; `None`
/// without a closed mesh.
fn sizes(database: &Database) -> Option<[(&'static str, f64, f64); 2]> {
    let (hull, mesh) = (&database.hull, database.hull.mesh.as_ref()?);
    let mesh = HullMesh::new(mesh.vertices_m.clone(), mesh.triangles.clone()).ok()?;
    let (mut wetted, upright) = (WettedHull::new(&mesh), FloatingPosition::upright(0.0));
    let area = wetted.waterplane(&mesh, &upright).area;
    let volume = wetted.buoyancy(&mesh, &upright).volume;
    let both = [("hull.waterplane.area_m2", hull.waterplane.area_m2, area), ("hull.volume_m3", hull.volume_m3, volume)];
    (area > 0.0 && volume > 0.0).then_some(both)
}

/// Checks the heave excitation in a long wave: `X_3 = rho g S - w^2 (rho V + A_33)`, from the water's level
/// and its acceleration.
fn check_heave(database: &Database) -> Checked {
    let (hull, water, omega) = (&database.hull, &database.water, database.frequencies_rad_s[0]);
    let extent = hull.length_m.max(hull.draught_m).max(2.0 * database.reach_m);
    let heave = libm::sqrt(database.squares_at(0)[2] / database.wave_directions_rad.len() as f64);
    if wave_number(omega, &waves_water(database)) * extent > LONG || heave == 0.0 {
        return Ok(());
    }
    let level = water.density_kg_m3 * water.gravity_m_s2 * hull.waterplane.area_m2;
    let inertia = omega * omega * (water.density_kg_m3 * hull.volume_m3 + database.added_mass[0][2][2]);
    let fits = ((level - inertia) / MOST_HEAVE..=(level + inertia) * MOST_HEAVE).contains(&heave);
    let found = format!("{heave:.4e} N/m in heave in long waves, of {omega} rad/s");
    let allowed = format!("about {level:.4e} N/m, rho g times hull.waterplane.area_m2: check units and scale of both");
    unless(fits, "froude_krylov + diffraction", found, &allowed)
}

/// Returns for each mode the ratio of the excitation's amplitude to that of Haskind's relation: the median
/// over frequencies that the directions resolve and at which the mode radiates waves. Modes without
/// excitation or damping are omitted: strip theory, for example, has no damping in surge.
fn excitation_ratios(database: &Database) -> impl Iterator<Item = (usize, f64)> {
    let (implied, scale) = (database.haskind_damping(), damping_scale(database));
    let of_mode = |mode: usize| -> Vec<[f64; 2]> {
        let given = database.radiation_damping.iter().map(|matrix| matrix[mode][mode]);
        implied.iter().zip(given).filter_map(|(implied, given)| Some([implied.as_ref()?[mode], given])).collect()
    };
    let found: Vec<(usize, f64)> =
        (0..6).filter_map(|mode| Some((mode, median_ratio(&of_mode(mode), scale[mode])?))).collect();
    found.into_iter()
}

/// Returns the median of `sqrt(implied / given)` over pairs of dampings; a damping counts if it is at least a
/// share of the largest one, or `least`.
fn median_ratio(pairs: &[[f64; 2]], least: f64) -> Option<f64> {
    let largest = |which: usize| pairs.iter().map(|pair| pair[which]).fold(0.0, f64::max);
    if largest(0) == 0.0 || largest(1) == 0.0 || largest(0).max(largest(1)) < least {
        return None;
    }
    let threshold = NOTICEABLE * largest(0).max(largest(1));
    let counts = pairs.iter().filter(|[implied, given]| implied.max(*given) >= threshold);
    let mut ratios: Vec<f64> =
        counts.map(|[implied, given]| libm::sqrt(implied / given.max(f64::MIN_POSITIVE))).collect();
    ratios.sort_by(f64::total_cmp);
    ratios.get(ratios.len() / 2).copied()
}
