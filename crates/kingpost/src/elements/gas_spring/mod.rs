//! A gas spring along one axis of a joint.

pub(crate) mod fields;

use crate::dynamics::Loads;
use crate::elements::{AnyElement, Context, Declaration, Element, Output, of_kind};
use crate::scalar::Scalar;

/// A gas behind a piston, which pushes the axis towards positive extensions. With the piston's area A, the volume V_0
/// and the pressure p_0 at the extension x_0, the exponent n and the pressure p_a on the other side of the piston,
///
/// ```text
/// V = V_0 + A (x - x_0),   p V^n = p_0 V_0^n,   F = (p - p_a) A,   -dF/dx = n p A^2 / V
/// ```
///
/// n is 1 if the gas keeps its temperature, and the ratio of its specific heats, 1.4 for nitrogen, if it exchanges no
/// heat (Cengel & Boles, *Thermodynamics*, 7th ed., sec. 4-1). The energy stored is the work against both pressures
/// since x_0, `p_0 V_0 (1 - (V_0 / V)^(n - 1)) / (n - 1)` from the gas; as an elastic force it has no losses: model
/// seal friction and flow losses by the friction of the joint.
#[derive(Clone, Debug)]
pub struct GasSpring<S = f64> {
    /// Name of its coordinate.
    pub name: String,
    /// Index in q.
    pub position: usize,
    /// Index in v.
    pub coordinate: usize,
    /// A, m^2.
    pub area: S,
    /// V_0, m^3.
    pub volume: S,
    /// p_0, absolute, Pa.
    pub pressure: S,
    /// x_0, m.
    pub extension: S,
    /// n.
    pub exponent: S,
    /// p_a, Pa.
    pub outside_pressure: S,
    /// Volume below which the pressure stays constant, m^3; it is reached only beyond the stop of the axis.
    pub smallest_volume: S,
}

/// Magnitude of (n - 1) ln(V / V_0) below which a series replaces the quotient, so that n may be 1.
const NEARLY_ISOTHERMAL: f64 = 1e-4;

impl<S: Scalar> Element<S> for GasSpring<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number =
            |variable, description, unit| Output::number(variable, description, "gas_spring", &self.name, unit);
        let outputs = vec![
            number("gas_spring_pressure", "absolute pressure in a gas spring", &["Pa"]),
            number(
                "gas_spring_force",
                "force of a gas spring on its joint, positive towards larger extensions",
                &["N"],
            ),
        ];
        Declaration { outputs, ..Declaration::default() }
    }

    /// Adds the force on the piston.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        loads.force[self.coordinate] += self.force(self.pressure_at(at.q));
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let pressure = self.pressure_at(at.q);
        out.extend([pressure, self.force(pressure)]);
    }

    /// Returns the energy stored since x_0, J; negative after an expansion.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let (volume, whole) = (self.volume_at(at.q), self.whole_volume_at(at.q));
        let swept = (volume / self.volume).ln();
        let scaled = (self.exponent - S::ONE) * swept;
        let size = scaled.select_below(0.0, || -scaled, || scaled);
        let series = || S::ONE - scaled * S::constant(0.5) + scaled * scaled * S::constant(1.0 / 6.0);
        let quotient = size.select_below(NEARLY_ISOTHERMAL, series, || -(-scaled).exp_m1() / scaled);
        let work = self.pressure * self.volume * swept * quotient;
        let beyond = self.pressure_at(at.q) * (whole - volume);
        self.outside_pressure * (whole - self.volume) - work - beyond
    }
}

impl<S: Scalar> GasSpring<S> {
    /// Returns the gas springs among the elements.
    pub fn among(elements: &[AnyElement<S>]) -> impl Iterator<Item = &Self> {
        of_kind(elements)
    }

    fn whole_volume_at(&self, q: &[S]) -> S {
        self.volume + self.area * (q[self.position] - self.extension)
    }

    fn volume_at(&self, q: &[S]) -> S {
        let whole = self.whole_volume_at(q);
        whole.select_less(self.smallest_volume, || self.smallest_volume, || whole)
    }

    fn pressure_at(&self, q: &[S]) -> S {
        self.pressure * (-self.exponent * (self.volume_at(q) / self.volume).ln()).exp()
    }

    fn force(&self, pressure: S) -> S {
        (pressure - self.outside_pressure) * self.area
    }
}
