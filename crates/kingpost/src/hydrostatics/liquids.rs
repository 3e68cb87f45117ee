//! Tanks of a model, and the report of each free surface.

use crate::dynamics::Kinematics;
use crate::elements::{AnyElement, FreeFloodingTank, SlackTank, UTank};
use crate::hydrostatics::hanging::Weight;
use serde::Serialize;

/// Free surface of a slack tank or a free-flooding tank, or both free surfaces of a U-tank. The tank is in a
/// hull, or in a body that the hull's joints carry and that does not hang.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FreeSurface {
    /// Name of the force in the scenario.
    pub force: String,
    /// Body that contains the tank.
    pub body: String,
    /// Mass of the liquid, kg; that of a slack tank is part of the body's mass.
    pub liquid_kg: f64,
    /// Height of the liquid's centre of mass above the keel in the present position, along the hull's z, m.
    pub keel_to_liquid_m: f64,
    /// Reduction of GM across and along the ship, `rho i / M`, with i the second moment of its present
    /// surface about its centroid and M the floating mass, m (Barrass & Derrett, *Ship Stability for Masters
    /// and Mates*, ch. on free surface). For a U-tank i is that of both levels, `A d^2 / 2`, with the area A
    /// of each and their distance d: the columns are narrow, and the liquid flows freely. For a tank that is
    /// open to the sea i is the loss of the ship's waterplane, `A (y - y') (y - y_0)`, with the centres of
    /// flotation y_0 without and y' with all openings.
    pub correction_m: [f64; 2],
}

/// The tanks of a model.
pub(super) struct Liquids<'a> {
    pub(super) slack_tanks: Vec<&'a SlackTank>,
    pub(super) u_tanks: Vec<&'a UTank>,
    pub(super) flooded: Vec<&'a FreeFloodingTank>,
}

impl<'a> Liquids<'a> {
    pub(super) fn of(elements: &'a [AnyElement]) -> Self {
        Self {
            slack_tanks: SlackTank::among(elements).collect(),
            u_tanks: UTank::among(elements).collect(),
            flooded: FreeFloodingTank::among(elements).collect(),
        }
    }

    /// Returns the total weight of these bodies and of the water that has entered them beyond the amount at
    /// rest.
    pub(super) fn with_flooding(&self, weight: Weight, at: &Kinematics, bodies: &[usize]) -> Weight {
        let on_them = self.flooded.iter().filter(|tank| bodies.contains(&tank.carrier));
        on_them.fold(weight, |Weight { mass, centre }, tank| {
            let added = tank.added(at);
            let total = mass + added.mass;
            Weight { mass: total, centre: (centre * mass + added.centre * added.mass) * (1.0 / total) }
        })
    }
}
