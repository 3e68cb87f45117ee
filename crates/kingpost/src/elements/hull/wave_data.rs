//! A hull in regular waves, from its database.

use super::{ByHeading, Hull, LowFrequencyFrame, SeaAxes, modes};
use crate::dynamics::Kinematics;
use crate::elements::{RegularWaves, WavePlace};
use crate::scalar::Scalar;
use crate::sea::database::Database;
use crate::sea::waves::Water;
use crate::spatial::{Frame, Twist};
use std::sync::Arc;

/// A hull and the database of its excitation.
#[derive(Debug)]
pub struct InRegularWaves<'a, S: Scalar> {
    hull: &'a Hull<S>,
    database: &'a Arc<Database>,
}

/// Real and imaginary part of six modes.
const PARTS: usize = 12;

impl<'a, S: Scalar> InRegularWaves<'a, S> {
    pub(super) fn new(hull: &'a Hull<S>, database: &'a Arc<Database>) -> Self {
        Self { hull, database }
    }

    fn frame(&self, bodies: &Kinematics<S>) -> Frame<S> {
        bodies.world[self.hull.frame.body].times(&self.hull.coordinates.coefficients.in_body)
    }
}

impl<S: Scalar> RegularWaves<S> for InRegularWaves<'_, S> {
    fn frequencies_rad_s(&self) -> &[f64] {
        &self.database.frequencies_rad_s
    }

    fn water(&self) -> Water {
        let given = self.database.water;
        Water { gravity_m_s2: given.gravity_m_s2, depth_m: given.depth_m, ..Water::default() }
    }

    fn place(&self, bodies: &Kinematics<S>) -> WavePlace<S> {
        let frame = self.frame(bodies);
        let LowFrequencyFrame { position, heading, .. } = LowFrequencyFrame::of(&frame);
        WavePlace { position, height: frame.position[2], heading }
    }

    /// Returns the rates along the axes of the wave loads, about the database's origin.
    fn along(&self, bodies: &Kinematics<S>, twists: &[Twist<S>]) -> [S; 6] {
        let frame = self.frame(bodies);
        let axes =
            SeaAxes::of(&self.hull.coordinates.coefficients, &frame, &LowFrequencyFrame::of(&frame), [S::ZERO; 2]);
        let rates = axes.rates(&twists[self.hull.frame.body]);
        modes(rates.linear, rates.angular)
    }

    /// Returns X at the hull's heading.
    fn amplitudes(&self, omega: f64, directions_rad: &[f64], place: &WavePlace<S>) -> Vec<[[S; 2]; 6]> {
        let on_grid = self.database.excitation(omega, true);
        let part = |part: usize, _| on_grid.iter().map(|x| x[part / 2][part % 2]).collect();
        let mut table = ByHeading::new(PARTS, directions_rad, part);
        table.turn_to(place.heading);
        let of = |wave| core::array::from_fn(|mode| [0, 1].map(|part| table.number(2 * mode + part, wave)));
        (0..directions_rad.len()).map(of).collect()
    }
}
