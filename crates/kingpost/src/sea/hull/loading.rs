//! Weight of a hull, and errors of a hull that does not float.

use crate::spatial::Vector3;
use thiserror::Error;

/// Weight of a hull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loading {
    /// Total floating mass, kg.
    pub mass: f64,
    /// Centre of gravity, hull axes, m.
    pub centre_of_gravity: Vector3,
    /// Density of the water, kg/m^3.
    pub water_density: f64,
}

/// Reason why a hull has no equilibrium, or no hydrostatics.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum StabilityError {
    /// The weight is not valid.
    #[error("{quantity} is {found}, allowed: {allowed}")]
    Loading {
        /// The quantity.
        quantity: &'static str,
        /// Its value.
        found: f64,
        /// Range that is allowed.
        allowed: &'static str,
    },
    /// The fully submerged hull displaces less than its weight.
    #[error(
        "the hull cannot float: {mass_t:.3} t displace {displacement_m3:.3} m3 of water, \
         allowed: less than the {largest_m3:.3} m3 of the whole hull"
    )]
    CannotFloat {
        /// The weight, t.
        mass_t: f64,
        /// Volume of water with this weight, m^3.
        displacement_m3: f64,
        /// Volume of the hull, m^3.
        largest_m3: f64,
    },
    /// The hull does not reach the water.
    #[error("the hull is above the water: its lowest point is at {lowest_m} m, allowed: less than 0, the water plane")]
    AboveWater {
        /// Height of the lowest point, m.
        lowest_m: f64,
    },
    /// The search for an equilibrium does not converge.
    #[error(
        "no equilibrium at heel {heel_deg:.3} deg to starboard, trim {trim_deg:.3} deg by the bow: the next rotation is {turn_rad:.1e} rad after {steps} steps, allowed: {allowed_rad:e} rad"
    )]
    NotSettled {
        /// Heel to starboard, deg.
        heel_deg: f64,
        /// Trim by the bow, deg.
        trim_deg: f64,
        /// Rotation of the next step, rad.
        turn_rad: f64,
        /// Number of steps.
        steps: usize,
        /// Largest rotation of the last step at convergence, rad.
        allowed_rad: f64,
    },
}
