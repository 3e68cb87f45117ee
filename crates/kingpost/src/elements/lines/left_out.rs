//! The warning of a quasi-static line whose inertia and drag are not small.

use super::CatenaryLine;
use super::catenary::{EndForce, Span};
use crate::elements::Context;
use crate::elements::watcher::significant;
use crate::scalar::Scalar;
use core::f64::consts::TAU;

/// Density of steel, kg/m^3: a catenary line has a weight in water and no mass, and most are chain or wire.
const STEEL_KG_M3: f64 = 7850.0;
/// Added mass of a circular section across the flow, over the mass of the displaced water (Newman, *Marine Hydrodynamics*,
/// 1977, table 4.3).
const ADDED_MASS: f64 = 1.0;
/// Share of the variance of the waves at frequencies below the upper end of their spectrum.
const SPECTRUM: f64 = 0.99;
/// Motion of the fairlead for the stiffness, as a share of the line's length.
const MOTION: f64 = 1e-6;

impl<S: Scalar> CatenaryLine<S> {
    /// Returns the warning of a line with a natural period longer than the shortest waves: it then does not follow its
    /// fairlead from one shape at rest to the next.
    ///
    /// The first transverse period of the hanging part is that of a taut string, `T_1 = 2 L_s sqrt(m / T)` (Irvine, *Cable
    /// Structures*, 1981, sec. 3.1), with the mean tension T and the mass m per length with the added mass. Where inertia
    /// and drag hold the shape of the line, only its stretch follows the fairlead: the stiffness is then EA / L.
    pub(super) fn dynamics_left_out(&self, at: &Context<'_, S>) -> Option<String> {
        let (gravity, water) = (at.world.gravity.value(), at.world.water_density.value());
        let highest_rad_s = at.world.waves.as_ref()?.frequency_at(SPECTRUM)?;
        let (_, span) = self.way(at.model, at.links);
        let force = self.line.force(&span);
        let [upper, lower, grounded] = self.line.tensions(&force).map(Scalar::value);
        let (length, weight) = (self.line.unstretched_length.value(), self.line.weight.value());
        let mass = weight / gravity * (STEEL_KG_M3 + ADDED_MASS * water) / (STEEL_KG_M3 - water);
        let period_s = 2.0 * (length - grounded) * libm::sqrt(mass / (0.5 * (upper + lower)));
        // NaN if the line is slack or has no gravity.
        if period_s.is_nan() || period_s <= TAU / highest_rad_s {
            return None;
        }
        Some(format!(
            "{}: its inertia and drag are left out, and the first transverse period of its hanging part, {} s for steel, is longer \
             than the shortest waves, {} s: where water holds its shape, its tension rises by up to {} kN per metre of motion of \
             the fairlead, by the quasi-static line {} kN",
            self.name,
            significant(period_s, 3),
            significant(TAU / highest_rad_s, 3),
            significant(self.line.axial_stiffness.value() / length / 1e3, 3),
            significant(self.stiffness_along(&span, &force) / 1e3, 3)
        ))
    }

    /// Returns the rise of the tension per motion of the fairlead along the line, N/m.
    fn stiffness_along(&self, span: &Span<S>, force: &EndForce<S>) -> f64 {
        let tension = |force: &EndForce<S>| self.line.tensions(force)[0];
        let step = self.line.unstretched_length * S::constant(MOTION) / tension(force);
        let moved = Span { across: span.across + step * force.horizontal, up: span.up + step * force.vertical };
        let rise = tension(&self.line.force(&moved)) - tension(force);
        rise.value() / (MOTION * self.line.unstretched_length.value())
    }
}
