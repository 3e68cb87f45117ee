//! Dynamic positioning: a controller and thrusters that hold a ship in position.

mod allocation;
pub(crate) mod assembly;
mod control;
pub(crate) mod fields;
mod thruster;
mod wave_filter;

pub use allocation::{Allocation, CannotGive};
pub use control::{Deviation, Gains, Planar, Target};
pub use thruster::{Thrust, Thruster, ThrusterKind};
pub use wave_filter::WaveFilter;

use crate::dynamics::{LinkKinematics, Loads};
use crate::elements::hull::HullFrame;
use crate::elements::{
    Components, Context, Declaration, Element, ElementState, EvaluationMode, Output, Settling, StateDeclaration,
    Support, VectorFrame,
};
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
/// Control*, 2011, sec. 12.2). tau_c is the part of tau that the thrusters can give, by [`Allocation`], in the hull's
/// x-y plane; while it is less than tau the second term of b' keeps the integrals from winding up (back-calculation:
/// Åström & Hägglund, *PID Controllers*, 2nd ed., 1995, sec. 3.5). Each [`Thruster`] follows its command with its own
/// time constant and acts at its own position.
///
/// The extra states are b, those of the [`WaveFilter`] and the thrusts. A run begins with the thrusters at the demanded
/// thrust.
#[derive(Clone, Debug)]
pub struct DynamicPositioning<S = f64> {
    /// Name of the force in the scenario.
    pub name: String,
    /// The body, and the point that is held.
    pub place: HullFrame<S>,
    /// The target.
    pub target: Target<S>,
    /// K_p, K_d, K_i.
    pub gains: Gains<S>,
    /// h(s).
    pub filter: WaveFilter<S>,
    /// The thrusters.
    pub allocation: Allocation<S>,
    /// b at the start of a run: force along the world's x and y, N, and moment, N m.
    pub bias: [S; 3],
}

/// Factor on K_p for motions with an integral while an equilibrium is sought.
const SETTLING_STIFFNESS: f64 = 100.0;

/// The demand at one moment, and the part that the thrusters can give.
struct Demand<S> {
    at: Deviation<S>,
    /// K_p e - K_d nu.
    proportional: Planar<S>,
    demand: Planar<S>,
    command: Planar<S>,
}

impl<S: Scalar> Element<S> for DynamicPositioning<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        Declaration { states: self.declared_states(), outputs: self.declared_outputs(), ..Declaration::default() }
    }

    /// Sets filter and thrusts to their steady state.
    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        let at = self.target.deviation(&self.place, at.model, at.links);
        let (proportional, integral) = (self.gains.proportional(&at), at.from_world(self.bias));
        let command = self.allocation.limited(core::array::from_fn(|k| proportional[k] + integral[k]));
        let (of_bias, rest) = own.states.split_at_mut(self.bias.len());
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

    /// Adds the thrusts and their work. While an equilibrium is sought, the thrusts follow the error without lag and
    /// without limits.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let wrench = if at.evaluation == EvaluationMode::Settling {
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

    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        let Demand { at: deviation, proportional, demand, command } = self.asked(at);
        let (of_bias, rest) = rates.split_at_mut(self.bias.len());
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

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let Demand { at: deviation, demand, command, .. } = self.asked(at);
        let thrusts = self.thrusts(at);
        let Wrench { moment, force } = self.wrench(|_, first| thrust_at(thrusts, first));
        for planar in [deviation.error, demand, command, [force[0], force[1], moment[2]]] {
            out.extend(planar);
        }
        let of_thrusters = || {
            let mut first = 0;
            self.allocation.thrusters().iter().map(move |thruster| {
                let thrust = thrust_at(thrusts, first);
                first += thruster.components();
                (thruster, thrust)
            })
        };
        out.extend(of_thrusters().map(|(thruster, thrust)| thruster.signed_thrust(thrust)));
        out.extend(of_thrusters().flat_map(|(thruster, thrust)| {
            let [x, y] = thruster.force(thrust);
            [x, y, S::ZERO]
        }));
        out.extend(of_thrusters().map(|(thruster, thrust)| thruster.utilisation(thrust)));
    }

    fn supports(&self) -> Vec<Support> {
        vec![Support::Station([Some(self.place.body), None])]
    }

    fn settling(&self) -> Option<&dyn Settling<S>> {
        Some(self)
    }

    fn settling_mut(&mut self) -> Option<&mut dyn Settling<S>> {
        Some(self)
    }
}

impl<S: Scalar> Settling<S> for DynamicPositioning<S> {
    fn trim(&self) -> &[S] {
        &self.bias
    }

    fn set_trim(&mut self, trim: &[S]) {
        self.bias.copy_from_slice(trim);
    }

    /// Transfers the holding force to the integrals; returns the remaining deviation from the target in the motions
    /// with integrals, m or rad.
    fn take_over(&mut self, at: &Context<'_, S>) -> S {
        let (model, links) = (at.model, at.links);
        let at = self.target.deviation(&self.place, model, links);
        let (held, carried) = (self.settling_command(model, links), at.from_world(self.bias));
        let next = core::array::from_fn(|k| if self.gains.integrates[k] { held[k] } else { carried[k] });
        self.bias = at.to_world(next);
        let off = (0..3).filter(|&k| self.gains.integrates[k]).map(|k| at.error[k]);
        off.map(|error| error.select_below(0.0, || -error, || error))
            .fold(S::ZERO, |most, off| most.select_less(off, || off, || most))
    }

