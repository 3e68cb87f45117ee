//! Forces that act on the bodies from outside.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{
    CatenaryLine, Contact, CurrentLoad, DynamicPositioning, FreeFloodingTank, Hydrodynamics, Name, NonNegative, Rope,
    SlackTank, SoftHold, SpringLine, Submerged, TrailingEdge, TuggerLine, UTank, WindLoad, yes,
};

/// Forces that act on the bodies from outside.
#[fields(assembled)]
pub enum Force<S = f64> {
    /// Weight, downwards along the world's z axis.
    Gravity(Gravity<S>),
    /// Damping proportional to a body's rates.
    ViscousDamping(ViscousDamping<S>),
    /// Drag proportional to the square of a body's rates.
    QuadraticDamping(QuadraticDamping<S>),
    /// The water on a hull.
    Hydrodynamics(Hydrodynamics<S>),
    /// The free surface of a tank that is neither empty nor full.
    SlackTank(Box<SlackTank<S>>),
    /// A U-tank: an anti-roll tank, or with a pump an anti-heeling tank.
    UTank(Box<UTank<S>>),
    /// A tank that is open to the sea; with a pump for its air, an active anti-roll tank.
    FreeFloodingTank(Box<FreeFloodingTank<S>>),
    /// The water on a lifted object, in the splash zone and below.
    Submerged(Box<Submerged<S>>),
    /// The trailing edge of a fin that swims.
    TrailingEdge(TrailingEdge<S>),
    /// A line without weight that pulls between two points.
    SpringLine(SpringLine<S>),
    /// A mooring line that hangs, and may lie on the seabed.
    CatenaryLine(CatenaryLine<S>),
    /// A rope over sheaves, which a drum may wind up.
    Rope(Box<Rope<S>>),
    /// A line whose winch keeps its tension: a tugger line or a tag line.
    TuggerLine(TuggerLine<S>),
    /// Contact of a load with a deck, a quay, the seabed, another vessel.
    Contact(Box<Contact<S>>),
    /// The wind on a body, by coefficients.
    WindLoad(Box<WindLoad<S>>),
    /// The current on a body, by coefficients.
    CurrentLoad(Box<CurrentLoad<S>>),
    /// Thrusters that keep a ship in its place.
    DynamicPositioning(Box<DynamicPositioning<S>>),
    /// Soft springs and dampers that keep a ship near its place.
    SoftHold(SoftHold<S>),
}

/// Weight of every body, downwards along the world's z axis.
#[fields(default)]
pub struct Gravity<S = f64> {
    /// Whether the element acts.
    pub enabled: bool,
    /// Acceleration of free fall, m/s^2.
    pub acceleration_m_s2: NonNegative<S>,
}

impl<S: Leaf> Default for Gravity<S> {
    fn default() -> Self {
        Self { enabled: true, acceleration_m_s2: NonNegative::literal(9.80665) }
    }
}

/// Reference against which the velocity is measured where the sea has a current.
#[fields]
#[derive(Copy, Default, Eq)]
pub enum DampedAgainst {
    /// The water at its surface: for friction and eddies of the hull.
    #[default]
    Water,
    /// The earth: for the damping of a moored ship by chains on the seabed and by slow drift in waves. A current exerts
    /// no force through it.
    Earth,
}

/// A force and a moment against a body's velocity and angular velocity, each in body axes.
#[fields]
pub struct ViscousDamping<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// Reference against which the velocity is measured.
    #[serde(default)]
    pub relative_to: DampedAgainst,
    /// The point where the force acts and whose velocity is used, in the body's drawing frame, m; without it, the
    /// centre of mass.
    pub position_m: Option<[S; 3]>,
    /// Force per velocity of the point along x, y, z of the body, N s/m.
    #[serde(default)]
    pub linear_n_s_m: [NonNegative<S>; 3],
    /// Moment per roll, pitch, yaw rate, N m s.
    #[serde(default)]
    pub angular_n_m_s: [NonNegative<S>; 3],
    /// A full matrix, added to the two above: rows of force x, y, z (N) and moment x, y, z (N m), columns of velocity
    /// x, y, z (m/s) and roll, pitch, yaw rate (rad/s). It may not add energy to any motion.
    pub matrix: Option<Box<[[S; 6]; 6]>>,
}

/// A force -c |v| v and a moment -c |omega| omega, component by component in body axes.
#[fields]
pub struct QuadraticDamping<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// Reference against which the velocity is measured.
    #[serde(default)]
    pub relative_to: DampedAgainst,
    /// The point where the force acts and whose velocity is used, in the body's drawing frame, m.
    #[serde(default)]
    pub position_m: [S; 3],
    /// Force per square of velocity along x, y, z of the body, N s^2/m^2.
    #[serde(default)]
    pub linear_n_s2_m2: [NonNegative<S>; 3],
    /// Moment per square of the roll, pitch, yaw rate, N m s^2.
    #[serde(default)]
    pub angular_n_m_s2: [NonNegative<S>; 3],
}
