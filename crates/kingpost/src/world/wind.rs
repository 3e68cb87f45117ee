//! The wind: steady, the same everywhere at one height.

use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A wind, by its speed at one height and how that goes with the height.
#[derive(Clone, Copy, Debug)]
pub struct Wind<S = f64> {
    /// Mean speed at the reference height, m/s.
    pub speed: S,
    /// Cosine and sine of the direction that it goes to, from the world's x counter-clockwise.
    pub direction: [S; 2],
    /// Above the still water, m.
    pub reference_height: S,
    /// Speed over height.
    pub profile: WindProfile<S>,
    /// Density of the air, kg/m^3.
    pub air_density: S,
}

/// Speed of the wind over height.
#[derive(Clone, Copy, Debug)]
pub enum WindProfile<S = f64> {
    /// The same at all heights.
    Uniform,
    /// U (z / z_reference)^exponent.
    PowerLaw(S),
    /// U ln(z / z_0) / ln(z_reference / z_0), with the roughness z_0, m.
    Logarithmic(S),
}

impl<S: Scalar> Wind<S> {
    /// Velocity at a height above the still water, m; world, m/s.
    pub fn at_height(&self, height: S) -> Vector3<S> {
        let speed = self.speed * self.share_at(height);
        let [cos, sin] = self.direction;
        Vector3::new(speed * cos, speed * sin, S::ZERO)
    }

    /// Speed at a height, of that at the reference height.
    fn share_at(&self, height: S) -> S {
        match self.profile {
            WindProfile::Uniform => S::ONE,
            WindProfile::PowerLaw(exponent) => (height / self.reference_height).pow(exponent),
            WindProfile::Logarithmic(roughness) => (height / roughness).ln() / (self.reference_height / roughness).ln(),
        }
    }
}
