//! Shapes with the spots of each: corners, lines, rims.

use super::solids;
use crate::elements::contact::{ContactSolid, Curve, Spot};
use crate::model::Axis;
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

/// Number of arcs of a ring or of the rim of a flat end, each with one contact point.
const ARCS: usize = 8;

/// Chamfer of the rim of a flat end, as a share of its radius. A standing body touches with the arcs at its flat, a lying one
/// with the circle on its side: so it stands on many points, and rolls on one without bumps.
const CHAMFER: f64 = 0.005;

/// The kinds of shapes, by the way in which they touch.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum ShapeKind {
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

/// A shape of either side.
pub(super) struct TouchingShape<S> {
    pub(super) kind: ShapeKind,
    pub(super) points: Vec<Spot<S>>,
    pub(super) lines: Vec<Spot<S>>,
    pub(super) rims: Vec<Spot<S>>,
    pub(super) solid: Option<ContactSolid<S>>,
}

/// Returns a load's shape.
pub(super) fn of_load<S: Quantity>(given: &LoadShape<S>, field: &str) -> Result<TouchingShape<S>, FieldError> {
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
            TouchingShape { points, ..shape(ShapeKind::Points, None) }
        }
    })
}

/// Returns a surface's shape.
pub(super) fn of_surface<S: Quantity>(given: &SurfaceShape<S>, field: &str) -> Result<TouchingShape<S>, FieldError> {
    Ok(match given {
        SurfaceShape::Plane(given) => shape(ShapeKind::Plane, Some(solids::plane(given))),
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

/// Returns a shape without spots.
fn shape<S>(kind: ShapeKind, solid: Option<ContactSolid<S>>) -> TouchingShape<S> {
    TouchingShape { kind, points: Vec::new(), lines: Vec::new(), rims: Vec::new(), solid }
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
    TouchingShape { points, ..shape(ShapeKind::Sphere, Some(solids::sphere(given))) }
}

fn cone<S: Quantity>(given: &schema::ConeShape<S>, field: &str) -> Result<TouchingShape<S>, FieldError> {
    let solid = solids::cone(given, field)?;
    let mut rims = vec![corner(Vector3::zero())];
    if let ContactSolid::Cone { half_angle: (sin, cos), length } = &solid {
        let (slope, chamfer) = (*sin / *cos, S::ONE - S::constant(CHAMFER));
        let circle = |at: S, radius: S| Circle { centre: Vector3([S::ZERO, S::ZERO, -at]), axis: Axis::Z, radius };
        rims.extend(arcs(&circle(*length, *length * slope * chamfer), S::ZERO));
        rims.push(circle(*length * chamfer, *length * slope * chamfer).rim());
    }
    Ok(TouchingShape { rims, ..shape(ShapeKind::Cone, Some(solid)) })
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
    TouchingShape { points: corners.into_iter().map(corner).collect(), lines, ..shape(kind, Some(solid)) }
}

/// Returns a capsule, or a cylinder as a capsule of its length, with the balls of its ends and the bar between them; a
/// cylinder with its rims too.
fn bar<S: Quantity>(kind: ShapeKind, solid: ContactSolid<S>) -> TouchingShape<S> {
    let (radius, half, axis) = match &solid {
        ContactSolid::Capsule { radius, half_length, axis } => (*radius, *half_length, *axis),
        ContactSolid::Cylinder { radius, half_length, axis } => (*radius, *half_length - *radius, *axis),
        _ => return shape(kind, Some(solid)),
    };
    let along = unit(axis) * half;
    let ends = [-along, along];
    let lines = if half.all(|half| half > 0.0) { vec![line(ends, radius)] } else { Vec::new() };
    let points = ends.map(|end| ball(end, radius)).to_vec();
    TouchingShape { points, lines, rims: rims(&solid), ..shape(kind, Some(solid)) }
}

/// Returns the rims of a cylinder, each as the arcs at its flat and the circle on its side.
fn rims<S: Quantity>(solid: &ContactSolid<S>) -> Vec<Spot<S>> {
    let ContactSolid::Cylinder { radius, half_length, axis } = *solid else { return Vec::new() };
    let chamfer =
        (radius * S::constant(CHAMFER)).select_less(half_length, || radius * S::constant(CHAMFER), || half_length);
    let ends = [-S::ONE, S::ONE].into_iter().flat_map(|side| {
        let circle = |at: S, radius: S| Circle { centre: unit(axis) * (side * at), axis, radius };
        let on_side = circle(half_length - chamfer, radius).rim();
        arcs(&circle(half_length, radius - radius * S::constant(CHAMFER)), S::ZERO).chain([on_side]).collect::<Vec<_>>()
    });
    ends.collect()
}

/// A circle about an axis.
struct Circle<S> {
    centre: Vector3<S>,
    axis: Axis,
    radius: S,
}

impl<S: Quantity> Circle<S> {
    fn rim(&self) -> Spot<S> {
        let [across, along] = self.turned(S::ZERO);
        Spot::Rim { centre: self.centre, across, along }
    }

    /// Returns the vectors from the centre to the point at an angle in turns, and to that a quarter turn after it.
    fn turned(&self, turns: S) -> [Vector3<S>; 2] {
        let (sin, cos) = turns.sin_cos_of_turns();
        let [first, second] = [1, 2].map(|next| (self.axis as usize + next) % 3);
        [[cos, sin], [-sin, cos]].map(|turned| {
            let mut unit = Vector3::zero();
            (unit[first], unit[second]) = (turned[0], turned[1]);
            unit * self.radius
        })
    }
}

fn unit<S: Quantity>(axis: Axis) -> Vector3<S> {
    let mut unit = Vector3::zero();
    unit[axis as usize] = S::ONE;
    unit
}

/// Returns a circle of round bar as arcs that touch at one point each.
fn arcs<S: Quantity>(circle: &Circle<S>, bar: S) -> impl Iterator<Item = Spot<S>> {
    let half_angle = S::constant(core::f64::consts::PI / ARCS as f64);
    (0..ARCS).map(move |k| {
        let [across, along] = circle.turned(S::constant(k as f64 / ARCS as f64));
        let curve = Curve::Arc { centre: circle.centre, across, along, half_angle };
        Spot::Tube { curve, radius: bar, crown: circle.radius * half_angle * S::constant(CROWN) }
    })
}

/// Returns a ring as arcs that touch at one point each.
fn ring<S: Quantity>(given: &schema::RingShape<S>, field: &str) -> Result<TouchingShape<S>, FieldError> {
    let (radius, bar) = (given.radius_m.get(), given.bar_radius_m.get());
    if !(radius - bar).all(|hole| hole > 0.0) {
        let allowed = format!("less than radius_m, {radius}");
        return Err(FieldError::new(format!("{field}.bar_radius_m"), given.bar_radius_m, allowed));
    }
    let circle = Circle { centre: Vector3::zero(), axis: Axis::Z, radius };
    Ok(TouchingShape { points: arcs(&circle, bar).collect(), ..shape(ShapeKind::Ring, None) })
}

/// Returns both ends of a cylinder, which must be longer than their bulges.
pub(super) fn flat_ends<S: Quantity>(shape: &TouchingShape<S>, field: &str) -> Result<Vec<Spot<S>>, FieldError> {
    let Some(ContactSolid::Cylinder { radius, half_length, axis }) = &shape.solid else { return Ok(Vec::new()) };
    let (radius, bulge) = (*radius, *radius * S::constant(BULGE));
    let middle = *half_length - bulge;
    if !middle.all(|middle| middle >= 0.0) {
        let allowed = format!("at least {}, {} of the radius", bulge + bulge, 2.0 * BULGE);
        return Err(FieldError::new(field, *half_length + *half_length, allowed));
    }
    let along = unit(*axis);
    let end = |centre: Vector3<S>| Spot::End { centre, axis: along, radius, bulge };
    Ok(vec![end(along * middle), end(-(along * middle))])
}