    /// Returns the largest utilisation of a thruster that holds the ship at this position, without limits.
    fn utilisation(&self, at: &Context<'_, S>) -> S {
        let command = self.settling_command(at.model, at.links);
        let thrusters = self.allocation.thrusters().iter().enumerate();
        let each = thrusters.map(|(i, thruster)| thruster.utilisation(self.allocation.thrust(i, command)));
        each.fold(S::ZERO, |most, next| most.select_less(next, || next, || most))
    }
}

impl<S: Scalar> DynamicPositioning<S> {
    fn declared_states(&self) -> Vec<StateDeclaration> {
        let axes = [("x", "N"), ("y", "N"), ("yaw", "N m")];
        let integrals = axes.map(|(axis, unit)| StateDeclaration::new(format!("integral.{axis}"), unit));
        let of_thruster = |thruster: &Thruster<S>| {
            let parts: &[&str] = if thruster.components() == 1 { &["thrust"] } else { &["thrust_x", "thrust_y"] };
            parts.iter().map(|part| StateDeclaration::new(format!("{}.{part}", thruster.name), "N")).collect::<Vec<_>>()
        };
        let thrusts = self.allocation.thrusters().iter().flat_map(of_thruster);
        integrals.into_iter().chain(self.filter.declared()).chain(thrusts).collect()
    }

    fn declared_outputs(&self) -> Vec<Output> {
        let error = "surge and sway from a ship on dynamic positioning to its target, and the heading error";
        let demand = "force and yaw moment that dynamic positioning demands, about the held point";
        let force = "force and yaw moment that the thrusters give, about the held point";
        let planar = |variable, description, frame, units| Output {
            components: Components::Planar,
            frame,
            units,
            ..Output::number(variable, description, "station", &self.name, &["N"])
        };
        let labels: Vec<String> =
            self.allocation.thrusters().iter().map(|thruster| format!("{}.{}", self.name, thruster.name)).collect();
        let of_thrusters = |variable, description, unit| Output {
            labels: labels.clone(),
            ..Output::number(variable, description, "thruster", "", unit)
        };
        vec![
            planar("station_error", error, VectorFrame::Heading, &["m", "m", "rad"]),
            planar("station_demand", demand, VectorFrame::Heading, &PLANAR),
            planar(
                "station_command",
                "part of the demand that is commanded to the thrusters",
                VectorFrame::Body,
                &PLANAR,
            ),
            planar("station_force", force, VectorFrame::Body, &PLANAR),
            of_thrusters("thruster_thrust", "thrust, negative astern; of an azimuth thruster the magnitude", &["N"]),
            Output {
                components: Components::Axis,
                frame: VectorFrame::Body,
                ..of_thrusters("thruster_force", "thrust as a force", &["N"])
            },
            of_thrusters("thruster_utilisation", "thrust over the thruster's limit in its direction", &["1"]),
        ]
    }

    /// Returns the force that holds the ship while an equilibrium is sought, without limits: with limits the search
    /// would not converge.
    fn settling_command(&self, model: &Model<S>, links: &LinkKinematics<S>) -> Planar<S> {
        let at = self.target.deviation(&self.place, model, links);
        let carried = at.from_world(self.bias);
        let stiffer = |k: usize| if self.gains.integrates[k] { SETTLING_STIFFNESS } else { 1.0 };
        let held = |k: usize| carried[k] + self.gains.stiffness[k] * at.error[k] * S::constant(stiffer(k));
        core::array::from_fn(held)
    }

    fn asked(&self, at: &Context<'_, S>) -> Demand<S> {
        let deviation = self.target.deviation(&self.place, at.model, at.links);
        let proportional = self.gains.proportional(&deviation);
        let passed = self.filter.output(proportional, self.filter_states(at));
        let bias = core::array::from_fn(|k| at.states[k]);
        let integral = deviation.from_world(bias);
        let demand = core::array::from_fn(|k| passed[k] + integral[k]);
        Demand { at: deviation, proportional, demand, command: self.allocation.limited(demand) }
    }

    /// Returns force and moment of all thrusts about the held point, body axes; `thrust` returns the thrust of a
    /// thruster from its number and the index of its first state.
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

    fn filter_states<'a>(&self, at: &Context<'a, S>) -> &'a [S] {
        &at.states[self.bias.len()..][..self.filter.state_count()]
    }

    fn thrusts<'a>(&self, at: &Context<'a, S>) -> &'a [S] {
        let before = self.bias.len() + self.filter.state_count();
        &at.states[before..][..self.allocation.components()]
    }
}

/// Units of a force in a plane and the moment about its normal.
const PLANAR: [&str; 3] = ["N", "N", "N m"];

/// Returns two numbers from a list; 0 beyond its end.
fn thrust_at<S: Scalar>(thrusts: &[S], first: usize) -> Thrust<S> {
    core::array::from_fn(|k| thrusts.get(first + k).copied().unwrap_or(S::ZERO))
}
