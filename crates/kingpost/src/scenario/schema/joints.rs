//! Joints: how a body moves against its parent.

use serde::{Deserialize, Serialize};

use super::{Direction, History, Name, NonNegative, Pulse};

/// How a body moves against its parent.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Joint {
    /// Free in the world, in six degrees; translation and rotation can be held.
    Floating(FloatingJoint),
    /// Turns about one axis.
    Revolute(RevoluteJoint),
    /// Slides along one axis.
    Prismatic(PrismaticJoint),
    /// Does not move against its parent.
    Fixed(FixedJoint),
}

impl Joint {
    /// `floating`, `revolute`, `prismatic` or `fixed`: the key under which it stands.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Floating(_) => "floating",
            Self::Revolute(_) => "revolute",
            Self::Prismatic(_) => "prismatic",
            Self::Fixed(_) => "fixed",
        }
    }

    /// The name written in the file; a joint without one is named as its body.
    pub fn name(&self) -> Option<&Name> {
        match self {
            Self::Floating(joint) => joint.name.as_ref(),
            Self::Revolute(joint) => joint.name.as_ref(),
            Self::Prismatic(joint) => joint.name.as_ref(),
            Self::Fixed(joint) => joint.name.as_ref(),
        }
    }
}

/// A body free in the world. Its parent is the world.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct FloatingJoint {
    /// Name of the joint; the body's when absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<Name>,
    /// Holds the centre of mass where it is.
    pub hold_translation: bool,
    /// Holds the orientation as it is.
    pub hold_rotation: bool,
    /// Where the body is and how it moves at the start.
    pub initial: InitialMotion,
}

/// Where a floating body is and how it moves at the start.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct InitialMotion {
    /// Position of the centre of mass in the world, m.
    pub position_m: [f64; 3],
    /// Roll, pitch, yaw (intrinsic z-y-x angles), rad.
    pub orientation_rad: [f64; 3],
    /// Velocity of the centre of mass in the world, m/s.
    pub velocity_m_s: [f64; 3],
    /// Angular velocity in body axes: roll, pitch, yaw rate, rad/s.
    pub angular_velocity_rad_s: [f64; 3],
}

/// A hinge.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct RevoluteJoint {
    /// Name of the joint; the body's when absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<Name>,
    /// The axis in this body's axes, of any length but 0.
    pub axis: Direction,
    /// The joint in the parent's drawing frame, m.
    #[serde(default)]
    pub position_m: [f64; 3],
    /// The joint in this body's drawing frame, m.
    #[serde(default)]
    pub child_position_m: [f64; 3],
    /// This body's axes in the parent's at angle 0: roll, pitch, yaw (intrinsic z-y-x angles), rad.
    #[serde(default)]
    pub orientation_rad: [f64; 3],
    /// Angle at the start, rad.
    #[serde(default)]
    pub initial_angle_rad: f64,
    /// Rate at the start, rad/s.
    #[serde(default)]
    pub initial_rate_rad_s: f64,
    /// Viscous damping moment per rate, N m s.
    #[serde(default, rename = "damping_N_m_s")]
    pub damping_n_m_s: NonNegative,
    /// Free, held or prescribed.
    #[serde(default)]
    pub mode: RevoluteMode,
}

/// What decides a hinge's angle.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum RevoluteMode {
    /// The dynamics do.
    #[default]
    Free,
    /// It stays at its initial angle.
    Held,
    /// A given rate does.
    Prescribed(PrescribedRate),
}

/// A hinge's rate as a given function of time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PrescribedRate {
    /// Full rate, rad/s.
    pub rate_rad_s: f64,
    /// How the rate goes with time.
    #[serde(default)]
    pub history: History,
    /// The times of the history `pulse`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pulse: Option<Pulse>,
}

/// A slide.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PrismaticJoint {
    /// Name of the joint; the body's when absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<Name>,
    /// The axis in this body's axes, of any length but 0.
    pub axis: Direction,
    /// The joint in the parent's drawing frame, m.
    #[serde(default)]
    pub position_m: [f64; 3],
    /// The joint in this body's drawing frame, m.
    #[serde(default)]
    pub child_position_m: [f64; 3],
    /// This body's axes in the parent's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
    #[serde(default)]
    pub orientation_rad: [f64; 3],
    /// Extension at the start, m.
    #[serde(default)]
    pub initial_extension_m: f64,
    /// Speed at the start, m/s.
    #[serde(default)]
    pub initial_speed_m_s: f64,
    /// Viscous damping force per speed, N s/m.
    #[serde(default, rename = "damping_N_s_m")]
    pub damping_n_s_m: NonNegative,
    /// Free, held or prescribed.
    #[serde(default)]
    pub mode: PrismaticMode,
}

/// What decides a slide's extension.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum PrismaticMode {
    /// The dynamics do.
    #[default]
    Free,
    /// It stays at its initial extension.
    Held,
    /// A given speed does.
    Prescribed(PrescribedSpeed),
}

/// A slide's speed as a given function of time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PrescribedSpeed {
    /// Full speed, m/s.
    pub speed_m_s: f64,
    /// How the speed goes with time.
    #[serde(default)]
    pub history: History,
    /// The times of the history `pulse`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pulse: Option<Pulse>,
}

/// No motion against the parent.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct FixedJoint {
    /// Name of the joint; the body's when absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<Name>,
    /// The joint in the parent's drawing frame, m.
    pub position_m: [f64; 3],
    /// The joint in this body's drawing frame, m.
    pub child_position_m: [f64; 3],
    /// This body's axes in the parent's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
    pub orientation_rad: [f64; 3],
}
