//! Solids of contacts and clearances, from their fields.

use crate::elements::contact::{ContactSolid, ConvexHull};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::bodies::axis;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;
use crate::spatial::Vector3;

/// Smallest and largest number of points of a convex hull.
const POINTS: [usize; 2] = [4, 32];

/// Smallest distance of a cone's half angle from 0 and from 90 degrees, rad: 0.1 degrees.
const LEAST_ANGLE: f64 = 1.7e-3;

fn half<S: Quantity>(length: schema::Positive<S>) -> S {
    length.get() * S::constant(0.5)
}

pub(crate) fn plane<S: Quantity>(given: &schema::ContactPlane<S>) -> ContactSolid<S> {
    ContactSolid::Plane { normal: Vector3(given.normal.get()).direction() }
}

pub(crate) fn cuboid<S: Quantity>(given: &schema::BoxShape<S>) -> ContactSolid<S> {
    ContactSolid::Box { half: [given.length_m, given.width_m, given.height_m].map(half) }
}

pub(crate) fn sphere<S: Quantity>(given: &schema::SphereShape<S>) -> ContactSolid<S> {
    ContactSolid::Sphere { radius: given.radius_m.get() }
}

pub(crate) fn cylinder<S: Quantity>(given: &schema::CylinderShape<S>) -> ContactSolid<S> {
    let radius = given.radius_m.get();
    ContactSolid::Cylinder { radius, half_length: half(given.length_m), axis: axis(given.axis) }
}

pub(crate) fn capsule<S: Quantity>(given: &schema::CapsuleShape<S>) -> ContactSolid<S> {
    let radius = given.radius_m.get();
    ContactSolid::Capsule { radius, half_length: half(given.length_m), axis: axis(given.axis) }
}

pub(crate) fn cone<S: Quantity>(given: &schema::ConeShape<S>, field: &str) -> Result<ContactSolid<S>, FieldError> {
    let angle = given.half_angle_rad.get();
    if !angle.all(|angle| (LEAST_ANGLE..=core::f64::consts::FRAC_PI_2 - LEAST_ANGLE).contains(&angle)) {
        let allowed = "0.0017 to 1.5691 rad, which is 0.1 to 89.9 degrees";
        return Err(FieldError::new(format!("{field}.half_angle_rad"), given.half_angle_rad, allowed));
    }
    Ok(ContactSolid::Cone { half_angle: angle.sin_cos(), length: given.length_m.get() })
}

pub(crate) fn convex<S: Quantity>(given: &schema::ConvexShape<S>, field: &str) -> Result<ConvexHull<S>, FieldError> {
    let (found, [least, most]) = (given.positions_m.len(), POINTS);
    let refused = |found: String, allowed: String| FieldError::new(format!("{field}.positions_m"), found, allowed);
    if !(least..=most).contains(&found) {
        return Err(refused(format!("{found} points"), format!("{least} to {most} points")));
    }
    let points: Vec<_> = given.positions_m.iter().map(|point| Vector3(*point)).collect();
    ConvexHull::new(&points).ok_or_else(|| {
        let allowed = "points that are not in one plane, and whose hull has the same faces in every run of a batch";
        refused("points without a convex hull".to_owned(), allowed.to_owned())
    })
}
