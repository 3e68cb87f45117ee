//! A free-flooding tank: the weight of its water, the pressures on it, and its losses.

mod air;
pub(crate) mod assembly;
mod column;
mod drawn;
pub(crate) mod fields;
mod opening_in_waves;

pub use air::{ATMOSPHERE_PA, AirChamber, AirPump};
pub use column::FloodedColumn;

use super::{
    AnyElement, AnyWatcher, Context, Declaration, Element, Input, LevelEnd, Output, RegularWaves, StateDeclaration,
    TankLevels, of_kind,
};
use crate::dynamics::{Kinematics, Loads};
use crate::scalar::Scalar;
use crate::sea::waves::Water;
use crate::spatial::{Frame, Vector3, Wrench};
use opening_in_waves::OpeningInWaves;

/// Output with the level of the water.
pub(crate) const LEVEL: &str = "water_level";

/// A tank with vertical walls on a hull, with an opening to the sea in its bottom. Its water is a body on a prismatic
/// joint (see [`FloodedColumn`]) with the mass at rest, on which gravity acts. x is the rise of the level from rest.
/// (Halse, Aesoy & Sporsheim, "An active roll reduction system using free flooding tanks controlled by vacuum pumps",
/// *World Maritime Technology Conference*, 2012; van Slooten, *Mathematical modeling of free-flooding anti-roll tanks*,
/// TU Delft, 2014.)
///
/// The data of a hull are those of its closed surface, so they contain the pressure of the sea over the opening. By the
/// momentum balance of the water in the tank, the hull then carries only the weight and the inertia of that water.
/// Added to the body on the joint are the weight of x, half of x above the opening, and the force along the joint by
/// which the sea drives the water in: with the vertical n in the axes of the carrier and the height z_o of the opening,
///
/// ```text
/// U = rho g A (x z_o + n_z x^2 / 2)
/// force = A (p_sea + rho g z_o - p_air) - c x' - K rho A u |u| / 2,    u = x' A / A_o
/// ```
///
/// so that it is conservative in calm water. p_sea is the pressure of the incident waves at the opening; 0 above their
/// surface.
#[derive(Clone, Debug)]
pub struct FreeFloodingTank<S = f64> {
    /// Name of the force, of the water's body and of its joint.
    pub name: String,
    /// The body that carries the tank.
    pub carrier: usize,
    /// The body of the water.
    pub body: usize,
    /// Whether the opening is open; if not, the water is frozen and the pump has no effect.
    pub open: bool,
    /// Index of the level in q.
    pub position: usize,
    /// Index of its rate in v.
    pub coordinate: usize,
    /// Middle of the opening from the carrier's centre, in its axes, m.
    pub opening: Vector3<S>,
    /// The tank and its water at rest.
    pub column: FloodedColumn<S>,
    /// c, N s/m.
    pub linear_damping: S,
    /// K.
    pub loss_coefficient: S,
    /// The pump of the air; without one the tank is open to the atmosphere.
    pub pump: Option<AirPump<S>>,
    /// The sea.
    pub water: Water,
}

/// The level and its surroundings at one moment.
struct Flooded<S> {
    /// x and x', m and m/s.
    rise: S,
    rate: S,
    /// z_o, m.
    height: S,
    /// n in the carrier's axes.
    vertical: Vector3<S>,
    /// p_sea + rho g z_o, Pa: pressure of the sea in excess of calm water.
    excess: S,
}

/// Water that has entered a tank in addition to the water at rest.
#[derive(Clone, Copy, Debug)]
pub struct AddedWater<S = f64> {
    /// kg; negative if water has left.
    pub mass: S,
    /// Its centre, half of the rise above the opening, world, m.
    pub centre: Vector3<S>,
}

/// Smallest share of the tank's volume that is air.
const LEAST_AIR: f64 = 0.01;

