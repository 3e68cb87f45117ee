//! The air above the water of a tank, and the pump that sets its pressure.

use crate::scalar::Scalar;

/// Pressure of the atmosphere, Pa.
pub const ATMOSPHERE_PA: f64 = 101_325.0;
/// Ratio of the specific heats of air.
const HEAT_RATIO: f64 = 1.4;

/// A pump whose controller follows a commanded pressure with a first-order lag, as far as its flow allows.
///
/// The air is an ideal gas without exchange of heat. With its volume V, its gauge pressure p, and the flow Q of air at
/// atmospheric pressure into the tank,
///
/// ```text
/// p' = kappa (p_atm Q - (p_atm + p) V') / V
/// p_atm Q = (p_command - p) V / (kappa T) + (p_atm + p) V',    |Q| <= Q_limit
/// ```
///
/// so that within the limit `p' = (p_command - p) / T`, and at the limit the air is a spring.
#[derive(Clone, Copy, Debug)]
pub struct AirPump<S = f64> {
    /// Largest commanded pressure above or below the atmosphere, Pa.
    pub pressure_limit: S,
    /// Q_limit, m^3/s.
    pub flow_limit: S,
    /// T, s.
    pub response_time: S,
}

/// The air in a tank at one moment.
#[derive(Clone, Copy, Debug)]
pub struct AirChamber<S = f64> {
    /// p, Pa.
    pub pressure: S,
    /// V, m^3.
    pub volume: S,
    /// V', m^3/s.
    pub growth: S,
}

impl<S: Scalar> AirChamber<S> {
    fn absolute(&self) -> S {
        self.pressure + S::constant(ATMOSPHERE_PA)
    }
}

impl<S: Scalar> AirPump<S> {
    /// Q, m^3/s.
    pub fn flow(&self, lever: S, air: &AirChamber<S>) -> S {
        let missing = self.pressure_limit * lever - air.pressure;
        let asked = missing * air.volume / (self.response_time * S::constant(HEAT_RATIO)) + air.absolute() * air.growth;
        (asked * S::constant(1.0 / ATMOSPHERE_PA)).clipped(-self.flow_limit, self.flow_limit)
    }

    /// p', Pa/s.
    pub fn pressure_rate(&self, lever: S, air: &AirChamber<S>) -> S {
        let entering = self.flow(lever, air) * S::constant(ATMOSPHERE_PA);
        (entering - air.absolute() * air.growth) * S::constant(HEAT_RATIO) / air.volume
    }

    /// Returns the smallest possible power of the pump, W: that of isothermal compression between the tank and the
    /// atmosphere, `p_atm Q ln((p_atm + p) / p_atm)`; 0 where the air flows without a pump.
    pub fn power(&self, lever: S, air: &AirChamber<S>) -> S {
        let ratio = air.absolute() * S::constant(1.0 / ATMOSPHERE_PA);
        let power = self.flow(lever, air) * ratio.ln() * S::constant(ATMOSPHERE_PA);
        power.select_below(0.0, || S::ZERO, || power)
    }
}
