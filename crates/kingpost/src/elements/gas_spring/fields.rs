//! Gas springs of sliding axes.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::Positive;

/// A gas cylinder with its connected vessels, which pushes an axis towards larger extensions: `p V^n` is constant. The
/// axis needs a lower limit at which the gas volume is above 0. Its outputs are `gas_spring_pressure` (Pa) and
/// `gas_spring_force` (N).
#[fields]
pub struct GasSpring<S = f64> {
    /// Area of the piston, m^2.
    pub piston_area_m2: Positive<S>,
    /// Volume of all the gas, connected vessels included, at `at_extension_m`, m^3.
    pub gas_volume_m3: Positive<S>,
    /// Absolute pressure of the gas at `at_extension_m`, Pa.
    pub pressure_pa: Positive<S>,
    /// Extension at which the gas has this volume and pressure, m.
    #[serde(default)]
    pub at_extension_m: S,
    /// n: 1 for slow changes at constant temperature, 1.4 for fast changes of nitrogen or air without exchange of heat.
    #[serde(default = "adiabatic::<S>")]
    pub polytropic_exponent: Positive<S>,
    /// Absolute pressure on the other side of the piston, Pa: that of the atmosphere by default.
    #[serde(default = "atmosphere::<S>")]
    pub outside_pressure_pa: Positive<S>,
}

fn adiabatic<S: Leaf>() -> Positive<S> {
    Positive::literal(1.4)
}

fn atmosphere<S: Leaf>() -> Positive<S> {
    Positive::literal(101_325.0)
}
