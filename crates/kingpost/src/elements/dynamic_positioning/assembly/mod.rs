//! Dynamic positioning: gains, filter and thrusters.

pub(crate) mod control_loop;

use crate::elements::AnyElement;
use crate::elements::dynamic_positioning::{
    Allocation, DynamicPositioning, Gains, Planar, Target, Thruster, ThrusterKind, WaveFilter,
};
use crate::elements::hull::HullFrame;
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::rigid_bodies::{from_centre, rigid};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Force as ForceSchema, PositioningGains, Scenario, ThrustPriority};
use crate::spatial::Vector3;
use control_loop::{ControlLoop, RootGrowth};
use core::f64::consts::{PI, TAU};

impl<S: Quantity> Assemble<S> for schema::DynamicPositioning<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(build(at.scenario, name, self, at.model)?.into_iter().collect())
    }
}

/// Dynamic positioning, if it is enabled and its body exists. Its states are placed later: see [`place_states`].
fn build<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::DynamicPositioning<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = format!("forces.{name}.dynamic_positioning");
    rigid(scenario, format!("{field}.body"), &given.body)?;
    check_finite(given, &field)?;
    check_gains(given, &field)?;
    let position = Vector3(given.position_m);
    let thrusters = thrusters(given, position);
    let found = if thrusters.is_empty() { "no enabled thruster".to_owned() } else { String::new() };
    let heading_first = given.priority == ThrustPriority::Heading;
    let allocation = Allocation::new(thrusters, heading_first).map_err(|error| {
        let found = if found.is_empty() { format!("thrusters that give {}", error.0) } else { found };
        FieldError::new(
            format!("{field}.thrusters"),
            found,
            "enabled thrusters that give surge, sway and yaw independently: two transverse thrusters at different positions along the ship, and one longitudinal thruster",
        )
    })?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let schema::StationTarget { x_m, y_m, heading_rad } = given.target;
    Ok(Some(Box::new(DynamicPositioning {
        name: name.to_owned(),
        place: HullFrame { body, origin: from_centre(scenario, &given.body, position) },
        target: Target { position: [x_m, y_m], heading: heading_rad },
        gains: gains(given, &field)?,
        filter: filter(given),
        allocation,
        bias: [S::ZERO; 3],
    })))
}

/// Checks the numbers that may have any finite value.
fn check_finite<S: Quantity>(given: &schema::DynamicPositioning<S>, field: &str) -> Result<(), FieldError> {
    let target = [("x_m", given.target.x_m), ("y_m", given.target.y_m), ("heading_rad", given.target.heading_rad)];
    let of_target = target.map(|(name, number)| (format!("target.{name}"), number));
    let of_point = given.position_m.iter().enumerate().map(|(k, number)| (format!("position_m.{k}"), *number));
    let of_thrusters = given.thrusters.iter().flat_map(|(name, thruster)| {
        let (kind, [position @ .., direction]) = (thruster.kind(), thruster.place());
        let positions = position.into_iter().enumerate().map(|(k, number)| (format!("position_m.{k}"), number));
        let numbers = positions.chain([("direction_rad".to_owned(), direction)]);
        numbers.map(|(field, number)| (format!("thrusters.{name}.{kind}.{field}"), number)).collect::<Vec<_>>()
    });
    let mut all = of_target.into_iter().chain(of_point).chain(of_thrusters);
    match all.find(|(_, number)| !number.all(f64::is_finite)) {
        Some((name, number)) => Err(FieldError::new(format!("{field}.{name}"), number, "a finite number")),
        None => Ok(()),
    }
}

/// Returns K_p, K_d and K_i of surge, sway and yaw.
fn numbers<S: Quantity>(gains: &PositioningGains<S>) -> [Planar<S>; 3] {
    match gains {
        PositioningGains::NaturalPeriods(given) => {
            let each = tunings(given);
            let (share, two) = (S::constant(if given.integral { 1.0 } else { 0.0 }), S::constant(2.0));
            [
                each.map(|tuning| tuning.inertia * tuning.frequency() * tuning.frequency()),
                each.map(|tuning| two * tuning.damping_ratio * tuning.frequency() * tuning.inertia),
                each.map(|tuning| {
                    share * tuning.inertia * tuning.frequency() * tuning.frequency() / tuning.integral_time()
                }),
            ]
        }
        PositioningGains::Stated(given) => {
            let [surge, sway] = given.stiffness_n_per_m.map(|gain| gain.get());
            let [surge_damping, sway_damping] = given.damping_n_s_per_m.map(|gain| gain.get());
            let [surge_integral, sway_integral] = given.integral_n_per_m_s.map(|gain| gain.get());
            [
                [surge, sway, given.yaw_stiffness_n_m_per_rad.get()],
                [surge_damping, sway_damping, given.yaw_damping_n_m_s_per_rad.get()],
                [surge_integral, sway_integral, given.yaw_integral_n_m_per_rad_s.get()],
            ]
        }
    }
}

