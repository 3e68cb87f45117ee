//! Joints: how a body moves relative to its parent.

use kingpost_derive::fields;

use super::axes::one;
use super::joints_of_several_axes::{CylindricalJoint, PlanarJoint, SphericalJoint, UniversalJoint};
use super::moved_by_waves::MovedByWaves;
use super::{
    AngleAxis, AngleFriction, AngleLimits, AngleSpring, Direction, GasSpring, LengthAxis, LengthFriction, LengthLimits,
    LengthSpring, Name, NonNegative, Positive, PrismaticMode, RevoluteMode,
};
use crate::scenario::leaf::Leaf;

/// How a body moves relative to its parent.
#[fields]
pub enum Joint<S = f64> {
    /// Free in the world, in six degrees; translation and rotation can be held.
    Floating(FloatingJoint<S>),
    /// Turns about one axis.
    Revolute(RevoluteJoint<S>),
    /// Slides along one axis.
    Prismatic(PrismaticJoint<S>),
    /// Turns about and slides along one axis.
    Cylindrical(CylindricalJoint<S>),
    /// Turns about two perpendicular axes.
    Universal(UniversalJoint<S>),
    /// Slides in a plane and turns about its normal.
    Planar(PlanarJoint<S>),
    /// Turns about a point.
    Spherical(SphericalJoint<S>),
    /// Does not move relative to its parent.
    Fixed(FixedJoint<S>),
    /// Moves in the world by the waves and the body's RAOs.
    MovedByWaves(MovedByWaves<S>),
}

impl<S: Leaf> Joint<S> {
    /// The key of the joint in the file: `floating`, `revolute` and so on.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Floating(_) => "floating",
            Self::Revolute(_) => "revolute",
            Self::Prismatic(_) => "prismatic",
            Self::Cylindrical(_) => "cylindrical",
            Self::Universal(_) => "universal",
            Self::Planar(_) => "planar",
            Self::Spherical(_) => "spherical",
            Self::Fixed(_) => "fixed",
            Self::MovedByWaves(_) => "moved_by_waves",
        }
    }

    /// The name written in the file; a joint without one has its body's name.
    pub fn name(&self) -> Option<&Name> {
        match self {
            Self::Floating(joint) => joint.name.as_ref(),
            Self::Revolute(joint) => joint.name.as_ref(),
            Self::Prismatic(joint) => joint.name.as_ref(),
            Self::Cylindrical(joint) => joint.name.as_ref(),
            Self::Universal(joint) => joint.name.as_ref(),
            Self::Planar(joint) => joint.name.as_ref(),
            Self::Spherical(joint) => joint.name.as_ref(),
            Self::Fixed(joint) => joint.name.as_ref(),
            Self::MovedByWaves(joint) => joint.name.as_ref(),
        }
    }

    /// Its place; at the origins for a floating joint.
    pub fn place(&self) -> JointPlace<S> {
        let (position_m, child_position_m, orientation_rad) = match self {
            Self::Floating(_) => return JointPlace::default(),
            Self::Revolute(j) => (j.position_m, j.child_position_m, j.orientation_rad),
            Self::Prismatic(j) => (j.position_m, j.child_position_m, j.orientation_rad),
            Self::Cylindrical(j) => (j.position_m, j.child_position_m, j.orientation_rad),
            Self::Universal(j) => (j.position_m, j.child_position_m, j.orientation_rad),
            Self::Planar(j) => (j.position_m, j.child_position_m, j.orientation_rad),
            Self::Spherical(j) => (j.position_m, j.child_position_m, j.orientation_rad),
            Self::Fixed(j) => (j.position_m, j.child_position_m, j.orientation_rad),
            Self::MovedByWaves(j) => (j.position_m, j.origin_m, [S::default(), S::default(), j.heading_rad]),
        };
        JointPlace { position_m, child_position_m, orientation_rad }
    }

    /// The fields that hold its directions, with what they hold.
    pub fn directions(&self) -> Vec<(&'static str, Direction<S>)> {
        match self {
            Self::Revolute(joint) => vec![("axis", joint.axis)],
            Self::Prismatic(joint) => vec![("axis", joint.axis)],
            Self::Cylindrical(joint) => vec![("axis", joint.axis)],
            Self::Universal(joint) => vec![("first_axis", joint.first_axis), ("second_axis", joint.second_axis)],
            Self::Planar(joint) => vec![("normal", joint.normal), ("x_axis", joint.x_axis)],
            Self::Floating(_) | Self::Spherical(_) | Self::Fixed(_) | Self::MovedByWaves(_) => Vec::new(),
        }
    }
}

/// The place of a joint in its two bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JointPlace<S = f64> {
    /// In the parent's drawing frame, m.
    pub position_m: [S; 3],
    /// In the body's drawing frame, m.
    pub child_position_m: [S; 3],
    /// Orientation of the body's axes in the parent's: roll, pitch, yaw, rad.
    pub orientation_rad: [S; 3],
}

/// A body that moves freely in the world. Its parent is the world.
#[fields(default)]
#[derive(Default)]
pub struct FloatingJoint<S = f64> {
    /// Name of the joint; without it, the body's name.
    pub name: Option<Name>,
    /// Holds the centre of mass where it is.
    pub hold_translation: bool,
    /// Holds the orientation as it is.
    pub hold_rotation: bool,
    /// Where the body is and how it moves at the start.
    pub initial: InitialMotion<S>,
}

