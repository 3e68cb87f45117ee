//! The liquid of a U-tank: its weight, its losses and its pump.

pub(crate) mod assembly;
mod drawn;
pub(crate) mod fields;
mod liquid;

pub use liquid::{UTankGeometry, UTankLiquid};

use super::{AnyElement, AnyWatcher, Context, Declaration, Element, Input, LevelEnd, Output, TankLevels, of_kind};
use crate::dynamics::Loads;
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};

/// Outputs with the levels in the port and the starboard column.
pub(crate) const LEVELS: [&str; 2] = ["level_port", "level_starboard"];

/// A U-tank on a body. Its liquid is a body on a hinge (see [`UTankLiquid`]); gravity pulls at that body's centre. This
/// element adds the difference from the pendulum: with the vector D from the pendulum's arc to the true centre of the
/// liquid, and the vertical n in the axes of the carrying body,
///
/// ```text
/// U = m g n . D(angle),    torque = -m g n . dD/dangle,    moment on the carrier = D x (-m g n)
/// ```
///
/// so that the potential of the levels is exactly `rho g A y^2` in an upright tank; and the pressure along the duct,
///
/// ```text
/// p = p_pump - 2 zeta sqrt(2 rho g A m_t) y' / A - K rho u |u| / 2,    u = y' A / A_duct
/// ```
#[derive(Clone, Debug)]
pub struct UTank<S = f64> {
    /// Name of the force, of the liquid's body and of its hinge.
    pub name: String,
    /// The body that carries the tank.
    pub carrier: usize,
    /// Index of the hinge in q.
    pub position: usize,
    /// Index of the hinge in v.
    pub coordinate: usize,
    /// The tank.
    pub geometry: UTankGeometry<S>,
    /// Its liquid.
    pub liquid: UTankLiquid<S>,
    /// Force against the rate of the level, N s/m.
    pub linear_damping: S,
    /// K.
    pub loss_coefficient: S,
    /// Pressure and flow of the pump at their limits, Pa and m^3/s.
    pub pump: Option<[S; 2]>,
    /// Top of the columns and of the duct, from the middle of the duct, m.
    pub ends: [S; 2],
}

impl<S: Scalar> Element<S> for UTank<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number = |variable, description, unit| Output::number(variable, description, "tank", &self.name, unit);
        let mut outputs = vec![
            number(LEVELS[0], "level in the port column above the middle of the duct", &["m"]),
            number(LEVELS[1], "level in the starboard column above the middle of the duct", &["m"]),
            number("tank_flow", "flow through the duct towards port", &["m^3/s"]),
        ];
        if self.pump.is_some() {
            outputs.push(number("pump_pressure", "pressure of the pump towards port", &["Pa"]));
            outputs.push(number("pump_power", "power of the pump on the liquid", &["W"]));
        }
        let inputs = self.pump.iter().map(|_| Input::lever(&self.name, -1.0, 0.0)).collect();
        Declaration { outputs, inputs, ..Declaration::default() }
    }

    /// Adds the weight in addition to the pendulum's, the losses and the pump.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let [beyond, slope] = self.liquid.beyond_the_arc(at.q[self.position]).map(Self::across);
        let weight = self.weight(at);
        let speed = self.speed(at);
        let loss = self.loss(speed);
        let pump = self.pressure(at) * self.liquid.area;
        loads.force[self.coordinate] += weight.dot(slope) + (pump - loss) / self.liquid.turn;
        loads.wrenches.push((self.carrier, Wrench { moment: beyond.cross(weight), force: Vector3::zero() }));
        loads.power.dissipated += loss * speed;
        loads.power.drives += pump * speed;
    }

    /// Returns the energy of the weight in addition to the pendulum's, J.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let [beyond, _] = self.liquid.beyond_the_arc(at.q[self.position]).map(Self::across);
        -self.weight(at).dot(beyond)
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let rise = at.q[self.position] / self.liquid.turn;
        let flow = self.speed(at) * self.liquid.area;
        out.extend([self.geometry.level + rise, self.geometry.level - rise, flow]);
        if self.pump.is_some() {
            let pressure = self.pressure(at);
            out.extend([pressure, pressure * flow]);
        }
    }

    fn watchers(&self) -> Vec<AnyWatcher> {
        let [top, duct] = self.ends.map(S::value);
        let ends = [
            LevelEnd { level: top, code: "liquid_at_top", warning: "its liquid reached the top of a column" },
            LevelEnd { level: duct, code: "air_in_duct", warning: "air reached the top of its duct" },
        ];
        vec![Box::new(TankLevels::new(&self.name, &LEVELS, ends))]
    }

    fn left_out_at_rest(&self) -> Option<&'static str> {
        let lossless = self.loss_coefficient.all(|loss| loss == 0.0);
        (!lossless).then_some("the loss of pressure quadratic in the flow")
    }
}

impl<S: Scalar> UTank<S> {
    /// Returns the U-tanks among elements.
    pub fn among(elements: &[AnyElement<S>]) -> impl Iterator<Item = &Self> {
        of_kind(elements)
    }

    /// Returns the moment of the free surface on a heeled ship, with the levels at rest, over g and the heel angle,
    /// `rho A d^2 / 2`, kg m^2.
    pub fn free_surface(&self) -> S {
        S::constant(0.5) * self.liquid.column_mass * self.geometry.distance * self.geometry.distance
    }

    fn across([y, z]: [S; 2]) -> Vector3<S> {
        Vector3([S::ZERO, y, z])
    }

    /// Returns the weight of the liquid, in the carrier's axes, N.
    fn weight(&self, at: &Context<'_, S>) -> Vector3<S> {
        let vertical = Vector3::new(S::ZERO, S::ZERO, S::ONE);
        at.links.to_body_axes(at.model, self.carrier, vertical) * -(self.liquid.mass * at.world.gravity)
    }

    /// Returns y', m/s.
    fn speed(&self, at: &Context<'_, S>) -> S {
        at.v[self.coordinate] / self.liquid.turn
    }

    /// Returns the force of the losses against y', N.
    fn loss(&self, speed: S) -> S {
        let Self { liquid, geometry, .. } = self;
        let half = S::constant(0.5) * self.loss_coefficient * geometry.density * liquid.area;
        let magnitude = speed.select_below(0.0, || -speed, || speed);
        speed * (self.linear_damping + half * liquid.contraction * liquid.contraction * magnitude)
    }

    /// Returns the pressure of the pump, Pa: it falls with the flow that it drives, to 0 at the limit of the flow.
    fn pressure(&self, at: &Context<'_, S>) -> S {
        let Some([pressure, limit]) = self.pump else { return S::ZERO };
        let lever = at.inputs[0];
        let flow = self.speed(at) * self.liquid.area / limit;
        let along = lever.select_below(0.0, || -flow, || flow);
        pressure * lever * (S::ONE - along.clipped(S::ZERO, S::ONE))
    }
}
