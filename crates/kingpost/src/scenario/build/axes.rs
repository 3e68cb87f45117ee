//! Axes of joints without the difference between turning and sliding, and what acts in them.

use super::super::schema::{self, AngleAxis, History, HistoryList, LengthAxis, PrismaticMode, RatePulse, RevoluteMode};
use super::FieldError;
use super::reading::{Gathered, Reading};
use crate::elements::{CoulombFriction, Force, JointDamping, JointSpring, JointStop, StopSide};
use crate::model::{AxisMotion, Mode};

/// An axis of a joint, in rad and N m or in m and N.
pub struct Axis {
    /// Its name within the joint; empty where that has one axis.
    pub label: &'static str,
    pub motion: AxisMotion,
    pub initial: f64,
    pub initial_rate: f64,
    pub mode: Mode,
    /// Its motion, where that is given.
    pub given: Option<GivenMotion>,
    pub damping: f64,
    /// Friction and smoothing.
    pub friction: Option<[f64; 2]>,
    /// Stiffness and rest.
    pub spring: Option<[f64; 2]>,
    pub limits: Option<Limits>,
    /// Of the rotor, times the gear ratio squared.
    pub rotor_inertia: f64,
}

/// A motion that a scenario gives.
pub enum GivenMotion {
    /// A rate over time.
    Rate { full: f64, history: History, pulse: Option<RatePulse>, list: Option<HistoryList> },
    /// A way from rest to rest, and its times, s.
    Travel { way: f64, start_s: f64, duration_s: f64, ramp_s: f64 },
}

/// Stops of an axis.
pub struct Limits {
    pub lower: Option<f64>,
    pub upper: Option<f64>,
    /// Stiffness and dissipation.
    pub contact: [f64; 2],
}

/// The axes of a joint, from the parent to the child; none of floating, spherical and fixed joints.
pub fn axes(joint: &schema::Joint) -> Vec<Axis> {
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
            slides.into_iter().chain(turns).map(|axis| Axis { mode: Mode::Prescribed, ..axis }).collect()
        }
        schema::Joint::Floating(_) | schema::Joint::Spherical(_) | schema::Joint::Fixed(_) => Vec::new(),
    }
}

fn angle(label: &'static str, axis: &AngleAxis) -> Axis {
    let (mode, given) = match &axis.mode {
        RevoluteMode::Free => (Mode::Free, None),
        RevoluteMode::Held => (Mode::Held, None),
        RevoluteMode::Prescribed(p) => {
            let (pulse, list) = (p.pulse.clone(), p.list.clone());
            (Mode::Prescribed, Some(GivenMotion::Rate { full: p.rate_rad_s, history: p.history, pulse, list }))
        }
        RevoluteMode::Travel(t) => {
            let [start_s, duration_s, ramp_s] = [t.start_s.get(), t.duration_s.get(), t.ramp_s.get()];
            (Mode::Prescribed, Some(GivenMotion::Travel { way: t.angle_rad, start_s, duration_s, ramp_s }))
        }
    };
    Axis {
        label,
        motion: AxisMotion::Rotation,
        initial: axis.initial_angle_rad,
        initial_rate: axis.initial_rate_rad_s,
        mode,
        given,
        damping: axis.damping_n_m_s.get(),
        friction: axis.friction.as_ref().map(|f| [f.torque_n_m.get(), f.smoothing_rad_s.get()]),
        spring: axis.spring.as_ref().map(|s| [s.stiffness_n_m_per_rad.get(), s.rest_rad]),
        limits: axis.limits.as_ref().map(|l| Limits {
            lower: l.lower_rad,
            upper: l.upper_rad,
            contact: [l.stiffness_n_m_per_rad.get(), l.dissipation_s_per_rad.get()],
        }),
        rotor_inertia: axis.rotor_inertia_kg_m2.get() * axis.gear_ratio.get() * axis.gear_ratio.get(),
    }
}

