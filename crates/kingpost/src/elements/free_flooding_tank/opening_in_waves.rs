//! A free-flooding tank in regular waves: the wave pressure at its opening drives the water.

use super::FreeFloodingTank;
use crate::dynamics::Kinematics;
use crate::elements::{RegularWaves, WavePlace};
use crate::scalar::Scalar;
use crate::sea::waves::{Water, wave_number};
use crate::spatial::{Frame, Twist};

/// A tank in linear waves of any frequency.
#[derive(Debug)]
pub(super) struct OpeningInWaves<'a, S: Scalar>(pub &'a FreeFloodingTank<S>);

impl<S: Scalar> RegularWaves<S> for OpeningInWaves<'_, S> {
    fn frequencies_rad_s(&self) -> &[f64] {
        &[]
    }

    fn water(&self) -> Water {
        self.0.water
    }

    fn place(&self, bodies: &Kinematics<S>) -> WavePlace<S> {
        let Frame { rotation, position } = bodies.world[self.0.carrier].times(&Frame::translation(self.0.opening));
        let [x, y, height] = position.0;
        WavePlace { position: [x, y], height, heading: rotation.0[1][0].atan2(rotation.0[0][0]) }
    }

    /// Returns the rate of the level: the velocity of the water relative to the hull, along the tank.
    fn along(&self, bodies: &Kinematics<S>, twists: &[Twist<S>]) -> [S; 6] {
        let [hull, water] = [self.0.carrier, self.0.body];
        let off =
            bodies.world[hull].rotation.transpose_times(bodies.world[water].position - bodies.world[hull].position);
        let carried = twists[hull].linear + twists[hull].angular.cross(off);
        let mut rates = [S::ZERO; 6];
        rates[0] = (twists[water].linear - carried)[2];
        rates
    }

    /// Returns `rho g A cosh(k (h + z)) / cosh(k h)`: the pressure is in phase with the surface elevation.
    fn amplitudes(&self, omega: f64, directions_rad: &[f64], place: &WavePlace<S>) -> Vec<[[S; 2]; 6]> {
        let Water { density_kg_m3, gravity_m_s2, depth_m } = self.0.water;
        let k = S::constant(wave_number(omega, &self.0.water));
        let decay = (k * place.height).exp();
        let decay = depth_m.map_or(decay, |depth| {
            let from_bottom = S::constant(-2.0 * depth) * k;
            decay * (S::ONE + (from_bottom - k * place.height * S::constant(2.0)).exp()) / (S::ONE + from_bottom.exp())
        });
        let mut forces = [[S::ZERO; 2]; 6];
        forces[0][0] = self.0.column.area() * decay * S::constant(density_kg_m3 * gravity_m_s2);
        vec![forces; directions_rad.len()]
    }
}