/// The desired response in surge, sway or yaw.
#[derive(Clone, Copy)]
struct Tuning<S> {
    inertia: S,
    period_s: S,
    damping_ratio: S,
    integral_time_s: Option<S>,
}

impl<S: Quantity> Tuning<S> {
    fn frequency(self) -> S {
        S::constant(TAU) / self.period_s
    }

    fn integral_time(self) -> S {
        self.integral_time_s.unwrap_or(S::constant(10.0) / self.frequency())
    }
}

fn tunings<S: Quantity>(given: &schema::NaturalPeriods<S>) -> [Tuning<S>; 3] {
    let of = |tuning: &schema::TranslationTuning<S>| Tuning {
        inertia: tuning.mass_kg.get(),
        period_s: tuning.period_s.get(),
        damping_ratio: tuning.damping_ratio.get(),
        integral_time_s: tuning.integral_time_s.map(|time| time.get()),
    };
    let yaw = Tuning {
        inertia: given.yaw.inertia_kg_m2.get(),
        period_s: given.yaw.period_s.get(),
        damping_ratio: given.yaw.damping_ratio.get(),
        integral_time_s: given.yaw.integral_time_s.map(|time| time.get()),
    };
    [of(&given.surge), of(&given.sway), yaw]
}

/// Checks the integral times: by Routh's criterion m s^3 + K_d s^2 + K_p s + K_i is stable only if T_i > m / K_d.
fn check_gains<S: Quantity>(given: &schema::DynamicPositioning<S>, field: &str) -> Result<(), FieldError> {
    let PositioningGains::NaturalPeriods(periods) = &given.gains else { return Ok(()) };
    let each = ["surge", "sway", "yaw"].into_iter().zip(tunings(periods));
    for (name, tuning) in each.filter(|_| periods.integral) {
        let least = tuning.period_s / (S::constant(4.0 * PI) * tuning.damping_ratio);
        if !(tuning.integral_time() - least).all(|room| room > 0.0) {
            let allowed = format!(
                "more than period_s / (4 pi damping_ratio), {least}: otherwise the ship is unstable even without delays"
            );
            let field = format!("{field}.gains.natural_periods.{name}.integral_time_s");
            return Err(FieldError::new(field, tuning.integral_time(), allowed));
        }
    }
    Ok(())
}

/// Checks that a free ship with the stated mass is stable in spite of the delays of filter and thrusters, for every
/// dynamic positioning, enabled or not.
pub fn check_stability(scenario: &Scenario) -> Result<(), FieldError> {
    scenario.forces.iter().try_for_each(|(name, force)| match force {
        ForceSchema::DynamicPositioning(given) => check_loops(given, &format!("forces.{name}.dynamic_positioning")),
        _ => Ok(()),
    })
}

/// Allowed periods of a wave filter, s: periods of waves.
const WAVE_PERIODS_S: core::ops::RangeInclusive<f64> = 0.1..=1e3;

fn check_filter(given: &schema::DynamicPositioning, field: &str) -> Result<(), FieldError> {
    let Some(filter) = &given.wave_filter else { return Ok(()) };
    let notches = (0..).zip(&filter.notch_periods_s).map(|(k, period)| (format!("notch_periods_s.{k}"), period));
    let cutoff = filter.cutoff_period_s.iter().map(|period| ("cutoff_period_s".to_owned(), period));
    let wrong = notches.chain(cutoff).find(|(_, period)| !WAVE_PERIODS_S.contains(&period.get()));
    let Some((name, period)) = wrong else { return Ok(()) };
    Err(FieldError::new(format!("{field}.wave_filter.{name}"), period.get(), "a number from 0.1 to 1000"))
}

fn check_loops(given: &schema::DynamicPositioning, field: &str) -> Result<(), FieldError> {
    check_filter(given, field)?;
    let PositioningGains::NaturalPeriods(periods) = &given.gains else { return Ok(()) };
    let gains = numbers(&given.gains);
    let running = given.thrusters.values().filter(|thruster| thruster.enabled());
    let slowest = running.map(|thruster| thruster.numbers()[2]).fold(0.0, f64::max);
    for (k, (name, tuning)) in ["surge", "sway", "yaw"].into_iter().zip(tunings(periods)).enumerate() {
        let of = ControlLoop {
            inertia: tuning.inertia,
            gains: gains.map(|gains| gains[k]),
            filter: given.wave_filter.as_ref(),
            time_constant_s: slowest,
        };
        let delays = "the delays of wave filter and thrusters";
        let (found, allowed) = match of.growth() {
            RootGrowth::None => continue,
            RootGrowth::Of(root) => (
                format!(
                    "{} s, with which {delays} cause a growing oscillation of {:.1} s",
                    tuning.period_s,
                    TAU / root.im.abs()
                ),
                "a longer natural period, or shorter filter periods and thrusters' time constants",
            ),
            RootGrowth::Unknown => (
                format!(
                    "{} s, with which {delays} differ so much in magnitude that their stability cannot be found",
                    tuning.period_s
                ),
                "filter periods and thrusters' time constants of comparable magnitude",
            ),
        };
        return Err(FieldError::new(format!("{field}.gains.natural_periods.{name}.period_s"), found, allowed));
    }
    Ok(())
}

