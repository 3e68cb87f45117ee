//! A hull's weight, and errors of a hull that does not float.

use crate::spatial::Vector3;
use thiserror::Error;

/// A hull's weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loading {
    /// Total floating mass, kg.
    pub mass: f64,
    /// Its centre of gravity, hull axes, m.
    pub centre_of_gravity: Vector3,
    /// Density of the water, kg/m^3.
    pub water_density: f64,
}

/// Why a hull has no equilibrium, or no hydrostatics.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum StabilityError {
    /// A weight that is not positive.
    #[error("{quantity} is {found}, allowed: {allowed}")]
    Loading {
        /// The quantity.
        quantity: &'static str,
        /// Its value.
        found: f64,
        /// Range that is allowed.
        allowed: &'static str,
    },
    /// A weight that the fully immersed hull does not carry.
    #[error(
        "the hull cannot float: {mass_t:.3} t displace {displacement_m3:.3} m3 of water, \
         allowed: less than the {largest_m3:.3} m3 of the whole hull"
    )]
    CannotFloat {
        /// The weight, t.
        mass_t: f64,
        /// The volume that it displaces, m^3.
        displacement_m3: f64,
        /// Volume of the hull, m^3.
        largest_m3: f64,
    },
    /// A hull that does not reach the water.
    #[error("the hull is above the water: its lowest point is at {lowest_m} m, allowed: less than 0, the water plane")]
    AboveWater {
        /// Height of the lowest point, m.
        lowest_m: f64,
    },
    /// No convergence.
    #[error(
        "no equilibrium at heel {heel_deg:.3} deg to starboard, trim {trim_deg:.3} deg by the bow: a turn of {turn_rad:.1e} rad is left after {steps} steps, allowed: {allowed_rad:e} rad"
    )]
    NotSettled {
        /// Heel to starboard, deg.
        heel_deg: f64,
        /// Trim by the bow, deg.
        trim_deg: f64,
        /// The next step, rad.
        turn_rad: f64,
        /// Number of steps.
        steps: usize,
        /// The largest last step that is allowed, rad.
        allowed_rad: f64,
    },
}
