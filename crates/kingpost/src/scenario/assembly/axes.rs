//! Rotational and translational axes of joints, and the forces in them.

use crate::elements::{
    AnyElement, CoulombFriction, GasSpring, JointDamping, JointSpring, JointStop, StopSide, significant,
};
use crate::model::{AxisMotion, MotionType};
use crate::scenario::assembly::FieldError;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{
    self, AngleAxis, History, HistoryList, LengthAxis, PrismaticMode, RatePulse, RevoluteMode,
};

/// An axis of a joint; its coordinate and force are in rad and N m, or in m and N.
pub struct JointAxis<S> {
    /// Its name within the joint; empty if the joint has one axis.
    pub label: &'static str,
    pub motion: AxisMotion,
    pub initial: S,
    pub initial_rate: S,
    pub mode: MotionType,
    /// Its prescribed motion, if any.
    pub given: Option<GivenMotion<S>>,
    pub damping: S,
    /// Friction torque or force, and its smoothing rate.
    pub friction: Option<[S; 2]>,
    /// Stiffness and rest position.
    pub spring: Option<[S; 2]>,
    pub gas_spring: Option<schema::GasSpring<S>>,
    pub limits: Option<AxisStops<S>>,
    /// Inertia of the rotor times the gear ratio squared.
    pub rotor_inertia: S,
}

/// A prescribed motion.
pub enum GivenMotion<S> {
    /// A rate over time.
    Rate { full: S, history: History, pulse: Option<RatePulse>, list: Option<HistoryList<S>> },
    /// A displacement that starts and ends at rest, and its times, s.
    Travel { way: S, start_s: f64, duration_s: f64, ramp_s: f64 },
    /// An oscillation about the initial value.
    Oscillation { amplitude: S, period_s: S, phase_rad: S, ramp_s: f64 },
}

/// Stops of an axis, at its limits.
pub struct AxisStops<S> {
    pub lower: Option<S>,
    pub upper: Option<S>,
    /// Stiffness and dissipation of the contact.
    pub contact: [S; 2],
}

/// The axes of a joint, from the parent to the child; empty for floating, spherical and fixed joints.
pub fn axes<S: Quantity>(joint: &schema::Joint<S>) -> Vec<JointAxis<S>> {
    match joint {
        schema::Joint::Revolute(joint) => vec![angle("", &joint.only_axis())],
        schema::Joint::Prismatic(joint) => vec![length("", &joint.only_axis())],
        schema::Joint::Cylindrical(joint) => {
            vec![angle("rotation", &joint.rotation), length("translation", &joint.translation)]
        }
        schema::Joint::Universal(joint) => vec![angle("first", &joint.first), angle("second", &joint.second)],
        schema::Joint::Planar(joint) => {
            vec![length("x", &joint.x), length("y", &joint.y), angle("rotation", &joint.rotation)]
        }
        schema::Joint::MovedByWaves(_) => {
            let slides = ["x", "y", "z"].map(|label| length(label, &LengthAxis::default()));
            let turns = ["yaw", "pitch", "roll"].map(|label| angle(label, &AngleAxis::default()));
            slides.into_iter().chain(turns).map(|axis| JointAxis { mode: MotionType::Prescribed, ..axis }).collect()
        }
        schema::Joint::Floating(_) | schema::Joint::Spherical(_) | schema::Joint::Fixed(_) => Vec::new(),
    }
}