impl<S: Scalar> Element<S> for FreeFloodingTank<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number = |variable, description, unit| Output::number(variable, description, "tank", &self.name, unit);
        let mut outputs = vec![
            number(LEVEL, "level of the water above the opening", &["m"]),
            number("flooding_flow", "flow of sea water into the tank", &["m^3/s"]),
        ];
        if self.pump.is_none() {
            return Declaration { outputs, ..Declaration::default() };
        }
        outputs.push(number("air_pressure", "pressure of the air above that of the atmosphere", &["Pa"]));
        outputs.push(number("air_flow", "flow of air at the pressure of the atmosphere into the tank", &["m^3/s"]));
        outputs.push(number("air_power", "smallest possible power of the air pump", &["W"]));
        let states = vec![StateDeclaration::new("air_pressure", "Pa")];
        Declaration { states, outputs, inputs: vec![Input::lever(&self.name, -1.0, 0.0)], ..Declaration::default() }
    }

    /// Adds the weight in addition to the body's, the pressures and the losses.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        if !self.open {
            return;
        }
        let now = self.flooded(at);
        let (area, specific_weight) = (self.column.area(), at.world.specific_weight());
        let weight = now.vertical * -(specific_weight * area * now.rise);
        let centre = self.opening + Self::up(now.rise * S::constant(0.5));
        loads.wrenches.push((self.carrier, Wrench { moment: centre.cross(weight), force: weight }));
        let calm = -(specific_weight * (now.height + now.vertical[2] * now.rise));
        let air = self.air_pressure(at);
        let loss = self.loss(now.rate);
        loads.force[self.coordinate] += (calm + now.excess - air) * area - loss;
        loads.power.outside += now.excess * area * now.rate;
        loads.power.drives -= air * area * now.rate;
        loads.power.dissipated += loss * now.rate;
    }

    /// Writes the rate of the air pressure.
    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        if let Some(pump) = &self.pump {
            rates[0] = pump.pressure_rate(at.inputs[0], &self.air(at));
        }
    }

    /// U, J.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let Frame { rotation, position } = self.opening_frame(at);
        let rise = at.q[self.position];
        let height = position[2] + rotation.0[2][2] * rise * S::constant(0.5);
        at.world.specific_weight() * self.column.area() * rise * height
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        out.extend([self.column.level + at.q[self.position], self.column.area() * at.v[self.coordinate]]);
        if let Some(pump) = &self.pump {
            let (air, lever) = (self.air(at), at.inputs[0]);
            out.extend([air.pressure, pump.flow(lever, &air), pump.power(lever, &air)]);
        }
    }

    fn watchers(&self) -> Vec<AnyWatcher> {
        let ends = [
            LevelEnd {
                level: self.column.edges[2].value(),
                code: "water_at_top",
                warning: "its water reached its top",
            },
            LevelEnd { level: 0.0, code: "air_at_opening", warning: "air reached its opening" },
        ];
        vec![Box::new(TankLevels::new(&self.name, &[LEVEL], ends))]
    }

    fn regular_waves(&self) -> Option<Box<dyn RegularWaves<S> + '_>> {
        self.open.then(|| Box::new(OpeningInWaves(self)) as Box<dyn RegularWaves<S>>)
    }

    fn left_out_at_rest(&self) -> Option<&'static str> {
        let lossless = self.loss_coefficient.all(|loss| loss == 0.0);
        (self.open && !lossless).then_some("the loss of pressure quadratic in the flow")
    }
}

impl<S: Scalar> FreeFloodingTank<S> {
    /// The free-flooding tanks among elements.
    pub fn among(elements: &[AnyElement<S>]) -> impl Iterator<Item = &Self> {
        of_kind(elements)
    }

    fn up(height: S) -> Vector3<S> {
        Vector3([S::ZERO, S::ZERO, height])
    }

    /// Returns the frame of the carrier with its origin in the opening, in the world.
    fn opening_frame(&self, at: &Context<'_, S>) -> Frame<S> {
        at.links.body_frame(at.model, self.carrier).times(&Frame::translation(self.opening))
    }

    fn flooded(&self, at: &Context<'_, S>) -> Flooded<S> {
        let Frame { rotation, position } = self.opening_frame(at);
        let calm = -(at.world.specific_weight() * position[2]);
        let waves = at.world.waves.as_ref().filter(|_| at.evaluation.has_waves());
        let sea = match waves {
            Some(waves) => waves.pressure_pa(position, at.clock.time_s),
            None => calm.select_below(0.0, || S::ZERO, || calm),
        };
        Flooded {
            rise: at.q[self.position],
            rate: at.v[self.coordinate],
            height: position[2],
            vertical: Vector3(rotation.0[2]),
            excess: sea - calm,
        }
    }

    /// Returns the water that has entered in addition to the water at rest, with its centre in the world.
    pub fn added(&self, bodies: &Kinematics<S>) -> AddedWater<S> {
        let Frame { rotation, position } = bodies.world[self.carrier].times(&Frame::translation(self.opening));
        let middle = rotation.transpose_times(bodies.world[self.body].position - position)[2];
        let rise = middle - self.column.level * S::constant(0.5);
        let centre = position + rotation * Self::up(rise * S::constant(0.5));
        AddedWater { mass: self.column.mass_per_metre() * rise, centre }
    }

    /// p, Pa.
    fn air_pressure(&self, at: &Context<'_, S>) -> S {
        if self.pump.is_some() { at.states[0] } else { S::ZERO }
    }

    fn air(&self, at: &Context<'_, S>) -> AirChamber<S> {
        let (area, height) = (self.column.area(), self.column.edges[2]);
        let (room, least) = (height - self.column.level - at.q[self.position], height * S::constant(LEAST_AIR));
        let room = room.select_less(least, || least, || room);
        AirChamber { pressure: self.air_pressure(at), volume: area * room, growth: -(area * at.v[self.coordinate]) }
    }

    /// Returns the force of the losses against x', N.
    fn loss(&self, rate: S) -> S {
        let contraction = self.column.area() / self.column.opening_area;
        let half = S::constant(0.5) * self.loss_coefficient * self.column.mass_per_metre();
        let speed = rate.select_below(0.0, || -rate, || rate);
        rate * (self.linear_damping + half * contraction * contraction * speed)
    }
}
