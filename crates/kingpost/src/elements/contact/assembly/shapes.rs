//! Pairs of shapes in contact: the spots of one that meet the solid of the other.

use super::solids;
use crate::elements::contact::{ContactSolid, Curve, Facing, Spot};
use crate::scenario::assembly::FieldError;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, LoadShape, SurfaceShape};
use crate::spatial::Vector3;

/// Largest number of points of one load.
const MOST_POINTS: usize = 64;

/// Bulge of a cylinder's ends, as a share of its radius.
const BULGE: f64 = 0.02;

/// Crown of a line or an arc, as a share of half its length: 5 mm on a bar of 10 m, within the usual penetration.
const CROWN: f64 = 1e-3;

/// Number of arcs of a ring, each with one contact point.
const ARCS: usize = 8;

pub(super) type Shapes<S> = (Vec<(Facing, Spot<S>)>, [Option<ContactSolid<S>>; 2]);

/// The kinds of shapes, by the way in which they touch.
#[derive(Clone, Copy, PartialEq)]
enum ShapeKind {
    Plane,
    Points,
    Sphere,
    Box,
    Convex,
    Cylinder,
    Capsule,
    Cone,
    Ring,
}

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
    /// The flat ends of a cylinder.
    Ends,
}

/// A shape of either side.
struct TouchingShape<S> {
    kind: ShapeKind,
    points: Vec<Spot<S>>,
    lines: Vec<Spot<S>>,
    solid: Option<ContactSolid<S>>,
}

