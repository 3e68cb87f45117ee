//! Waves: sums of regular waves, their realisation from spectra, and the motion of the water.
//!
//! [`Spectrum`] and [`Spreading`] give the distribution of energy over frequency and direction;
//! [`WaveSystem`] draws a sum of [`WaveComponent`]s from them, by [`Noise`]; a [`WaveField`] gives the motion
//! of the water for such a sum. Directions are propagation directions, from the world's x counter-clockwise;
//! the elevation is Re{a e^(i (k x cos b + k y sin b - w t + phase))}.

mod at_body;
mod at_points;
mod breaking;
mod components;
mod dispersion;
mod error;
mod field;
mod motion;
mod noise;
mod ramp;
mod realization;
mod record;
mod spectrum;
mod spreading;
mod stretching;
mod surface;
mod water;

pub use at_body::{LocalSurface, WavesAtBody};
pub use at_points::WavesAtPoints;
pub use breaking::breaking_height_m;
pub(crate) use breaking::unbroken;
pub use components::{MOST_COMPONENTS, WaveComponent, significant_height_of_components_m};
pub use dispersion::{group_velocity_m_s, wave_number};
pub use error::WaveError;
pub use field::{WaveField, WaveKinematics};
pub use noise::Noise;
pub use ramp::ramp;
pub use realization::{Amplitudes, WaveSystem};
pub use record::{ElevationRecord, ElevationTable, MOST_SAMPLES};
pub(crate) use spectrum::jonswap_shape;
pub use spectrum::{
    Band, Jonswap, OchiHubble, OchiHubblePart, PiersonMoskowitz, Spectrum, SpectrumTable, Torsethaugen,
};
pub use spreading::Spreading;
pub use stretching::Stretching;
pub use water::Water;
