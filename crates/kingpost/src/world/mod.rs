//! The world outside the model: gravity, the water and its waves, current, wind and gusts.
//!
//! It is realised once, when a run is built. All elements and views evaluate this world at a position and a
//! time; no element has a separate sea, wind or gravity.

mod current;
mod gusts;
mod wind;

pub use current::{Current, CurrentAt, CurrentProfile, CurrentTable};
pub use gusts::{GustError, GustRealisation, GustSpectrum, Gusts, GustsAtHeight, MeanWind};
pub use wind::{Wind, WindProfile};

use crate::scalar::Scalar;
use crate::sea::waves::{Water, WaveField};
use crate::spatial::Vector3;

/// The world outside the model.
#[derive(Clone, Debug)]
pub struct World<S = f64> {
    /// Acceleration of free fall, m/s^2, along the world's -z; 0 without gravity.
    pub gravity: S,
    /// Density of the water, kg/m^3.
    pub water_density: S,
    /// Depth of the still water over a level seabed, m; `None` if it is infinite.
    pub depth: Option<S>,
    /// The incident waves, realised once; `None` in calm water.
    pub waves: Option<WaveField<S>>,
    /// The current.
    pub current: Current<S>,
    /// The wind, if there is any.
    pub wind: Option<Wind<S>>,
}

impl<S: Scalar> Default for World<S> {
    fn default() -> Self {
        Self::calm()
    }
}

impl<S: Scalar> World<S> {
    /// Returns the water in plain numbers, for checks without derivatives.
    pub fn plain_water(&self) -> Water {
        Water {
            density_kg_m3: self.water_density.value(),
            gravity_m_s2: self.gravity.value(),
            depth_m: self.depth.map(Scalar::value),
        }
    }

    /// Returns a world with sea water of infinite depth at rest, without wind and gravity.
    pub fn calm() -> Self {
        Self {
            gravity: S::ZERO,
            water_density: S::constant(Water::default().density_kg_m3),
            depth: None,
            waves: None,
            current: Current::none(),
            wind: None,
        }
    }

    /// Returns the world with this gravity, m/s^2.
    pub fn with_gravity(self, gravity: S) -> Self {
        Self { gravity, ..self }
    }

    /// Returns rho g of the water, N/m^3.
    pub fn specific_weight(&self) -> S {
        self.water_density * self.gravity
    }

    /// Returns the ramp factor of the waves' amplitudes at a time, with its first and second rate.
    pub fn wave_ramp(&self, time_s: f64) -> [f64; 3] {
        self.waves.as_ref().map_or([1.0, 0.0, 0.0], |waves| waves.ramp_and_rates(time_s))
    }

    /// Returns the velocity of the current at the water's surface, world, m/s.
    pub fn surface_current(&self) -> Vector3<S> {
        self.current.surface
    }

    /// Returns the velocity of the current that a load uses, world, m/s.
    pub fn current_at(&self, place: &CurrentAt<S>) -> Vector3<S> {
        self.current.at(place, self.depth)
    }
}

impl World {
    /// Returns the elevation of the incident waves at a time, m, at every grid point of x and y, world, m:
    /// first all points of the first x; 0 in calm water. It does not contain radiated or diffracted waves.
    pub fn elevations_m(&self, x: &[f64], y: &[f64], time_s: f64) -> Vec<f64> {
        match &self.waves {
            Some(waves) => waves.elevations_m(x, y, time_s),
            None => vec![0.0; x.len() * y.len()],
        }
    }
}