fn length(label: &'static str, axis: &LengthAxis) -> Axis {
    let (mode, given) = match &axis.mode {
        PrismaticMode::Free => (Mode::Free, None),
        PrismaticMode::Held => (Mode::Held, None),
        PrismaticMode::Prescribed(p) => {
            let (pulse, list) = (p.pulse.clone(), p.list.clone());
            (Mode::Prescribed, Some(GivenMotion::Rate { full: p.speed_m_s, history: p.history, pulse, list }))
        }
        PrismaticMode::Travel(t) => {
            let [start_s, duration_s, ramp_s] = [t.start_s.get(), t.duration_s.get(), t.ramp_s.get()];
            (Mode::Prescribed, Some(GivenMotion::Travel { way: t.length_m, start_s, duration_s, ramp_s }))
        }
    };
    Axis {
        label,
        motion: AxisMotion::Translation,
        initial: axis.initial_extension_m,
        initial_rate: axis.initial_speed_m_s,
        mode,
        given,
        damping: axis.damping_n_s_m.get(),
        friction: axis.friction.as_ref().map(|f| [f.force_n.get(), f.smoothing_m_s.get()]),
        spring: axis.spring.as_ref().map(|s| [s.stiffness_n_per_m.get(), s.rest_m]),
        limits: axis.limits.as_ref().map(|l| Limits {
            lower: l.lower_m,
            upper: l.upper_m,
            contact: [l.stiffness_n_per_m.get(), l.dissipation_s_per_m.get()],
        }),
        rotor_inertia: axis.rotor_inertia_kg_m2.get() * axis.gear_ratio_rad_per_m.get().powi(2),
    }
}

impl Axis {
    /// The name of its coordinate.
    pub fn coordinate_name(&self, joint: &str) -> String {
        if self.label.is_empty() { joint.to_owned() } else { format!("{joint}.{}", self.label) }
    }

    /// The path of one of its fields below the joint's.
    pub fn field(&self, name: &str) -> String {
        if self.label.is_empty() { name.to_owned() } else { format!("{}.{name}", self.label) }
    }

    /// The path of its initial rate below the joint's.
    pub fn rate_field(&self) -> String {
        self.field(self.either("initial_rate_rad_s", "initial_speed_m_s"))
    }

    fn either(&self, turning: &'static str, sliding: &'static str) -> &'static str {
        if self.motion == AxisMotion::Rotation { turning } else { sliding }
    }

    /// An error unless the limits leave a travel; `joint` is the path of the joint.
    fn check_limits(&self, joint: &str) -> Result<(), FieldError> {
        let Some(limits) = &self.limits else { return Ok(()) };
        let (lower, upper) = (self.either("lower_rad", "lower_m"), self.either("upper_rad", "upper_m"));
        let field = |name: &str| format!("{joint}.{}", self.field(name));
        match (limits.lower, limits.upper) {
            (None, None) => Err(FieldError::new(field("limits"), "no limit", format!("{lower}, {upper}, or both"))),
            (Some(low), Some(high)) if low >= high => {
                let allowed = format!("less than {upper}, {high}");
                Err(FieldError::new(field(&format!("limits.{lower}")), low, allowed))
            }
            _ => Ok(()),
        }
    }
}

/// What acts in axis k of a joint, whose coordinate is at these places of q and v; `path` is the
/// joint's. Refuses limits that cross.
pub fn forces_in_axis<S: Gathered>(
    path: &str,
    joint: &Reading<schema::Joint>,
    k: usize,
    (position, coordinate): (usize, usize),
) -> Result<Vec<Force<S>>, FieldError> {
    let axis = &axes(joint.first())[k];
    axis.check_limits(path)?;
    let mut forces = Vec::new();
    let damping = |joint: &schema::Joint| axes(joint)[k].damping;
    if joint.any_nonzero(damping) {
        forces.push(Force::JointDamping(JointDamping { coordinate, damping: joint.number(damping) }));
    }
    if axis.friction.is_some() {
        let [friction, smoothing] = joint.numbers(|joint| axes(joint)[k].friction.unwrap_or_default());
        forces.push(Force::CoulombFriction(CoulombFriction { coordinate, friction, smoothing }));
    }
    if axis.spring.is_some() {
        let [stiffness, rest] = joint.numbers(|joint| axes(joint)[k].spring.unwrap_or_default());
        forces.push(Force::JointSpring(JointSpring { position, coordinate, stiffness, rest }));
    }
    let stop = |side, limit: fn(&Limits) -> Option<f64>| {
        axis.limits.as_ref().and_then(limit)?;
        let number = |joint: &schema::Joint| axes(joint)[k].limits.as_ref().and_then(limit).unwrap_or_default();
        let contact = |joint: &schema::Joint| axes(joint)[k].limits.as_ref().map_or([0.0; 2], |limits| limits.contact);
        let [stiffness, dissipation] = joint.numbers(contact);
        let limit = joint.number(number);
        Some(Force::JointStop(JointStop { position, coordinate, side, limit, stiffness, dissipation }))
    };
    forces.extend(stop(StopSide::Lower, |limits| limits.lower));
    forces.extend(stop(StopSide::Upper, |limits| limits.upper));
    Ok(forces)
}
