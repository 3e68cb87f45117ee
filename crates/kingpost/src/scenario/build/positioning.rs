//! Dynamic positioning: gains, filter and thrusters.

use super::super::schema::{self, Force as ForceSchema, PositioningGains, Scenario, ThrustPriority};
use super::FieldError;
use super::damping::{from_centre, rigid};
use super::positioning_loop::Loop;
use super::reading::{Gathered, Reading};
use crate::elements::dynamic_positioning::{
    Allocation, DynamicPositioning, Gains, Planar, Target, Thruster, ThrusterKind, WaveFilter,
};
use crate::elements::{AnyElement, hull::HullFrame};
use crate::model::Model;
use crate::spatial::Vector3;
use core::f64::consts::{PI, TAU};

/// Dynamic positioning, where it is on and its body there. Its states are placed later: see [`place_states`].
pub fn build<S: Gathered>(
    scenario: &Reading<Scenario>,
    name: &str,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let all = scenario.part(|scenario| &scenario.forces[name]).kind(positioning_of);
    let (given, field) = (all.first(), format!("forces.{name}.dynamic_positioning"));
    rigid(scenario.first(), format!("{field}.body"), &given.body)?;
    check_finite(given, &field)?;
    check_gains(given, &field)?;
    let position = all.vector(|given| given.position_m);
    let thrusters = thrusters(&all, position);
    let found = if thrusters.is_empty() { "none that runs".to_owned() } else { String::new() };
    let heading_first = given.priority == ThrustPriority::Heading;
    let allocation = Allocation::new(thrusters, heading_first).map_err(|error| {
        let found = if found.is_empty() { format!("thrusters that give {}", error.0) } else { found };
        FieldError::new(
            format!("{field}.thrusters"),
            found,
            "thrusters that run and give surge, sway and yaw independently: two of them one behind the other, and one \
             along the ship",
        )
    })?;
    check_loops(given, &field)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let [x, y, heading] = all.numbers(|given| [given.target.x_m, given.target.y_m, given.target.heading_rad]);
    Ok(Some(Box::new(DynamicPositioning {
        name: name.to_owned(),
        place: HullFrame { body, origin: from_centre(scenario, &given.body, position) },
        target: Target { position: [x, y], heading },
        gains: gains(&all),
        filter: filter(&all),
        allocation,
        bias: [S::ZERO; 3],
    })))
}

fn positioning_of(force: &ForceSchema) -> Option<&schema::DynamicPositioning> {
    if let ForceSchema::DynamicPositioning(positioning) = force { Some(positioning) } else { None }
}

/// Numbers that may be anything finite.
fn check_finite(given: &schema::DynamicPositioning, field: &str) -> Result<(), FieldError> {
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
    match all.find(|(_, number)| !number.is_finite()) {
        Some((name, number)) => Err(FieldError::new(format!("{field}.{name}"), number, "a finite number")),
        None => Ok(()),
    }
}

