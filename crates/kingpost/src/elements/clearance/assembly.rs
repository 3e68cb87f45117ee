//! Clearances and air gaps: their points and solids.

use crate::elements::contact::ContactSolid;
use crate::elements::contact::assembly::solids;
use crate::elements::{AirGap, AnyElement, Clearance};
use crate::model::{Attachment, Model};
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::assembly::rigid_bodies::rigid;
use crate::scenario::assembly::{FieldError, known};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, ClearanceShape, LocalName, Name, Pin, Scenario, WORLD};
use crate::scenario::wording::one_of_with_hint;
use crate::spatial::{Frame, Vector3, rotation_from_roll_pitch_yaw};

impl<S: Quantity> Assemble<S> for schema::Clearance<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let field = |rest: &str| format!("sensors.{name}.clearance.{rest}");
        let Self { first, second, .. } = self;
        let bends = |given: &schema::ClearanceFrom<S>| {
            at.scenario.bodies.get(&given.body).is_some_and(|body| body.flexible.is_some())
        };
        if first.body == second.body && !bends(first) {
            let allowed = format!("another body than first.body, {}", first.body);
            return Err(FieldError::new(field("second.body"), &second.body, allowed));
        }
        let sides = [(first, field("first")), (second, field("second"))].map(|(given, field)| {
            let pin = pin(at.scenario, &field, &given.body, given.point.as_ref(), given.position_m)?;
            Ok((
                solid(at.scenario, &field, given)?,
                frame(at.model, place(at.scenario, at.model, &field, &pin)?, given),
            ))
        });
        let [(own, own_place), (from, from_place)] = both(sides)?;
        if let (Some(ContactSolid::Plane { .. }), Some(ContactSolid::Plane { .. })) = (&own, &from) {
            return Err(FieldError::new(field("second.shape"), "plane", "another shape: first has a plane"));
        }
        let (Some(own_place), Some(from_place), true) = (own_place, from_place, self.enabled) else {
            return Ok(Vec::new());
        };
        let (places, second) = ([own_place, from_place], from.unwrap_or(ContactSolid::Sphere { radius: S::ZERO }));
        Ok(vec![Box::new(Clearance { name: name.to_owned(), places, first: own, second })])
    }
}

/// Returns both results, or the first error.
fn both<T>([first, second]: [Result<T, FieldError>; 2]) -> Result<[T; 2], FieldError> {
    Ok([first?, second?])
}

/// Returns the place of a solid with its axes.
fn frame<S: Quantity>(
    model: &Model<S>,
    place: Option<Attachment<S>>,
    given: &schema::ClearanceFrom<S>,
) -> Option<Attachment<S>> {
    let rotation = rotation_from_roll_pitch_yaw(Vector3(given.orientation_rad));
    place.map(|place| {
        let position = if is_own(given) { Vector3::zero() } else { place.in_body.position };
        model.attachment(place.body, Frame { rotation, position })
    })
}

impl<S: Quantity> Assemble<S> for schema::AirGap<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let field = format!("sensors.{name}.air_gap");
        let pin = pin(at.scenario, &field, &self.body, self.point.as_ref(), self.position_m)?;
        let Some(point) = place(at.scenario, at.model, &field, &pin)?.filter(|_| self.enabled) else {
            return Ok(Vec::new());
        };
        Ok(vec![Box::new(AirGap { name: name.to_owned(), point })])
    }
}

/// Returns a point as its attachment to a body, if the body exists.
fn pin<S: Quantity>(
    scenario: &Scenario<S>,
    field: &str,
    body: &Name,
    point: Option<&LocalName>,
    position_m: [S; 3],
) -> Result<Pin<S>, FieldError> {
    known(&format!("{field}.body"), body, scenario.bodies.keys().map(|body| body.as_str()).chain([WORLD]))?;
    let Some(point) = point else { return Ok(Pin { body: body.clone(), position_m }) };
    let points = scenario.bodies.get(body).map(|body| &body.points);
    let Some(named) = points.and_then(|points| points.get(point.as_str())) else {
        let names: Vec<&str> = points.into_iter().flatten().map(|(name, _)| name.as_str()).collect();
        let allowed = match names.as_slice() {
            [] => format!("none: {body} has no points"),
            names => one_of_with_hint(names, point),
        };
        return Err(FieldError::new(format!("{field}.point"), point, allowed));
    };
    let position_m = core::array::from_fn(|k| named.position_m[k] + position_m[k]);
    Ok(Pin { body: body.clone(), position_m })
}

/// Returns its attachment in the model; `None` if the body does not exist.
fn place<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    field: &str,
    pin: &Pin<S>,
) -> Result<Option<Attachment<S>>, FieldError> {
    if pin.named_body().is_some_and(|body| model.body(body).is_none()) {
        return Ok(None);
    }
    attachment(scenario, model, &format!("{field}.position_m"), pin).map(Some)
}

fn is_own<S>(given: &schema::ClearanceFrom<S>) -> bool {
    matches!(given.shape, Some(ClearanceShape::Own))
}

/// Returns the solid; `None` for a point.
fn solid<S: Quantity>(
    scenario: &Scenario<S>,
    field: &str,
    given: &schema::ClearanceFrom<S>,
) -> Result<Option<ContactSolid<S>>, FieldError> {
    let Some(shape) = &given.shape else { return Ok(None) };
    if scenario.bodies.contains_key(&given.body) {
        rigid(scenario, format!("{field}.body"), &given.body)?;
    }
    let inside = |kind: &str| format!("{field}.shape.{kind}");
    Ok(Some(match shape {
        ClearanceShape::Own => own(scenario, field, given)?,
        ClearanceShape::Plane(given) => solids::plane(given),
        ClearanceShape::Box(given) => solids::cuboid(given),
        ClearanceShape::Cylinder(given) => solids::cylinder(given),
        ClearanceShape::Sphere(given) => solids::sphere(given),
        ClearanceShape::Capsule(given) => solids::capsule(given),
        ClearanceShape::Cone(given) => solids::cone(given, &inside("cone"))?,
        ClearanceShape::Convex(given) => ContactSolid::Convex(solids::convex(given, &inside("convex"))?),
    }))
}

/// The shape of the body itself, on its centre of mass.
fn own<S: Quantity>(
    scenario: &Scenario<S>,
    field: &str,
    given: &schema::ClearanceFrom<S>,
) -> Result<ContactSolid<S>, FieldError> {
    let is_placed = |numbers: &[S; 3]| !numbers.iter().all(|number| number.vanishes());
    for (name, placed) in [
        ("point", given.point.is_some()),
        ("position_m", is_placed(&given.position_m)),
        ("orientation_rad", is_placed(&given.orientation_rad)),
    ] {
        if placed {
            let allowed = "none: a body's own shape is centred on its centre of mass";
            return Err(FieldError::new(format!("{field}.{name}"), "a place", allowed));
        }
    }
    match scenario.bodies.get(&given.body).and_then(|body| body.shape.as_ref()) {
        Some(schema::Shape::Box(given)) => Ok(solids::cuboid(given)),
        Some(schema::Shape::Cylinder(given)) => Ok(solids::cylinder(given)),
        Some(schema::Shape::Sphere(given)) => Ok(solids::sphere(given)),
        Some(schema::Shape::Point(_)) | None => {
            let found = format!("own, but {} is not a solid", given.body);
            Err(FieldError::new(format!("{field}.shape"), found, "plane, box, cylinder or sphere, with its fields"))
        }
    }
}
