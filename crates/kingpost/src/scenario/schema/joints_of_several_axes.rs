//! Joints of several axes, and the spherical joint.

use kingpost_derive::fields;

use super::{AngleAxis, Direction, LengthAxis, Name, NonNegative};

/// Turns about and slides along one axis. Its coordinates are `rotation` and `translation`.
#[fields]
pub struct CylindricalJoint<S = f64> {
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
    /// Orientation of this body's axes in the parent's where all coordinates are 0: roll, pitch, yaw (intrinsic z-y-x
    /// angles), rad.
    #[serde(default)]
    pub orientation_rad: [S; 3],
    /// The rotation about the axis.
    #[serde(default)]
    pub rotation: AngleAxis<S>,
    /// The translation along the axis.
    #[serde(default)]
    pub translation: LengthAxis<S>,
}

/// Turns about an axis fixed in the parent, then about an axis fixed in this body. Its coordinates are `first` and
/// `second`.
#[fields]
pub struct UniversalJoint<S = f64> {
    /// Name of the joint; without it, the body's name.
    pub name: Option<Name>,
    /// The axis fixed in the parent, given in this body's axes at angle 0, of any length except 0.
    pub first_axis: Direction<S>,
    /// The axis fixed in this body, in its axes, perpendicular to the first.
    pub second_axis: Direction<S>,
    /// The joint in the parent's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// The joint in this body's drawing frame, m.
    #[serde(default)]
    pub child_position_m: [S; 3],
    /// Orientation of this body's axes in the parent's where all coordinates are 0: roll, pitch, yaw (intrinsic z-y-x
    /// angles), rad.
    #[serde(default)]
    pub orientation_rad: [S; 3],
    /// The rotation about the first axis.
    #[serde(default)]
    pub first: AngleAxis<S>,
    /// The rotation about the second axis.
    #[serde(default)]
    pub second: AngleAxis<S>,
}

/// Slides in a plane fixed in the parent and turns about its normal. Its coordinates are `x`, `y` and `rotation`.
#[fields]
pub struct PlanarJoint<S = f64> {
    /// Name of the joint; without it, the body's name.
    pub name: Option<Name>,
    /// The plane's normal in this body's axes, of any length except 0.
    pub normal: Direction<S>,
    /// The direction of x in the plane, in this body's axes at angle 0, perpendicular to the normal; y is the cross
    /// product of the normal and x.
    pub x_axis: Direction<S>,
    /// The joint in the parent's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// The joint in this body's drawing frame, m.
    #[serde(default)]
    pub child_position_m: [S; 3],
    /// Orientation of this body's axes in the parent's where all coordinates are 0: roll, pitch, yaw (intrinsic z-y-x
    /// angles), rad.
    #[serde(default)]
    pub orientation_rad: [S; 3],
    /// The sliding along x.
    #[serde(default)]
    pub x: LengthAxis<S>,
    /// The sliding along y.
    #[serde(default)]
    pub y: LengthAxis<S>,
    /// The rotation about the normal.
    #[serde(default)]
    pub rotation: AngleAxis<S>,
}

/// Turns about a point. Its coordinates `x`, `y` and `z` are the angular velocity relative to the parent in this body's
/// axes.
#[fields]
#[derive(Default)]
pub struct SphericalJoint<S = f64> {
    /// Name of the joint; without it, the body's name.
    pub name: Option<Name>,
    /// The joint in the parent's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// The joint in this body's drawing frame, m.
    #[serde(default)]
    pub child_position_m: [S; 3],
    /// Orientation of this body's axes in the parent's where all coordinates are 0: roll, pitch, yaw (intrinsic z-y-x
    /// angles), rad.
    #[serde(default)]
    pub orientation_rad: [S; 3],
    /// Orientation of this body's axes at the start, relative to that of `orientation_rad`: roll, pitch, yaw (intrinsic
    /// z-y-x angles), rad.
    #[serde(default)]
    pub initial_orientation_rad: [S; 3],
    /// Angular velocity relative to the parent at the start, in this body's axes, rad/s.
    #[serde(default)]
    pub initial_angular_velocity_rad_s: [S; 3],
    /// Viscous damping moment per angular velocity, N m s.
    #[serde(default)]
    pub damping_n_m_s: NonNegative<S>,
    /// Holds the orientation relative to the parent.
    #[serde(default)]
    pub held: bool,
}