/// Where a floating body is and how it moves at the start.
#[fields(default)]
#[derive(Default)]
pub struct InitialMotion<S = f64> {
    /// Position of the centre of mass in the world, m. With another centre of mass the whole body stands elsewhere: see
    /// `drawing_frame_m`.
    pub position_m: [S; 3],
    /// Position of the origin of the body's drawing frame in the world, m, instead of `position_m`: the body stays where it
    /// is drawn when its centre of mass changes.
    pub drawing_frame_m: Option<[S; 3]>,
    /// Roll, pitch, yaw (intrinsic z-y-x angles), rad.
    pub orientation_rad: [S; 3],
    /// Velocity of the centre of mass in the world, m/s.
    pub velocity_m_s: [S; 3],
    /// Angular velocity in body axes: roll, pitch, yaw rate, rad/s.
    pub angular_velocity_rad_s: [S; 3],
}

/// A hinge.
#[fields]
pub struct RevoluteJoint<S = f64> {
    /// Name of the joint; without it, the body's name.
    pub name: Option<Name>,
    /// The axis in this body's axes, of any length except 0.
    pub axis: Direction<S>,
    /// The joint in the parent's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// The joint in this body's drawing frame, m.
    #[serde(default)]
    pub child_position_m: [S; 3],
    /// Orientation of this body's axes in the parent's at angle 0: roll, pitch, yaw (intrinsic z-y-x angles), rad.
    #[serde(default)]
    pub orientation_rad: [S; 3],
    /// Angle at the start, rad.
    #[serde(default)]
    pub initial_angle_rad: S,
    /// Rate at the start, rad/s.
    #[serde(default)]
    pub initial_rate_rad_s: S,
    /// Viscous damping moment per rate, N m s.
    #[serde(default)]
    pub damping_n_m_s: NonNegative<S>,
    /// Dry friction.
    pub friction: Option<AngleFriction<S>>,
    /// A spring.
    pub spring: Option<AngleSpring<S>>,
    /// Stops at the ends of the travel.
    pub limits: Option<AngleLimits<S>>,
    /// Moment of inertia of the motor's rotor about its own axis, kg m^2.
    #[serde(default)]
    pub rotor_inertia_kg_m2: NonNegative<S>,
    /// Turns of the rotor for one turn about the axis.
    #[serde(default = "one::<S>")]
    pub gear_ratio: Positive<S>,
    /// Free, held or prescribed.
    #[serde(default)]
    pub mode: RevoluteMode<S>,
}

impl<S: Leaf> RevoluteJoint<S> {
    /// Its one axis.
    pub fn only_axis(&self) -> AngleAxis<S> {
        AngleAxis {
            initial_angle_rad: self.initial_angle_rad,
            initial_rate_rad_s: self.initial_rate_rad_s,
            mode: self.mode.clone(),
            damping_n_m_s: self.damping_n_m_s,
            friction: self.friction.clone(),
            spring: self.spring.clone(),
            limits: self.limits.clone(),
            rotor_inertia_kg_m2: self.rotor_inertia_kg_m2,
            gear_ratio: self.gear_ratio,
        }
    }
}

/// A slide.
#[fields]
pub struct PrismaticJoint<S = f64> {
    /// Name of the joint; without it, the body's name.
    pub name: Option<Name>,
    /// The axis in this body's axes, of any length except 0.
    pub axis: Direction<S>,
    /// The joint in the parent's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// The joint in this body's drawing frame, m.
    #[serde(default)]
    pub child_position_m: [S; 3],
    /// Orientation of this body's axes in the parent's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
    #[serde(default)]
    pub orientation_rad: [S; 3],
    /// Extension at the start, m.
    #[serde(default)]
    pub initial_extension_m: S,
    /// Speed at the start, m/s.
    #[serde(default)]
    pub initial_speed_m_s: S,
    /// Viscous damping force per speed, N s/m.
    #[serde(default)]
    pub damping_n_s_m: NonNegative<S>,
    /// Dry friction.
    pub friction: Option<LengthFriction<S>>,
    /// A spring.
    pub spring: Option<LengthSpring<S>>,
    /// A gas spring, which pushes towards larger extensions.
    pub gas_spring: Option<GasSpring<S>>,
    /// Stops at the ends of the travel.
    pub limits: Option<LengthLimits<S>>,
    /// Moment of inertia of the motor's rotor about its own axis, kg m^2.
    #[serde(default)]
    pub rotor_inertia_kg_m2: NonNegative<S>,
    /// Angle of the rotor per extension, rad/m.
    #[serde(default = "one::<S>")]
    pub gear_ratio_rad_per_m: Positive<S>,
    /// Free, held or prescribed.
    #[serde(default)]
    pub mode: PrismaticMode<S>,
}

impl<S: Leaf> PrismaticJoint<S> {
    /// Its one axis.
    pub fn only_axis(&self) -> LengthAxis<S> {
        LengthAxis {
            initial_extension_m: self.initial_extension_m,
            initial_speed_m_s: self.initial_speed_m_s,
            mode: self.mode.clone(),
            damping_n_s_m: self.damping_n_s_m,
            friction: self.friction.clone(),
            spring: self.spring.clone(),
            gas_spring: self.gas_spring.clone(),
            limits: self.limits.clone(),
            rotor_inertia_kg_m2: self.rotor_inertia_kg_m2,
            gear_ratio_rad_per_m: self.gear_ratio_rad_per_m,
        }
    }
}

/// No motion relative to the parent.
#[fields(default)]
#[derive(Default)]
pub struct FixedJoint<S = f64> {
    /// Name of the joint; without it, the body's name.
    pub name: Option<Name>,
    /// The joint in the parent's drawing frame, m.
    pub position_m: [S; 3],
    /// The joint in this body's drawing frame, m.
    pub child_position_m: [S; 3],
    /// Orientation of this body's axes in the parent's: roll, pitch, yaw (intrinsic z-y-x angles), rad.
    pub orientation_rad: [S; 3],
}
