//! Wind, current, and their loads by coefficients.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{Gusts, NonNegative, Positive};

/// The wind: uniform at each height, steady or with gusts.
#[fields]
pub struct Wind<S = f64> {
    /// Mean speed at the reference height, m/s.
    pub speed_m_s: NonNegative<S>,
    /// Direction that the wind goes to, from the world's x axis, counter-clockwise, rad.
    pub direction_rad: S,
    /// Height above the still water at which the speed is given, m.
    #[serde(default = "ten_metres::<S>")]
    pub reference_height_m: Positive<S>,
    /// How the mean speed varies with height.
    #[serde(default)]
    pub profile: WindProfile<S>,
    /// Variation of the speed about its mean; without it, the wind is steady.
    pub gusts: Option<Gusts<S>>,
    /// Density of the air, kg/m^3.
    #[serde(default = "air::<S>")]
    pub air_density_kg_m3: Positive<S>,
}

pub(crate) fn ten_metres<S: Leaf>() -> Positive<S> {
    Positive::literal(10.0)
}

fn air<S: Leaf>() -> Positive<S> {
    Positive::literal(1.225)
}

/// Speed of the wind over height.
#[fields]
#[derive(Copy)]
pub enum WindProfile<S = f64> {
    /// Speed that is the same at all heights.
    Uniform,
    /// By a power of the height.
    PowerLaw(PowerLaw<S>),
    /// By the logarithm of the height over a roughness.
    Logarithmic(Logarithmic<S>),
    /// That of the NPD spectrum, of the mean over one hour at 10 m (ISO 19901-1).
    Npd,
}

impl<S: Leaf> Default for WindProfile<S> {
    fn default() -> Self {
        Self::PowerLaw(PowerLaw::default())
    }
}

/// U(z) = U (z / z_reference)^exponent; of a current U(z) = U ((h + z) / h)^exponent, with h the water's depth.
#[fields(default)]
#[derive(Copy)]
pub struct PowerLaw<S = f64> {
    /// 1/7 unless given.
    pub exponent: NonNegative<S>,
}

impl<S: Leaf> Default for PowerLaw<S> {
    fn default() -> Self {
        Self { exponent: NonNegative::literal(1.0 / 7.0) }
    }
}

/// U(z) = U ln(z / roughness) / ln(z_reference / roughness).
#[fields]
#[derive(Copy)]
pub struct Logarithmic<S = f64> {
    /// Height at which the mean wind is zero by this law, m: 0.0001 to 0.01 at sea.
    pub roughness_m: Positive<S>,
}

/// Speed of the current over depth.
#[fields]
#[derive(Default)]
pub enum CurrentProfile<S = f64> {
    /// Speed that is the same at all depths.
    #[default]
    Uniform,
    /// By a power of the height over the bottom, for tides.
    PowerLaw(PowerLaw<S>),
    /// By a table, as measured; leave out `current_m_s` then.
    Table(CurrentTable<S>),
}

/// The current at given depths. Its components are linear between depths and constant below the last.
#[fields]
pub struct CurrentTable<S = f64> {
    /// Depths under the still water, m, from 0 on, increasing.
    pub depths_m: Vec<f64>,
    /// Speed at each depth, m/s.
    pub speeds_m_s: Vec<S>,
    /// Direction that the current goes to at each depth, from the world's x axis, counter-clockwise, rad.
    pub directions_rad: Vec<S>,
}
