//! Warnings of wave data that are for another loading, or have too few directions.

use super::floating::LoadedHull;
use crate::spatial::{Frame, SpatialInertia};

/// Largest difference of the loading from that of the data's mean drift without a warning, as a share.
const LARGEST_CHANGE: f64 = 0.05;
/// Largest share of the waves' energy in waves too short for the number of the data's directions.
const MOST_UNRESOLVED: f64 = 0.1;

impl LoadedHull<'_> {
    /// Returns warnings of a drifting hull: mass, KG and radii of gyration of the ship with its cargo in its
    /// present position differ from those of the data's mean drift.
    pub(super) fn drift_warnings(&self, keel_to_gravity_m: f64) -> Vec<String> {
        let Some(of_data) = &self.database.mean_drift_loading else { return Vec::new() };
        let ([roll, pitch, yaw], data) = (self.radii_of_gyration(), of_data.radii_of_gyration_m);
        let quantities = [
            ("mass", "t", self.carried_weight().mass / 1000.0, of_data.mass_kg / 1000.0),
            ("KG", "m", keel_to_gravity_m, of_data.keel_to_gravity_m),
            ("radius of gyration in roll", "m", roll, data[0]),
            ("radius of gyration in pitch", "m", pitch, data[1]),
            ("radius of gyration in yaw", "m", yaw, data[2]),
        ];
        let apart =
            quantities.into_iter().filter(|(_, _, here, data)| (here - data).abs() > LARGEST_CHANGE * data.abs());
        let body = &self.model.bodies[self.hull.frame.body].name;
        let warning = |(what, unit, here, data): (&str, &str, f64, f64)| {
            format!(
                "{body}: {what} {here:.4} {unit}, the database's mean drift is for {data:.4} {unit}: wave_drift is that of another loading (warned of beyond {:.0} %)",
                100.0 * LARGEST_CHANGE
            )
        };
        apart.map(warning).collect()
    }

    /// Returns the radii of gyration about the total centre of gravity, along the hull's axes, m.
    fn radii_of_gyration(&self) -> [f64; 3] {
        let weight = self.carried_weight();
        let centre = Frame { rotation: self.frame().rotation, position: weight.centre }.inverse();
        let moments = |body: usize, inertia: &SpatialInertia| {
            let angular = inertia.to_parent(&centre.times(&self.at.world[body])).angular;
            [angular.xx, angular.yy, angular.zz]
        };
        let bodies = self.model.carried(self.hull.frame.body);
        let mut sums = [0.0; 3];
        for &body in &bodies {
            let of_body = moments(body, &self.model.tree.nodes[body].inertia);
            sums = core::array::from_fn(|k| sums[k] + of_body[k]);
        }
        // Added mass is not part of the loading.
        for (body, added) in self.model.added_inertias.iter().filter(|(body, _)| bodies.contains(body)) {
            let of_water = moments(*body, added);
            sums = core::array::from_fn(|k| sums[k] - of_water[k]);
        }
        sums.map(|moment| libm::sqrt(moment / weight.mass))
    }

    /// Returns warnings of too few directions. N directions on the circle resolve N / 2 harmonics of a load;
    /// a ship of half length R needs about k R harmonics at the wave number k.
    pub(super) fn direction_warnings(&self) -> Vec<String> {
        let Some(waves) = self.world.waves.as_ref().filter(|_| self.hull.excitation.is_some()) else {
            return Vec::new();
        };
        let count = self.database.wave_directions_rad.len();
        // Waves that other hulls scatter come from farther off.
        let length = self.database.hull.length_m.max(2.0 * self.database.reach_m);
        let shortest_m = core::f64::consts::TAU * length / count as f64;
        let energy = |counts: &dyn Fn(f64) -> bool| -> f64 {
            let waves = waves.components().filter(|wave| counts(wave.wave_number_per_m));
            waves.map(|wave| wave.amplitude_m * wave.amplitude_m).sum()
        };
        let share = energy(&|k| k * length > count as f64) / energy(&|_| true);
        if share.is_nan() || share <= MOST_UNRESOLVED {
            return Vec::new();
        }
        let body = &self.model.bodies[self.hull.frame.body].name;
        let is_alone = length <= self.database.hull.length_m;
        let what = if is_alone { "its length" } else { "twice its distance to the rim of the hulls beside it," };
        vec![format!(
            "{body}: {count} wave directions of its database resolve waves of {shortest_m:.1} m and longer for {what} of {length:.1} m: \
             {:.1} % of the waves' energy is in shorter waves, whose loads are inaccurate at headings between the directions (warned of \
             beyond {:.0} %)",
            100.0 * share,
            100.0 * MOST_UNRESOLVED
        )]
    }
}
