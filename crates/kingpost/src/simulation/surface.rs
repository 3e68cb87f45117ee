//! The sea around the bodies, for a view.

use super::Simulation;
use crate::elements::Force;
use crate::sea::waves::WaveField;

impl Simulation {
    /// Elevation of the incident waves now, m, at every crossing of the lines x and y, world, m:
    /// along the first x first. It is 0 where no hull feels waves. Waves that a hull makes or turns
    /// back are not in it.
    pub fn surface(&self, x: &[f64], y: &[f64]) -> Vec<f64> {
        match self.waves() {
            Some(waves) => waves.elevations_m(x, y, self.time_s()),
            None => vec![0.0; x.len() * y.len()],
        }
    }

    /// The waves that the hulls feel: those of the one sea.
    fn waves(&self) -> Option<&WaveField> {
        let hulls = self.plant.forces.iter().filter_map(Force::hull);
        hulls.filter_map(|hull| hull.excitation.as_ref()).map(|excitation| excitation.field()).next()
    }
}
