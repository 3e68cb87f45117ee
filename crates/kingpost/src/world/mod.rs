//! What is outside the model and the same for all that acts on it: gravity, the water and its waves, current, wind and its gusts.
//!
//! It is realised once, when a run is built. Elements and views ask it at a place and a time; none keeps a sea, a wind or
//! a gravity of its own.

mod current;
mod gusts;
mod wind;

pub use current::{Current, CurrentAt, CurrentProfile, CurrentTable};
pub use gusts::{GustError, GustRealisation, GustSpectrum, Gusts, GustsAtHeight, MeanWind};
pub use wind::{Wind, WindProfile};

use crate::scalar::Scalar;
use crate::sea::waves::{Water, WaveField};
use crate::spatial::Vector3;

/// What is outside.
#[derive(Clone, Debug)]
pub struct World<S = f64> {
    /// Acceleration of free fall, m/s^2, against the world's z; 0 where there is no gravity.
    pub gravity: S,
    /// Density of the water, kg/m^3.
    pub water_density: S,
    /// Depth of the still water over a level seabed, m; `None` where it is infinite.
    pub depth: Option<S>,
    /// The incident waves, realised once; `None` in calm water.
    pub waves: Option<WaveField<S>>,
    /// What the water does beside them.
    pub current: Current<S>,
    /// The wind, where there is one.
    pub wind: Option<Wind<S>>,
}

impl<S: Scalar> Default for World<S> {
    fn default() -> Self {
        Self::calm()
    }
}

impl<S: Scalar> World<S> {
    /// Sea water of infinite depth at rest; no wind, no gravity.
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

    /// The same with this gravity, m/s^2.
    pub fn with_gravity(self, gravity: S) -> Self {
        Self { gravity, ..self }
    }

    /// rho g of the water, N/m^3.
    pub fn specific_weight(&self) -> S {
        self.water_density * self.gravity
    }

    /// What the waves' amplitudes are multiplied by at a time, with its first and second rate.
    pub fn wave_ramp(&self, time_s: f64) -> [f64; 3] {
        self.waves.as_ref().map_or([1.0, 0.0, 0.0], |waves| waves.ramp_and_rates(time_s))
    }

    /// Velocity of the water at its surface, waves apart, world, m/s.
    pub fn surface_current(&self) -> Vector3<S> {
        self.current.surface
    }

    /// Velocity of the water that counts, waves apart, world, m/s.
    pub fn current_at(&self, place: &CurrentAt<S>) -> Vector3<S> {
        self.current.at(place, self.depth)
    }
}

impl World {
    /// Elevation of the incident waves at a time, m, at every crossing of the lines x and y, world, m: along the first x
    /// first; 0 in calm water. Waves that a hull makes or turns back are not in it.
    pub fn elevations_m(&self, x: &[f64], y: &[f64], time_s: f64) -> Vec<f64> {
        match &self.waves {
            Some(waves) => waves.elevations_m(x, y, time_s),
            None => vec![0.0; x.len() * y.len()],
        }
    }
}
