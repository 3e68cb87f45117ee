//! Clearances and air gaps of points.

use kingpost_derive::fields;

use crate::scenario::schema::{
    BoxShape, CapsuleShape, ConeShape, ContactPlane, ConvexShape, CylinderShape, LocalName, Name, SphereShape, yes,
};

/// The distance between two points or solids, as `clearance` (m) in the results. Of a point inside a solid it is the
/// negative distance from the surface; of overlapping solids, the negative of the shortest displacement that parts them. It is
/// only an output: no force keeps the two apart.
#[fields]
pub struct Clearance<S = f64> {
    /// Whether the clearance is measured.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The point or solid.
    pub first: ClearanceFrom<S>,
    /// The point or solid from which the clearance is measured.
    pub second: ClearanceFrom<S>,
}

/// A point on a body, by its name or its position, or a point in the world; or a solid with its place there.
#[fields]
pub struct ClearanceFrom<S = f64> {
    /// The body, or `world`.
    pub body: Name,
    /// The name of one of the body's `points`.
    pub point: Option<LocalName>,
    /// The point, a point of the plane, or the centre of the solid, in the body's drawing frame, m; measured from the
    /// named point if one is given.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Orientation of the solid's axes in the body's: roll, pitch, yaw, rad.
    #[serde(default)]
    pub orientation_rad: [S; 3],
    /// The solid; without it, the distance is to the point.
    pub shape: Option<ClearanceShape<S>>,
}

/// A solid whose clearance is measured.
#[fields]
pub enum ClearanceShape<S = f64> {
    /// The body's own `shape`, centred on its centre of mass; a position is then not allowed.
    Own,
    /// Everything below an infinite plane: a quay, the seabed.
    Plane(ContactPlane<S>),
    /// A box: a deck, a house.
    Box(BoxShape<S>),
    /// A circular cylinder: a boom, a leg.
    Cylinder(CylinderShape<S>),
    /// A ball.
    Sphere(SphereShape<S>),
    /// A circular cylinder with round ends: a bumper bar, a guide.
    Capsule(CapsuleShape<S>),
    /// A cone: a pin, a funnel from outside.
    Cone(ConeShape<S>),
    /// The convex hull of points.
    Convex(ConvexShape<S>),
}

/// The height of a point above the surface of the incident waves at that point, as `air_gap` (m) in the results; above
/// the still water in a sea without waves. Negative under water.
#[fields]
pub struct AirGap<S = f64> {
    /// Whether the clearance is measured.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body, or `world`.
    pub body: Name,
    /// The name of one of the body's `points`.
    pub point: Option<LocalName>,
    /// The point in the body's drawing frame, m; measured from the named point if one is given.
    #[serde(default)]
    pub position_m: [S; 3],
}