/// K_p, K_d and K_i of surge, sway and yaw.
fn numbers(gains: &PositioningGains) -> [Planar<f64>; 3] {
    match gains {
        PositioningGains::NaturalPeriods(given) => {
            let each = tunings(given);
            let share = if given.integral { 1.0 } else { 0.0 };
            [
                each.map(|tuning| tuning.inertia * tuning.frequency() * tuning.frequency()),
                each.map(|tuning| 2.0 * tuning.damping_ratio * tuning.frequency() * tuning.inertia),
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

/// How one of surge, sway and yaw is to answer.
#[derive(Clone, Copy)]
struct Tuning {
    inertia: f64,
    period_s: f64,
    damping_ratio: f64,
    integral_time_s: Option<f64>,
}

impl Tuning {
    fn frequency(self) -> f64 {
        TAU / self.period_s
    }

    fn integral_time(self) -> f64 {
        self.integral_time_s.unwrap_or(10.0 / self.frequency())
    }
}

fn tunings(given: &schema::NaturalPeriods) -> [Tuning; 3] {
    let of = |tuning: &schema::TranslationTuning| Tuning {
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

/// By Routh's criterion m s^3 + K_d s^2 + K_p s + K_i is stable only where T_i > m / K_d.
fn check_gains(given: &schema::DynamicPositioning, field: &str) -> Result<(), FieldError> {
    let PositioningGains::NaturalPeriods(periods) = &given.gains else { return Ok(()) };
    let each = ["surge", "sway", "yaw"].into_iter().zip(tunings(periods));
    for (name, tuning) in each.filter(|_| periods.integral) {
        let least = tuning.period_s / (4.0 * PI * tuning.damping_ratio);
        if tuning.integral_time() <= least {
            let allowed =
                format!("more than period_s / (4 pi damping_ratio), {least}: else even a ship alone is unstable");
            let field = format!("{field}.gains.natural_periods.{name}.integral_time_s");
            return Err(FieldError::new(field, tuning.integral_time(), allowed));
        }
    }
    Ok(())
}

/// The delays of filter and thrusters must leave a free ship of the stated mass stable.
fn check_loops(given: &schema::DynamicPositioning, field: &str) -> Result<(), FieldError> {
    let PositioningGains::NaturalPeriods(periods) = &given.gains else { return Ok(()) };
    let gains = numbers(&given.gains);
    let running = given.thrusters.values().filter(|thruster| thruster.enabled());
    let slowest = running.map(|thruster| thruster.numbers()[2]).fold(0.0, f64::max);
    for (k, (name, tuning)) in ["surge", "sway", "yaw"].into_iter().zip(tunings(periods)).enumerate() {
        let of = Loop {
            inertia: tuning.inertia,
            gains: gains.map(|gains| gains[k]),
            filter: given.wave_filter.as_ref(),
            time_constant_s: slowest,
        };
        if let Some(root) = of.growing() {
            let found = format!(
                "{} s, with which the delays of wave filter and thrusters make an oscillation of {:.1} s grow",
                tuning.period_s,
                TAU / root.im.abs()
            );
            let allowed = "a longer natural period, or filter periods and thrusters' time constants that are shorter";
            return Err(FieldError::new(format!("{field}.gains.natural_periods.{name}.period_s"), found, allowed));
        }
    }
    Ok(())
}

fn gains<S: Gathered>(all: &Reading<schema::DynamicPositioning>) -> Gains<S> {
    let [stiffness, damping, integral] =
        core::array::from_fn(|i| core::array::from_fn(|k| all.number(|given| numbers(&given.gains)[i][k])));
    let integrates = core::array::from_fn(|k| numbers(&all.first().gains)[2][k] > 0.0);
    let tracking_time = core::array::from_fn(|k| {
        all.number(|given| {
            let [stiffness, damping, integral] = numbers(&given.gains).map(|gains| gains[k]);
            let time = if damping > 0.0 { libm::sqrt(damping / integral) } else { stiffness / integral };
            given.anti_windup_time_s.map_or(if integral > 0.0 { time } else { 1.0 }, |time| time.get())
        })
    });
    Gains { stiffness, damping, integral, integrates, tracking_time }
}

fn filter<S: Gathered>(all: &Reading<schema::DynamicPositioning>) -> WaveFilter<S> {
    let Some(first) = &all.first().wave_filter else { return WaveFilter::default() };
    let given = all.kind(|given| given.wave_filter.as_ref());
    let mut filter = WaveFilter::default();
    for k in 0..first.notch_periods_s.len() {
        let frequency = given.number(|filter| TAU / filter.notch_periods_s[k].get());
        filter = filter.with_notch(frequency, given.number(|filter| filter.notch_damping_ratio.get()));
    }
    if let Some(cutoff) = first.cutoff_period_s {
        let frequency = given.number(|filter| TAU / filter.cutoff_period_s.unwrap_or(cutoff).get());
        filter = filter.with_low_pass(frequency, given.number(|filter| filter.cutoff_damping_ratio.get()));
    }
    filter
}

/// The thrusters that run, seen from the point that is kept.
fn thrusters<S: Gathered>(all: &Reading<schema::DynamicPositioning>, point: Vector3<S>) -> Vec<Thruster<S>> {
    let running = all.first().thrusters.iter().filter(|(_, thruster)| thruster.enabled());
    let build = |name: &schema::Name| {
        let given = all.part(|given| &given.thrusters[name]);
        let [x, y, z, direction] = given.numbers(schema::Thruster::place);
        let [ahead, astern, time_constant, weight] = given.numbers(schema::Thruster::numbers);
        let (sin, cos): (S, S) = S::sin_cos(direction);
        let kind = match given.first() {
            schema::Thruster::Azimuth(_) => ThrusterKind::Azimuth { limit: ahead },
            _ => ThrusterKind::Fixed { direction: [cos, sin], ahead, astern },
        };
        let position = Vector3::new(x, y, z) - point;
        Thruster { name: name.to_string(), position, kind, time_constant, weight }
    };
    running.map(|(name, _)| build(name)).collect()
}

impl schema::Thruster {
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

    /// Position, m, and direction, rad.
    fn place(&self) -> [f64; 4] {
        let ([x, y, z], direction) = match self {
            Self::Tunnel(given) => (given.position_m, given.direction_rad),
            Self::MainPropeller(given) => (given.position_m, given.direction_rad),
            Self::Azimuth(given) => (given.position_m, 0.0),
        };
        [x, y, z, direction]
    }

    /// Limits ahead and astern, N, time constant, s, and weight.
    fn numbers(&self) -> [f64; 4] {
        let [ahead, astern, time_constant, weight] = match self {
            Self::Tunnel(t) => [t.max_thrust_n, t.max_thrust_n, t.time_constant_s, t.weight],
            Self::MainPropeller(t) => [t.max_thrust_n, t.max_astern_thrust_n, t.time_constant_s, t.weight],
            Self::Azimuth(t) => [t.max_thrust_n, t.max_thrust_n, t.time_constant_s, t.weight],
        };
        [ahead, astern, time_constant, weight].map(|number| number.get())
    }
}
