//! Forces that act on the bodies from outside.

use kingpost_derive::fields;

use crate::scenario::schema::{
    CatenaryLine, Contact, CurrentLoad, DynamicLine, DynamicPositioning, FreeFloodingTank, Gravity, Hydrodynamics,
    QuadraticDamping, Rope, SlackTank, SoftHold, SpringLine, Submerged, TrailingEdge, TuggerLine, UTank,
    ViscousDamping, WindLoad,
};

/// Forces that act on the bodies from outside.
// `assembled`: each kind assembles its elements in its room, by `Assemble` in `elements/KIND/assembly.rs`.
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
    /// A wire or chain with mass and drag: a mooring line, a hoisting wire in deep water.
    Line(Box<DynamicLine<S>>),
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
