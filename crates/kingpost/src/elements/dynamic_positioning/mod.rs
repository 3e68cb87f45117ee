//! Dynamic positioning: a controller and thrusters that keep a ship in its place.

mod allocation;
mod control;
mod thruster;
mod wave_filter;

pub use allocation::{Allocation, CannotGive};
pub use control::{Deviation, Gains, Planar, Target};
pub use thruster::{Thrust, Thruster, ThrusterKind};
pub use wave_filter::WaveFilter;

use crate::dynamics::{LinkKinematics, Loads, Moment};
use crate::elements::hull::HullFrame;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};

/// A ship on dynamic positioning.
///
/// With e the error and nu the velocity in the axes of the heading psi, h(s) the wave filter and b the integrals, as a
/// force and a moment in world axes,
///
/// ```text
/// tau = h(s) [K_p e - K_d nu] + R(psi)^T b,       b' = R(psi) [K_i e + (tau_c - tau) / T_t]
/// ```
///
/// (PID for positioning with the integral in world axes: Fossen, *Handbook of Marine Craft Hydrodynamics and Motion
/// Control*, 2011, sec. 12.2). tau_c is what of tau the thrusters can give, by [`Allocation`], in the hull's x-y plane;
/// while that is less than tau the second term of b' keeps the integrals from winding up (back-calculation: Åström &
/// Hägglund, *PID Controllers*, 2nd ed., 1995, sec. 3.5). Each [`Thruster`] follows its command in its own time and acts
/// where it is.
///
/// The extra states are b, those of the [`WaveFilter`] and the thrusts. A run begins with the thrusters at what is asked
/// for there.
#[derive(Clone, Debug)]
pub struct DynamicPositioning<S = f64> {
    /// Name of the force in the scenario.
    pub name: String,
    /// The body, and the point that is kept.
    pub place: HullFrame<S>,
    /// Where.
    pub target: Target<S>,
    /// K_p, K_d, K_i.
    pub gains: Gains<S>,
    /// h(s).
    pub filter: WaveFilter<S>,
    /// The thrusters.
    pub allocation: Allocation<S>,
    /// b where a run begins: force along x and y of the world, N, and moment, N m.
    pub bias: [S; 3],
    /// Whether an equilibrium is sought: thrusts then follow the error at once, and without limits.
    pub settling: bool,
    /// First of its states among those of forces.
    pub first_state: usize,
}

/// Dynamic positioning at one moment: force along the ship and athwartships, N, and yaw moment, N m, about the point
/// that is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PositioningReading<S = f64> {
    /// Surge and sway, m, and yaw, rad, that lack.
    pub error: Planar<S>,
    /// What the controller asks for.
    pub demand: Planar<S>,
    /// What of that the thrusters are told to give.
    pub command: Planar<S>,
    /// What they give.
    pub delivered: Planar<S>,
}

/// A thruster at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThrusterReading<S = f64> {
    /// Along and athwart the hull, N.
    pub force: [S; 2],
    /// With its sign, or its length where the thruster turns, N.
    pub thrust: S,
    /// Of what the thruster can give that way.
    pub utilisation: S,
}

/// While an equilibrium is sought, what has an integral is held by this many times K_p.
const SETTLING_STIFFNESS: f64 = 100.0;

/// What is asked for at one moment, and what of it can be given.
struct Asked<S> {
    at: Deviation<S>,
    /// K_p e - K_d nu.
    proportional: Planar<S>,
    demand: Planar<S>,
    command: Planar<S>,
}

impl<S: Scalar> DynamicPositioning<S> {
    /// Adds the thrusts, and their work.
    pub fn apply(&self, at: &Moment<'_, S>, loads: &mut Loads<S>) {
        let wrench = if self.settling {
            let command = self.settling_command(at.model, at.links);
            self.wrench(|i, _| self.allocation.thrust(i, command))
        } else {
            let thrusts = self.thrusts(at);
            self.wrench(|_, first| thrust_at(thrusts, first))
        };
        let wrench = self.place.about_centre(&wrench);
        loads.power.outside += wrench.dot(&at.links.body_twist(at.model, self.place.body));
        loads.wrenches.push((self.place.body, wrench));
    }

