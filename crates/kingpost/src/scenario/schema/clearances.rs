//! Clearances of points, and their air gap.

use serde::{Deserialize, Serialize};

use super::{BoxShape, ContactPlane, CylinderShape, Name, SphereShape, yes};
use crate::scenario::leaf::Leaf;

/// The distance of a point from another point or from a solid, as `clearance` (m) in the results; negative inside of a
/// solid. Nothing keeps the two apart.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "Clearance", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct Clearance<S = f64> {
    /// Whether it is measured.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The point.
    pub first: OwnPoint<S>,
    /// What it is to stay clear of.
    pub second: ClearanceFrom<S>,
}

/// A point on a body, by its name there or by its place, or on the world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "OwnPoint", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct OwnPoint<S = f64> {
    /// The body, or `world`.
    pub body: Name,
    /// The name of one of the body's `points`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point: Option<Name>,
    /// The point in the body's drawing frame, m; from the named one, where there is one.
    #[serde(default)]
    pub position_m: [S; 3],
}

/// A point, or a solid and where it is on its body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "ClearanceFrom", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct ClearanceFrom<S = f64> {
    /// The body, or `world`.
    pub body: Name,
    /// The name of one of the body's `points`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point: Option<Name>,
    /// The point, a point of the plane, or the centre of the solid, in the body's drawing frame, m; from the named point,
    /// where there is one.
    #[serde(default)]
    pub position_m: [S; 3],
    /// The solid's axes in the body's: roll, pitch, yaw, rad.
    #[serde(default)]
    pub orientation_rad: [S; 3],
    /// The solid; without it, the point.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shape: Option<ClearanceShape<S>>,
}

/// What a point is to stay clear of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "ClearanceShape", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(rename_all = "snake_case", bound(deserialize = "S: Leaf"))]
pub enum ClearanceShape<S = f64> {
    /// The body's own `shape`, which stands on its centre of mass: no place is given.
    Own,
    /// All below a plane without bounds: a quay, the seabed.
    Plane(ContactPlane<S>),
    /// A box: a deck, a house.
    Box(BoxShape<S>),
    /// A circular cylinder: a boom, a leg.
    Cylinder(CylinderShape<S>),
    /// A ball.
    Sphere(SphereShape<S>),
}

/// The height of a point above the surface of the incident waves where the point is, as `air_gap` (m) in the results; over
/// the still water where there are none. Negative under water.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "AirGap", bound = "S: crate::scenario::leaf::Described")
)]
#[serde(deny_unknown_fields, bound(deserialize = "S: Leaf"))]
pub struct AirGap<S = f64> {
    /// Whether it is measured.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body, or `world`.
    pub body: Name,
    /// The name of one of the body's `points`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point: Option<Name>,
    /// The point in the body's drawing frame, m; from the named one, where there is one.
    #[serde(default)]
    pub position_m: [S; 3],
}