fn angle<S: Quantity>(label: &'static str, axis: &AngleAxis<S>) -> JointAxis<S> {
    let (mode, given) = match &axis.mode {
        RevoluteMode::Free => (MotionType::Free, None),
        RevoluteMode::Held => (MotionType::Held, None),
        RevoluteMode::Prescribed(p) => {
            let (pulse, list) = (p.pulse.clone(), p.list.clone());
            (MotionType::Prescribed, Some(GivenMotion::Rate { full: p.rate_rad_s, history: p.history, pulse, list }))
        }
        RevoluteMode::Travel(t) => {
            let [start_s, duration_s, ramp_s] = [t.start_s.get(), t.duration_s.get(), t.ramp_s.get()];
            (MotionType::Prescribed, Some(GivenMotion::Travel { way: t.angle_rad, start_s, duration_s, ramp_s }))
        }
        RevoluteMode::Oscillation(o) => {
            (MotionType::Prescribed, Some(oscillation(o.amplitude_rad, o.period_s, o.phase_rad, o.ramp_s)))
        }
    };
    JointAxis {
        label,
        motion: AxisMotion::Rotation,
        initial: axis.initial_angle_rad,
        initial_rate: axis.initial_rate_rad_s,
        mode,
        given,
        damping: axis.damping_n_m_s.get(),
        friction: axis.friction.as_ref().map(|f| [f.torque_n_m.get(), f.smoothing_rad_s.get()]),
        spring: axis.spring.as_ref().map(|s| [s.stiffness_n_m_per_rad.get(), s.rest_rad]),
        gas_spring: None,
        limits: axis.limits.as_ref().map(|l| AxisStops {
            lower: l.lower_rad,
            upper: l.upper_rad,
            contact: [l.stiffness_n_m_per_rad.get(), l.dissipation_s_per_rad.get()],
        }),
        rotor_inertia: axis.rotor_inertia_kg_m2.get() * axis.gear_ratio.get() * axis.gear_ratio.get(),
    }
}

fn length<S: Quantity>(label: &'static str, axis: &LengthAxis<S>) -> JointAxis<S> {
    let (mode, given) = match &axis.mode {
        PrismaticMode::Free => (MotionType::Free, None),
        PrismaticMode::Held => (MotionType::Held, None),
        PrismaticMode::Prescribed(p) => {
            let (pulse, list) = (p.pulse.clone(), p.list.clone());
            (MotionType::Prescribed, Some(GivenMotion::Rate { full: p.speed_m_s, history: p.history, pulse, list }))
        }
        PrismaticMode::Travel(t) => {
            let [start_s, duration_s, ramp_s] = [t.start_s.get(), t.duration_s.get(), t.ramp_s.get()];
            (MotionType::Prescribed, Some(GivenMotion::Travel { way: t.length_m, start_s, duration_s, ramp_s }))
        }
        PrismaticMode::Oscillation(o) => {
            (MotionType::Prescribed, Some(oscillation(o.amplitude_m, o.period_s, o.phase_rad, o.ramp_s)))
        }
    };
    JointAxis {
        label,
        motion: AxisMotion::Translation,
        initial: axis.initial_extension_m,
        initial_rate: axis.initial_speed_m_s,
        mode,
        given,
        damping: axis.damping_n_s_m.get(),
        friction: axis.friction.as_ref().map(|f| [f.force_n.get(), f.smoothing_m_s.get()]),
        spring: axis.spring.as_ref().map(|s| [s.stiffness_n_per_m.get(), s.rest_m]),
        gas_spring: axis.gas_spring.clone(),
        limits: axis.limits.as_ref().map(|l| AxisStops {
            lower: l.lower_m,
            upper: l.upper_m,
            contact: [l.stiffness_n_per_m.get(), l.dissipation_s_per_m.get()],
        }),
        rotor_inertia: axis.rotor_inertia_kg_m2.get()
            * (axis.gear_ratio_rad_per_m.get() * axis.gear_ratio_rad_per_m.get()),
    }
}

fn oscillation<S: Quantity>(
    amplitude: S,
    period_s: schema::Positive<S>,
    phase_rad: S,
    ramp_s: schema::Positive,
) -> GivenMotion<S> {
    GivenMotion::Oscillation { amplitude, period_s: period_s.get(), phase_rad, ramp_s: ramp_s.get() }
}

impl<S: Quantity> JointAxis<S> {
    /// Returns the name of the axis's coordinate.
    pub fn coordinate_name(&self, joint: &str) -> String {
        if self.label.is_empty() { joint.to_owned() } else { format!("{joint}.{}", self.label) }
    }

    /// Returns the path of a field of the axis, relative to the joint.
    pub fn field(&self, name: &str) -> String {
        if self.label.is_empty() { name.to_owned() } else { format!("{}.{name}", self.label) }
    }

    /// Returns the path of the initial rate, relative to the joint.
    pub fn rate_field(&self) -> String {
        self.field(self.either("initial_rate_rad_s", "initial_speed_m_s"))
    }