    /// Number of its extra states.
    pub fn state_count(&self) -> usize {
        self.bias.len() + self.filter.state_count() + self.allocation.components()
    }

    /// Writes the rates of its extra states.
    pub fn state_rates(&self, at: &Moment<'_, S>, rates: &mut [S]) {
        let Asked { at: deviation, proportional, demand, command } = self.asked(at);
        let (of_bias, rest) = rates[self.first_state..][..self.state_count()].split_at_mut(self.bias.len());
        let (of_filter, of_thrusts) = rest.split_at_mut(self.filter.state_count());
        let integral = self.gains.integral_rate(&deviation, demand, command);
        of_bias.copy_from_slice(&deviation.to_world(integral));
        self.filter.rates(proportional, self.filter_states(at), of_filter);
        let thrusts = self.thrusts(at);
        let mut first = 0;
        for (i, thruster) in self.allocation.thrusters().iter().enumerate() {
            let wanted = self.allocation.thrust(i, command);
            for k in 0..thruster.components() {
                of_thrusts[first + k] = (wanted[k] - thrusts[first + k]) / thruster.time_constant;
            }
            first += thruster.components();
        }
    }

    /// Writes its extra states where a run begins: nothing of the filter and the thrusts is on its way.
    pub fn first_states(&self, model: &Model<S>, links: &LinkKinematics<S>, states: &mut [S]) {
        let at = self.target.deviation(&self.place, model, links);
        let (proportional, integral) = (self.gains.proportional(&at), at.from_world(self.bias));
        let command = self.allocation.limited(core::array::from_fn(|k| proportional[k] + integral[k]));
        let (of_bias, rest) = states[self.first_state..][..self.state_count()].split_at_mut(self.bias.len());
        let (of_filter, of_thrusts) = rest.split_at_mut(self.filter.state_count());
        of_bias.copy_from_slice(&self.bias);
        self.filter.settled_states(proportional, of_filter);
        let mut first = 0;
        for (i, thruster) in self.allocation.thrusters().iter().enumerate() {
            let count = thruster.components();
            of_thrusts[first..first + count].copy_from_slice(&self.allocation.thrust(i, command)[..count]);
            first += count;
        }
    }

    /// Names of its extra states.
    pub fn state_names(&self) -> Vec<String> {
        let integrals = ["x", "y", "yaw"].map(|axis| format!("integral.{axis}"));
        let of_thruster = |thruster: &Thruster<S>| {
            let parts: &[&str] = if thruster.components() == 1 { &["thrust"] } else { &["thrust_x", "thrust_y"] };
            parts.iter().map(|part| format!("{}.{part}", thruster.name)).collect::<Vec<_>>()
        };
        let thrusts = self.allocation.thrusters().iter().flat_map(of_thruster);
        let names = integrals.into_iter().chain(self.filter.state_names()).chain(thrusts);
        names.map(|name| format!("{}.{name}", self.name)).collect()
    }

    /// While an equilibrium is sought: hands what holds the ship over to the integrals, and says by how much the ship is
    /// still off where integrals should take it, m or rad.
    pub fn take_over(&mut self, model: &Model<S>, links: &LinkKinematics<S>) -> S {
        let at = self.target.deviation(&self.place, model, links);
        let (held, carried) = (self.settling_command(model, links), at.from_world(self.bias));
        let next = core::array::from_fn(|k| if self.gains.integrates[k] { held[k] } else { carried[k] });
        self.bias = at.to_world(next);
        let off = (0..3).filter(|&k| self.gains.integrates[k]).map(|k| at.error[k]);
        off.map(|error| error.select_below(0.0, || -error, || error))
            .fold(S::ZERO, |most, off| most.select_less(off, || off, || most))
    }

