//! Contact of a load with a deck, a quay, the seabed, another vessel.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{
    BoxShape, CylinderShape, Direction, Fraction, Name, NonNegative, Positive, PrincipalAxis, SphereShape, yes,
};

/// Contact of a load with a surface: a normal force pushes the load out, and friction holds it.
#[fields]
pub struct Contact<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The load.
    pub load: ContactLoad<S>,
    /// The surface that the load touches: a deck, a quay, the seabed, a bumper.
    pub surface: ContactSurface<S>,
    /// Stiffness of each contact point, N/m: a box that stands on four corners has four times this stiffness.
    pub stiffness_n_per_m: Positive<S>,
    /// Coefficient of restitution, from 0.1 to 1: rebound speed over impact speed, at `restitution_speed_m_s`. It is
    /// higher for slower impacts.
    #[serde(default = "third::<S>")]
    pub restitution: Fraction<S>,
    /// The impact speed at which `restitution` holds, m/s.
    #[serde(default = "half::<S>")]
    pub restitution_speed_m_s: Positive<S>,
    /// Coulomb's coefficient of friction; 0 for a smooth surface.
    pub friction_coefficient: NonNegative<S>,
    /// Tangential stiffness of each contact point while friction holds it, N/m; without it, `stiffness_N_per_m`.
    pub friction_stiffness_n_per_m: Option<Positive<S>>,
    /// Largest penetration, m: a deeper penetration is an error at the start and a warning during the run.
    #[serde(default = "tolerance::<S>")]
    pub penetration_tolerance_m: Positive<S>,
}

/// The shape that touches, with its place on its body.
#[fields]
pub struct ContactLoad<S = f64> {
    /// The body.
    pub body: Name,
    /// The centre of the shape in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Orientation of the shape's axes in the body's: roll, pitch, yaw, rad.
    #[serde(default)]
    pub orientation_rad: [S; 3],
    /// The load.
    pub shape: LoadShape<S>,
}

/// The shape of a load.
#[fields]
pub enum LoadShape<S = f64> {
    /// A box: its corners touch, and corners of the surface touch its faces.
    Box(BoxShape<S>),
    /// A circular cylinder that rolls or stands on a plane.
    Cylinder(CylinderShape<S>),
    /// A ball.
    Sphere(SphereShape<S>),
    /// Points: feet, or the corners of a convex body.
    Points(ContactPoints<S>),
    /// A circular cylinder with round ends: a bumper bar, a guide, a pile.
    Capsule(CapsuleShape<S>),
    /// A cone with its tip ahead: a pin for stab-in.
    Cone(ConeShape<S>),
    /// A ring of round bar: the mouth of a funnel, a shackle.
    Ring(RingShape<S>),
    /// The convex hull of points: its corners and edges touch.
    Convex(ConvexShape<S>),
}

/// Points that touch.
#[fields]
pub struct ContactPoints<S = f64> {
    /// Positions from the shape's centre, in its axes, m; at most 64.
    pub positions_m: Vec<[S; 3]>,
}

/// The surface, with its place on its body.
#[fields]
pub struct ContactSurface<S = f64> {
    /// The body, or `world`.
    pub body: Name,
    /// A point of the plane, or the centre of the shape, in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Orientation of the shape's axes in the body's: roll, pitch, yaw, rad.
    #[serde(default)]
    pub orientation_rad: [S; 3],
    /// The shape of the surface.
    pub shape: SurfaceShape<S>,
}

/// The shape of a surface.
#[fields]
pub enum SurfaceShape<S = f64> {
    /// An infinite plane: the seabed, a quay, a deck whose edge no load reaches.
    Plane(ContactPlane<S>),
    /// A box, with edges that a load may slip off: a deck, a platform, a guide.
    Box(BoxShape<S>),
    /// A ball: a bumper, a roller.
    Sphere(SphereShape<S>),
    /// A circular cylinder: a leg, a bumper, a pile.
    Cylinder(CylinderShape<S>),
    /// A circular cylinder with round ends: a bumper bar, a guide.
    Capsule(CapsuleShape<S>),
    /// A cone with its tip ahead: a pin for stab-in.
    Cone(ConeShape<S>),
    /// A ring of round bar: the mouth of a funnel, a hole in a plate.
    Ring(RingShape<S>),
    /// The convex hull of points: its corners and edges touch.
    Convex(ConvexShape<S>),
}

/// A circular cylinder with round ends.
#[fields]
pub struct CapsuleShape<S = f64> {
    /// Radius, m.
    pub radius_m: Positive<S>,
    /// Distance between the centres of the two round ends, m.
    pub length_m: Positive<S>,
    /// The axis that it lies along.
    #[serde(default)]
    pub axis: PrincipalAxis,
}

/// A circular cone: its tip is at the shape's position and points along z.
#[fields]
pub struct ConeShape<S = f64> {
    /// Angle between the axis and the side, below 90 degrees, rad.
    pub half_angle_rad: Positive<S>,
    /// Distance of the base from the tip, m.
    pub length_m: Positive<S>,
}

/// A ring of round bar about z.
#[fields]
pub struct RingShape<S = f64> {
    /// Radius of the circle in the middle of the bar, m.
    pub radius_m: Positive<S>,
    /// Radius of the bar, below that of the circle, m.
    pub bar_radius_m: Positive<S>,
}

/// The convex hull of points that are not in one plane.
#[fields]
pub struct ConvexShape<S = f64> {
    /// Positions from the shape's centre, in its axes, m; 4 to 32.
    pub positions_m: Vec<[S; 3]>,
}

/// A plane.
#[fields]
pub struct ContactPlane<S = f64> {
    /// The outward normal, in the surface's axes, of any length except 0.
    #[serde(default = "up::<S>")]
    pub normal: Direction<S>,
}

impl<S: Leaf> Default for ContactPlane<S> {
    fn default() -> Self {
        Self { normal: up() }
    }
}

/// The default of `normal`.
fn up<S: Leaf>() -> Direction<S> {
    Direction::literal([0.0, 0.0, 1.0])
}

/// The default of `restitution`.
fn third<S: Leaf>() -> Fraction<S> {
    Fraction::literal(0.3)
}

/// The default of `restitution_speed_m_s`.
fn half<S: Leaf>() -> Positive<S> {
    Positive::literal(0.5)
}

/// The default of `penetration_tolerance_m`.
fn tolerance<S: Leaf>() -> Positive<S> {
    Positive::literal(0.02)
}
