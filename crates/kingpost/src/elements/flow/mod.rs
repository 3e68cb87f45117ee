//! Wind and current on a body, by coefficients.

pub(crate) mod assembly;
pub(crate) mod fields;
mod table;

pub use table::{DirectionTable, TableError};

use super::hull::HullFrame;
use super::{Context, Declaration, Element, Output, VectorFrame};
use crate::dynamics::Loads;
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};
use crate::world::{CurrentAt, GustsAtHeight, World};

/// Forces of a flow, proportional to the square of its velocity relative to the body,
///
/// ```text
/// F_x = rho/2 V^2 A_x C_x(theta),   F_y = rho/2 V^2 A_y C_y(theta),   M_z = rho/2 V^2 A_y L C_n(theta)
/// ```
///
/// about a reference point, in body axes, with V the speed and theta the direction of the flow relative to that point,
/// in the body's x-y plane (OCIMF, *Mooring Equipment Guidelines*, 4th ed., 2018, appendix A: its angle of attack, 0
/// from astern and 180 degrees from ahead, is theta). V does not contain the rotation of the body.
#[derive(Clone, Debug)]
pub struct FlowLoad<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The body, and the point that the coefficients refer to.
    pub place: HullFrame<S>,
    /// The flow: wind or current.
    pub flow: Flow<S>,
    /// The gusts at that height, if the wind has any.
    pub gusts: Option<GustsAtHeight<S>>,
    /// A_x and A_y, m^2, and L, m.
    pub sizes: [S; 3],
    /// C_x, C_y and C_n over theta.
    pub coefficients: DirectionTable<S>,
}

/// The flow past a body, from the world.
#[derive(Clone, Copy, Debug)]
pub enum Flow<S = f64> {
    /// The wind at this height above the still water, m.
    Wind(S),
    /// The current, with the velocity of its profile that is used.
    Current(CurrentAt<S>),
}

impl<S: Scalar> Flow<S> {
    /// Returns the mean velocity in the world, m/s, and the density, kg/m^3.
    pub fn in_world(&self, world: &World<S>) -> (Vector3<S>, S) {
        match (self, &world.wind) {
            (Self::Wind(height), Some(wind)) => (wind.at_height(*height), wind.air_density),
            (Self::Wind(_), None) => (Vector3::zero(), S::ZERO),
            (Self::Current(place), _) => (world.current_at(place), world.water_density),
        }
    }
}

/// Square of the speed, m^2/s^2, below which the flow is neglected, because it has no direction.
const STILL: f64 = 1e-18;

impl<S: Scalar> Element<S> for FlowLoad<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let description = "force and moment of wind or current about the reference point of its coefficients";
        let force = Output::wrench("flow_force", description, "flow", &self.name, VectorFrame::Body);
        let description = "speed over ground of the wind or current that acts on a body";
        let speed = Output::number("flow_speed", description, "flow", &self.name, &["m/s"]);
        Declaration { outputs: vec![force, speed], ..Declaration::default() }
    }

    /// Adds the load and its work.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let wrench = self.about_centre(at);
        loads.power.outside += wrench.dot(&at.links.body_twist(at.model, self.place.body));
        loads.wrenches.push((self.place.body, wrench));
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let Wrench { moment, force } = self.wrench(at);
        out.extend(force.0);
        out.extend(moment.0);
        let [x, y, _] = self.velocity(at).0.0;
        let square = x * x + y * y;
        out.push(square.select_below(STILL, || S::ZERO, || square.select_below(STILL, || S::ONE, || square).sqrt()));
    }
}

impl<S: Scalar> FlowLoad<S> {
    /// Returns the velocity in the world, m/s, with gusts except at an equilibrium, and the density, kg/m^3.
    fn velocity(&self, at: &Context<'_, S>) -> (Vector3<S>, S) {
        let (mean, density) = self.flow.in_world(at.world);
        match (&self.gusts, &at.world.wind) {
            (Some(gusts), Some(wind)) if at.evaluation.has_waves() => {
                (mean + wind.along(gusts.speed(at.clock.time_s)), density)
            }
            _ => (mean, density),
        }
    }

    /// Returns force (N) and moment (N m) about the reference point, in body axes.
    pub fn wrench(&self, at: &Context<'_, S>) -> Wrench<S> {
        let (flow, density) = self.velocity(at);
        let [x, y, length] = self.sizes;
        let half = density * S::constant(0.5);
        let scales = [half * x, half * y, half * y * length];
        let through = self.place.through_water(at, flow).0.linear;
        let (along, aside) = (-through[0], -through[1]);
        let square = along * along + aside * aside;
        let moves = square.select_below(STILL, || S::ZERO, || S::ONE);
        let along = moves.select_below(0.5, || S::ONE, || along);
        let coefficients = self.coefficients.at(aside.atan2(along));
        let [x, y, yaw] = core::array::from_fn(|k| {
            let load = square * scales[k] * coefficients[k];
            moves.select_below(0.5, || S::ZERO, || load)
        });
        Wrench { moment: Vector3::new(S::ZERO, S::ZERO, yaw), force: Vector3::new(x, y, S::ZERO) }
    }

    fn about_centre(&self, at: &Context<'_, S>) -> Wrench<S> {
        self.place.about_centre(&self.wrench(at))
    }
}