    /// Error, demand, and what is given.
    pub fn reading(&self, at: &Moment<'_, S>) -> PositioningReading<S> {
        let Asked { at: deviation, demand, command, .. } = self.asked(at);
        let thrusts = self.thrusts(at);
        let Wrench { moment, force } = self.wrench(|_, first| thrust_at(thrusts, first));
        PositioningReading { error: deviation.error, demand, command, delivered: [force[0], force[1], moment[2]] }
    }

    /// What each thruster does.
    pub fn thruster_readings<'a>(&'a self, at: &Moment<'a, S>) -> impl Iterator<Item = ThrusterReading<S>> + 'a {
        let (thrusts, mut first) = (self.thrusts(at), 0);
        self.allocation.thrusters().iter().map(move |thruster| {
            let thrust = thrust_at(thrusts, first);
            first += thruster.components();
            ThrusterReading {
                force: thruster.force(thrust),
                thrust: thruster.signed_thrust(thrust),
                utilisation: thruster.utilisation(thrust),
            }
        })
    }

    /// What holds the ship while an equilibrium is sought, limits left out: they would hide the way there.
    fn settling_command(&self, model: &Model<S>, links: &LinkKinematics<S>) -> Planar<S> {
        let at = self.target.deviation(&self.place, model, links);
        let carried = at.from_world(self.bias);
        let stiffer = |k: usize| if self.gains.integrates[k] { SETTLING_STIFFNESS } else { 1.0 };
        let held = |k: usize| carried[k] + self.gains.stiffness[k] * at.error[k] * S::constant(stiffer(k));
        core::array::from_fn(held)
    }

    /// While an equilibrium is sought: the largest utilisation of a thruster that holds the ship there, limits left out.
    pub fn utilisation(&self, model: &Model<S>, links: &LinkKinematics<S>) -> S {
        let command = self.settling_command(model, links);
        let thrusters = self.allocation.thrusters().iter().enumerate();
        let each = thrusters.map(|(i, thruster)| thruster.utilisation(self.allocation.thrust(i, command)));
        each.fold(S::ZERO, |most, next| most.select_less(next, || next, || most))
    }

    fn asked(&self, at: &Moment<'_, S>) -> Asked<S> {
        let deviation = self.target.deviation(&self.place, at.model, at.links);
        let proportional = self.gains.proportional(&deviation);
        let passed = self.filter.output(proportional, self.filter_states(at));
        let bias = core::array::from_fn(|k| at.states[self.first_state + k]);
        let integral = deviation.from_world(bias);
        let demand = core::array::from_fn(|k| passed[k] + integral[k]);
        Asked { at: deviation, proportional, demand, command: self.allocation.limited(demand) }
    }

    /// Force and moment of all thrusts about the point that is kept, body axes; `thrust` gives that of a thruster by its
    /// number and that of its first state.
    fn wrench(&self, thrust: impl Fn(usize, usize) -> Thrust<S>) -> Wrench<S> {
        let (mut sum, mut first) = (Wrench::zero(), 0);
        for (i, thruster) in self.allocation.thrusters().iter().enumerate() {
            let [x, y] = thruster.force(thrust(i, first));
            let force = Vector3::new(x, y, S::ZERO);
            sum += Wrench { moment: thruster.position.cross(force), force };
            first += thruster.components();
        }
        sum
    }

    fn filter_states<'a>(&self, at: &Moment<'a, S>) -> &'a [S] {
        &at.states[self.first_state + self.bias.len()..][..self.filter.state_count()]
    }

    fn thrusts<'a>(&self, at: &Moment<'a, S>) -> &'a [S] {
        let before = self.bias.len() + self.filter.state_count();
        &at.states[self.first_state + before..][..self.allocation.components()]
    }
}

/// Two numbers from a list; 0 behind its end.
fn thrust_at<S: Scalar>(thrusts: &[S], first: usize) -> Thrust<S> {
    core::array::from_fn(|k| thrusts.get(first + k).copied().unwrap_or(S::ZERO))
}
