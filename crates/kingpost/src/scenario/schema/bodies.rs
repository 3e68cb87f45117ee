//! Bodies: mass, shape, inertia, named points.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use super::{Colour, Flexible, Joint, Name, NonNegative, Positive, WORLD, yes};

/// A rigid body. Its geometry is written in a drawing frame of its own; the shape is centred on the centre of mass.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Off leaves out this body and all that hangs on it.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body that this one hangs on, or `world`.
    #[serde(default = "Name::world")]
    pub parent: Name,
    /// Mass, kg.
    pub mass_kg: Positive,
    /// Colour in the views, `#rrggbb`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub colour: Option<Colour>,
    /// The solid that gives the inertia, unless `inertia` does, and the picture.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shape: Option<Shape>,
    /// The inertia in numbers; it replaces that of the shape.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inertia: Option<Inertia>,
    /// Makes this body a beam that bends, twists and shears.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flexible: Option<Flexible>,
    /// The centre of mass in the drawing frame, m.
    #[serde(default)]
    pub centre_of_mass_m: [f64; 3],
    /// How this body moves against its parent.
    pub joint: Joint,
    /// Named points of this body, reported in the results.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub points: IndexMap<Name, Point>,
}

impl Body {
    /// The body that this one hangs on; `None` for the world.
    pub fn parent_body(&self) -> Option<&Name> {
        (self.parent != WORLD).then_some(&self.parent)
    }
}

/// A named point of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Point {
    /// Position in the body's drawing frame, m.
    pub position_m: [f64; 3],
}

/// A homogeneous solid, or a point mass.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Shape {
    /// A solid box.
    Box(BoxShape),
    /// A solid circular cylinder.
    Cylinder(CylinderShape),
    /// A solid sphere.
    Sphere(SphereShape),
    /// A point mass.
    Point(PointShape),
}

/// A solid box, its edges along the body's axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct BoxShape {
    /// Extent along x, m.
    pub length_m: Positive,
    /// Extent along y, m.
    pub width_m: Positive,
    /// Extent along z, m.
    pub height_m: Positive,
}

/// A solid circular cylinder.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct CylinderShape {
    /// Radius, m.
    pub radius_m: Positive,
    /// Extent along the axis, m.
    pub length_m: Positive,
    /// The body axis that the cylinder lies along.
    #[serde(default)]
    pub axis: PrincipalAxis,
}

/// A solid sphere.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct SphereShape {
    /// Radius, m.
    pub radius_m: Positive,
}

/// A point mass: no extent, no inertia of its own.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PointShape {}

/// One of the body's axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum PrincipalAxis {
    /// Forward.
    X,
    /// To port.
    Y,
    /// Up.
    #[default]
    Z,
}

/// Inertia in numbers, about the centre of mass in body axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Inertia {
    /// Moments and products of inertia.
    Tensor(InertiaTensor),
    /// Radii of gyration.
    RadiiOfGyration(RadiiOfGyration),
}

/// Moments and products of inertia about the centre of mass in body axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct InertiaTensor {
    /// Ixx, Iyy, Izz, kg m^2. No one of them may exceed the sum of the other two.
    pub moments_kg_m2: [NonNegative; 3],
    /// Ixy, Ixz, Iyz, kg m^2, as entries of the tensor: Ixy = -integral(x y dm).
    #[serde(default)]
    pub products_kg_m2: [f64; 3],
}

/// Radii of gyration about the centre of mass; the body's axes are its principal axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct RadiiOfGyration {
    /// kx, ky, kz, m.
    pub radii_m: [NonNegative; 3],
}