/// Returns how two shapes meet; `None` if they cannot.
fn meeting(load: ShapeKind, surface: ShapeKind) -> Option<Meeting> {
    use Meeting::{Both, Load, Surface};
    use ShapeKind::{Box, Capsule, Cone, Convex, Cylinder, Plane, Points, Ring, Sphere};
    Some(match (load, surface) {
        (Plane, _) | (_, Points) | (Cone, Plane) | (Ring | Points, Ring) => return None,
        (_, Ring) => Surface(TouchingPart::Points),
        (Cylinder, Plane) => Load(TouchingPart::Ends),
        (_, Plane) | (Points | Sphere | Ring, _) => Load(TouchingPart::Points),
        (_, Sphere) => Surface(TouchingPart::Points),
        (Capsule, Capsule) => Both([TouchingPart::Lines, TouchingPart::Points]),
        (Capsule, _) | (Cylinder, Cylinder) => Load(TouchingPart::Lines),
        (_, Capsule) => Surface(TouchingPart::Lines),
        (Box, Box) => Both([TouchingPart::Points; 2]),
        (Box | Convex, Box | Convex) => Both([TouchingPart::Lines; 2]),
        (Box | Convex | Cylinder | Cone, Box | Convex | Cylinder | Cone) => return None,
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
        let allowed = format!("one of {}, on a {}", names.join(", "), name(theirs.kind));
        return Err(FieldError::new(field("load.shape"), name(own.kind), allowed));
    };
    let spots = |shape: &TouchingShape<S>, part: TouchingPart| match part {
        TouchingPart::Points => Ok(shape.points.clone()),
        TouchingPart::Lines => Ok([shape.points.as_slice(), &shape.lines].concat()),
        TouchingPart::Ends => flat_ends(shape, &field("load.shape.cylinder.length_m")),
    };
    if own.kind == ShapeKind::Cylinder && theirs.kind == ShapeKind::Cylinder && own.lines.is_empty() {
        let allowed = "more than the diameter, on a cylinder: its ends are rounded there";
        return Err(FieldError::new(field("load.shape.cylinder.length_m"), "a disc", allowed));
    }
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

fn of_load<S: Quantity>(given: &LoadShape<S>, field: &str) -> Result<TouchingShape<S>, FieldError> {
    Ok(match given {
        LoadShape::Box(given) => polyhedron(ShapeKind::Box, solids::cuboid(given)),
        LoadShape::Sphere(given) => sphere(given),
        LoadShape::Cylinder(given) => bar(ShapeKind::Cylinder, solids::cylinder(given)),
        LoadShape::Capsule(given) => bar(ShapeKind::Capsule, solids::capsule(given)),
        LoadShape::Cone(given) => cone(given, &format!("{field}.cone"))?,
        LoadShape::Ring(given) => ring(given, &format!("{field}.ring"))?,
        LoadShape::Convex(given) => {
            let hull = solids::convex(given, &format!("{field}.convex"))?;
            polyhedron(ShapeKind::Convex, ContactSolid::Convex(hull))
        }
        LoadShape::Points(given) => {
            let found = given.positions_m.len();
            if !(1..=MOST_POINTS).contains(&found) {
                let (field, allowed) = (format!("{field}.points.positions_m"), format!("1 to {MOST_POINTS} points"));
                return Err(FieldError::new(field, format!("{found} points"), allowed));
            }
            let points = given.positions_m.iter().map(|point| corner(Vector3(*point))).collect();
            TouchingShape { kind: ShapeKind::Points, points, lines: Vec::new(), solid: None }
        }
    })
}

fn of_surface<S: Quantity>(given: &SurfaceShape<S>, field: &str) -> Result<TouchingShape<S>, FieldError> {
    Ok(match given {
        SurfaceShape::Plane(given) => {
            let solid = Some(solids::plane(given));
            TouchingShape { kind: ShapeKind::Plane, points: Vec::new(), lines: Vec::new(), solid }
        }
        SurfaceShape::Box(given) => polyhedron(ShapeKind::Box, solids::cuboid(given)),
        SurfaceShape::Sphere(given) => sphere(given),
        SurfaceShape::Cylinder(given) => bar(ShapeKind::Cylinder, solids::cylinder(given)),
        SurfaceShape::Capsule(given) => bar(ShapeKind::Capsule, solids::capsule(given)),
        SurfaceShape::Cone(given) => cone(given, &format!("{field}.cone"))?,
        SurfaceShape::Ring(given) => ring(given, &format!("{field}.ring"))?,
        SurfaceShape::Convex(given) => {
            let hull = solids::convex(given, &format!("{field}.convex"))?;
            polyhedron(ShapeKind::Convex, ContactSolid::Convex(hull))
        }
    })
}

fn ball<S: Quantity>(centre: Vector3<S>, radius: S) -> Spot<S> {
    Spot::Ball { centre, radius }
}

fn corner<S: Quantity>(at: Vector3<S>) -> Spot<S> {
    ball(at, S::ZERO)
}

/// Returns a round bar between two points; of radius 0, an edge.
fn line<S: Quantity>([a, b]: [Vector3<S>; 2], radius: S) -> Spot<S> {
    let (middle, half) = ((a + b) * S::constant(0.5), (b - a) * S::constant(0.5));
    Spot::Tube { curve: Curve::Line { middle, half }, radius, crown: half.norm() * S::constant(CROWN) }
}

fn sphere<S: Quantity>(given: &schema::SphereShape<S>) -> TouchingShape<S> {
    let points = vec![ball(Vector3::zero(), given.radius_m.get())];
    TouchingShape { kind: ShapeKind::Sphere, points, lines: Vec::new(), solid: Some(solids::sphere(given)) }
}

fn cone<S: Quantity>(given: &schema::ConeShape<S>, field: &str) -> Result<TouchingShape<S>, FieldError> {
    let solid = Some(solids::cone(given, field)?);
    Ok(TouchingShape { kind: ShapeKind::Cone, points: Vec::new(), lines: Vec::new(), solid })
}

/// Returns a box or a hull with its corners and edges.
fn polyhedron<S: Quantity>(kind: ShapeKind, solid: ContactSolid<S>) -> TouchingShape<S> {
    let (corners, edges) = match &solid {
        ContactSolid::Box { half } => {
            let corners = (0..8_usize)
                .map(|k| Vector3(core::array::from_fn(|i| if k >> i & 1 == 0 { -half[i] } else { half[i] })));
            let edges =
                (0..3_usize).flat_map(|i| (0..8).filter(move |k| k >> i & 1 == 0).map(move |k| [k, k | 1 << i]));
            (corners.collect(), edges.collect())
        }
        ContactSolid::Convex(hull) => (hull.corners.clone(), hull.edges.clone()),
        _ => (Vec::new(), Vec::new()),
    };
    let lines = edges.iter().map(|edge| line(edge.map(|i| corners[i]), S::ZERO)).collect();
    TouchingShape { kind, points: corners.into_iter().map(corner).collect(), lines, solid: Some(solid) }
}

/// Returns a capsule, or a cylinder as a capsule of its length, with the balls of its ends and the bar between them.
fn bar<S: Quantity>(kind: ShapeKind, solid: ContactSolid<S>) -> TouchingShape<S> {
    let (radius, half, axis) = match &solid {
        ContactSolid::Capsule { radius, half_length, axis } => (*radius, *half_length, *axis),
        ContactSolid::Cylinder { radius, half_length, axis } => (*radius, *half_length - *radius, *axis),
        _ => return TouchingShape { kind, points: Vec::new(), lines: Vec::new(), solid: Some(solid) },
    };
    let mut end = Vector3::zero();
    end[axis as usize] = half;
    let ends = [-end, end];
    let lines = if half.all(|half| half > 0.0) { vec![line(ends, radius)] } else { Vec::new() };
    TouchingShape { kind, points: ends.map(|end| ball(end, radius)).to_vec(), lines, solid: Some(solid) }
}

/// Returns a ring as arcs that touch at one point each.
fn ring<S: Quantity>(given: &schema::RingShape<S>, field: &str) -> Result<TouchingShape<S>, FieldError> {
    let (radius, bar) = (given.radius_m.get(), given.bar_radius_m.get());
    if !(radius - bar).all(|hole| hole > 0.0) {
        let allowed = format!("less than radius_m, {radius}");
        return Err(FieldError::new(format!("{field}.bar_radius_m"), given.bar_radius_m, allowed));
    }
    let half_angle = core::f64::consts::PI / ARCS as f64;
    let points = (0..ARCS).map(|k| {
        let (sin, cos) = S::constant(k as f64 / ARCS as f64).sin_cos_of_turns();
        let [across, along] = [[cos, sin, S::ZERO], [-sin, cos, S::ZERO]].map(|unit| Vector3(unit) * radius);
        let half_angle = S::constant(half_angle);
        let curve = Curve::Arc { centre: Vector3::zero(), across, along, half_angle };
        Spot::Tube { curve, radius: bar, crown: radius * half_angle * S::constant(CROWN) }
    });
    Ok(TouchingShape { kind: ShapeKind::Ring, points: points.collect(), lines: Vec::new(), solid: None })
}

/// Returns both ends of a cylinder, which must be longer than their bulges.
fn flat_ends<S: Quantity>(shape: &TouchingShape<S>, field: &str) -> Result<Vec<Spot<S>>, FieldError> {
    let Some(ContactSolid::Cylinder { radius, half_length, axis }) = &shape.solid else { return Ok(Vec::new()) };
    let (radius, bulge) = (*radius, *radius * S::constant(BULGE));
    let middle = *half_length - bulge;
    if !middle.all(|middle| middle >= 0.0) {
        let allowed = format!("at least {}, {} of the radius", bulge + bulge, 2.0 * BULGE);
        return Err(FieldError::new(field, *half_length + *half_length, allowed));
    }
    let mut along = Vector3::zero();
    along[*axis as usize] = S::ONE;
    let end = |centre: Vector3<S>| Spot::End { centre, axis: along, radius, bulge };
    Ok(vec![end(along * middle), end(-(along * middle))])
}
