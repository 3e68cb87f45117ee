//! Water in which waves propagate.

use super::error::{WaveError, between};

/// Water with a uniform density over a level bottom, or in infinite depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Water {
    /// Density, kg/m^3.
    pub density_kg_m3: f64,
    /// Acceleration of gravity, m/s^2.
    pub gravity_m_s2: f64,
    /// Depth of the still water, m; `None` if it is infinite.
    pub depth_m: Option<f64>,
}

impl Default for Water {
    /// Returns sea water of infinite depth: 1025 kg/m^3, 9.80665 m/s^2.
    fn default() -> Self {
        Self { density_kg_m3: 1025.0, gravity_m_s2: 9.80665, depth_m: None }
    }
}

impl Water {
    /// Creates water with these properties.
    ///
    /// # Errors
    /// A density outside 1 to 20,000 kg/m^3, a gravity outside 0.01 to 1000 m/s^2, a depth outside
    /// 0.01 to 20,000 m.
    pub fn new(density_kg_m3: f64, gravity_m_s2: f64, depth_m: Option<f64>) -> Result<Self, WaveError> {
        between("density_kg_m3", density_kg_m3, [1.0, 2e4])?;
        between("gravity_m_s2", gravity_m_s2, [0.01, 1e3])?;
        if let Some(depth_m) = depth_m {
            between("depth_m", depth_m, [0.01, 2e4])?;
        }
        Ok(Self { density_kg_m3, gravity_m_s2, depth_m })
    }
}