    fn either(&self, turning: &'static str, sliding: &'static str) -> &'static str {
        if self.motion == AxisMotion::Rotation { turning } else { sliding }
    }

    /// Returns an error unless the lower limit is below the upper one; `joint` is the path of the joint.
    fn check_limits(&self, joint: &str) -> Result<(), FieldError> {
        let Some(limits) = &self.limits else { return Ok(()) };
        let (lower, upper) = (self.either("lower_rad", "lower_m"), self.either("upper_rad", "upper_m"));
        let field = |name: &str| format!("{joint}.{}", self.field(name));
        match (limits.lower, limits.upper) {
            (None, None) => Err(FieldError::new(field("limits"), "no limit", format!("{lower}, {upper}, or both"))),
            (Some(low), Some(high)) if !(high - low).all(|travel| travel > 0.0) => {
                let allowed = format!("less than {upper}, {high}");
                Err(FieldError::new(field(&format!("limits.{lower}")), low, allowed))
            }
            _ => Ok(()),
        }
    }
}

/// Returns the forces in an axis of a joint; its coordinate has these indices in q and v, and `path` is the joint's
/// path. Refuses a lower limit above the upper one, and a gas spring without a lower limit at which gas is left.
pub fn forces_in_axis<S: Quantity>(
    (joint, path): (&str, &str),
    axis: &JointAxis<S>,
    (position, coordinate): (usize, usize),
) -> Result<Vec<AnyElement<S>>, FieldError> {
    axis.check_limits(path)?;
    let mut forces: Vec<AnyElement<S>> = Vec::new();
    if !axis.damping.vanishes() {
        forces.push(Box::new(JointDamping { coordinate, damping: axis.damping }));
    }
    if let Some([friction, smoothing]) = axis.friction {
        forces.push(Box::new(CoulombFriction { coordinate, friction, smoothing }));
    }
    if let Some([stiffness, rest]) = axis.spring {
        forces.push(Box::new(JointSpring { position, coordinate, stiffness, rest }));
    }
    if let Some(given) = &axis.gas_spring {
        forces.push(Box::new(gas_spring((joint, path), axis, given, (position, coordinate))?));
    }
    if let Some(AxisStops { lower, upper, contact: [stiffness, dissipation] }) = axis.limits {
        let stop = |(side, limit): (StopSide, Option<S>)| -> Option<AnyElement<S>> {
            Some(Box::new(JointStop { position, coordinate, side, limit: limit?, stiffness, dissipation }))
        };
        forces.extend([(StopSide::Lower, lower), (StopSide::Upper, upper)].into_iter().filter_map(stop));
    }
    Ok(forces)
}

/// Returns the gas spring of an axis.
fn gas_spring<S: Quantity>(
    (joint, path): (&str, &str),
    axis: &JointAxis<S>,
    given: &schema::GasSpring<S>,
    (position, coordinate): (usize, usize),
) -> Result<GasSpring<S>, FieldError> {
    let (area, volume, extension) = (given.piston_area_m2.get(), given.gas_volume_m3.get(), given.at_extension_m);
    let field = |name: &str| format!("{path}.{}", axis.field(name));
    let Some(lower) = axis.limits.as_ref().and_then(|limits| limits.lower) else {
        let allowed = "limits with lower_m, at which the gas volume is not 0, for the gas spring of the axis";
        return Err(FieldError::new(field("limits"), "no lower limit", allowed));
    };
    let left = volume + area * (lower - extension);
    if let Some(left) = left.outside(|left| left > 0.0) {
        let empty = extension - volume / area;
        let found = format!("{lower}, with a gas volume of {} m3 in the gas spring", significant(left, 4));
        return Err(FieldError::new(
            field("limits.lower_m"),
            found,
            format!("more than {empty:.4}, where the gas volume is 0"),
        ));
    }
    Ok(GasSpring {
        name: axis.coordinate_name(joint),
        position,
        coordinate,
        area,
        volume,
        pressure: given.pressure_pa.get(),
        extension,
        exponent: given.polytropic_exponent.get(),
        outside_pressure: given.outside_pressure_pa.get(),
        smallest_volume: left * S::constant(0.5),
    })
}
