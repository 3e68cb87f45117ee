//! Wind: uniform at each height, steady or with gusts.

use super::gusts::{Gusts, GustsAtHeight, MeanWind};
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A wind with its mean speed at one height and its profile over height.
#[derive(Clone, Debug)]
pub struct Wind<S = f64> {
    /// Mean speed at the reference height, m/s.
    pub speed: S,
    /// Cosine and sine of the direction to which the wind blows, from the world's x counter-clockwise.
    pub direction: [S; 2],
    /// Reference height above the still water, m.
    pub reference_height: S,
    /// Profile of the mean speed over height.
    pub profile: WindProfile<S>,
    /// Variation of the speed about the mean; `None` if the wind is steady.
    pub gusts: Option<Gusts<S>>,
    /// Density of the air, kg/m^3.
    pub air_density: S,
}

/// Mean speed of the wind over height.
#[derive(Clone, Copy, Debug)]
pub enum WindProfile<S = f64> {
    /// Speed that is the same at all heights.
    Uniform,
    /// U (z / z_reference)^exponent.
    PowerLaw(S),
    /// U ln(z / z_0) / ln(z_reference / z_0), with the roughness z_0, m.
    Logarithmic(S),
    /// U (1 + C ln(z / 10 m)) with C = 0.0573 (1 + 0.15 U)^(1/2), U the mean over one hour at 10 m, which is the reference
    /// height (ISO 19901-1:2015, A.7.3).
    Npd,
}

impl<S: Scalar> Wind<S> {
    /// Returns the mean velocity at a height above the still water, m; world, m/s.
    pub fn at_height(&self, height: S) -> Vector3<S> {
        self.along(self.mean_speed(height))
    }

    /// Returns a velocity with this speed in the wind's direction, world.
    pub fn along(&self, speed: S) -> Vector3<S> {
        let [cos, sin] = self.direction;
        Vector3::new(speed * cos, speed * sin, S::ZERO)
    }

    /// Returns the gusts at a height above the still water, m.
    pub fn gusts_at_height(&self, height: S) -> Option<GustsAtHeight<S>> {
        let at_ten_metres = self.mean_speed(S::constant(10.0));
        let mean = MeanWind { height, speed: self.mean_speed(height), at_ten_metres };
        self.gusts.as_ref().map(|gusts| gusts.at_height(&mean))
    }

    /// Returns the mean speed at a height, m/s.
    fn mean_speed(&self, height: S) -> S {
        self.speed * self.share_at(height)
    }

    /// Returns the ratio of the speed at a height to that at the reference height.
    fn share_at(&self, height: S) -> S {
        match self.profile {
            WindProfile::Uniform => S::ONE,
            WindProfile::PowerLaw(exponent) => (height / self.reference_height).pow(exponent),
            WindProfile::Logarithmic(roughness) => (height / roughness).ln() / (self.reference_height / roughness).ln(),
            WindProfile::Npd => {
                let slope = S::constant(0.0573) * (S::ONE + S::constant(0.15) * self.speed).sqrt();
                S::ONE + slope * (height / self.reference_height).ln()
            }
        }
    }
}
