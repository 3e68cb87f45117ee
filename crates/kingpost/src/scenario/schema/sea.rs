//! The sea: the water, its depth, its waves.

use indexmap::IndexMap;
use kingpost_derive::fields;

use super::{CurrentProfile, Name, NonNegative, Positive, Waves};
use crate::scenario::leaf::Leaf;

/// The water, its waves and its current.
#[fields(default)]
pub struct Sea<S = f64> {
    /// Density of the water, kg/m^3.
    pub density_kg_m3: Positive<S>,
    /// Depth of the still water, m; without it, infinite.
    pub depth_m: Option<Positive<S>>,
    /// The wave systems by name: wind sea, swell.
    pub waves: IndexMap<Name, Waves<S>>,
    /// How the water's motion continues from the still water level, where linear theory ends, to the moving surface.
    pub stretching: Stretching,
    /// Time over which the waves grow from zero at the start, s.
    pub ramp_s: NonNegative,
    /// Velocity of the current at the surface along the world's x and y, m/s; leave it out for a current by a table.
    pub current_m_s: [S; 2],
    /// How the current varies with depth. Current loads by coefficients use it; damping, radiation and drift use the
    /// current at the surface.
    pub current_profile: CurrentProfile<S>,
}

impl<S: Leaf> Default for Sea<S> {
    fn default() -> Self {
        Self {
            density_kg_m3: Positive::literal(1025.0),
            depth_m: None,
            waves: IndexMap::new(),
            stretching: Stretching::default(),
            ramp_s: NonNegative::literal(0.0),
            current_m_s: [S::default(); 2],
            current_profile: CurrentProfile::Uniform,
        }
    }
}

/// Method by which the kinematics of linear waves continue from the still water level to the moving surface.
#[fields]
#[derive(Copy, Default, Eq)]
pub enum Stretching {
    /// No motion and no dynamic pressure of the water above the still water level.
    None,
    /// Kinematics above the still water level equal those at it; below it they are those of linear theory.
    #[default]
    Vertical,
    /// Wheeler's: the column of water is stretched from the bottom to the surface, so that kinematics change at every
    /// depth: less under crests, more under troughs.
    Wheeler,
    /// Kinematics above the still water level continue along their tangent there; below it they are those of linear
    /// theory.
    Extrapolated,
}
