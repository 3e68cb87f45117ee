//! Bodies: mass, shape, inertia, named points.

use indexmap::IndexMap;
use kingpost_derive::fields;

use super::{Colour, Flexible, Joint, Name, NonNegative, Positive, WORLD, yes};
use crate::scenario::leaf::Leaf;

/// A rigid body. Its geometry is written in a drawing frame of its own; the shape is centred on the centre of mass.
#[fields]
pub struct Body<S = f64> {
    /// `false` leaves out this body and every body below it in the tree.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The parent body, or `world`: this body's joint connects the two.
    #[serde(default = "Name::world")]
    pub parent: Name,
    /// Mass, kg.
    pub mass_kg: Positive<S>,
    /// Colour in the views, `#rrggbb`.
    pub colour: Option<Colour>,
    /// The solid that is drawn, and whose inertia the body has unless `inertia` is given.
    pub shape: Option<Shape<S>>,
    /// The inertia in numbers; it replaces the shape's inertia.
    pub inertia: Option<Inertia<S>>,
    /// Makes this body a beam that bends, twists and shears.
    pub flexible: Option<Flexible<S>>,
    /// The centre of mass in the drawing frame, m.
    #[serde(default)]
    pub centre_of_mass_m: [S; 3],
    /// The joint to the parent: how this body moves relative to it.
    pub joint: Joint<S>,
    /// Named points of this body, reported in the results.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub points: IndexMap<Name, Point<S>>,
}

impl<S: Leaf> Body<S> {
    /// The parent body; `None` for the world.
    pub fn parent_body(&self) -> Option<&Name> {
        (self.parent != WORLD).then_some(&self.parent)
    }
}

/// A named point of a body.
#[fields]
pub struct Point<S = f64> {
    /// Position in the body's drawing frame, m.
    pub position_m: [S; 3],
}

/// A homogeneous solid, or a point mass.
#[fields]
pub enum Shape<S = f64> {
    /// A solid box.
    Box(BoxShape<S>),
    /// A solid circular cylinder.
    Cylinder(CylinderShape<S>),
    /// A solid sphere.
    Sphere(SphereShape<S>),
    /// A point mass.
    Point(PointShape),
}

/// A solid box, its edges along the body's axes.
#[fields]
pub struct BoxShape<S = f64> {
    /// Extent along x, m.
    pub length_m: Positive<S>,
    /// Extent along y, m.
    pub width_m: Positive<S>,
    /// Extent along z, m.
    pub height_m: Positive<S>,
}

/// A solid circular cylinder.
#[fields]
pub struct CylinderShape<S = f64> {
    /// Radius, m.
    pub radius_m: Positive<S>,
    /// Extent along the axis, m.
    pub length_m: Positive<S>,
    /// The body axis that the cylinder lies along.
    #[serde(default)]
    pub axis: PrincipalAxis,
}

/// A solid sphere.
#[fields]
pub struct SphereShape<S = f64> {
    /// Radius, m.
    pub radius_m: Positive<S>,
}

/// A point mass: no extent, no inertia of its own.
#[fields]
#[derive(Default)]
pub struct PointShape {}

/// One of the body's axes.
#[fields]
#[derive(Copy, Default, Eq)]
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
#[fields]
pub enum Inertia<S = f64> {
    /// Moments and products of inertia.
    Tensor(InertiaTensor<S>),
    /// Radii of gyration.
    RadiiOfGyration(RadiiOfGyration<S>),
}

/// Moments and products of inertia about the centre of mass in body axes.
#[fields]
pub struct InertiaTensor<S = f64> {
    /// Ixx, Iyy, Izz, kg m^2. None may exceed the sum of the other two.
    pub moments_kg_m2: [NonNegative<S>; 3],
    /// Ixy, Ixz, Iyz, kg m^2, as entries of the tensor: Ixy = -integral(x y dm).
    #[serde(default)]
    pub products_kg_m2: [S; 3],
}

/// Radii of gyration about the centre of mass; the body's axes are its principal axes.
#[fields]
pub struct RadiiOfGyration<S = f64> {
    /// kx, ky, kz, m.
    pub radii_m: [NonNegative<S>; 3],
}