fn gains<S: Quantity>(given: &schema::DynamicPositioning<S>, field: &str) -> Result<Gains<S>, FieldError> {
    let [stiffness, damping, integral] = numbers(&given.gains);
    let field = format!("{field}.gains");
    let (mut integrates, mut tracking_time) = ([false; 3], [S::ONE; 3]);
    for k in 0..3 {
        integrates[k] = is_there(integral[k], &field)?;
        tracking_time[k] = match given.anti_windup_time_s {
            Some(time) => time.get(),
            None if !integrates[k] => S::ONE,
            None if is_there(damping[k], &field)? => (damping[k] / integral[k]).sqrt(),
            None => stiffness[k] / integral[k],
        };
    }
    Ok(Gains { stiffness, damping, integral, integrates, tracking_time })
}

/// Whether a gain is greater than 0; a direction without a gain cannot become unstable.
fn is_there<S: Quantity>(gain: S, field: &str) -> Result<bool, FieldError> {
    let there = gain.decides(field, |gain| gain > 0.0)?;
    if !there {
        gain.same(field)?;
    }
    Ok(there)
}

fn filter<S: Quantity>(given: &schema::DynamicPositioning<S>) -> WaveFilter<S> {
    let Some(given) = &given.wave_filter else { return WaveFilter::default() };
    let mut filter = WaveFilter::default();
    for period in &given.notch_periods_s {
        filter = filter.with_notch(S::constant(TAU) / period.get(), given.notch_damping_ratio.get());
    }
    if let Some(period) = given.cutoff_period_s {
        filter = filter.with_low_pass(S::constant(TAU) / period.get(), given.cutoff_damping_ratio.get());
    }
    filter
}

/// Returns the enabled thrusters, with positions relative to the held point.
fn thrusters<S: Quantity>(given: &schema::DynamicPositioning<S>, point: Vector3<S>) -> Vec<Thruster<S>> {
    let running = given.thrusters.iter().filter(|(_, thruster)| thruster.enabled());
    let build = |(name, given): (&schema::Name, &schema::Thruster<S>)| {
        let [x, y, z, direction] = given.place();
        let [ahead, astern, time_constant, weight] = given.numbers();
        let (sin, cos) = direction.sin_cos();
        let kind = match given {
            schema::Thruster::Azimuth(_) => ThrusterKind::Azimuth { limit: ahead },
            _ => ThrusterKind::Fixed { direction: [cos, sin], ahead, astern },
        };
        let position = Vector3::new(x, y, z) - point;
        Thruster { name: name.to_string(), position, kind, time_constant, weight }
    };
    running.map(build).collect()
}

impl<S: Quantity> schema::Thruster<S> {
    fn kind(&self) -> &'static str {
        match self {
            Self::Tunnel(_) => "tunnel",
            Self::MainPropeller(_) => "main_propeller",
            Self::Azimuth(_) => "azimuth",
        }
    }

    fn enabled(&self) -> bool {
        match self {
            Self::Tunnel(given) => given.enabled,
            Self::MainPropeller(given) => given.enabled,
            Self::Azimuth(given) => given.enabled,
        }
    }

    /// Returns position, m, and direction, rad.
    fn place(&self) -> [S; 4] {
        let ([x, y, z], direction) = match self {
            Self::Tunnel(given) => (given.position_m, given.direction_rad),
            Self::MainPropeller(given) => (given.position_m, given.direction_rad),
            Self::Azimuth(given) => (given.position_m, S::ZERO),
        };
        [x, y, z, direction]
    }

    /// Returns the limits ahead and astern, N, the time constant, s, and the weight.
    fn numbers(&self) -> [S; 4] {
        let [ahead, astern, time_constant, weight] = match self {
            Self::Tunnel(t) => [t.max_thrust_n, t.max_thrust_n, t.time_constant_s, t.weight],
            Self::MainPropeller(t) => [t.max_thrust_n, t.max_astern_thrust_n, t.time_constant_s, t.weight],
            Self::Azimuth(t) => [t.max_thrust_n, t.max_thrust_n, t.time_constant_s, t.weight],
        };
        [ahead, astern, time_constant, weight].map(|number| number.get())
    }
}
