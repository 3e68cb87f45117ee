//! Pairs of shapes in contact: the spots of one that meet the solid of the other.

use super::touching::{ShapeKind, TouchingShape, flat_ends, of_load, of_surface};
use crate::elements::contact::{ContactSolid, Facing, Spot};
use crate::scenario::assembly::FieldError;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;

pub(super) type Shapes<S> = (Vec<(Facing, Spot<S>)>, [Option<ContactSolid<S>>; 2]);

const KINDS: [(ShapeKind, &str); 9] = [
    (ShapeKind::Plane, "plane"),
    (ShapeKind::Points, "points"),
    (ShapeKind::Sphere, "sphere"),
    (ShapeKind::Box, "box"),
    (ShapeKind::Convex, "convex"),
    (ShapeKind::Cylinder, "cylinder"),
    (ShapeKind::Capsule, "capsule"),
    (ShapeKind::Cone, "cone"),
    (ShapeKind::Ring, "ring"),
];

/// The spots of a load and of a surface that meet the solid of the other.
enum Meeting {
    /// Spots of the load alone.
    Load(TouchingPart),
    /// Spots of the surface alone.
    Surface(TouchingPart),
    /// Spots of both.
    Both([TouchingPart; 2]),
}

/// Spots of a shape.
#[derive(Clone, Copy)]
enum TouchingPart {
    /// Corners and balls, the ends of a capsule, the arcs of a ring.
    Points,
    /// Points, and lines between them.
    Lines,
    /// The flat ends of a cylinder, on a plane.
    Ends,
    /// The rims of flat ends, and the tip of a cone.
    Rims,
    /// Rims, and the bar between the ends of a cylinder.
    Bar,
}

/// Returns how two shapes meet; `None` if they cannot.
fn meeting(load: ShapeKind, surface: ShapeKind) -> Option<Meeting> {
    use Meeting::{Both, Load, Surface};
    use ShapeKind::{Box, Capsule, Cone, Convex, Cylinder, Plane, Points, Ring, Sphere};
    Some(match (load, surface) {
        (Plane, _) | (_, Points) | (Ring | Points, Ring) | (Cone, Cone) => return None,
        (_, Ring) => Surface(TouchingPart::Points),
        (Cylinder, Plane) => Load(TouchingPart::Ends),
        (Cone, Plane) => Load(TouchingPart::Rims),
        (_, Plane) | (Points | Sphere | Ring, _) => Load(TouchingPart::Points),
        (_, Sphere) => Surface(TouchingPart::Points),
        (Capsule, Capsule) => Both([TouchingPart::Lines, TouchingPart::Points]),
        (Capsule, _) | (Cylinder, Cylinder) => Load(TouchingPart::Lines),
        (_, Capsule) => Surface(TouchingPart::Lines),
        (Box, Box) => Both([TouchingPart::Points; 2]),
        (Box | Convex, Box | Convex) => Both([TouchingPart::Lines; 2]),
        (Box | Convex, Cylinder | Cone) => Both([TouchingPart::Lines, TouchingPart::Rims]),
        (Cylinder | Cone, Box | Convex) => Both([TouchingPart::Rims, TouchingPart::Lines]),
        (Cylinder, Cone) => Both([TouchingPart::Bar, TouchingPart::Rims]),
        (Cone, Cylinder) => Both([TouchingPart::Rims, TouchingPart::Bar]),
    })
}

/// Returns the spots of both sides and the solids that they touch.
pub(super) fn shapes<S: Quantity>(
    load: &schema::ContactLoad<S>,
    surface: &schema::ContactSurface<S>,
    field: &impl Fn(&str) -> String,
) -> Result<Shapes<S>, FieldError> {
    let own = of_load(&load.shape, &field("load.shape"))?;
    let theirs = of_surface(&surface.shape, &field("surface.shape"))?;
    let Some(meeting) = meeting(own.kind, theirs.kind) else {
        let name = |kind: ShapeKind| KINDS.iter().find(|(other, _)| *other == kind).map_or("", |(_, name)| name);
        let fits = |(kind, _): &&(ShapeKind, &str)| self::meeting(*kind, theirs.kind).is_some();
        let names: Vec<&str> = KINDS.iter().filter(fits).map(|(_, name)| *name).collect();
        let mut allowed = format!("one of {}, on a {}", names.join(", "), name(theirs.kind));
        allowed += instead(own.kind, theirs.kind);
        return Err(FieldError::new(field("load.shape"), name(own.kind), allowed));
    };
    let spots = |shape: &TouchingShape<S>, part: TouchingPart| match part {
        TouchingPart::Points => Ok(shape.points.clone()),
        TouchingPart::Lines => Ok([shape.points.as_slice(), &shape.lines].concat()),
        TouchingPart::Ends => flat_ends(shape, &field("load.shape.cylinder.length_m")),
        TouchingPart::Rims => Ok(shape.rims.clone()),
        TouchingPart::Bar => Ok([shape.rims.as_slice(), &shape.lines].concat()),
    };
    check_bar([&own, &theirs], field)?;
    let (of_load, of_surface) = match meeting {
        Meeting::Load(part) => (spots(&own, part)?, Vec::new()),
        Meeting::Surface(part) => (Vec::new(), spots(&theirs, part)?),
        Meeting::Both([of_own, of_theirs]) => (spots(&own, of_own)?, spots(&theirs, of_theirs)?),
    };
    let needed = [!of_surface.is_empty(), !of_load.is_empty()];
    let all = of_load.into_iter().map(|spot| (Facing::Load, spot));
    let all = all.chain(of_surface.into_iter().map(|spot| (Facing::Surface, spot))).collect();
    let [own, theirs] = [own.solid.filter(|_| needed[0]), theirs.solid.filter(|_| needed[1])];
    Ok((all, [own, theirs]))
}

/// Returns what serves in place of two shapes whose nearest points are not found one by one.
fn instead(load: ShapeKind, surface: ShapeKind) -> &'static str {
    match (load, surface) {
        (ShapeKind::Ring, ShapeKind::Ring) => {
            ": the nearest points of two rings come in pairs that merge and vanish; describe the bow of a shackle by \
             capsules, a flange by a cylinder, a funnel's mouth or a pin by a cone"
        }
        (ShapeKind::Cone, ShapeKind::Cone) => {
            ": sides that cross have no edge to touch with; describe the funnel by a ring at its mouth"
        }
        _ => "",
    }
}

/// Checks that a cylinder whose side meets another round side is a bar: a disc has no line in its middle.
fn check_bar<S>(shapes: [&TouchingShape<S>; 2], field: &impl Fn(&str) -> String) -> Result<(), FieldError> {
    use ShapeKind::{Cone, Cylinder};
    let (which, other) = match shapes.map(|shape| (shape.kind, shape.lines.is_empty())) {
        [(Cylinder, true), (Cylinder, _)] => ("load", "cylinder: its ends are rounded there"),
        [(Cylinder, true), (Cone, _)] => ("load", "cone"),
        [(Cone, _), (Cylinder, true)] => ("surface", "cone"),
        _ => return Ok(()),
    };
    let allowed = format!("more than the diameter, on a {other}");
    Err(FieldError::new(field(&format!("{which}.shape.cylinder.length_m")), "a disc", allowed))
}
